/* Boxes of several materials for the tests. */
#pragma once
#include "tests/solid/make.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/materials.h"
#include "solid/bonds/segments.h"
#include "solid/contact/contact.h"
#include "solid/force/force.h"
#include "solid/measure/energy.h"
#include "solid/measure/fragments.h"
#include "solid/measure/motion.h"
#include "solid/measure/stress.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "solid/step/relax.h"
#include "solid/voxels/voxels.h"
#include "tests/check.h"
#include "tests/solid/derivative.h"

#include <stdlib.h>

static const double G0 = 0.05;

enum pattern { ONE, HALVES, GRAINS, RANDOM, LAYER };

/* A box of sites, one a voxel. */
struct mix {
    int sites[3], periodic[3];
    enum pattern pattern;
    int at; /* HALVES: the first site of kind 1 along x; LAYER: the only ones, along y, are this and the next three */
    struct solid_material material[3];
    int kinds, contact, constraints;
    const struct solid_constraint *constraint;
    double body_force[3];
};

/* as macros for the table below, because a struct is not a constant in C17 */
#define QUARTZ                                                                                                         \
    { YOUNG, DENSITY, G0, 3, PHYSICS_CONSTANT, 0, 0 }
#define CLAY                                                                                                           \
    { 0.3 * YOUNG, 0.8 * DENSITY, 0.2 * G0, 3, PHYSICS_CONSTANT, 0, 0 }
#define ORE                                                                                                            \
    { 2.2 * YOUNG, 1.9 * DENSITY, 3 * G0, 3, PHYSICS_CONSTANT, 0, 0 }
static const struct solid_material quartz = QUARTZ, clay = CLAY, ore = ORE;

static inline int kind_at(const struct mix *m, const int site[3]) {
    const int block[3] = {site[0] / 5, site[1] / 5, site[2] / 5}, *cell = m->pattern == RANDOM ? site : block;
    switch (m->pattern) {
    case ONE:
        return 0;
    case HALVES:
        return site[0] >= m->at;
    case GRAINS:
    case RANDOM:
        return (int)(((unsigned)((cell[2] * 37 + cell[1]) * 41 + cell[0] + 5) * 2654435761u >> 16) %
                     (unsigned)m->kinds);
    case LAYER:
        return site[1] >= m->at && site[1] < m->at + 4;
    }
    return 0;
}

static inline int kind_of(const struct mix *m, const struct solid *s, int h) {
    int site[3];
    for (int c = 0; c < 3; c++) site[c] = (int)floor(s->x0[c][h] / SPACING);
    return kind_at(m, site);
}

static inline struct solid *mixed(const struct mix *m) {
    struct solid_body body = {.name = "rock", .shape = SOLID_IMAGE};
    const int corner[3] = {0};
    struct solid_voxels *v = solid_voxels_new(m->sites, NULL, corner);
    if (m->pattern != ONE) {
        body.image_materials = m->kinds;
        for (int k = 0; k < m->kinds; k++) body.image_material[k] = k;
        solid_voxels_kinds(v, m->kinds);
    }
    for (int k = 0; k < m->sites[2]; k++)
        for (int j = 0; j < m->sites[1]; j++)
            for (int i = 0; i < m->sites[0]; i++) {
                solid_voxels_set(v, v->bits, i, j, k);
                solid_voxels_set_kind(v, kind_at(m, (const int[3]){i, j, k}), i, j, k);
            }
    body.voxels = v;
    struct solid_input in = {.spacing = SPACING,
                             .bodies = 1,
                             .body = &body,
                             .materials = 3,
                             .material = m->material,
                             .constraints = m->constraints,
                             .constraint = m->constraint,
                             .surface_correction = SOLID_CORRECTION_ENERGY,
                             .contact = m->contact,
                             .contact_stiffness = 15,
                             .contact_exponent = 1,
                             .contact_radius = 1};
    for (int c = 0; c < 3; c++) {
        body.high[c] = m->sites[c] * SPACING;
        in.periodic[c] = m->periodic[c];
        in.length[c] = body.high[c];
        in.body_force[c] = m->body_force[c];
    }
    par_barrier(); /* the bits are the node's: all ranks have set them */
    struct solid *s = solid_new(&in);
    solid_voxels_free(v);
    return s;
}

static inline void shake(struct solid *s, double by) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            s->d[c][h] = by * SPACING * noise(s, h, c);
            s->v[c][h] = 0.1 * noise(s, h, c + 3);
        }
    solid_ghosts_update(s);
}

static inline double length_of(const double *xi) { return sqrt(xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2]); }

static inline double stretch_of(const struct solid *s, int h, const struct solid_family_view *view, int b) {
    double eta[3], zeta2 = 0, xi2 = 0;
    for (int c = 0; c < 3; c++) {
        eta[c] = s->d[c][view->l[b]] - s->d[c][h];
        zeta2 += (view->xi[b][c] + eta[c]) * (view->xi[b][c] + eta[c]);
        xi2 += view->xi[b][c] * view->xi[b][c];
    }
    return sqrt(zeta2 / xi2) - 1;
}

/* c0 and s0 of a bond between two materials, by the formula of an interface. */
static inline void bond_of(const struct mix *m, int a, int b, double *c0, double *s0) {
    const double ca = solid_material_micromodulus(&m->material[a], SPACING),
                 cb = solid_material_micromodulus(&m->material[b], SPACING),
                 sa = solid_material_critical_stretch(&m->material[a], SPACING),
                 sb = solid_material_critical_stretch(&m->material[b], SPACING);
    *c0 = (ca + cb) / 2;
    *s0 = sqrt((ca * sa * sa + cb * sb * sb) / (ca + cb));
}
