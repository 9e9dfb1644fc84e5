/* Moves lanes between vectors and memory: transposes, and rows of a few numbers at scattered places. */
#pragma once
#include "base/vec.h"

#if VEC_AVX512
#    define VEC_AFTER 1, 2, 3, 4, 5, 6, 7, 8
#elif VEC_AVX2
#    define VEC_AFTER 1, 2, 3, 4
#else
#    define VEC_AFTER 1, 2
#endif

/* Shifts by one lane: lane k of the result is lane k+1 of here; the last lane is the first lane of next. */
static inline vec vec_shuffle_after(vec here, vec next) { return __builtin_shufflevector(here, next, VEC_AFTER); }

/* Lane l of v[k] becomes lane k of v[l]. */
static inline __attribute__((always_inline)) void vec_shuffle_transpose(vec v[VEC_LANES]) {
#if VEC_AVX512
    vec lane[VEC_LANES], pair[VEC_LANES];
    for (int k = 0; k < 8; k += 2) { /* lanes 0 2 4 6 of two vectors; lanes 1 3 5 7 */
        lane[k] = __builtin_shufflevector(v[k], v[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        lane[k + 1] = __builtin_shufflevector(v[k], v[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int odd = 0; odd < 2; odd++)
        for (int k = 0; k < 8; k += 4) { /* lanes 0 and 4 of four vectors; lanes 2 and 6 */
            pair[k + odd] = __builtin_shufflevector(lane[k + odd], lane[k + odd + 2], 0, 1, 4, 5, 8, 9, 12, 13);
            pair[k + odd + 2] = __builtin_shufflevector(lane[k + odd], lane[k + odd + 2], 2, 3, 6, 7, 10, 11, 14, 15);
        }
    for (int l = 0; l < 4; l++) {
        v[l] = __builtin_shufflevector(pair[l], pair[l + 4], 0, 1, 4, 5, 8, 9, 12, 13);
        v[l + 4] = __builtin_shufflevector(pair[l], pair[l + 4], 2, 3, 6, 7, 10, 11, 14, 15);
    }
#elif VEC_AVX2
    const vec even01 = __builtin_shufflevector(v[0], v[1], 0, 4, 2, 6),
              odd01 = __builtin_shufflevector(v[0], v[1], 1, 5, 3, 7),
              even23 = __builtin_shufflevector(v[2], v[3], 0, 4, 2, 6),
              odd23 = __builtin_shufflevector(v[2], v[3], 1, 5, 3, 7);
    v[0] = __builtin_shufflevector(even01, even23, 0, 1, 4, 5);
    v[1] = __builtin_shufflevector(odd01, odd23, 0, 1, 4, 5);
    v[2] = __builtin_shufflevector(even01, even23, 2, 3, 6, 7);
    v[3] = __builtin_shufflevector(odd01, odd23, 2, 3, 6, 7);
#else
    const vec even = __builtin_shufflevector(v[0], v[1], 0, 2), odd = __builtin_shufflevector(v[0], v[1], 1, 3);
    v[0] = even;
    v[1] = odd;
#endif
}

/* Lane k is p[at[k]], one of four numbers. */
static inline vec vec_shuffle_pick(const double *p, const int *at) {
#if VEC_AVX512
    const __m512i from = _mm512_cvtepi32_epi64(_mm256_loadu_si256((const __m256i *)(const void *)at));
    return (vec)_mm512_permutexvar_pd(from, _mm512_castpd256_pd512(_mm256_loadu_pd(p)));
#elif VEC_AVX2
    return (vec){p[at[0]], p[at[1]], p[at[2]], p[at[3]]};
#else
    return (vec){p[at[0]], p[at[1]]};
#endif
}

/* Two numbers from each of VEC_LANES places: lane k of v[c] is p[at[k] + c]. */
static inline void vec_shuffle_gather2(const double *p, const int *at, vec v[2]) {
#if VEC_AVX512 && defined __AVX512DQ__
    __m512d pairs[2]; /* [0] of the even places, [1] of the odd ones; masked loads do not use the shuffle units */
    for (int odd = 0; odd < 2; odd++) {
        pairs[odd] = _mm512_castpd128_pd512(_mm_loadu_pd(p + at[odd]));
        pairs[odd] = _mm512_mask_broadcast_f64x2(pairs[odd], 0x0c, _mm_loadu_pd(p + at[2 + odd]));
        pairs[odd] = _mm512_mask_broadcast_f64x2(pairs[odd], 0x30, _mm_loadu_pd(p + at[4 + odd]));
        pairs[odd] = _mm512_mask_broadcast_f64x2(pairs[odd], 0xc0, _mm_loadu_pd(p + at[6 + odd]));
    }
    v[0] = (vec)_mm512_unpacklo_pd(pairs[0], pairs[1]);
    v[1] = (vec)_mm512_unpackhi_pd(pairs[0], pairs[1]);
#elif VEC_AVX2
    const __m256d even =
                      _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(p + at[0])), _mm_loadu_pd(p + at[2]), 1),
                  odd =
                      _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(p + at[1])), _mm_loadu_pd(p + at[3]), 1);
    v[0] = (vec)_mm256_unpacklo_pd(even, odd);
    v[1] = (vec)_mm256_unpackhi_pd(even, odd);
#else
    for (int c = 0; c < 2; c++) v[c] = (vec){p[at[0] + c], p[at[1] + c]};
#endif
}

#if VEC_AVX512
/* Four numbers from each of two places. */
static inline __m512d vec_shuffle_two4(const double *lower, const double *upper) {
    return _mm512_insertf64x4(_mm512_castpd256_pd512(_mm256_loadu_pd(lower)), _mm256_loadu_pd(upper), 1);
}
/* Turns rows of four numbers, of the places 0 and 2, 1 and 3, 4 and 6, 5 and 7, to v[c] of all places. */
static inline void vec_shuffle_columns4(const __m512d pair[4], vec v[4]) {
    const __m512d even01 = _mm512_unpacklo_pd(pair[0], pair[1]), odd01 = _mm512_unpackhi_pd(pair[0], pair[1]);
    const __m512d even23 = _mm512_unpacklo_pd(pair[2], pair[3]), odd23 = _mm512_unpackhi_pd(pair[2], pair[3]);
    v[0] = (vec)_mm512_shuffle_f64x2(even01, even23, 0x88);
    v[1] = (vec)_mm512_shuffle_f64x2(odd01, odd23, 0x88);
    v[2] = (vec)_mm512_shuffle_f64x2(even01, even23, 0xdd);
    v[3] = (vec)_mm512_shuffle_f64x2(odd01, odd23, 0xdd);
}
#endif

/* Four numbers from each of VEC_LANES places: lane k of v[c] is p[stride at[k] + c]. */
static inline void vec_shuffle_gather4(const double *p, int stride, const int *at, vec v[4]) {
    const long s = stride;
#if VEC_AVX512
    const __m512d pair[4] = {
        vec_shuffle_two4(p + s * at[0], p + s * at[2]), vec_shuffle_two4(p + s * at[1], p + s * at[3]),
        vec_shuffle_two4(p + s * at[4], p + s * at[6]), vec_shuffle_two4(p + s * at[5], p + s * at[7])};
    vec_shuffle_columns4(pair, v);
#elif VEC_AVX2
    __m256d pair[4]; /* halves of two places each: the loads of the second do not use the shuffle units */
    for (int half = 0; half < 2; half++)
        for (int i = 0; i < 2; i++)
            pair[2 * half + i] = _mm256_insertf128_pd(_mm256_castpd128_pd256(_mm_loadu_pd(p + s * at[i] + 2 * half)),
                                                      _mm_loadu_pd(p + s * at[i + 2] + 2 * half), 1);
    for (int half = 0; half < 2; half++) {
        v[2 * half] = (vec)_mm256_unpacklo_pd(pair[2 * half], pair[2 * half + 1]);
        v[2 * half + 1] = (vec)_mm256_unpackhi_pd(pair[2 * half], pair[2 * half + 1]);
    }
#else
    for (int c = 0; c < 4; c++) v[c] = (vec){p[s * at[0] + c], p[s * at[1] + c]};
#endif
}

/* vec_shuffle_gather4 of the places h minus that of the places l. */
static inline void vec_shuffle_between4(const double *p, int stride, const int *h, const int *l, vec v[4]) {
#if VEC_AVX512
    static const int first[4] = {0, 1, 4, 5}; /* subtracted before the columns are made of them */
    const long s = stride;
    __m512d pair[4];
    for (int i = 0; i < 4; i++) {
        const int k = first[i], m = first[i] + 2;
        pair[i] = vec_shuffle_two4(p + s * h[k], p + s * h[m]) - vec_shuffle_two4(p + s * l[k], p + s * l[m]);
    }
    vec_shuffle_columns4(pair, v);
#else
    vec of_l[4];
    vec_shuffle_gather4(p, stride, h, v);
    vec_shuffle_gather4(p, stride, l, of_l);
    for (int c = 0; c < 4; c++) v[c] -= of_l[c];
#endif
}

/* VEC_LANES rows of three numbers, one after another: p[3 k + c] <- lane k of v[c]. */
static inline void vec_shuffle_store3(double *p, const vec v[3]) {
#if VEC_AVX512
    const vec a = __builtin_shufflevector(v[0], v[1], 0, 8, 0, 1, 9, 0, 2, 10);
    const vec b = __builtin_shufflevector(v[0], v[1], 0, 3, 11, 0, 4, 12, 0, 5);
    const vec c = __builtin_shufflevector(v[0], v[1], 13, 0, 6, 14, 0, 7, 15, 0);
    vec_store(p, __builtin_shufflevector(a, v[2], 0, 1, 8, 3, 4, 9, 6, 7));
    vec_store(p + 8, __builtin_shufflevector(b, v[2], 10, 1, 2, 11, 4, 5, 12, 7));
    vec_store(p + 16, __builtin_shufflevector(c, v[2], 0, 13, 2, 3, 14, 5, 6, 15));
#else
    for (int k = 0; k < VEC_LANES; k++)
        for (int c = 0; c < 3; c++) p[3 * k + c] = v[c][k];
#endif
}

/* VEC_LANES rows of four numbers: p[4 k + c] <- lane k of v[c]. */
static inline void vec_shuffle_store4(double *p, const vec v[4]) {
#if VEC_AVX512
    for (int half = 0; half < 2; half++) {
        const vec a = half ? __builtin_shufflevector(v[0], v[1], 4, 12, 5, 13, 6, 14, 7, 15)
                           : __builtin_shufflevector(v[0], v[1], 0, 8, 1, 9, 2, 10, 3, 11);
        const vec b = half ? __builtin_shufflevector(v[2], v[3], 4, 12, 5, 13, 6, 14, 7, 15)
                           : __builtin_shufflevector(v[2], v[3], 0, 8, 1, 9, 2, 10, 3, 11);
        vec_store(p + 16 * half, __builtin_shufflevector(a, b, 0, 1, 8, 9, 2, 3, 10, 11));
        vec_store(p + 16 * half + 8, __builtin_shufflevector(a, b, 4, 5, 12, 13, 6, 7, 14, 15));
    }
#elif VEC_AVX2
    vec row[4] = {v[0], v[1], v[2], v[3]};
    vec_shuffle_transpose(row);
    for (int k = 0; k < VEC_LANES; k++) vec_store(p + 4 * k, row[k]);
#else
    for (int k = 0; k < VEC_LANES; k++)
        for (int c = 0; c < 4; c++) p[4 * k + c] = v[c][k];
#endif
}
