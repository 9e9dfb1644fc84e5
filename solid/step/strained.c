/* The largest stretch or compression of some short bonds of each particle. */
#include "solid/step/strained.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/law/material.h"

#include <math.h>

enum { BONDS = 3 };
static const double SMALL = 0.02;         /* a stretch that changes no step */
static const double MOVED = 0.01;         /* spacings */
static const double LARGEST_COSINE = 0.8; /* the cosine between two bonds of a particle is at most this */

struct solid_strained {
    struct solid *s; /* borrowed */
    double most;     /* longer bonds are broken; INFINITY: none breaks */
    int made;        /* 1: the bonds are chosen */
    int *other;      /* [BONDS n] the other end, -1: none */
    double (*xi)[3]; /* [BONDS n] X0_l - X0_h, m */
};

/* The stretch from which on bonds are broken. */
static double longest(const struct solid *s) {
    double most = 0;
    if (!s->stage.breakage || s->in.unbreakables > 0) return INFINITY;
    for (int m = 0; m < s->in.materials; m++) {
        const struct solid_material *material = &s->in.material[m];
        if (isinf(material->fracture_energy) || material->tensile_strength > 0) return INFINITY;
        most = fmax(most, solid_material_constants(s->in.model, s->in.thickness, material,
                                                   material->horizon_ratio * s->in.spacing)
                              .s0);
    }
    return most;
}

struct solid_strained *solid_strained_new(struct solid *s) {
    const double most = longest(s);
    if (s->refine || s->in.rigid || !(most > SMALL)) return NULL;
    struct solid_strained *strained = memory_new(MEMORY_SOLID, 1, sizeof *strained);
    strained->s = s;
    strained->most = most;
    return strained;
}

void solid_strained_forget(struct solid_strained *strained) {
    if (!strained) return;
    MEMORY_FREE(strained->other, strained->xi);
    strained->other = NULL;
    strained->xi = NULL;
    strained->made = 0;
}

void solid_strained_free(struct solid_strained *strained) {
    if (!strained) return;
    MEMORY_FREE(strained->other, strained->xi, strained);
}

static double dot(const double x[3], const double y[3]) { return x[0] * y[0] + x[1] * y[1] + x[2] * y[2]; }

static int is_transverse(const double xi[3], int chosen, double (*unit)[3]) {
    for (int k = 0; k < chosen; k++)
        if (fabs(dot(xi, unit[k])) > LARGEST_COSINE * sqrt(dot(xi, xi) * dot(unit[k], unit[k]))) return 0;
    return 1;
}

/* The shortest intact bond in another direction than those chosen before; -1: none. */
static int next_bond(const struct solid_family_view *view, int chosen, double (*unit)[3]) {
    double least = INFINITY;
    int best = -1;
    for (int b = 0; b < view->n; b++) {
        const double length2 = dot(view->xi[b], view->xi[b]);
        if (!view->intact[b] || length2 >= least || !is_transverse(view->xi[b], chosen, unit)) continue;
        least = length2;
        best = b;
    }
    return best;
}

static void choose(struct solid_strained *strained) {
    const struct solid *s = strained->s;
    struct solid_family_view *view = memory_new(MEMORY_SOLID, 1, sizeof *view);
    strained->other = memory_new(MEMORY_SOLID, (size_t)BONDS * (size_t)s->n + 1, sizeof *strained->other);
    strained->xi = memory_new(MEMORY_SOLID, (size_t)BONDS * (size_t)s->n + 1, sizeof *strained->xi);
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, view);
        int *other = strained->other + BONDS * h;
        double(*xi)[3] = strained->xi + BONDS * h;
        for (int k = 0; k < BONDS; k++) {
            const int b = k > 0 && other[k - 1] < 0 ? -1 : next_bond(view, k, xi);
            other[k] = b < 0 ? -1 : view->l[b];
            for (int c = 0; c < s->dim && b >= 0; c++) xi[k][c] = view->xi[b][c];
        }
    }
    memory_free(view);
    strained->made = 1;
}

static int has_moved(const struct solid *s) {
    double most = 0;
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) most = fmax(most, fabs(s->d[c][h]));
    return par_max(most) > MOVED * s->in.spacing;
}

/* The stretch of a chosen bond. */
static double stretch_of(const struct solid *s, int h, int l, const double xi[3]) {
    double q = 0;
    for (int c = 0; c < s->dim; c++) {
        const double eta = s->d[c][l] - s->d[c][h];
        q += eta * (2 * xi[c] + eta);
    }
    const double eps = q / dot(xi, xi);
    return eps / (1 + sqrt(1 + eps));
}

double solid_strained_stretch(struct solid_strained *strained) {
    struct solid *s = strained->s;
    double most = 0;
    if (!strained->made && !has_moved(s)) return 0;
    if (!strained->made) choose(strained);
    solid_ghosts_update(s);
    for (int k = 0; k < BONDS * s->n; k++) {
        if (strained->other[k] < 0) continue;
        const double stretch = stretch_of(s, k / BONDS, strained->other[k], strained->xi[k]);
        if (stretch <= strained->most) most = fmax(most, fabs(stretch));
    }
    return par_max(most);
}
