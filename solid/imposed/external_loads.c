/* The input's loads over time, as forces per unit volume on their particles. */
#include "solid/imposed/external_loads.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/edge_load.h"
#include "solid/imposed/time.h"

#include <string.h>

/* The particles of a load, and the force on each at a factor of 1. */
struct share {
    int n;
    int *h;
    double *force[3]; /* [n] N/m3 */
    double factor;    /* the factor contained in s->load */
};

struct solid_external_loads {
    int loads;
    struct share *share; /* [loads] */
    int touched;
    int *touch;     /* [touched] particles with a load */
    double *sum[3]; /* [s->n] the loads' part of s->load, N/m3 */
};

static void *array(int n, size_t size) { return memory_new(MEMORY_SOLID, (size_t)n + 1, size); }

/* part [n]: of the value, by owned particle; those with a part are stored, also where the value is 0. */
static void share_new(const struct solid *s, struct share *p, const double *part, const double value[3]) {
    p->h = array(s->n, sizeof *p->h);
    for (int h = 0; h < s->n; h++)
        if (part[h] != 0) p->h[p->n++] = h;
    for (int c = 0; c < s->dim; c++) {
        p->force[c] = array(p->n, sizeof **p->force);
        for (int i = 0; i < p->n; i++) p->force[c][i] = value[c] * part[p->h[i]];
    }
}

static void of_region(const struct solid *s, const struct solid_load *load, double *part) {
    for (int h = 0; h < s->n; h++) part[h] = solid_constraint_inside(s, h, load->low, load->high, &load->turn);
}

void solid_external_loads_new(struct solid *s, struct solid_sites *const *sites, solid_edge_load_lengths *of_cloud) {
    if (s->in.loads == 0) return;
    struct solid_external_loads *g = memory_new(MEMORY_SOLID, 1, sizeof *g);
    g->loads = s->in.loads;
    g->share = array(g->loads, sizeof *g->share);
    g->touch = array(s->n, sizeof *g->touch);
    for (int c = 0; c < s->dim; c++) g->sum[c] = array(s->n, sizeof **g->sum);
    double *part = array(s->n, sizeof *part);
    uint8_t *touched = array(s->n, 1);
    struct solid_edges *edges = sites ? solid_edge_load_new(&s->in) : NULL;
    for (int k = 0; k < g->loads; k++) {
        const struct solid_load *load = &s->in.load[k];
        memset(part, 0, (size_t)s->n * sizeof *part);
        switch (load->kind) {
        case SOLID_LOAD_REGION:
            of_region(s, load, part);
            break;
        case SOLID_LOAD_EDGE:
            if (sites)
                solid_edge_load_per_volume(s, sites, edges, k, part);
            else
                solid_edge_load_per_volume_refined(s, of_cloud, k, part);
            break;
        }
        share_new(s, &g->share[k], part, load->kind == SOLID_LOAD_REGION ? load->force : load->traction);
        if (par_sum_long(g->share[k].n) == 0) die_all(EXIT_CODE_SCENE, "solid.loads[%d]: no particle takes it up", k);
        for (int i = 0; i < g->share[k].n; i++) touched[g->share[k].h[i]] = 1;
    }
    for (int h = 0; h < s->n; h++)
        if (touched[h]) g->touch[g->touched++] = h;
    memory_free(touched);
    if (edges) solid_edge_load_free(edges);
    memory_free(part);
    s->external_loads = g;
    solid_external_loads_update(s, s->t, 0);
}

void solid_external_loads_free(struct solid_external_loads *g) {
    if (!g) return;
    for (int k = 0; k < g->loads; k++) {
        memory_free(g->share[k].h);
        for (int c = 0; c < 3; c++) memory_free(g->share[k].force[c]);
    }
    for (int c = 0; c < 3; c++) memory_free(g->sum[c]);
    MEMORY_FREE(g->share, g->touch, g);
}

void solid_external_loads_invalidate(struct solid *s) {
    struct solid_external_loads *g = s->external_loads;
    if (!g) return;
    for (int k = 0; k < g->loads; k++) g->share[k].factor = 0;
    for (int c = 0; c < s->dim; c++) memset(g->sum[c], 0, (size_t)s->n * sizeof **g->sum);
}

void solid_external_loads_restart(struct solid *s) {
    if (!s->external_loads) return;
    for (int c = 0; c < s->dim; c++) memset(s->load[c], 0, (size_t)s->n * sizeof(double));
    solid_external_loads_invalidate(s);
}

void solid_external_loads_mark(const struct solid *s, uint8_t *mark) {
    for (int i = 0; s->external_loads && i < s->external_loads->touched; i++) mark[s->external_loads->touch[i]] = 1;
}

double solid_external_loads_on(const struct solid *s, int h, int c) {
    return s->external_loads ? s->external_loads->sum[c][h] : 0;
}

double solid_external_loads_factor(const struct solid *s, int k) {
    return s->external_loads ? s->external_loads->share[k].factor : 0;
}

struct solid_external_loads_sum solid_external_loads_sum_of(const struct solid *s, int k) {
    struct solid_external_loads_sum sum = {0};
    if (!s->external_loads) return sum;
    const struct share *p = &s->external_loads->share[k];
    sum.particles = p->n;
    for (int i = 0; i < p->n; i++) {
        const double volume = s->volume[p->h[i]];
        sum.volume += volume;
        for (int c = 0; c < s->dim; c++) {
            sum.force[c] += volume * p->force[c][i];
            sum.moved[c] += volume * s->d[c][p->h[i]];
        }
    }
    return sum;
}

/* Sums up component c of the loads at the present factors, into sum, which is 0. */
static void sum_up(struct solid_external_loads *g, int c) {
    for (int k = 0; k < g->loads; k++) {
        const struct share *p = &g->share[k];
        for (int i = 0; i < p->n; i++) g->sum[c][p->h[i]] += p->factor * p->force[c][i];
    }
}

void solid_external_loads_save(const struct solid *s, double *factor) {
    for (int k = 0; s->external_loads && k < s->external_loads->loads; k++)
        factor[k] = s->external_loads->share[k].factor;
}

void solid_external_loads_restore(struct solid *s, const double *factor) {
    struct solid_external_loads *g = s->external_loads;
    int differs = 0;
    for (int k = 0; g && k < g->loads; k++) {
        differs |= factor[k] != g->share[k].factor;
        g->share[k].factor = factor[k];
    }
    for (int c = 0; differs && c < s->dim; c++) {
        for (int i = 0; i < g->touched; i++) g->sum[c][g->touch[i]] = 0;
        sum_up(g, c);
    }
}

int solid_external_loads_update(struct solid *s, double t, double dt) {
    struct solid_external_loads *g = s->external_loads;
    int differs = 0;
    for (int k = 0; g && k < g->loads; k++) {
        const double factor = solid_time_mean(&s->in.load[k].time, t, t + dt);
        differs |= factor != g->share[k].factor;
        g->share[k].factor = factor;
    }
    if (!differs) return 0;
    for (int c = 0; c < s->dim; c++) {
        double *load = s->load[c], *sum = g->sum[c];
        for (int i = 0; i < g->touched; i++) { /* load - sum is exactly 0 for a particle without other loads */
            load[g->touch[i]] -= sum[g->touch[i]];
            sum[g->touch[i]] = 0;
        }
        sum_up(g, c);
        for (int i = 0; i < g->touched; i++) load[g->touch[i]] += sum[g->touch[i]];
    }
    return 1;
}
