/*
 * NumPy .npy files of doubles with one or two dimensions.
 *
 * Written: format 1.0, little-endian float64, Fortran order.  Read: formats 1.0 and 2.0, both
 * orders; header and size of the data are verified.
 */
#ifndef SEILWERK_SYS_NPY_H
#define SEILWERK_SYS_NPY_H

#include "sys/in.h"
#include "sys/out.h"

#include <stddef.h>

struct npy {
    int dims;       /* 1 or 2 */
    size_t rows;    /* first extent */
    size_t columns; /* second extent; 1 for a vector */
    double *data;   /* rows x columns, column-major; owned */
};

/* Read the whole file.  SW_FORMAT, SW_READ, SW_NOMEM. */
enum status npy_read(const struct in *in, struct npy *ret, struct why *why);

void npy_free(struct npy *a);

/* The header alone, for data that are written column by column afterwards; it has NPY_HEADER_BYTES
 * for any extents. */
#define NPY_HEADER_BYTES 128
void npy_begin(struct out *o, int dims, size_t rows, size_t columns);

/* Write rows x columns doubles, column-major; a vector if dims is 1.  Errors show in out_close. */
void npy_write(struct out *o, int dims, size_t rows, size_t columns, const double *data);

#endif
