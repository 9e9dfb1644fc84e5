/* Up to four doubles (vec4), half a register with AVX-512 and one elsewhere: the namesakes of vec in base/vec.h, which
 * says what each does. With FRANA_SCALAR a vec4 is one double. Loops over vec4 advance by VEC4_LANES. */
#pragma once
#include "base/vec.h"

#ifdef FRANA_SCALAR

enum { VEC4_LANES = 1 };
typedef double vec4;

static inline vec4 vec4_set(double a) { return a; }
static inline vec4 vec4_where(unsigned bits, vec4 a) { return bits & 1 ? a : 0; }
static inline vec4 vec4_max(vec4 a, vec4 b) { return a > b ? a : b; }
static inline vec4 vec4_min(vec4 a, vec4 b) { return a < b ? a : b; }
static inline vec4 vec4_sqrt(vec4 a) { return __builtin_sqrt(a); }
static inline double vec4_highest(vec4 a) { return a; }
static inline double vec4_lowest(vec4 a) { return a; }
static inline double vec4_sum(vec4 a) { return a; }
static inline int vec4_any_above(vec4 a, double b) { return !(a <= b); }

#elif VEC_AVX512

enum { VEC4_LANES = 4 };
typedef double vec4 __attribute__((vector_size(32)));

static inline vec4 vec4_set(double a) { return (vec4){a, a, a, a}; }
static inline vec4 vec4_where(unsigned bits, vec4 a) { return (vec4)_mm256_maskz_mov_pd((__mmask8)bits, (__m256d)a); }
static inline vec4 vec4_max(vec4 a, vec4 b) { return (vec4)_mm256_max_pd((__m256d)a, (__m256d)b); }
static inline vec4 vec4_min(vec4 a, vec4 b) { return (vec4)_mm256_min_pd((__m256d)a, (__m256d)b); }
static inline vec4 vec4_sqrt(vec4 a) { return (vec4)_mm256_sqrt_pd((__m256d)a); }
static inline double vec4_highest(vec4 a) {
    const double x = a[0] > a[1] ? a[0] : a[1], y = a[2] > a[3] ? a[2] : a[3];
    return x > y ? x : y;
}
static inline double vec4_lowest(vec4 a) {
    const double x = a[0] < a[1] ? a[0] : a[1], y = a[2] < a[3] ? a[2] : a[3];
    return x < y ? x : y;
}
static inline double vec4_sum(vec4 a) { return (a[0] + a[1]) + (a[2] + a[3]); }
static inline int vec4_any_above(vec4 a, double b) {
    return _mm256_cmp_pd_mask((__m256d)a, _mm256_set1_pd(b), _CMP_NLE_UQ) != 0;
}

#else

enum { VEC4_LANES = VEC_LANES };
typedef vec vec4;

static inline vec4 vec4_set(double a) { return vec_set(a); }
static inline vec4 vec4_where(unsigned bits, vec4 a) { return vec_where(bits, a); }
static inline vec4 vec4_max(vec4 a, vec4 b) { return vec_max(a, b); }
static inline vec4 vec4_min(vec4 a, vec4 b) { return vec_min(a, b); }
static inline vec4 vec4_sqrt(vec4 a) { return vec_sqrt(a); }
static inline double vec4_highest(vec4 a) { return vec_highest(a); }
static inline double vec4_lowest(vec4 a) { return vec_lowest(a); }
static inline double vec4_sum(vec4 a) { return vec_total(a); }
static inline int vec4_any_above(vec4 a, double b) { return vec_any_above(a, b); }

#endif

static inline vec4 vec4_load(const double *p) {
    vec4 v;
    memcpy(&v, p, sizeof v);
    return v;
}
static inline void vec4_store(double *p, vec4 v) { memcpy(p, &v, sizeof v); }
