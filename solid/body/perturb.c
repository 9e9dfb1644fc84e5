/* Moves a body's particles at random from their places: by a hash of seed and particle, the same on every rank. */
#include "solid/body/perturb.h"

#include <stdint.h>

/* The output function of SplitMix64.  (Steele, Lea, Flood 2014) */
static uint64_t mixed(uint64_t z) {
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}

double solid_perturb(const struct solid_body *body, long i, long j, int c) {
    if (body->perturbation == 0) return 0;
    uint64_t z = mixed((uint64_t)body->perturbation_seed);
    z = mixed(z ^ (uint64_t)(int64_t)i);
    z = mixed(z ^ (uint64_t)(int64_t)j);
    z = mixed(z ^ (uint64_t)c);
    return body->perturbation * ((double)(z >> 11) * 0x1p-52 - 1);
}
