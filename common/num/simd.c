/* How wide registers may be. */
#include "num/simd.h"

int simd_most = 8;
