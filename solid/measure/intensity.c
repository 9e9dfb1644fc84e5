/* J by the bonds between circles about a crack's tip, and stress-intensity factors by its mixed form. */
#include "solid/measure/intensity.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "physics/crack_tip.h"
#include "solid/bonds/family.h"
#include "solid/force/dilatation.h"
#include "solid/law/material.h"

#include <math.h>

enum { MODES = 3 }; /* I, II, and a force on the tip */

/* Particles near the tip, owned and ghosts, in the tip's frame. */
struct near {
    const struct solid *s; /* borrowed */
    const struct solid_tip *tip;
    double (*x)[2];                           /* [n + n_ghost] m */
    double (*own)[MODES][2];                  /* [n + n_ghost] displacement of the crack's own fields, m */
    double (*own_slope)[MODES][2], *slope[2]; /* [n + n_ghost] derivatives along the crack; of the own field, of d */
    /* with a dilatation: pressures P of the displacement and of the own fields [n + n_ghost], 1; and what gives the
     * energy 1/2 bears P^2 of a particle [n], J/m3. NULL: bonds alone (solid/force/dilatation.h) */
    double *pressure[1 + MODES], *bears;
    double widest; /* only particles within twice this count */
};

static void turn(const struct solid_tip *tip, const double from[2], double to[2]) {
    to[0] = tip->along[0] * from[0] + tip->along[1] * from[1];
    to[1] = tip->along[0] * from[1] - tip->along[1] * from[0];
}

static void place(const struct solid *s, const struct solid_tip *tip, int h, double x[2]) {
    const double from[2] = {solid_shortest(s, 0, s->x0[0][h] - tip->x[0]),
                            solid_shortest(s, 1, s->x0[1][h] - tip->x[1])};
    turn(tip, from, x);
}

static int is_near(const struct near *near, int h) { return hypot(near->x[h][0], near->x[h][1]) < 2 * near->widest; }

/* Solves A x = b for two right-hand sides by Cholesky's method; 0 if A is singular. A is overwritten. */
static int solve(int n, double a[5][5], double b[5][2]) {
    for (int i = 0; i < n; i++) {
        const double whole = a[i][i];
        for (int k = 0; k < i; k++) a[i][i] -= a[i][k] * a[i][k];
        if (!(a[i][i] > 1e-6 * whole)) return 0;
        a[i][i] = sqrt(a[i][i]);
        for (int j = i + 1; j < n; j++) {
            for (int k = 0; k < i; k++) a[j][i] -= a[j][k] * a[i][k];
            a[j][i] /= a[i][i];
        }
    }
    for (int c = 0; c < 2; c++) {
        for (int i = 0; i < n; i++) {
            for (int k = 0; k < i; k++) b[i][c] -= a[i][k] * b[k][c];
            b[i][c] /= a[i][i];
        }
        for (int i = n - 1; i >= 0; i--) {
            for (int k = i + 1; k < n; k++) b[i][c] -= a[k][i] * b[k][c];
            b[i][c] /= a[i][i];
        }
    }
    return 1;
}

/* eta = g1 y1 + g2 y2 + (g3 y1^2 + g4 y1 y2 + g5 y2^2) over h's intact bonds, y = xi over the spacing: g1 is the slope.
 * Where too few bonds are left the linear part alone, and 0 where these do not fix it. */
static void find_slope(const struct near *near, int h, const struct solid_family_view *view, double slope[2]) {
    const struct solid *s = near->s;
    const double scale = 1 / s->in.spacing;
    for (int n = 5; n >= 2; n -= 3) {
        double a[5][5] = {{0}}, b[5][2] = {{0}};
        for (int k = 0; k < view->n; k++) {
            if (!view->intact[k]) continue;
            const double d[2] = {s->d[0][view->l[k]] - s->d[0][h], s->d[1][view->l[k]] - s->d[1][h]};
            double y[2], eta[2];
            turn(near->tip, view->xi[k], y);
            turn(near->tip, d, eta);
            for (int c = 0; c < 2; c++) y[c] *= scale;
            const double p[5] = {y[0], y[1], y[0] * y[0], y[0] * y[1], y[1] * y[1]};
            const double w = view->weight[k] / (p[2] + p[4]);
            for (int i = 0; i < n; i++) {
                for (int j = 0; j <= i; j++) a[i][j] += w * p[i] * p[j];
                for (int c = 0; c < 2; c++) b[i][c] += w * p[i] * eta[c];
            }
        }
        if (solve(n, a, b)) {
            for (int c = 0; c < 2; c++) slope[c] = scale * b[0][c];
            return;
        }
    }
    slope[0] = slope[1] = 0;
}

/* P of h of the displacement and the own fields, whose stretches are linear here; sets bears. */
static void find_pressure(const struct near *near, int h, const struct solid_family_view *view) {
    const struct solid *s = near->s;
    const struct solid_dilatation *d = s->dilatation;
    double m = 0, sum[1 + MODES] = {0};
    for (int k = 0; k < view->n; k++) {
        const int l = view->l[k];
        if (!view->intact[k]) continue;
        const double eta[2] = {s->d[0][l] - s->d[0][h], s->d[1][l] - s->d[1][h]};
        const double length = hypot(view->xi[k][0], view->xi[k][1]),
                     part = view->micro[k] * view->weight[k]; /* over the length: what M has of the bond */
        double xi[2];
        turn(near->tip, view->xi[k], xi);
        m += part * length;
        sum[0] += part * (view->xi[k][0] * eta[0] + view->xi[k][1] * eta[1]) / length;
        for (int mode = 0; mode < MODES; mode++)
            for (int c = 0; c < 2; c++)
                sum[1 + mode] += part * xi[c] * (near->own[l][mode][c] - near->own[h][mode][c]) / length;
    }
    if (!(m > 0)) return;
    const double per = s->dim * s->dim * d->excess[h] / (d->full[h] * m);
    for (int k = 0; k < 1 + MODES; k++) near->pressure[k][h] = per * sum[k];
    near->bears[h] = 1 / per;
}

static void find_pressures(struct near *near) {
    const struct solid *s = near->s;
    const size_t all = (size_t)(s->n + s->n_ghost) + 1;
    struct solid_family_view view;
    for (int k = 0; k < 1 + MODES; k++) near->pressure[k] = memory_new(MEMORY_OUTPUT, all, sizeof *near->pressure[k]);
    near->bears = memory_new(MEMORY_OUTPUT, all, sizeof *near->bears);
    for (int h = 0; h < s->n; h++) {
        if (!is_near(near, h) || !s->dilatation->of_body[s->body[h]]) continue;
        solid_family_view(s, h, &view);
        find_pressure(near, h, &view);
    }
    par_ghost_update(s->ghost, 1 + MODES, near->pressure, s->n);
}

static struct near near_new(const struct solid *s, const struct solid_tip *tip,
                            const struct physics_crack_tip *material, double widest) {
    const size_t all = (size_t)(s->n + s->n_ghost) + 1;
    struct near near = {.s = s, .tip = tip, .widest = widest};
    struct solid_family_view view;
    near.x = memory_new(MEMORY_OUTPUT, all, sizeof *near.x);
    near.own = memory_new(MEMORY_OUTPUT, all, sizeof *near.own);
    near.own_slope = memory_new(MEMORY_OUTPUT, all, sizeof *near.own_slope);
    for (int c = 0; c < 2; c++) near.slope[c] = memory_new(MEMORY_OUTPUT, all, sizeof *near.slope[c]);
    for (int h = 0; h < s->n + s->n_ghost; h++) {
        place(s, tip, h, near.x[h]);
        const double r = hypot(near.x[h][0], near.x[h][1]), t = atan2(near.x[h][1], near.x[h][0]);
        double stress[3];
        if (!is_near(&near, h) || r == 0) continue;
        for (int m = 0; m < MODES; m++)
            physics_crack_tip_field(material, m, r, t, stress, near.own[h][m], near.own_slope[h][m]);
    }
    for (int h = 0; h < s->n; h++) {
        double slope[2];
        if (!is_near(&near, h)) continue;
        solid_family_view(s, h, &view);
        find_slope(&near, h, &view, slope);
        for (int c = 0; c < 2; c++) near.slope[c][h] = slope[c];
    }
    par_ghost_update(s->ghost, 2, near.slope, s->n);
    if (s->dilatation) find_pressures(&near);
    return near;
}

static void near_free(struct near *near) {
    MEMORY_FREE(near->x, near->own, near->own_slope);
    for (int c = 0; c < 2; c++) memory_free(near->slope[c]);
    for (int k = 0; k < 1 + MODES; k++) memory_free(near->pressure[k]);
    memory_free(near->bears);
}

/* q at x and its derivative along the crack. */
static double weight_at(const double x[2], double radius, double *slope) {
    const double r = hypot(x[0], x[1]), inner = 0.5 * radius;
    *slope = 0;
    if (r <= inner) return 1;
    if (r >= radius) return 0;
    *slope = -x[0] / (r * (radius - inner));
    return (radius - r) / (radius - inner);
}

/* The same of the dilatation's pressure on a bond with this stiffness without alpha: drop and the means of both fields'
 * u,1 along the bond. */
static void add_pressure(const struct near *near, int h, int l, double plain, double drop, double mean,
                         const double own_mean[MODES], double sum[1 + MODES]) {
    const double p = near->pressure[0][h] + near->pressure[0][l];
    sum[0] -= 0.5 * plain * p * drop * mean;
    for (int m = 0; m < MODES; m++) {
        const double own = near->pressure[1 + m][h] + near->pressure[1 + m][l];
        sum[1 + m] -= 0.5 * plain * drop * (p * own_mean[m] + own * mean);
    }
}

/* The energy of h's dilatation and the mixed ones. */
static void add_dilatation(const struct near *near, int h, double q_slope, double sum[1 + MODES]) {
    const double p = near->pressure[0][h], factor = near->bears[h] * near->s->volume[h] * q_slope;
    sum[0] -= 0.5 * factor * p * p;
    for (int m = 0; m < MODES; m++) sum[1 + m] -= factor * p * near->pressure[1 + m][h];
}

/* h's terms of t J and of its mixed forms, the bonds by halves. */
static void add(const struct near *near, int h, const struct solid_family_view *view, double radius,
                double sum[1 + MODES]) {
    const struct solid *s = near->s;
    double q_slope;
    const double q = weight_at(near->x[h], radius, &q_slope), volume = s->volume[h];
    if (near->bears) add_dilatation(near, h, q_slope, sum);
    for (int k = 0; k < view->n; k++) {
        const int l = view->l[k];
        double unused;
        const double drop = q - weight_at(near->x[l], radius, &unused);
        if (!view->intact[k] || (drop == 0 && q_slope == 0)) continue;
        const double d[2] = {s->d[0][l] - s->d[0][h], s->d[1][l] - s->d[1][h]};
        double xi[2], eta[2];
        turn(near->tip, view->xi[k], xi);
        turn(near->tip, d, eta);
        const double length2 = xi[0] * xi[0] + xi[1] * xi[1], length = sqrt(length2);
        /* to second order in the displacements: the stretch is xi.eta/|xi|^2, and the force is along xi */
        const double stretch = (xi[0] * eta[0] + xi[1] * eta[1]) / length2;
        const double stiffness = view->alpha[k] * view->micro[k] * view->weight[k] * volume;
        const double along[2] = {xi[0] / length, xi[1] / length};
        double mean = 0, own_means[MODES]; /* of u,1 at both ends, along the bond */
        for (int c = 0; c < 2; c++) mean += 0.5 * along[c] * (near->slope[c][h] + near->slope[c][l]);
        sum[0] -= stiffness * stretch * (0.25 * stretch * length * q_slope + 0.5 * drop * mean);
        for (int m = 0; m < MODES; m++) {
            double own = 0, own_mean = 0;
            for (int c = 0; c < 2; c++) {
                own += along[c] * (near->own[l][m][c] - near->own[h][m][c]) / length;
                own_mean += 0.5 * along[c] * (near->own_slope[h][m][c] + near->own_slope[l][m][c]);
            }
            sum[1 + m] -=
                stiffness * (0.5 * stretch * own * length * q_slope + 0.5 * drop * (stretch * own_mean + own * mean));
            own_means[m] = own_mean;
        }
        if (near->bears)
            add_pressure(near, h, l, view->micro[k] * view->weight[k] * volume, drop, mean, own_means, sum);
    }
}

void solid_intensity_measure(const struct solid *s, const struct solid_tip *tip, int material, int radii,
                             const double *radius, struct solid_intensity *is) {
    const enum physics_model model = (enum physics_model)s->in.model;
    const struct physics_crack_tip law = {s->in.material[material].youngs_modulus,
                                          solid_material_poisson_ratio(model, &s->in.material[material]),
                                          model == PHYSICS_PLANE_STRAIN};
    const double modulus = physics_crack_tip_modulus(&law);
    double widest = 0, *sum = memory_new(MEMORY_OUTPUT, (size_t)radii * (1 + MODES), sizeof *sum);
    struct solid_family_view view;
    for (int k = 0; k < radii; k++) widest = fmax(widest, radius[k]);
    struct near near = near_new(s, tip, &law, widest);
    for (int h = 0; h < s->n; h++) {
        if (!is_near(&near, h)) continue;
        solid_family_view(s, h, &view);
        for (int k = 0; k < radii; k++) add(&near, h, &view, radius[k], sum + (ptrdiff_t)k * (1 + MODES));
    }
    near_free(&near);
    par_sum_array(sum, radii * (1 + MODES));
    for (int k = 0; k < radii; k++) {
        const double *its = sum + (ptrdiff_t)k * (1 + MODES);
        is[k].j = its[0] / s->in.thickness;
        is[k].k_j = sqrt(fmax(is[k].j, 0) * modulus);
        for (int m = 0; m < 2; m++) is[k].k[m] = 0.5 * modulus * its[1 + m] / s->in.thickness;
        is[k].t = modulus * its[3] / s->in.thickness;
    }
    memory_free(sum);
}

int solid_intensity_is_inside(const struct solid *s, const struct solid_tip *tip, double radius) {
    const double pi = acos(-1), reach = 1.2 * s->in.spacing; /* no point of a lattice is farther than 0.71 from one */
    const int places = 8 + (int)(4 * pi * radius / s->in.spacing);
    double *mark = memory_new(MEMORY_OUTPUT, (size_t)places, sizeof *mark);
    for (int h = 0; h < s->n; h++) {
        double x[2];
        place(s, tip, h, x);
        const double r = hypot(x[0], x[1]);
        if (fabs(r - radius) > reach) continue;
        for (int k = 0; k < places; k++) {
            const double t = 2 * pi * k / places;
            mark[k] += hypot(x[0] - radius * cos(t), x[1] - radius * sin(t)) <= reach;
        }
    }
    par_sum_array(mark, places);
    int inside = 1;
    for (int k = 0; k < places; k++) inside &= mark[k] > 0;
    memory_free(mark);
    return inside;
}
