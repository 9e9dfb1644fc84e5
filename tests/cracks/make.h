/* Solids for tests of cracks: plates and blocks on the lattice, cut by integers or by a scene's cracks. */
#pragma once
#include "base/par.h"
#include "cracks/cracks.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/solid.h"
#include "tests/check.h"
#include "tests/solid/noise.h"

static const double SPACING = 1e-3, YOUNG = 2e10, DENSITY = 2500, THICKNESS = 2e-3;

struct make {
    int sites[3];           /* sites[2] = 0: a plate, plane strain */
    int periodic, list;     /* periodic 1: in all directions, 2: in x alone */
    double ratio;           /* m, default 3 */
    double fracture_energy; /* 0: never breaks */
    double density;         /* 0: DENSITY */
    int cuts, constraints, contact;
    const struct solid_cut *cut;
    const struct solid_constraint *constraint;
    int loads;
    const struct solid_load *load;
};

static inline struct solid *make(struct make m) {
    const int plate = m.sites[2] == 0;
    const double w = m.sites[0] * SPACING, h = m.sites[1] * SPACING;
    const double corner[4][2] = {{0, 0}, {w, 0}, {w, h}, {0, h}};
    const signed char turn[4] = {0};
    const struct solid_outline outline = {0, 4, corner, corner, turn};
    struct solid_body body = {.name = "body", .shape = plate ? SOLID_POLYGON : SOLID_BOX};
    body.outlines = plate;
    body.outline = &outline;
    const struct solid_material material = {YOUNG,
                                            m.density > 0 ? m.density : DENSITY,
                                            m.fracture_energy > 0 ? m.fracture_energy : INFINITY,
                                            m.ratio > 0 ? m.ratio : 3,
                                            PHYSICS_CONSTANT,
                                            0,
                                            0};
    struct solid_input in = {.model = plate ? PHYSICS_PLANE_STRAIN : PHYSICS_3D,
                             .thickness = plate ? THICKNESS : 0,
                             .spacing = SPACING,
                             .bodies = 1,
                             .body = &body,
                             .materials = 1,
                             .material = &material,
                             .cuts = m.cuts,
                             .cut = m.cut,
                             .constraints = m.constraints,
                             .constraint = m.constraint,
                             .loads = m.loads,
                             .load = m.load,
                             .contact = m.contact,
                             .contact_stiffness = 15,
                             .contact_exponent = 1,
                             .contact_radius = 1,
                             .surface_correction = SOLID_CORRECTION_VOLUME,
                             .general_bonds = m.list};
    for (int c = 0; c < 3; c++) {
        body.high[c] = m.sites[c] * SPACING;
        in.periodic[c] = m.periodic == 2 ? c == 0 : m.periodic && !(plate && c == 2);
        in.length[c] = body.high[c];
    }
    return solid_new(&in);
}

/* Cuts of a periodic solid by integers alone: the site i has the number n.i modulo the period, and the sites below and
 * from half the period on are apart. So there are two plane cuts: 1 where the number passes half the period, 2 where it
 * passes 0. */
struct planes {
    int sites[3], n[3], period;
};

static inline int number_of(const struct solid *s, const struct planes *p, int h) {
    int number = 0;
    for (int c = 0; c < s->dim; c++) number += p->n[c] * (int)lrint(s->x0[c][h] / SPACING - 0.5);
    return ((number % p->period) + p->period) % p->period;
}

static inline int side_of(const struct planes *p, int number) { return number >= p->period / 2; }

/* Whether a particle is nearer to cut 1 than to cut 2. */
static inline int is_at_first(const struct planes *p, int number) {
    return number >= p->period / 4 && number < 3 * p->period / 4;
}

/* Breaks the bonds whose ends are apart. */
static inline void cut(struct solid *s, const struct planes *p) {
    static struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        const int side = side_of(p, number_of(s, p, h));
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++)
            if (view.intact[b] && side_of(p, number_of(s, p, view.l[b])) != side) solid_family_break(s, h, b);
    }
}

/* Area of one of the cuts, m2, and its unit normal. */
static inline double area_of(const struct planes *p, double normal[3]) {
    const int dim = p->sites[2] ? 3 : 2;
    double n2 = 0, sites = 1;
    for (int c = 0; c < 3; c++) n2 += p->n[c] * p->n[c];
    for (int c = 0; c < dim; c++) sites *= p->sites[c];
    for (int c = 0; c < 3; c++) normal[c] = p->n[c] / sqrt(n2);
    return sites / p->period * sqrt(n2) * SPACING * (dim == 3 ? SPACING : THICKNESS);
}
