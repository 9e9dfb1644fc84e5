/* AVX-512's instructions as loops, for tests of its kernels on a machine that has not got it: to be included before
 * everything else (-include). Those that base/ uses. */
#pragma once
#include <immintrin.h>
#include <math.h>
#include <string.h>

#define __AVX512F__ 1
#define __AVX512VL__ 1
#define __AVX512DQ__ 1

#define FAKE static inline __attribute__((unused))

/* Each lane of an eight: r[k] = value. */
#define FAKE_EACH(type, value)                                                                                         \
    type r = {0};                                                                                                      \
    for (int k = 0; k < 8; k++) r[k] = (value);                                                                        \
    return r

FAKE __m512d fake_set1(double a) { FAKE_EACH(__m512d, a); }
FAKE __m512d fake_max(__m512d a, __m512d b) { FAKE_EACH(__m512d, a[k] > b[k] ? a[k] : b[k]); }
FAKE __m512d fake_min(__m512d a, __m512d b) { FAKE_EACH(__m512d, a[k] < b[k] ? a[k] : b[k]); }
FAKE __m512d fake_sqrt(__m512d a) { FAKE_EACH(__m512d, sqrt(a[k])); }
FAKE __m512d fake_floor(__m512d a) { FAKE_EACH(__m512d, floor(a[k])); }
FAKE __m512d fake_fnmadd(__m512d a, __m512d b, __m512d c) { FAKE_EACH(__m512d, fma(-a[k], b[k], c[k])); }
FAKE __m512d fake_rcp14(__m512d a) { FAKE_EACH(__m512d, (1 + 0x1p-15) / a[k]); }
FAKE __m512d fake_range(__m512d a, __m512d b) { FAKE_EACH(__m512d, fmax(fabs(a[k]), fabs(b[k]))); }
FAKE __m512d fake_maskz_mov(__mmask8 bits, __m512d a) { FAKE_EACH(__m512d, bits >> k & 1 ? a[k] : 0); }
FAKE __m512d fake_permutexvar(__m512i at, __m512d a) { FAKE_EACH(__m512d, a[at[k] & 7]); }
FAKE __m512d fake_unpacklo(__m512d a, __m512d b) { FAKE_EACH(__m512d, k % 2 ? b[k - 1] : a[k]); }
FAKE __m512d fake_unpackhi(__m512d a, __m512d b) { FAKE_EACH(__m512d, k % 2 ? b[k] : a[k + 1]); }
FAKE __m512d fake_shuffle_f64x2(__m512d a, __m512d b, int how) {
    FAKE_EACH(__m512d, (k < 4 ? a : b)[2 * (how >> k / 2 * 2 & 3) + k % 2]);
}
FAKE __m512d fake_from_pairs(__m128d a) { FAKE_EACH(__m512d, k < 2 ? a[k] : 0); }
FAKE __m512d fake_from_fours(__m256d a) { FAKE_EACH(__m512d, k < 4 ? a[k] : 0); }
FAKE __m512d fake_insertf64x4(__m512d a, __m256d b, int half) { FAKE_EACH(__m512d, k / 4 == half ? b[k % 4] : a[k]); }
FAKE __m512d fake_mask_broadcast_f64x2(__m512d a, __mmask8 bits, __m128d b) {
    FAKE_EACH(__m512d, bits >> k & 1 ? b[k % 2] : a[k]);
}
FAKE __m512d fake_maskz_loadu(__mmask8 bits, const double *p) { FAKE_EACH(__m512d, bits >> k & 1 ? p[k] : 0); }
FAKE __m512d fake_maskz_expand(__mmask8 bits, __m512d a) {
    FAKE_EACH(__m512d, bits >> k & 1 ? a[__builtin_popcount(bits & ((1u << k) - 1))] : 0);
}
FAKE __m512d fake_maskz_compress(__mmask8 bits, __m512d a) {
    __m512d r = {0};
    for (int k = 0, n = 0; k < 8; k++)
        if (bits >> k & 1) r[n++] = a[k];
    return r;
}
FAKE void fake_mask_storeu(double *p, __mmask8 bits, __m512d a) {
    for (int k = 0; k < 8; k++)
        if (bits >> k & 1) p[k] = a[k];
}
FAKE void fake_stream(double *p, __m512d a) { memcpy(p, &a, sizeof a); }
FAKE __m512d fake_cvtps(__m256 a) { FAKE_EACH(__m512d, (double)a[k]); }
FAKE __m256 fake_cvtpd(__m512d a) { FAKE_EACH(__m256, (float)a[k]); }
FAKE __m256i fake_cvttpd(__m512d a) {
    int r[8];
    for (int k = 0; k < 8; k++) r[k] = (int)a[k];
    return _mm256_loadu_si256((const __m256i *)(const void *)r);
}
FAKE __m512i fake_cvtepi32(__m256i a) {
    int lanes[8];
    memcpy(lanes, &a, sizeof lanes);
    FAKE_EACH(__m512i, lanes[k]);
}
FAKE __mmask8 fake_movepi64(__m512i a) {
    unsigned bits = 0;
    for (int k = 0; k < 8; k++) bits |= (unsigned)(a[k] < 0) << k;
    return (__mmask8)bits;
}
FAKE __mmask8 fake_not_below(__m512d a, __m512d b) {
    unsigned bits = 0;
    for (int k = 0; k < 8; k++) bits |= (unsigned)!(a[k] <= b[k]) << k;
    return (__mmask8)bits;
}
FAKE double fake_reduce_max(__m512d a) {
    double most = a[0];
    for (int k = 1; k < 8; k++) most = a[k] > most ? a[k] : most;
    return most;
}
FAKE double fake_reduce_min(__m512d a) {
    double least = a[0];
    for (int k = 1; k < 8; k++) least = a[k] < least ? a[k] : least;
    return least;
}
FAKE double fake_reduce_add(__m512d a) {
    double four[4];
    for (int k = 0; k < 4; k++) four[k] = a[k] + a[k + 4];
    return (four[0] + four[2]) + (four[1] + four[3]);
}
FAKE __mmask8 fake_four_not_below(__m256d a, __m256d b) {
    return (__mmask8)_mm256_movemask_pd(_mm256_cmp_pd(a, b, _CMP_NLE_UQ));
}
FAKE __mmask8 fake_differ(__m256i a, __m256i b) {
    return (__mmask8)(_mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpeq_epi32(a, b))) ^ 255);
}
FAKE __m256d fake_four_maskz_mov(__mmask8 bits, __m256d a) {
    for (int k = 0; k < 4; k++) a[k] = bits >> k & 1 ? a[k] : 0;
    return a;
}
FAKE __m256 fake_singles_maskz_mov(__mmask8 bits, __m256 a) {
    for (int k = 0; k < 8; k++) a[k] = bits >> k & 1 ? a[k] : 0;
    return a;
}
FAKE __m128 fake_four_singles_maskz_mov(__mmask8 bits, __m128 a) {
    for (int k = 0; k < 4; k++) a[k] = bits >> k & 1 ? a[k] : 0;
    return a;
}

#undef _mm512_set1_pd
#define _mm512_set1_pd fake_set1
#undef _mm512_max_pd
#define _mm512_max_pd fake_max
#undef _mm512_min_pd
#define _mm512_min_pd fake_min
#undef _mm512_sqrt_pd
#define _mm512_sqrt_pd fake_sqrt
#undef _mm512_floor_pd
#define _mm512_floor_pd fake_floor
#undef _mm512_fnmadd_pd
#define _mm512_fnmadd_pd fake_fnmadd
#undef _mm512_rcp14_pd
#define _mm512_rcp14_pd fake_rcp14
#undef _mm512_range_pd
#define _mm512_range_pd(a, b, how) fake_range(a, b) /* how: 11, the larger size */
#undef _mm512_maskz_mov_pd
#define _mm512_maskz_mov_pd fake_maskz_mov
#undef _mm512_permutexvar_pd
#define _mm512_permutexvar_pd fake_permutexvar
#undef _mm512_unpacklo_pd
#define _mm512_unpacklo_pd fake_unpacklo
#undef _mm512_unpackhi_pd
#define _mm512_unpackhi_pd fake_unpackhi
#undef _mm512_shuffle_f64x2
#define _mm512_shuffle_f64x2 fake_shuffle_f64x2
#undef _mm512_castpd128_pd512
#define _mm512_castpd128_pd512 fake_from_pairs
#undef _mm512_castpd256_pd512
#define _mm512_castpd256_pd512 fake_from_fours
#undef _mm512_insertf64x4
#define _mm512_insertf64x4 fake_insertf64x4
#undef _mm512_mask_broadcast_f64x2
#define _mm512_mask_broadcast_f64x2 fake_mask_broadcast_f64x2
#undef _mm512_maskz_loadu_pd
#define _mm512_maskz_loadu_pd(bits, p) fake_maskz_loadu(bits, p)
#undef _mm512_maskz_expand_pd
#define _mm512_maskz_expand_pd fake_maskz_expand
#undef _mm512_maskz_compress_pd
#define _mm512_maskz_compress_pd fake_maskz_compress
#undef _mm512_mask_storeu_pd
#define _mm512_mask_storeu_pd(p, bits, a) fake_mask_storeu(p, bits, a)
#undef _mm512_stream_pd
#define _mm512_stream_pd fake_stream
#undef _mm512_cvtps_pd
#define _mm512_cvtps_pd fake_cvtps
#undef _mm512_cvtpd_ps
#define _mm512_cvtpd_ps fake_cvtpd
#undef _mm512_cvttpd_epi32
#define _mm512_cvttpd_epi32 fake_cvttpd
#undef _mm512_cvtepi32_epi64
#define _mm512_cvtepi32_epi64 fake_cvtepi32
#undef _mm512_movepi64_mask
#define _mm512_movepi64_mask fake_movepi64
#undef _mm512_cmp_pd_mask
#define _mm512_cmp_pd_mask(a, b, how) fake_not_below(a, b) /* how: _CMP_NLE_UQ */
#undef _mm512_reduce_max_pd
#define _mm512_reduce_max_pd fake_reduce_max
#undef _mm512_reduce_min_pd
#define _mm512_reduce_min_pd fake_reduce_min
#undef _mm512_reduce_add_pd
#define _mm512_reduce_add_pd fake_reduce_add
#undef _mm256_cmp_pd_mask
#define _mm256_cmp_pd_mask(a, b, how) fake_four_not_below(a, b)
#undef _mm256_cmpneq_epi32_mask
#define _mm256_cmpneq_epi32_mask fake_differ
#undef _mm256_maskz_mov_pd
#define _mm256_maskz_mov_pd fake_four_maskz_mov
#undef _mm256_maskz_mov_ps
#define _mm256_maskz_mov_ps fake_singles_maskz_mov
#undef _mm_maskz_mov_ps
#define _mm_maskz_mov_ps fake_four_singles_maskz_mov
