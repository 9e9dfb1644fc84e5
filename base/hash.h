/* Seeded numbers that look random: a hash of a seed and a place, the same on every rank and in every order. */
#pragma once
#include <stdint.h>

/* The output function of SplitMix64.  (Steele, Lea, Flood 2014) */
static inline uint64_t hash_mixed(uint64_t z) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

/* Even in -1 ... 1. Pure. */
static inline double hash_even(long seed, long i, long j, int c) {
    uint64_t z = hash_mixed((uint64_t)seed);
    z = hash_mixed(z ^ (uint64_t)(int64_t)i);
    z = hash_mixed(z ^ (uint64_t)(int64_t)j);
    z = hash_mixed(z ^ (uint64_t)c);
    return (double)(z >> 11) * 0x1p-52 - 1;
}
