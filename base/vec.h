/* Eight doubles at once, by the compilers' vector extensions: gcc and clang lower them to whatever the machine has. */
#pragma once
#include <stdint.h>
#include <string.h>

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
