/* Any bytes as a .npy file: refused, or an array whose numbers are all there. */
#include "fuzz.h"
#include "sys/npy.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct in in = {.f = bytes(data, size), .name = "fuzz"};
    struct npy a;
    struct why why;

    if (npy_read(&in, &a, &why) == SW_OK) {
        volatile double sum = 0;

        check(a.dims == 1 || a.dims == 2);
        check(a.rows * a.columns * sizeof(double) <= size);
        for (size_t i = 0; i < a.rows * a.columns; i++)
            sum += a.data[i];
        (void)sum;
        npy_free(&a);
    }
    fclose(in.f);
    return 0;
}
