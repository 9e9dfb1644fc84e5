/* Indenters: their places, and the forces on the particles inside them. */
#include "solid/imposed/indenter.h"
#include "base/memory.h"

#include <math.h>
#include <string.h>

void solid_indenter_new(struct solid *s) {
    const size_t n = (size_t)s->in.indenters;
    if (n == 0) return;
    struct solid_indent *indent = memory_new(MEMORY_SOLID, 1, sizeof *indent);
    indent->place = memory_new(MEMORY_SOLID, n, sizeof *indent->place);
    indent->force = memory_new(MEMORY_SOLID, n, sizeof *indent->force);
    indent->energy = memory_new(MEMORY_SOLID, n, sizeof *indent->energy);
    indent->inside = memory_new(MEMORY_SOLID, n, sizeof *indent->inside);
    s->indent = indent;
    solid_indenter_place(s, s->t);
}

void solid_indenter_free(struct solid_indent *indent) {
    if (!indent) return;
    MEMORY_FREE(indent->place, indent->force, indent->energy, indent->inside, indent);
}

void solid_indenter_place(struct solid *s, double t) {
    struct solid_indent *indent = s->indent;
    if (!indent) return;
    indent->t = t;
    for (int k = 0; k < s->in.indenters; k++)
        for (int c = 0; c < 3; c++)
            indent->place[k][c] = s->in.indenter[k].centre[c] + s->in.indenter[k].velocity[c] * t;
}

/* From one indenter; returns its power, W. */
static double push(struct solid *s, int k) {
    struct solid_indent *indent = s->indent;
    const struct solid_indenter *in = &s->in.indenter[k];
    double power = 0, away[3];
    memset(indent->force[k], 0, sizeof indent->force[k]);
    indent->energy[k] = 0;
    indent->inside[k] = 0;
    for (int h = 0; h < s->n; h++) {
        double r2 = 0;
        for (int c = 0; c < s->dim; c++) {
            away[c] = solid_shortest(s, c, s->x0[c][h] + s->d[c][h] - indent->place[k][c]);
            r2 += away[c] * away[c];
        }
        if (!(r2 < in->radius * in->radius) || r2 == 0) continue;
        const double r = sqrt(r2), depth = in->radius - r, f = in->stiffness * depth * depth / r;
        const double inv_density = 1 / solid_density(s, h), volume = s->volume[h];
        for (int c = 0; c < s->dim; c++) {
            const double force = f * away[c];
            s->a[c][h] += force * inv_density;
            power += volume * force * s->v[c][h];
            indent->force[k][c] += volume * force;
        }
        indent->energy[k] += volume * in->stiffness / 3 * depth * depth * depth;
        indent->inside[k]++;
    }
    return power;
}

void solid_indenter_push(struct solid *s) {
    for (int k = 0; k < s->in.indenters; k++) s->power_load += push(s, k);
}

static double lightest_of(const struct solid *s) {
    double least = INFINITY;
    for (int m = 0; m < s->in.materials; m++) least = fmin(least, s->in.material[m].density);
    return least;
}

double solid_indenter_rate(const struct solid *s) {
    double sum = 0;
    for (int k = 0; k < s->in.indenters; k++) sum += 2 * s->in.indenter[k].stiffness * s->in.indenter[k].radius;
    return sum / lightest_of(s);
}

/* All the energy of a particle at the centre, and twice the indenter's own speed. */
double solid_indenter_speed(const struct solid *s) {
    double sum = 0;
    for (int k = 0; k < s->in.indenters; k++) {
        const struct solid_indenter *in = &s->in.indenter[k];
        sum += sqrt(2 * in->stiffness * in->radius * in->radius * in->radius / (3 * lightest_of(s)));
        for (int c = 0; c < s->dim; c++) sum += 2 * fabs(in->velocity[c]);
    }
    return sum;
}
