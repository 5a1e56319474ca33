/* Any text as a number: what is read, printed and read again is the same double; and any eight
 * bytes as a double, printed and read. */
#include "fuzz.h"
#include "sys/number.h"

#include <math.h>
#include <string.h>

static void round_trip(double x)
{
    char text[NUMBER_SIZE];
    double y = NAN;

    check(number_print(x, text) == strlen(text));
    check(number_read(text, &y) == NULL);
    check(y == x);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    char text[256];
    double x;
    long i;

    if (size < sizeof text) {
        memcpy(text, data, size);
        text[size] = '\0';
        if (!number_read(text, &x))
            round_trip(x);
        if (!integer_read(text, -1000, 1000, &i))
            check(i >= -1000 && i <= 1000);
    }
    if (size >= sizeof x) {
        memcpy(&x, data, sizeof x);
        if (isfinite(x))
            round_trip(x);
    }
    return 0;
}
