/* What short waves hold beyond the sums of velocity Verlet, by a few steps of Lanczos's iteration. */
#include "solid/step/shadow.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "solid/force/force.h"
#include "solid/force/forms.h"
#include "solid/state.h"
#include "solid/step/rates.h"

#include <math.h>
#include <string.h>

/* Displacements by which second derivatives are found, spacings: forces are linear to 1e-3 over it, and rounded by less
 * than that in mixed precision. */
static const double STEP = 1e-4;
/* The largest x^2: at 1 the step is unstable. */
static const double MOST = 0.98;

struct work {
    double *d[3], *a[3]; /* [n] the state's d and a */
    double *rest[3];     /* [n] a by the bonds at d, m/s2 */
    double *u[3];        /* [n] the vector at hand */
};

static int is_held(const struct solid *s, int h, int c) { return s->flag[h] >> c & SOLID_HELD_X; }

/* s->a = H u. */
static void apply(struct solid *s, const struct work *w) {
    double most = 0;
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) most = fmax(most, fabs(w->u[c][h]));
    most = par_max(most);
    const double scale = most > 0 ? STEP * s->in.spacing / most : 0;
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) s->d[c][h] = w->d[c][h] + scale * w->u[c][h];
    par_ghost_update(s->ghost, s->dim, s->d, s->n);
    solid_force_bonds(s, 0, 0);
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++)
            s->a[c][h] = is_held(s, h, c) || scale == 0 ? 0 : (w->rest[c][h] - s->a[c][h]) / scale;
}

/* f - 1 of the header, at x^2. */
static double excess(double x2) {
    x2 = fmin(x2, MOST);
    if (fabs(x2) < 1e-3) return x2 * (2. / 3 + x2 * (8. / 15 + x2 * 16. / 35));
    const double x = sqrt(fabs(x2));
    return (x2 > 0 ? asin(x) : asinh(x)) / (x * sqrt(1 - x2)) - 1;
}

/* ((1 - x^2) f - 1)/x^2 + 1. */
static double of_potential(double x2) {
    x2 = fmin(x2, MOST);
    if (fabs(x2) < 1e-3) return 2. / 3 - x2 * (2. / 15 + x2 * 8. / 105);
    return ((1 - x2) * (excess(x2) + 1) - 1) / x2 + 1;
}

/* The sum of m u.(f(X) - 1) u of the velocity in w->u, by two steps. */
static double of_velocity(struct solid *s, struct work *w, double quarter) {
    const double norm2 = solid_rates_product(s, w->u, w->u);
    if (!(norm2 > 0)) return 0;
    apply(s, w);
    const double first = solid_rates_product(s, w->u, s->a) / norm2;
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) w->u[c][h] = s->a[c][h] - first * w->u[c][h];
    const double rest2 = solid_rates_product(s, w->u, w->u), beside2 = rest2 / norm2;
    if (!(beside2 > 1e-20 * first * first)) return norm2 * excess(quarter * first);
    apply(s, w);
    const double second = solid_rates_product(s, w->u, s->a) / rest2, middle = 0.5 * (first + second),
                 half = hypot(0.5 * (first - second), sqrt(beside2)), low = middle - half, high = middle + half;
    const double of_high = (first - low) / (high - low);
    return norm2 * (of_high * excess(quarter * high) + (1 - of_high) * excess(quarter * low));
}

/* The sum of m a.(...) a of the acceleration in w->u, by one step. */
static double of_acceleration(struct solid *s, struct work *w, double quarter) {
    const double norm2 = solid_rates_product(s, w->u, w->u);
    if (!(norm2 > 0)) return 0;
    apply(s, w);
    return norm2 * quarter * of_potential(quarter * solid_rates_product(s, w->u, s->a) / norm2);
}

static void work_new(struct solid *s, struct work *w) {
    const size_t n = (size_t)s->n;
    for (int c = 0; c < s->dim; c++) {
        double **const all[] = {&w->d[c], &w->a[c], &w->rest[c], &w->u[c]};
        for (int k = 0; k < 4; k++) *all[k] = memory_new(MEMORY_SOLID, n + 1, sizeof(double));
        memcpy(w->d[c], s->d[c], n * sizeof(double));
        memcpy(w->a[c], s->a[c], n * sizeof(double));
    }
}

static void work_free(struct solid *s, struct work *w) {
    for (int c = 0; c < s->dim; c++) {
        memcpy(s->a[c], w->a[c], (size_t)s->n * sizeof(double));
        MEMORY_FREE(w->d[c], w->a[c], w->rest[c], w->u[c]);
    }
}

double solid_shadow_waves(struct solid *s, double dt) {
    const long sweeps = s->sweeps;
    const double power = s->power_damped, quarter = 0.25 * dt * dt;
    struct solid_forms *forms = solid_forms_save(s);
    struct work w = {0};
    work_new(s, &w);
    par_ghost_update(s->ghost, s->dim, s->d, s->n);
    solid_force_bonds(s, 0, 0);
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) {
            w.rest[c][h] = s->a[c][h];
            w.u[c][h] = is_held(s, h, c) ? 0 : s->v[c][h];
        }
    double sum = of_velocity(s, &w, quarter);
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++)
            w.u[c][h] = is_held(s, h, c) ? 0 : w.rest[c][h] + s->load[c][h] / solid_density(s, h) + s->in.body_force[c];
    sum += of_acceleration(s, &w, quarter);
    for (int c = 0; c < s->dim; c++) memcpy(s->d[c], w.d[c], (size_t)s->n * sizeof(double));
    par_ghost_update(s->ghost, s->dim, s->d, s->n);
    solid_force_bonds(s, 0, 0); /* families' dilatations are those of d again */
    work_free(s, &w);
    solid_forms_restore(s, forms);
    s->sweeps = sweeps;
    s->power_damped = power;
    return 0.5 * sum;
}
