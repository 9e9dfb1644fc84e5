/* What is done with a register of doubles (vec, base/vec_type.h); and with up to four of them (vec4, base/vec4.h). By
 * the vector extensions of gcc and clang, which compile to the machine's instructions. The program's few intrinsics are
 * here and in the headers beside this one.
 *
 * A kernel takes VEC_LANES numbers at a time from arrays whose layout is the same on every machine: blocks of eight are
 * one, two or four vecs. With FRANA_SCALAR there are no intrinsics, and vec4 is one double. */
#pragma once
#include "base/vec_type.h"
#include <string.h>
#if VEC_AVX512 || VEC_AVX2
#    include <immintrin.h>
#endif

/* Bits of the first n lanes; of all, if n is larger. */
static inline unsigned vec_first(long n) { return n < VEC_LANES ? (1u << n) - 1 : VEC_ALL; }

static inline vec vec_load(const double *p) {
    vec v;
    memcpy(&v, p, sizeof v);
    return v;
}
static inline void vec_store(double *p, vec v) { memcpy(p, &v, sizeof v); }

/* Non-temporal store (past the caches), for values that are not read again soon; p aligned to the size of a vec. */
static inline void vec_stream(double *p, vec v) {
#if VEC_AVX512
    _mm512_stream_pd(p, (__m512d)v);
#elif VEC_AVX2
    _mm256_stream_pd(p, (__m256d)v);
#else
    vec_store(p, v);
#endif
}

static inline vec vec_set(double a) { return (vec){VEC_EACH(a)}; }

/* Shifts by one lane: lane k of the result is lane k-1 of here; lane 0 is the last lane of before. */
static inline vec vec_before(vec before, vec here) { return __builtin_shufflevector(before, here, VEC_BEFORE); }

/* Lane k is all ones where bit k of bits is set, else 0. */
static inline vec_mask vec_mask_of_bits(unsigned bits) {
#if VEC_AVX512
    const vec_mask bit = {VEC_BITS}, all = {VEC_EACH(bits)};
    return (all & bit) == bit;
#elif VEC_AVX2 /* one load; without AVX2 a comparison of integers takes several instructions */
    static const vec_mask mask[1 << VEC_LANES] = {{0, 0, 0, 0},   {-1, 0, 0, 0},   {0, -1, 0, 0},   {-1, -1, 0, 0},
                                                  {0, 0, -1, 0},  {-1, 0, -1, 0},  {0, -1, -1, 0},  {-1, -1, -1, 0},
                                                  {0, 0, 0, -1},  {-1, 0, 0, -1},  {0, -1, 0, -1},  {-1, -1, 0, -1},
                                                  {0, 0, -1, -1}, {-1, 0, -1, -1}, {0, -1, -1, -1}, {-1, -1, -1, -1}};
    return mask[bits & VEC_ALL];
#else
    static const vec_mask mask[1 << VEC_LANES] = {{0, 0}, {-1, 0}, {0, -1}, {-1, -1}};
    return mask[bits & VEC_ALL];
#endif
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
#if VEC_AVX2
    return (vec)_mm256_blendv_pd((__m256d)b, (__m256d)a, (__m256d)mask);
#else
    return (vec)((mask & (vec_mask)a) | (~mask & (vec_mask)b));
#endif
}

static inline vec vec_max(vec a, vec b) {
#if VEC_AVX512
    return (vec)_mm512_max_pd((__m512d)a, (__m512d)b);
#elif VEC_AVX2
    return (vec)_mm256_max_pd((__m256d)a, (__m256d)b);
#else
    return vec_choose(a > b, a, b);
#endif
}

static inline vec vec_min(vec a, vec b) {
#if VEC_AVX512
    return (vec)_mm512_min_pd((__m512d)a, (__m512d)b);
#elif VEC_AVX2
    return (vec)_mm256_min_pd((__m256d)a, (__m256d)b);
#else
    return vec_choose(a < b, a, b);
#endif
}

static inline vec vec_sqrt(vec a) {
#if VEC_AVX512
    return (vec)_mm512_sqrt_pd((__m512d)a);
#elif VEC_AVX2
    return (vec)_mm256_sqrt_pd((__m256d)a);
#else
    return (vec){__builtin_sqrt(a[0]), __builtin_sqrt(a[1])};
#endif
}

static inline vec vec_floor(vec a) {
#if VEC_AVX512
    return (vec)_mm512_floor_pd((__m512d)a);
#elif VEC_AVX2
    return (vec)_mm256_floor_pd((__m256d)a);
#else
    return (vec){__builtin_floor(a[0]), __builtin_floor(a[1])};
#endif
}

/* Lanes that are whole numbers of less than 2^31, as integers. */
static inline vec_mask vec_whole(vec a) {
#if VEC_AVX512
    return (vec_mask)_mm512_cvtepi32_epi64(_mm512_cvttpd_epi32((__m512d)a));
#elif VEC_AVX2
    return (vec_mask)_mm256_cvtepi32_epi64(_mm256_cvttpd_epi32((__m256d)a));
#else
    return (vec_mask){(int64_t)a[0], (int64_t)a[1]};
#endif
}

/* c - a b, rounded once on machines with such an instruction. Of a b - c d a compiler may round either product by
 * itself, and not the same one at all places. */
static inline vec vec_less_product(vec c, vec a, vec b) {
#if VEC_AVX512
    return (vec)_mm512_fnmadd_pd((__m512d)a, (__m512d)b, (__m512d)c);
#elif VEC_AVX2 && defined __FMA__
    return (vec)_mm256_fnmadd_pd((__m256d)a, (__m256d)b, (__m256d)c);
#elif !VEC_AVX2 && defined __FP_FAST_FMA
    return (vec){__builtin_fma(-a[0], b[0], c[0]), __builtin_fma(-a[1], b[1], c[1])};
#else
    return c - a * b;
#endif
}

/* 1/a to one or two units in the last place, for a normal number a. With AVX-512 a division takes three times as
 * long. */
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
#elif VEC_AVX2
    const __m128d half = _mm_add_pd(_mm256_castpd256_pd128((__m256d)a), _mm256_extractf128_pd((__m256d)a, 1));
    return _mm_cvtsd_f64(_mm_add_sd(half, _mm_unpackhi_pd(half, half)));
#else
    return a[0] + a[1];
#endif
}

/* The larger of |a| and |b|. */
static inline vec vec_absmax(vec a, vec b) {
#if VEC_AVX512 && defined __AVX512DQ__
    return (vec)_mm512_range_pd((__m512d)a, (__m512d)b, 11);
#else
    const vec_mask digits = {VEC_EACH(INT64_MAX)};
    return vec_max((vec)((vec_mask)a & digits), (vec)((vec_mask)b & digits));
#endif
}

/* Whether a lane is above b or NaN. */
static inline int vec_any_above(vec a, double b) {
#if VEC_AVX512
    return _mm512_cmp_pd_mask((__m512d)a, _mm512_set1_pd(b), _CMP_NLE_UQ) != 0;
#elif VEC_AVX2
    return _mm256_movemask_pd(_mm256_cmp_pd((__m256d)a, _mm256_set1_pd(b), _CMP_NLE_UQ)) != 0;
#else
    return !(a[0] <= b) | !(a[1] <= b);
#endif
}

/* Bit k is the sign of lane k. */
static inline unsigned vec_signs(vec a) {
#if VEC_AVX512 && defined __AVX512DQ__
    return _mm512_movepi64_mask((__m512i)a);
#elif VEC_AVX2
    return (unsigned)_mm256_movemask_pd((__m256d)a);
#else
    unsigned bits = 0;
    for (int k = 0; k < VEC_LANES; k++) bits |= (unsigned)!!__builtin_signbit(a[k]) << k;
    return bits;
#endif
}

/* The power of two at or below a > 0; 0 for 0, infinity for NaN. */
static inline double vec_power_below(double a) {
    uint64_t bits;
    memcpy(&bits, &a, sizeof bits);
    bits &= UINT64_C(0x7ff) << 52;
    memcpy(&a, &bits, sizeof a);
    return a;
}

/* Lanes whose bit is set take p[0], p[1], ... in turn, the others 0; nothing more of p is read. */
static inline vec vec_expand(unsigned bits, const double *p) {
#if VEC_AVX512
    const __mmask8 first = (__mmask8)((1u << __builtin_popcount(bits)) - 1);
    return (vec)_mm512_maskz_expand_pd((__mmask8)bits, _mm512_maskz_loadu_pd(first, p));
#else
    vec a = {0};
    bits &= VEC_ALL;
    if (bits == VEC_ALL) return vec_load(p);
    for (; bits; bits &= bits - 1) a[__builtin_ctz(bits)] = *p++;
    return a;
#endif
}

/* The reverse: lanes whose bit is set are written to p[0], p[1], ... */
static inline void vec_compress(unsigned bits, vec v, double *p) {
#if VEC_AVX512
    const __mmask8 first = (__mmask8)((1u << __builtin_popcount(bits)) - 1);
    _mm512_mask_storeu_pd(p, first, _mm512_maskz_compress_pd((__mmask8)bits, (__m512d)v));
#else
    bits &= VEC_ALL;
    if (bits == VEC_ALL)
        vec_store(p, v);
    else
        for (; bits; bits &= bits - 1) *p++ = v[__builtin_ctz(bits)];
#endif
}

static inline vec vec_load_floats(const float *p) {
#if VEC_AVX512
    return (vec)_mm512_cvtps_pd(_mm256_loadu_ps(p));
#elif VEC_AVX2
    return (vec)_mm256_cvtps_pd(_mm_loadu_ps(p));
#else
    return (vec){(double)p[0], (double)p[1]};
#endif
}

/* Bit k is set where a[k] and b[k] differ; eight numbers each. */
static inline unsigned vec_differ(const int *a, const int *b) {
#if VEC_AVX512
    return _mm256_cmpneq_epi32_mask(_mm256_loadu_si256((const __m256i *)(const void *)a),
                                    _mm256_loadu_si256((const __m256i *)(const void *)b));
#elif VEC_AVX2
    const __m256i same = _mm256_cmpeq_epi32(_mm256_loadu_si256((const __m256i *)(const void *)a),
                                            _mm256_loadu_si256((const __m256i *)(const void *)b));
    return (unsigned)_mm256_movemask_ps(_mm256_castsi256_ps(same)) ^ 0xffu;
#else
    unsigned bits = 0;
    for (int k = 0; k < 8; k++) bits |= (unsigned)(a[k] != b[k]) << k;
    return bits;
#endif
}
