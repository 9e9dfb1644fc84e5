/* As many singles as a vec has doubles (vecf), and four (vecf4): the namesakes of vec in base/vec.h, which says what
 * each does. With FRANA_SCALAR vecf4 is one single: loops over vecf4 advance by VECF4_LANES. */
#pragma once
#include "base/vec.h"

typedef float vecf __attribute__((vector_size(4 * VEC_LANES)));
typedef int32_t vecf_mask __attribute__((vector_size(4 * VEC_LANES)));

static inline vecf vecf_load(const float *p) {
    vecf v;
    memcpy(&v, p, sizeof v);
    return v;
}
static inline void vecf_store(float *p, vecf v) { memcpy(p, &v, sizeof v); }
static inline vecf vecf_set(float a) { return (vecf){VEC_EACH(a)}; }

/* Rounded to nearest. */
static inline vecf vecf_of(vec a) {
#if VEC_AVX512
    return (vecf)_mm512_cvtpd_ps((__m512d)a);
#elif VEC_AVX2
    return (vecf)_mm256_cvtpd_ps((__m256d)a);
#else
    return __builtin_convertvector(a, vecf);
#endif
}

static inline vecf vecf_where(unsigned bits, vecf a) {
#if VEC_AVX512
    return (vecf)_mm256_maskz_mov_ps((__mmask8)bits, (__m256)a);
#else
    const int32_t b = (int32_t)bits;
    const vecf_mask bit = {VEC_BITS}, all = {VEC_EACH(b)};
    return (vecf)(((all & bit) == bit) & (vecf_mask)a);
#endif
}

static inline vecf vecf_max(vecf a, vecf b) {
#if VEC_AVX512
    return (vecf)_mm256_max_ps((__m256)a, (__m256)b);
#elif VEC_AVX2
    return (vecf)_mm_max_ps((__m128)a, (__m128)b);
#else
    for (int k = 0; k < VEC_LANES; k++) a[k] = a[k] > b[k] ? a[k] : b[k];
    return a;
#endif
}

static inline vecf vecf_min(vecf a, vecf b) {
#if VEC_AVX512
    return (vecf)_mm256_min_ps((__m256)a, (__m256)b);
#elif VEC_AVX2
    return (vecf)_mm_min_ps((__m128)a, (__m128)b);
#else
    for (int k = 0; k < VEC_LANES; k++) a[k] = a[k] < b[k] ? a[k] : b[k];
    return a;
#endif
}

static inline vecf vecf_sqrt(vecf a) {
#if VEC_AVX512
    return (vecf)_mm256_sqrt_ps((__m256)a);
#elif VEC_AVX2
    return (vecf)_mm_sqrt_ps((__m128)a);
#else
    return (vecf){__builtin_sqrtf(a[0]), __builtin_sqrtf(a[1])};
#endif
}

static inline float vecf_highest(vecf a) {
#if VEC_AVX512
    const vecf b = vecf_max(a, __builtin_shufflevector(a, a, 4, 5, 6, 7, 0, 1, 2, 3)),
               c = vecf_max(b, __builtin_shufflevector(b, b, 2, 3, 0, 1, 6, 7, 4, 5));
    return c[0] > c[1] ? c[0] : c[1];
#endif
    float m = a[0];
    for (int k = 1; k < VEC_LANES; k++) m = a[k] > m ? a[k] : m;
    return m;
}

static inline float vecf_lowest(vecf a) {
#if VEC_AVX512
    const vecf b = vecf_min(a, __builtin_shufflevector(a, a, 4, 5, 6, 7, 0, 1, 2, 3)),
               c = vecf_min(b, __builtin_shufflevector(b, b, 2, 3, 0, 1, 6, 7, 4, 5));
    return c[0] < c[1] ? c[0] : c[1];
#endif
    float m = a[0];
    for (int k = 1; k < VEC_LANES; k++) m = a[k] < m ? a[k] : m;
    return m;
}

/* In double. */
static inline double vecf_sum(vecf a) {
    double sum = 0;
    for (int k = 0; k < VEC_LANES; k++) sum += (double)a[k];
    return sum;
}

/* vecf4 and as many doubles. */
#ifdef FRANA_SCALAR

enum { VECF4_LANES = 1 };
typedef float vecf4;
typedef double vecf4_wide;

static inline vecf4 vecf4_set(float a) { return a; }
static inline vecf4 vecf4_of(vecf4_wide a) { return (float)a; }
static inline vecf4 vecf4_where(unsigned bits, vecf4 a) { return bits & 1 ? a : 0; }
static inline vecf4 vecf4_max(vecf4 a, vecf4 b) { return a > b ? a : b; }
static inline vecf4 vecf4_min(vecf4 a, vecf4 b) { return a < b ? a : b; }
static inline vecf4 vecf4_sqrt(vecf4 a) { return __builtin_sqrtf(a); }
static inline float vecf4_highest(vecf4 a) { return a; }
static inline float vecf4_lowest(vecf4 a) { return a; }
static inline double vecf4_sum(vecf4 a) { return (double)a; }

#else

enum { VECF4_LANES = 4 };
typedef float vecf4 __attribute__((vector_size(16)));
typedef int32_t vecf4_mask __attribute__((vector_size(16)));
typedef double vecf4_wide __attribute__((vector_size(32)));

static inline vecf4 vecf4_set(float a) { return (vecf4){a, a, a, a}; }

static inline vecf4 vecf4_of(vecf4_wide a) {
#    if VEC_AVX512 || VEC_AVX2
    return (vecf4)_mm256_cvtpd_ps((__m256d)a);
#    else
    return __builtin_convertvector(a, vecf4);
#    endif
}

static inline vecf4 vecf4_where(unsigned bits, vecf4 a) {
#    if VEC_AVX512
    return (vecf4)_mm_maskz_mov_ps((__mmask8)bits, (__m128)a);
#    else
    const int32_t b = (int32_t)bits;
    const vecf4_mask bit = {1, 2, 4, 8}, all = {b, b, b, b};
    return (vecf4)(((all & bit) == bit) & (vecf4_mask)a);
#    endif
}

static inline vecf4 vecf4_max(vecf4 a, vecf4 b) {
#    if VEC_AVX512 || VEC_AVX2
    return (vecf4)_mm_max_ps((__m128)a, (__m128)b);
#    else
    for (int k = 0; k < VECF4_LANES; k++) a[k] = a[k] > b[k] ? a[k] : b[k];
    return a;
#    endif
}

static inline vecf4 vecf4_min(vecf4 a, vecf4 b) {
#    if VEC_AVX512 || VEC_AVX2
    return (vecf4)_mm_min_ps((__m128)a, (__m128)b);
#    else
    for (int k = 0; k < VECF4_LANES; k++) a[k] = a[k] < b[k] ? a[k] : b[k];
    return a;
#    endif
}

static inline vecf4 vecf4_sqrt(vecf4 a) {
#    if VEC_AVX512 || VEC_AVX2
    return (vecf4)_mm_sqrt_ps((__m128)a);
#    else
    for (int k = 0; k < VECF4_LANES; k++) a[k] = __builtin_sqrtf(a[k]);
    return a;
#    endif
}

static inline float vecf4_highest(vecf4 a) {
    const float x = a[0] > a[1] ? a[0] : a[1], y = a[2] > a[3] ? a[2] : a[3];
    return x > y ? x : y;
}

static inline float vecf4_lowest(vecf4 a) {
    const float x = a[0] < a[1] ? a[0] : a[1], y = a[2] < a[3] ? a[2] : a[3];
    return x < y ? x : y;
}

/* In double. */
static inline double vecf4_sum(vecf4 a) { return ((double)a[0] + (double)a[1]) + ((double)a[2] + (double)a[3]); }

#endif

static inline vecf4 vecf4_load(const float *p) {
    vecf4 v;
    memcpy(&v, p, sizeof v);
    return v;
}
static inline void vecf4_store(float *p, vecf4 v) { memcpy(p, &v, sizeof v); }
static inline vecf4_wide vecf4_wide_load(const double *p) {
    vecf4_wide v;
    memcpy(&v, p, sizeof v);
    return v;
}
