/* The number pi, which C11 does not name. */
#ifndef SEILWERK_NUM_PI_H
#define SEILWERK_NUM_PI_H

#define PI 3.14159265358979323846

#endif
