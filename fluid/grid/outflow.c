/* Convective outflow condition for the normal velocity, with mass conserved.  (001: sec. 5.1) */
#include "fluid/grid/outflow.h"
#include "base/par.h"
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"

#include <math.h>

typedef double face_rule(struct fluid_boundary_side *s, size_t face, size_t inside, const double *q, double *rate,
                         const double factor[3]);

/* Sets every value of the convective sides' planes by a rule of the face and the value inside it. */
static void set_planes(struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3],
                       double *const rate[3], const double factor[2], face_rule *rule) {
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            struct fluid_boundary_side *s = &boundary->side[d][side];
            int a, b;
            fluid_boundary_others(d, &a, &b);
            if (!s->here || s->normal != FLUID_NORMAL_CONVECTIVE) continue;
            const ptrdiff_t in = side ? -fluid_boundary_stride(g, d) : fluid_boundary_stride(g, d);
            const double rule_factor[3] = {factor[0], factor[1], 1 / g->d[d]};
            for (int l = 0; l < g->m[b]; l++)
                for (int j = 0; j < g->m[a]; j++) {
                    const size_t face = fluid_boundary_face(g, d, side, j, l);
                    s->plane[l * g->m[a] + j] =
                        rule(s, face, (size_t)((ptrdiff_t)face + in), q[d], rate ? rate[d] : NULL, rule_factor);
                }
        }
}

/* This rank's share of the outflow through the planes by side, m3/s. */
static void flux_out(const struct fluid_boundary *boundary, const struct fluid_grid *g, double out[6]) {
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            const struct fluid_boundary_side *s = &boundary->side[d][side];
            int a, b;
            fluid_boundary_others(d, &a, &b);
            double sum = 0;
            if (s->here && s->normal == FLUID_NORMAL_CONVECTIVE)
                for (int i = 0; i < g->m[a] * g->m[b]; i++) sum += s->plane[i];
            out[2 * d + side] = (side ? sum : -sum) * g->d[a] * g->d[b];
        }
}

static void conserve_mass(struct fluid_boundary *boundary, const struct fluid_grid *g) {
    if (boundary->open) return; /* the free sides balance the flux */
    double out[6], total = 0;
    flux_out(boundary, g, out);
    par_sum_array(out, 6);
    for (int i = 0; i < 6; i++) total += out[i];
    const double missing = (boundary->inflow - total) / boundary->outlet;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            struct fluid_boundary_side *s = &boundary->side[d][side];
            int a, b;
            fluid_boundary_others(d, &a, &b);
            if (!s->here || s->normal != FLUID_NORMAL_CONVECTIVE) continue;
            for (int i = 0; i < g->m[a] * g->m[b]; i++) s->plane[i] += side ? missing : -missing;
        }
}

static double as_it_stands(struct fluid_boundary_side *s, size_t face, size_t inside, const double *q, double *rate,
                           const double factor[3]) {
    (void)s, (void)inside, (void)rate, (void)factor;
    return q[face];
}

static double convected(struct fluid_boundary_side *s, size_t face, size_t inside, const double *q, double *rate,
                        const double factor[3]) {
    const double own = face > inside ? q[inside] : -q[inside], /* out of the domain */
        speed = s->follows ? fmax(s->speed, own) : s->speed;
    const double now = -speed * (q[face] - q[inside]) * factor[2], before = rate[face];
    rate[face] = now;
    return q[face] + factor[0] * now + (factor[1] != 0 ? factor[1] * before : 0);
}

void fluid_outflow_begin(struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3]) {
    if (boundary->outlet == 0) return;
    double out[12]; /* flux; number of ranks with a body near */
    set_planes(boundary, g, q, NULL, (double[2]){0, 0}, as_it_stands);
    flux_out(boundary, g, out);
    for (int i = 0; i < 6; i++) out[6 + i] = boundary->side[i / 2][i % 2].is_near;
    par_sum_array(out, 12);
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            struct fluid_boundary_side *s = &boundary->side[d][side];
            int a, b;
            fluid_boundary_others(d, &a, &b);
            s->speed = fmax(0, out[2 * d + side] / (g->length[a] * g->length[b]));
            s->follows = out[6 + 2 * d + side] > 0;
        }
}

void fluid_outflow_near(struct fluid *f, int d, int side, int is_near) { f->boundary->side[d][side].is_near = is_near; }

void fluid_outflow_advance(struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3],
                           double *const rate[3], double a, double b) {
    if (boundary->outlet == 0) return;
    set_planes(boundary, g, q, rate, (double[2]){a, b}, convected);
    conserve_mass(boundary, g);
}

void fluid_outflow_take(struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3]) {
    set_planes(boundary, g, q, NULL, (double[2]){0, 0}, as_it_stands);
}
