/* Bodies for the tests of the surface, contact and measures, on a lattice of spacing 1e-3 m. */
#pragma once
#include "base/par.h"
#include "solid/bonds/family.h"
#include "solid/state.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#define SPACING 1e-3
#define DELTA (3 * SPACING)
#define YOUNG 1e8
#define DENSITY 3000.0

static const struct solid_material bodies_material = {YOUNG, DENSITY, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};

/* n[0] x n[1] x n[2] particles from site `from`. */
static inline struct solid_body bodies_box(int x, int y, int z, int nx, int ny, int nz) {
    return (struct solid_body){.name = "box",
                               .shape = SOLID_BOX,
                               .low = {x * SPACING, y * SPACING, z * SPACING},
                               .high = {(x + nx) * SPACING, (y + ny) * SPACING, (z + nz) * SPACING}};
}

static inline struct solid_input bodies_input(int bodies, const struct solid_body *body) {
    return (struct solid_input){.spacing = SPACING,
                                .bodies = bodies,
                                .body = body,
                                .materials = 1,
                                .material = &bodies_material,
                                .surface_correction = 1,
                                .contact_stiffness = 15,
                                .contact_exponent = 1,
                                .contact_radius = 1};
}

/* The lattice site of a particle. */
static inline void bodies_site(const struct solid *s, int h, int site[3]) {
    for (int c = 0; c < 3; c++) site[c] = (int)floor(s->x0[c][h] / SPACING);
}

static inline long bodies_id(const struct solid *s, int h) { return s->first[par_rank()] + h; }

/* Breaks every bond up to `longest` that crosses the plane between sites at - 1 and at. */
static inline void bodies_cut_short(struct solid *s, int axis, int at, double longest) {
    struct solid_family_view view;
    const double plane = at * SPACING;
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            const double from = s->x0[axis][h], to = from + view.xi[b][axis];
            const double *xi = view.xi[b];
            if (view.intact[b] && (from < plane) != (to < plane) &&
                xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2] < longest * longest)
                solid_family_break(s, h, b);
        }
    }
}

/* All of them. */
static inline void bodies_cut(struct solid *s, int axis, int at) { bodies_cut_short(s, axis, at, INFINITY); }

/* Moves everything beyond the plane by `by`. */
static inline void bodies_open(struct solid *s, int axis, int at, double by) {
    for (int h = 0; h < s->n; h++) s->d[axis][h] = s->x0[axis][h] > at * SPACING ? by : 0;
}

/* A number in [0, 1) that depends on its arguments only, not on ranks. */
static inline double bodies_random(long a, long b) {
    uint64_t x = (uint64_t)a * 0x9E3779B97F4A7C15u + (uint64_t)b * 0xBF58476D1CE4E5B9u + 1;
    x ^= x >> 30;
    x *= 0xBF58476D1CE4E5B9u;
    x ^= x >> 27;
    x *= 0x94D049BB133111EBu;
    x ^= x >> 31;
    return (double)(x >> 11) / 9007199254740992.0;
}

/* d = R X0 + shift - X0, R the turn by angle about the axis (1, 1, 1)/sqrt(3). */
static inline void bodies_turn(struct solid *s, double angle, double shift) {
    const double c = cos(angle), t = (1 - c) / 3, w = sin(angle) / sqrt(3);
    const double r[3][3] = {{c + t, t - w, t + w}, {t + w, c + t, t - w}, {t - w, t + w, c + t}};
    for (int h = 0; h < s->n; h++)
        for (int i = 0; i < 3; i++)
            s->d[i][h] = r[i][0] * s->x0[0][h] + r[i][1] * s->x0[1][h] + r[i][2] * s->x0[2][h] + shift - s->x0[i][h];
}
