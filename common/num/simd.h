/*
 * Two versions of a function from one body: for any processor, and for those with AVX2 and fused
 * multiply-add.  Their results differ in the last digits.
 */
#ifndef SEILWERK_NUM_SIMD_H
#define SEILWERK_NUM_SIMD_H

/* The body: static INLINE_BODY void work(...) */
#define INLINE_BODY inline __attribute__((always_inline))

#ifdef __x86_64__
#define FOR_AVX2 __attribute__((target("avx2,fma")))

static inline int has_avx2(void)
{
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
#else
#define FOR_AVX2

static inline int has_avx2(void)
{
    return 0;
}
#endif

#endif
