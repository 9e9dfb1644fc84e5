/* Two particles that a bond joins: along the bond they are one linear oscillator, at any amplitude. */
#pragma once
#include "solid/law/material.h"
#include "tests/solid/make.h"

/* General bonds or a lattice, without surface correction. */
static inline struct solid *pair_new(int list) {
    return make((struct make){.sites = {2, 1, 1}, .list = list, .uncorrected = 1});
}

/* Square of its frequency, 2 c0 V/(rho spacing), 1/s2. */
static inline double pair_stiffness(void) {
    const struct solid_material material = {YOUNG, DENSITY, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};
    return 2 * solid_material_micromodulus(&material, SPACING) * SPACING * SPACING / DENSITY;
}

/* k_d of a damping rate, 1/s: the rate is 2 k_d V/rho. */
static inline double pair_damping(double rate) { return rate * DENSITY / (2 * SPACING * SPACING * SPACING); }

/* The right particle. */
static inline int pair_right(const struct solid *s) { return s->x0[0][1] > s->x0[0][0]; }

/* The distance grows by d at the speed v; the middle rests. */
static inline void pair_set(struct solid *s, double d, double v) {
    for (int h = 0; h < 2; h++) {
        s->d[0][h] = h == pair_right(s) ? 0.5 * d : -0.5 * d;
        s->v[0][h] = h == pair_right(s) ? 0.5 * v : -0.5 * v;
    }
    s->a_holds = 0;
}

static inline void pair_get(const struct solid *s, double *d, double *v) {
    const int r = pair_right(s);
    *d = s->d[0][r] - s->d[0][1 - r];
    *v = s->v[0][r] - s->v[0][1 - r];
}
