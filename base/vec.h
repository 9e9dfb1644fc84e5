/* Eight doubles at once, by the compilers' vector extensions: gcc and clang lower them to whatever the machine has. */
#pragma once
#include <stdint.h>
#include <string.h>
#ifdef __AVX512F__
#    include <immintrin.h>
#endif

enum { VEC_LANES = 8 };
typedef double vec __attribute__((vector_size(64)));
typedef int64_t vec_mask __attribute__((vector_size(64)));

static inline vec vec_load(const double *p) {
    vec v;
    memcpy(&v, p, sizeof v);
    return v;
}

static inline void vec_store(double *p, vec v) { memcpy(p, &v, sizeof v); }

static inline vec vec_set(double a) { return (vec){a, a, a, a, a, a, a, a}; }

/* Bit k of bits -> lane k all ones. */
static inline vec_mask vec_mask_of_bits(unsigned bits) {
    const vec_mask bit = {1, 2, 4, 8, 16, 32, 64, 128};
    const vec_mask all = {bits, bits, bits, bits, bits, bits, bits, bits};
    return (all & bit) != 0;
}

static inline vec vec_and(vec_mask m, vec v) { return (vec)(m & (vec_mask)v); }

/* a where a bit of bits is set, 0 elsewhere; one masked move with AVX-512. */
static inline vec vec_where(unsigned bits, vec a) {
#ifdef __AVX512F__
    return (vec)_mm512_maskz_mov_pd((__mmask8)bits, (__m512d)a);
#else
    return vec_and(vec_mask_of_bits(bits), a);
#endif
}

static inline vec vec_max(vec a, vec b) {
#ifdef __AVX512F__
    return (vec)_mm512_max_pd((__m512d)a, (__m512d)b);
#else
    for (int k = 0; k < VEC_LANES; k++) a[k] = a[k] > b[k] ? a[k] : b[k];
    return a;
#endif
}

static inline vec vec_min(vec a, vec b) {
#ifdef __AVX512F__
    return (vec)_mm512_min_pd((__m512d)a, (__m512d)b);
#else
    for (int k = 0; k < VEC_LANES; k++) a[k] = a[k] < b[k] ? a[k] : b[k];
    return a;
#endif
}

static inline vec vec_sqrt(vec a) {
#ifdef __AVX512F__
    return (vec)_mm512_sqrt_pd((__m512d)a);
#else
    for (int k = 0; k < VEC_LANES; k++) a[k] = __builtin_sqrt(a[k]);
    return a;
#endif
}

static inline double vec_highest(vec a) {
    double m = a[0];
    for (int k = 1; k < VEC_LANES; k++) m = a[k] > m ? a[k] : m;
    return m;
}

static inline double vec_lowest(vec a) {
    double m = a[0];
    for (int k = 1; k < VEC_LANES; k++) m = a[k] < m ? a[k] : m;
    return m;
}

static inline double vec_sum(vec a) {
    double sum = 0;
    for (int k = 0; k < VEC_LANES; k++) sum += a[k];
    return sum;
}
