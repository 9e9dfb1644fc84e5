/* Cubes for the tests of measures: of the bodies' material, under known displacements. */
#pragma once
#include "solid/bonds/ghosts.h"
#include "solid/solid.h"
#include "tests/solid/test_surface_bodies.h"

static inline struct solid *cube_new(int n, int general, int correction) {
    const struct solid_body body = bodies_box(0, 0, 0, n, n, n);
    struct solid_input in = bodies_input(1, &body);
    in.general_bonds = general;
    in.surface_correction = correction;
    return solid_new(&in);
}

/* d = g X0. */
static inline void strain_affine(struct solid *s, double g[3][3]) {
    for (int h = 0; h < s->n; h++)
        for (int i = 0; i < 3; i++) s->d[i][h] = g[i][0] * s->x0[0][h] + g[i][1] * s->x0[1][h] + g[i][2] * s->x0[2][h];
    solid_ghosts_update(s);
}

/* A cube turned, every particle moved by up to half of `by` spacings, and cut. */
static inline struct solid *cube_uneven(int general, double by) {
    struct solid *s = cube_new(9, general, 1);
    bodies_turn(s, 0.4, 0);
    for (int h = 0; h < s->n; h++) {
        int p[3];
        bodies_site(s, h, p);
        for (int c = 0; c < 3; c++) s->d[c][h] += by * SPACING * (bodies_random(p[0] + 9 * (p[1] + 9 * p[2]), c) - 0.5);
    }
    bodies_cut(s, 2, 4);
    solid_ghosts_update(s);
    return s;
}
