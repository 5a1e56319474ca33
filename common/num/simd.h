/*
 * Versions of a function from one body: for any processor, for those with AVX2, and for those with
 * AVX-512, both with fused multiply-add.  Their results differ in the last digits.
 */
#ifndef SEILWERK_NUM_SIMD_H
#define SEILWERK_NUM_SIMD_H

/* For tests: registers of this many numbers at the most, 2, 4 or 8, whatever the processor has. */
extern int simd_most;

/* The body: static INLINE_BODY void work(...) */
#define INLINE_BODY inline __attribute__((always_inline))

#ifdef __x86_64__
#define FOR_AVX2 __attribute__((target("avx2,fma")))

static inline int has_avx2(void)
{
    return simd_most >= 4 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
}
#define FOR_AVX512 __attribute__((target("avx512f,avx512dq,avx512vl,fma")))

static inline int has_avx512(void)
{
    return simd_most >= 8 && __builtin_cpu_supports("avx512f") &&
           __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("fma");
}
#else
#define FOR_AVX2
#define FOR_AVX512

static inline int has_avx512(void)
{
    return 0;
}

static inline int has_avx2(void)
{
    return 0;
}
#endif

#endif
