/* Moves a body's particles at random from their places: by a hash of seed and particle, the same on every rank. */
#include "solid/body/perturb.h"
#include "base/hash.h"

double solid_perturb(const struct solid_body *body, long i, long j, int c) {
    if (body->perturbation == 0) return 0;
    return body->perturbation * hash_even(body->perturbation_seed, i, j, c);
}
