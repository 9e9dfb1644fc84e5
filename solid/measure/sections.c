/* Finds the plane section of a body with the largest nominal stress, by statics alone. */
#include "solid/measure/sections.h"
#include "base/memory.h"
#include "base/par.h"
#include "physics/griffith.h"
#include "solid/measure/support.h"

#include <math.h>

/* Sums over the particles of a layer: volume, its first and second moments along p and q; force and moment. */
enum { VOLUME, FIRST, SECOND = FIRST + 2, FORCE = SECOND + 2, MOMENT = FORCE + 3, SUMS = MOMENT + 3 };
enum { ENDS = 4 }; /* largest -p, p, -q, q */

struct layers {
    int n, axis, p, q;
    double low, spacing;
    double (*sum)[SUMS], (*end)[ENDS]; /* [n] */
};

static void layer_add(double sum[SUMS], double end[ENDS], const struct layers *l, const double x[3], double volume,
                      const double force[3]) {
    const int across[2] = {l->p, l->q};
    sum[VOLUME] += volume;
    for (int k = 0; k < 2; k++) {
        const double y = x[across[k]];
        sum[FIRST + k] += volume * y;
        sum[SECOND + k] += volume * y * y;
        end[2 * k] = fmax(end[2 * k], -y);
        end[2 * k + 1] = fmax(end[2 * k + 1], y);
    }
    for (int c = 0; c < 3; c++) {
        const int a = (c + 1) % 3, b = (c + 2) % 3;
        sum[FORCE + c] += volume * force[c];
        sum[MOMENT + c] += volume * (x[a] * force[b] - x[b] * force[a]);
    }
}

static struct layers layers_new(const struct solid *s, const uint8_t *chosen, const struct solid_support_extent *e,
                                int axis, double *const force[3]) {
    struct layers l = {.axis = axis, .p = (axis + 1) % 3, .q = (axis + 2) % 3, .spacing = s->in.spacing};
    l.low = e->low[axis];
    l.n = (int)lrint((e->high[axis] - e->low[axis]) / l.spacing) + 1;
    l.sum = memory_new(MEMORY_OUTPUT, (size_t)l.n, sizeof *l.sum);
    l.end = memory_new(MEMORY_OUTPUT, (size_t)l.n, sizeof *l.end);
    for (int k = 0; k < l.n; k++)
        for (int j = 0; j < ENDS; j++) l.end[k][j] = -INFINITY;
    for (int h = 0; h < s->n; h++) {
        if (!chosen[s->body[h]]) continue;
        double x[3] = {0}, f[3] = {0};
        for (int c = 0; c < s->dim; c++) {
            x[c] = solid_support_place(s, e, c, h);
            f[c] = force[c][h];
        }
        const int k = (int)fmin(l.n - 1, floor(x[axis] / l.spacing + 0.5));
        layer_add(l.sum[k], l.end[k], &l, x, s->volume[h], f);
    }
    par_sum_array(l.sum[0], l.n * SUMS);
    par_max_array(l.end[0], l.n * ENDS);
    return l;
}

/* Second moment of area of a section along the direction number k of p, q, about its centre, m4. */
static double inertia_of(const double sum[SUMS], double spacing, int k) {
    const double mean = sum[FIRST + k] / sum[VOLUME];
    return (sum[SECOND + k] - sum[FIRST + k] * mean + sum[VOLUME] * spacing * spacing / 12) / spacing;
}

/* The outermost fibre's stress by the moment about p or q, which bends along the direction number k of p, q. */
static double bending(const double sum[SUMS], const double end[ENDS], double spacing, int k, double moment) {
    const double mean = sum[FIRST + k] / sum[VOLUME];
    return fabs(moment) * (fmax(end[2 * k + 1] - mean, end[2 * k] + mean) + 0.5 * spacing) /
           inertia_of(sum, spacing, k);
}

/* Of a fibre under a normal and a shear stress, Pa. */
static double tension_of(double normal, double shear) {
    const double root = hypot(0.5 * normal, shear);
    return physics_griffith_tension((const double[3]){0.5 * normal + root, 0, 0.5 * normal - root});
}

/* The moment about p or q that bends a section along the direction number j of p, q: that of the force beyond it and
 * of its moment about the origin of x, about the section's centre. */
static double moment_on(const struct layers *l, int k, int j, const double beyond[6]) {
    const double *sum = l->sum[k], *f = beyond, *m = beyond + 3;
    double centre[3] = {0};
    centre[l->axis] = k * l->spacing;
    centre[l->p] = sum[FIRST] / sum[VOLUME];
    centre[l->q] = sum[FIRST + 1] / sum[VOLUME];
    const int about = j ? l->p : l->q, a = (about + 1) % 3, b = (about + 2) % 3;
    return m[about] - (centre[a] * f[b] - centre[b] * f[a]);
}

/* beyond: force on all that lies beyond the section, and its moment about the origin of x. */
static double stress_on(const struct layers *l, int k, const double beyond[6], const int endless[3]) {
    const double *sum = l->sum[k], area = sum[VOLUME] / l->spacing;
    if (!(area > 0)) return 0;
    double bent = 0;
    const double *f = beyond, normal = f[l->axis] / area, shear = 1.5 * hypot(f[l->p], f[l->q]) / area;
    for (int j = 0; j < 2; j++)
        if (!endless[j ? l->q : l->p]) bent += bending(sum, l->end[k], l->spacing, j, moment_on(l, k, j, beyond));
    return fmax(tension_of(normal + bent, shear), tension_of(normal - bent, shear));
}

/* Force on all that lies beyond each section, and its moment about the origin of x. [l->n] */
static void resultants(const struct layers *l, double (*beyond)[6]) {
    double sum[6] = {0};
    for (int k = l->n - 1; k >= 0; k--) /* half of the layer itself lies beyond its middle */
        for (int c = 0; c < 6; c++) {
            beyond[k][c] = sum[c] + 0.5 * l->sum[k][FORCE + c];
            sum[c] += l->sum[k][FORCE + c];
        }
}

static void add_to_all(const struct layers *l, int c, double value, double (*beyond)[6]) {
    for (int k = 0; k < l->n; k++) beyond[k][c] += value;
}

/* A force along the axis or across it stretches or shears an endless bar nowhere on the whole: its mean, weighted by
 * 1/area, is 0. */
static double mean_force(const struct layers *l, int c, double (*beyond)[6]) {
    double sum = 0, weight = 0;
    for (int k = 0; k < l->n; k++) {
        if (!(l->sum[k][VOLUME] > 0)) continue;
        sum += beyond[k][c] / l->sum[k][VOLUME];
        weight += 1 / l->sum[k][VOLUME];
    }
    return sum / weight;
}

/* The same of the moment that bends along the direction number j: the ends of a period are parallel. */
static double mean_moment(const struct layers *l, int j, double (*beyond)[6]) {
    double sum = 0, weight = 0;
    for (int k = 0; k < l->n; k++) {
        if (!(l->sum[k][VOLUME] > 0)) continue;
        const double inertia = inertia_of(l->sum[k], l->spacing, j);
        sum += moment_on(l, k, j, beyond[k]) / inertia;
        weight += 1 / inertia;
    }
    return sum / weight;
}

/* Bodies that are endless along the axis: the next period holds their ends. Its force across the axis balances the
 * moments on a period, or shears it nowhere on the whole where a moment means nothing. */
static void join_ends(const struct layers *l, const struct solid_support_extent *e, double (*beyond)[6]) {
    const double period = e->period[l->axis];
    double total[6] = {0}, add[3] = {0};
    for (int k = 0; k < l->n; k++)
        for (int c = 0; c < 6; c++) total[c] += l->sum[k][FORCE + c];
    add[l->axis] = -mean_force(l, l->axis, beyond);
    add[l->p] = e->endless[l->p] ? -mean_force(l, l->p, beyond) : -total[3 + l->q] / period;
    add[l->q] = e->endless[l->q] ? -mean_force(l, l->q, beyond) : total[3 + l->p] / period;
    for (int c = 0; c < 3; c++) add_to_all(l, c, add[c], beyond);
    add_to_all(l, 3 + l->p, -period * add[l->q], beyond);
    add_to_all(l, 3 + l->q, period * add[l->p], beyond);
    add_to_all(l, 3 + l->q, -mean_moment(l, 0, beyond), beyond);
    add_to_all(l, 3 + l->p, -mean_moment(l, 1, beyond), beyond);
}

static void worst_of(const struct layers *l, const struct solid_support_extent *e, struct solid_section *worst) {
    double(*beyond)[6] = memory_new(MEMORY_OUTPUT, (size_t)l->n, sizeof *beyond);
    resultants(l, beyond);
    if (e->endless[l->axis]) join_ends(l, e, beyond);
    for (int k = l->n - 1; k >= 0; k--) {
        const double stress = stress_on(l, k, beyond[k], e->endless);
        if (!(stress > worst->stress)) continue;
        double at = l->low + k * l->spacing;
        if (e->period[l->axis] > 0 && at >= e->period[l->axis]) at -= e->period[l->axis];
        *worst = (struct solid_section){stress, l->axis, at, l->sum[k][VOLUME] / l->spacing};
    }
    memory_free(beyond);
}

struct solid_section solid_sections_worst(const struct solid *s, const uint8_t *chosen, double *const force[3]) {
    struct solid_section worst = {.axis = -1};
    const struct solid_support_extent e = solid_support_extent_of(s, chosen);
    if (!(e.low[0] < INFINITY)) return worst;
    solid_support_add(s, chosen, &e, force);
    for (int axis = 0; axis < s->dim; axis++) {
        struct layers l = layers_new(s, chosen, &e, axis, force);
        worst_of(&l, &e, &worst);
        MEMORY_FREE(l.sum, l.end);
    }
    return worst;
}
