/* Eight doubles at once (vec) and four (vec4), by the vector extensions of gcc and clang, which compile to the
 * machine's instructions. The program's few intrinsics are all here. With FRANA_SCALAR there are none, and vec4 is one
 * double: loops over vec4 advance by VEC4_LANES. */
#pragma once
#include <stdint.h>
#include <string.h>
#if defined __AVX512F__ && defined __AVX512VL__ && !defined FRANA_SCALAR
#    include <immintrin.h>
#    define VEC_AVX512 1
#else
#    define VEC_AVX512 0
#endif

enum { VEC_LANES = 8, VEC_IS_NATIVE = VEC_AVX512 }; /* native: a vec is one register */
typedef double vec __attribute__((vector_size(64)));
typedef int64_t vec_mask __attribute__((vector_size(64)));
#ifdef FRANA_SCALAR
enum { VEC4_LANES = 1 };
typedef double vec4;
#else
enum { VEC4_LANES = 4 };
typedef double vec4 __attribute__((vector_size(32)));
typedef int64_t vec4_mask __attribute__((vector_size(32)));
#endif

static inline vec vec_load(const double *p) {
    vec v;
    memcpy(&v, p, sizeof v);
    return v;
}
static inline vec4 vec4_load(const double *p) {
    vec4 v;
    memcpy(&v, p, sizeof v);
    return v;
}
static inline void vec_store(double *p, vec v) { memcpy(p, &v, sizeof v); }
static inline void vec4_store(double *p, vec4 v) { memcpy(p, &v, sizeof v); }

/* Non-temporal store (past the caches), for values that are not read again soon; p aligned to 64 bytes. */
static inline void vec_stream(double *p, vec v) {
#if VEC_AVX512
    _mm512_stream_pd(p, (__m512d)v);
#else
    vec_store(p, v);
#endif
}

static inline vec vec_set(double a) { return (vec){a, a, a, a, a, a, a, a}; }

/* Shifts by one lane: lane k of the result is lane k-1 of here; lane 0 is the last lane of before. */
static inline vec vec_before(vec before, vec here) {
    return __builtin_shufflevector(before, here, 7, 8, 9, 10, 11, 12, 13, 14);
}

/* Lane k is all ones where bit k of bits is set, else 0. */
static inline vec_mask vec_mask_of_bits(unsigned bits) {
    const vec_mask bit = {1, 2, 4, 8, 16, 32, 64, 128};
    const vec_mask all = {bits, bits, bits, bits, bits, bits, bits, bits};
    return (all & bit) != 0;
}

/* a where a bit of bits is set, 0 elsewhere; one masked move with AVX-512. */
static inline vec vec_where(unsigned bits, vec a) {
#if VEC_AVX512
    return (vec)_mm512_maskz_mov_pd((__mmask8)bits, (__m512d)a);
#else
    return (vec)(vec_mask_of_bits(bits) & (vec_mask)a);
#endif
}

/* a where the lane of the mask is all ones, b where it is 0. */
static inline vec vec_choose(vec_mask mask, vec a, vec b) {
    return (vec)((mask & (vec_mask)a) | (~mask & (vec_mask)b));
}

static inline vec vec_max(vec a, vec b) {
#if VEC_AVX512
    return (vec)_mm512_max_pd((__m512d)a, (__m512d)b);
#else
    for (int k = 0; k < VEC_LANES; k++) a[k] = a[k] > b[k] ? a[k] : b[k];
    return a;
#endif
}

static inline vec vec_min(vec a, vec b) {
#if VEC_AVX512
    return (vec)_mm512_min_pd((__m512d)a, (__m512d)b);
#else
    for (int k = 0; k < VEC_LANES; k++) a[k] = a[k] < b[k] ? a[k] : b[k];
    return a;
#endif
}

static inline vec vec_sqrt(vec a) {
#if VEC_AVX512
    return (vec)_mm512_sqrt_pd((__m512d)a);
#else
    for (int k = 0; k < VEC_LANES; k++) a[k] = __builtin_sqrt(a[k]);
    return a;
#endif
}

#ifdef FRANA_SCALAR

static inline vec4 vec4_set(double a) { return a; }
static inline vec4 vec4_where(unsigned bits, vec4 a) { return bits & 1 ? a : 0; }
static inline vec4 vec4_max(vec4 a, vec4 b) { return a > b ? a : b; }
static inline vec4 vec4_min(vec4 a, vec4 b) { return a < b ? a : b; }
static inline vec4 vec4_sqrt(vec4 a) { return __builtin_sqrt(a); }
static inline double vec4_highest(vec4 a) { return a; }
static inline double vec4_lowest(vec4 a) { return a; }
static inline double vec4_sum(vec4 a) { return a; }
static inline int vec4_any_above(vec4 a, double b) { return !(a <= b); }

#else

static inline vec4 vec4_set(double a) { return (vec4){a, a, a, a}; }

static inline vec4_mask vec4_mask_of_bits(unsigned bits) {
    const vec4_mask bit = {1, 2, 4, 8};
    const vec4_mask all = {bits, bits, bits, bits};
    return (all & bit) != 0;
}

static inline vec4 vec4_where(unsigned bits, vec4 a) {
#    if VEC_AVX512
    return (vec4)_mm256_maskz_mov_pd((__mmask8)bits, (__m256d)a);
#    else
    return (vec4)(vec4_mask_of_bits(bits) & (vec4_mask)a);
#    endif
}

static inline vec4 vec4_max(vec4 a, vec4 b) {
#    if VEC_AVX512
    return (vec4)_mm256_max_pd((__m256d)a, (__m256d)b);
#    else
    for (int k = 0; k < VEC4_LANES; k++) a[k] = a[k] > b[k] ? a[k] : b[k];
    return a;
#    endif
}

static inline vec4 vec4_min(vec4 a, vec4 b) {
#    if VEC_AVX512
    return (vec4)_mm256_min_pd((__m256d)a, (__m256d)b);
#    else
    for (int k = 0; k < VEC4_LANES; k++) a[k] = a[k] < b[k] ? a[k] : b[k];
    return a;
#    endif
}

static inline vec4 vec4_sqrt(vec4 a) {
#    if VEC_AVX512
    return (vec4)_mm256_sqrt_pd((__m256d)a);
#    else
    for (int k = 0; k < VEC4_LANES; k++) a[k] = __builtin_sqrt(a[k]);
    return a;
#    endif
}

static inline double vec4_highest(vec4 a) {
    const double x = a[0] > a[1] ? a[0] : a[1], y = a[2] > a[3] ? a[2] : a[3];
    return x > y ? x : y;
}

static inline double vec4_lowest(vec4 a) {
    const double x = a[0] < a[1] ? a[0] : a[1], y = a[2] < a[3] ? a[2] : a[3];
    return x < y ? x : y;
}

static inline double vec4_sum(vec4 a) { return (a[0] + a[1]) + (a[2] + a[3]); }

#endif

/* 1/a to one or two units in the last place, for a normal number a; a division takes three times as long. */
static inline vec vec_reciprocal(vec a) {
#if VEC_AVX512
    vec r = (vec)_mm512_rcp14_pd((__m512d)a); /* correct to 14 bits; a Newton step doubles them: 28, 56 */
    r += r * (1 - a * r);
    return r + r * (1 - a * r);
#else
    return 1 / a;
#endif
}

static inline double vec_highest(vec a) {
#if VEC_AVX512
    return _mm512_reduce_max_pd((__m512d)a);
#endif
    double m = a[0];
    for (int k = 1; k < VEC_LANES; k++) m = a[k] > m ? a[k] : m;
    return m;
}

static inline double vec_lowest(vec a) {
#if VEC_AVX512
    return _mm512_reduce_min_pd((__m512d)a);
#endif
    double m = a[0];
    for (int k = 1; k < VEC_LANES; k++) m = a[k] < m ? a[k] : m;
    return m;
}

static inline double vec_sum(vec a) {
    double sum = 0;
    for (int k = 0; k < VEC_LANES; k++) sum += a[k];
    return sum;
}

/* The sum of the lanes in the fastest order: for numbers whose sums are exact. */
static inline double vec_total(vec a) {
#if VEC_AVX512
    return _mm512_reduce_add_pd((__m512d)a);
#else
    double sum[4];
    for (int k = 0; k < 4; k++) sum[k] = a[k] + a[k + 4];
    return (sum[0] + sum[2]) + (sum[1] + sum[3]);
#endif
}

/* The larger of |a| and |b|. */
static inline vec vec_absmax(vec a, vec b) {
#if VEC_AVX512 && defined __AVX512DQ__
    return (vec)_mm512_range_pd((__m512d)a, (__m512d)b, 11);
#else
    const vec_mask digits = (vec_mask){-1, -1, -1, -1, -1, -1, -1, -1} & INT64_MAX;
    return vec_max((vec)((vec_mask)a & digits), (vec)((vec_mask)b & digits));
#endif
}

/* Whether a lane is above b or NaN. */
static inline int vec_any_above(vec a, double b) {
#if VEC_AVX512
    return _mm512_cmp_pd_mask((__m512d)a, _mm512_set1_pd(b), _CMP_NLE_UQ) != 0;
#else
    int any = 0;
    for (int k = 0; k < VEC_LANES; k++) any |= !(a[k] <= b);
    return any;
#endif
}

#ifndef FRANA_SCALAR
static inline int vec4_any_above(vec4 a, double b) {
#    if VEC_AVX512
    return _mm256_cmp_pd_mask((__m256d)a, _mm256_set1_pd(b), _CMP_NLE_UQ) != 0;
#    else
    int any = 0;
    for (int k = 0; k < VEC4_LANES; k++) any |= !(a[k] <= b);
    return any;
#    endif
}
#endif

/* The power of two at or below a > 0; 0 for 0, infinity for NaN. */
static inline double vec_power_below(double a) {
    uint64_t bits;
    memcpy(&bits, &a, sizeof bits);
    bits &= UINT64_C(0x7ff) << 52;
    memcpy(&a, &bits, sizeof a);
    return a;
}

/* Lanes whose bit is set take p[0], p[1], ... in turn, the others 0; nothing more of p is read. */
static inline vec vec_spread(unsigned bits, const double *p) {
#if VEC_AVX512
    const __mmask8 first = (__mmask8)((1u << __builtin_popcount(bits)) - 1);
    return (vec)_mm512_maskz_expand_pd((__mmask8)bits, _mm512_maskz_loadu_pd(first, p));
#else
    double a[VEC_LANES] = {0};
    for (; bits; bits &= bits - 1) a[__builtin_ctz(bits)] = *p++;
    return vec_load(a);
#endif
}

/* The reverse: lanes whose bit is set are written to p[0], p[1], ... */
static inline void vec_press(unsigned bits, vec v, double *p) {
#if VEC_AVX512
    const __mmask8 first = (__mmask8)((1u << __builtin_popcount(bits)) - 1);
    _mm512_mask_storeu_pd(p, first, _mm512_maskz_compress_pd((__mmask8)bits, (__m512d)v));
#else
    for (; bits; bits &= bits - 1) *p++ = v[__builtin_ctz(bits)];
#endif
}

static inline vec vec_load_floats(const float *p) {
#if VEC_AVX512
    return (vec)_mm512_cvtps_pd(_mm256_loadu_ps(p));
#else
    vec v;
    for (int k = 0; k < VEC_LANES; k++) v[k] = (double)p[k];
    return v;
#endif
}

/* Bit k is the sign of lane k. */
static inline unsigned vec_signs(vec a) {
#if VEC_AVX512 && defined __AVX512DQ__
    return _mm512_movepi64_mask((__m512i)a);
#else
    unsigned bits = 0;
    for (int k = 0; k < VEC_LANES; k++) bits |= (unsigned)__builtin_signbit(a[k]) << k;
    return bits;
#endif
}

/* Two numbers from each of eight places: lane k of v[c] is p[at[k] + c]. */
static inline void vec_gather2(const double *p, const int *at, vec v[2]) {
#if VEC_AVX512 && defined __AVX512DQ__
    __m512d of[2]; /* [0] of the even places, [1] of the odd ones; masked loads do not use the shuffle units */
    for (int odd = 0; odd < 2; odd++) {
        of[odd] = _mm512_castpd128_pd512(_mm_loadu_pd(p + at[odd]));
        of[odd] = _mm512_mask_broadcast_f64x2(of[odd], 0x0c, _mm_loadu_pd(p + at[2 + odd]));
        of[odd] = _mm512_mask_broadcast_f64x2(of[odd], 0x30, _mm_loadu_pd(p + at[4 + odd]));
        of[odd] = _mm512_mask_broadcast_f64x2(of[odd], 0xc0, _mm_loadu_pd(p + at[6 + odd]));
    }
    v[0] = (vec)_mm512_unpacklo_pd(of[0], of[1]);
    v[1] = (vec)_mm512_unpackhi_pd(of[0], of[1]);
#else
    double t[2][VEC_LANES];
    for (int k = 0; k < VEC_LANES; k++)
        for (int c = 0; c < 2; c++) t[c][k] = p[at[k] + c];
    for (int c = 0; c < 2; c++) v[c] = vec_load(t[c]);
#endif
}

/* Four numbers from each of eight places: lane k of v[c] is p[stride at[k] + c]. */
static inline void vec_gather4(const double *p, int stride, const int *at, vec v[4]) {
#if VEC_AVX512
    static const int lower[4] = {0, 1, 4, 5}, upper[4] = {2, 3, 6, 7};
    __m512d pair[4]; /* paired so that the lanes are in order after the shuffles between halves */
    for (int i = 0; i < 4; i++)
        pair[i] = _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(p + (long)stride * at[lower[i]])),
                                     _mm256_loadu_pd(p + (long)stride * at[upper[i]]), 1);
    const __m512d even01 = _mm512_unpacklo_pd(pair[0], pair[1]), odd01 = _mm512_unpackhi_pd(pair[0], pair[1]);
    const __m512d even23 = _mm512_unpacklo_pd(pair[2], pair[3]), odd23 = _mm512_unpackhi_pd(pair[2], pair[3]);
    v[0] = (vec)_mm512_shuffle_f64x2(even01, even23, 0x88);
    v[1] = (vec)_mm512_shuffle_f64x2(odd01, odd23, 0x88);
    v[2] = (vec)_mm512_shuffle_f64x2(even01, even23, 0xdd);
    v[3] = (vec)_mm512_shuffle_f64x2(odd01, odd23, 0xdd);
#else
    double t[4][VEC_LANES];
    for (int k = 0; k < VEC_LANES; k++)
        for (int c = 0; c < 4; c++) t[c][k] = p[(long)stride * at[k] + c];
    for (int c = 0; c < 4; c++) v[c] = vec_load(t[c]);
#endif
}

/* Eight rows of three numbers, one after another: p[3 k + c] <- lane k of v[c]. */
static inline void vec_store3(double *p, const vec v[3]) {
    const vec a = __builtin_shufflevector(v[0], v[1], 0, 8, 0, 1, 9, 0, 2, 10);
    const vec b = __builtin_shufflevector(v[0], v[1], 0, 3, 11, 0, 4, 12, 0, 5);
    const vec c = __builtin_shufflevector(v[0], v[1], 13, 0, 6, 14, 0, 7, 15, 0);
    vec_store(p, __builtin_shufflevector(a, v[2], 0, 1, 8, 3, 4, 9, 6, 7));
    vec_store(p + 8, __builtin_shufflevector(b, v[2], 10, 1, 2, 11, 4, 5, 12, 7));
    vec_store(p + 16, __builtin_shufflevector(c, v[2], 0, 13, 2, 3, 14, 5, 6, 15));
}

/* Eight rows of four numbers: p[4 k + c] <- lane k of v[c]. */
static inline void vec_store4(double *p, const vec v[4]) {
    for (int half = 0; half < 2; half++) {
        const vec a = half ? __builtin_shufflevector(v[0], v[1], 4, 12, 5, 13, 6, 14, 7, 15)
                           : __builtin_shufflevector(v[0], v[1], 0, 8, 1, 9, 2, 10, 3, 11);
        const vec b = half ? __builtin_shufflevector(v[2], v[3], 4, 12, 5, 13, 6, 14, 7, 15)
                           : __builtin_shufflevector(v[2], v[3], 0, 8, 1, 9, 2, 10, 3, 11);
        vec_store(p + 16 * half, __builtin_shufflevector(a, b, 0, 1, 8, 9, 2, 3, 10, 11));
        vec_store(p + 16 * half + 8, __builtin_shufflevector(a, b, 4, 5, 12, 13, 6, 7, 14, 15));
    }
}

/* Bit k is set where a[k] and b[k] differ; eight numbers each. */
static inline unsigned vec_differ(const int *a, const int *b) {
#if VEC_AVX512
    return _mm256_cmpneq_epi32_mask(_mm256_loadu_si256((const __m256i *)(const void *)a),
                                    _mm256_loadu_si256((const __m256i *)(const void *)b));
#else
    unsigned bits = 0;
    for (int k = 0; k < VEC_LANES; k++) bits |= (unsigned)(a[k] != b[k]) << k;
    return bits;
#endif
}
