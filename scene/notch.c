/* Finds the initial cracks that an injection meets, and what similarity solutions say of their growth. */
#include "scene/notch.h"
#include "physics/bond.h"
#include "physics/crack_tip.h"
#include "physics/dilatation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static enum physics_model model_of(const struct scene *s) {
    return s->dimension == 2 ? (enum physics_model)s->solid->model : PHYSICS_3D;
}

/* The largest factor, 1 without times. */
static double largest_factor(const struct scene_time *t) {
    double most = t->n ? t->factor[0] : 1;
    for (int k = 1; k < t->n; k++) most = fmax(most, t->factor[k]);
    return most;
}

static void bounds_of(const struct scene_crack *c, double low[3], double high[3]) {
    for (int a = 0; a < 3; a++) {
        low[a] = INFINITY;
        high[a] = -INFINITY;
        for (int p = 0; p < c->points; p++) {
            low[a] = fmin(low[a], c->point[p][a]);
            high[a] = fmax(high[a], c->point[p][a]);
        }
    }
}

static int meet(int dim, double gap, const double low[3], const double high[3], const double a[3], const double b[3]) {
    for (int c = 0; c < dim; c++)
        if (low[c] > b[c] + gap || high[c] < a[c] - gap) return 0;
    return 1;
}

/* Length of a plate's crack, m; area of a quadrilateral, m2. */
static double size_of(const struct scene_crack *c, int dim) {
    double size = 0;
    for (int p = 0; dim == 2 && p + 1 < c->points; p++)
        size += hypot(c->point[p + 1][0] - c->point[p][0], c->point[p + 1][1] - c->point[p][1]);
    for (int p = 1; dim == 3 && p + 1 < c->points; p++) { /* triangles about the first corner */
        double a[3], b[3], n[3];
        for (int k = 0; k < 3; k++) {
            a[k] = c->point[p][k] - c->point[0][k];
            b[k] = c->point[p + 1][k] - c->point[0][k];
        }
        for (int k = 0; k < 3; k++) n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
        size += 0.5 * sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    }
    return size;
}

/* Sizes of the cracks that meet the injection's box, and of those that touch these, and so on. 0: none does. */
static double sizes_of(const struct scene *s, const struct scene_injection *at) {
    const int n = s->solid->cracks, dim = s->dimension;
    double(*low)[3] = calloc((size_t)n + 1, sizeof *low), (*high)[3] = calloc((size_t)n + 1, sizeof *high), size = 0;
    char *joined = calloc((size_t)n + 1, 1);
    for (int k = 0; k < n; k++) bounds_of(&s->solid->crack[k], low[k], high[k]);
    for (int more = 1; more;) {
        more = 0;
        for (int k = 0; k < n; k++) {
            if (joined[k]) continue;
            int is = meet(dim, 0, low[k], high[k], at->low, at->high);
            for (int l = 0; l < n; l++)
                is |= joined[l] && meet(dim, s->solid->spacing, low[k], high[k], low[l], high[l]);
            if (!is) continue;
            joined[k] = 1;
            size += size_of(&s->solid->crack[k], dim);
            more = 1;
        }
    }
    free(low);
    free(high);
    free(joined);
    return size;
}

static void grow(struct scene_notch *n) {
    n->speed = INFINITY;
    n->pressure = n->start = 0;
    for (int k = 0; k < 2; k++) {
        const enum physics_hydraulic_regime regime = k ? PHYSICS_VISCOSITY : PHYSICS_TOUGHNESS;
        const double t = physics_hydraulic_fracture_reached(&n->in, regime, n->length);
        const struct physics_hydraulic_state now = physics_hydraulic_fracture_at(&n->in, regime, t);
        n->speed = fmin(n->speed, physics_hydraulic_fracture_speed(&n->in, regime, t));
        n->pressure = fmax(n->pressure, isfinite(now.pressure_well) ? now.pressure_well : now.pressure_half);
        n->start = fmax(n->start, t);
    }
    n->number = physics_hydraulic_fracture_number(&n->in, n->start);
}

double scene_notch_limit(const struct scene *s) {
    const struct scene_material *m = &s->solid->material[s->solid->body[0].material_index];
    if (!isfinite(m->fracture_energy)) return INFINITY;
    if (m->tensile_strength > 0) return m->tensile_strength;
    return m->youngs_modulus * physics_bond_elastic(model_of(s), (enum physics_micromodulus)m->micromodulus,
                                                    s->dimension == 2 ? s->solid->thickness : 1, m->youngs_modulus,
                                                    physics_dilatation_ratio_excess(model_of(s), m->poisson_ratio),
                                                    m->fracture_energy, m->horizon_ratio * s->solid->spacing)
                                   .s0;
}

int scene_notch_of(const struct scene *s, struct scene_notch *notch) {
    const struct scene_crack_fluid *f = s->crack_fluid;
    int q = 0;
    while (f && q < f->injections &&
           (f->injection[q].is_pressure || !(f->injection[q].rate * largest_factor(&f->injection[q].time) > 0)))
        q++;
    if (!f || q == f->injections) return 0;
    const struct scene_material *m = &s->solid->material[s->solid->body[0].material_index];
    const enum physics_model model = model_of(s);
    const double size = sizes_of(s, &f->injection[q]);
    if (!(size > 0) || !isfinite(m->fracture_energy)) return 0;
    const int plate = s->dimension == 2;
    const struct physics_crack_tip tip = {m->youngs_modulus, physics_dilatation_ratio(model, m->poisson_ratio),
                                          model != PHYSICS_PLANE_STRESS};
    const double modulus = physics_crack_tip_modulus(&tip);
    *notch = (struct scene_notch){.injection = q,
                                  .in = {.shape = plate ? PHYSICS_KGD : PHYSICS_PENNY,
                                         .modulus = modulus,
                                         .toughness = sqrt(modulus * m->fracture_energy),
                                         .viscosity = f->viscosity,
                                         .rate = f->injection[q].rate * largest_factor(&f->injection[q].time) /
                                                 (plate ? s->solid->thickness : 1)},
                                  .length = plate ? 0.5 * size : sqrt(size / acos(-1)),
                                  .over = {1, plate ? 4 : 3.5},
                                  .wave = sqrt(m->youngs_modulus / m->density),
                                  .limit = scene_notch_limit(s)};
    grow(notch);
    return 1;
}

const char *scene_notch_regime(const struct scene_notch *notch) {
    return notch->number >= notch->over[1]   ? "toughness"
           : notch->number <= notch->over[0] ? "viscosity"
                                             : "between the regimes";
}
