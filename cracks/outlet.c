/* Outlets: wet particles at which the cracks are open to a fluid outside, whose pressure is given. */
#include "cracks/outlet.h"
#include "base/memory.h"
#include "base/par.h"
#include "cracks/struts.h"

#include <math.h>
#include <string.h>

struct cracks_outlets *cracks_outlet_new(const struct solid *s) {
    struct cracks_outlets *m = memory_new(MEMORY_SOLID, 1, sizeof *m);
    cracks_outlet_reserve(m, 1);
    m->gain = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *m->gain);
    return m;
}

void cracks_outlet_free(struct cracks_outlets *m) {
    if (!m) return;
    MEMORY_FREE(m->h, m->rate, m->pressure, m->conductance, m->volume, m->storage, m->gain, m);
}

void cracks_outlet_reserve(struct cracks_outlets *m, int n) {
    if (n < m->capacity) return;
    const size_t used = (size_t)m->n, capacity = (size_t)(n + n / 4 + 64);
    double **const array[] = {&m->rate, &m->pressure, &m->conductance, &m->volume, &m->storage};
    m->h = memory_grown(MEMORY_SOLID, m->h, used, capacity, sizeof *m->h);
    for (size_t a = 0; a < sizeof array / sizeof array[0]; a++)
        *array[a] = memory_grown(MEMORY_SOLID, *array[a], used, capacity, sizeof **array[a]);
    m->capacity = (int)capacity;
}

double cracks_outlet_rate(const struct cracks_outlets *m, int h) {
    int low = 0, high = m->n;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (m->h[middle] < h)
            low = middle + 1;
        else
            high = middle;
    }
    return low < m->n && m->h[low] == h ? m->rate[low] : 0;
}

int cracks_outlet_is_wet(const struct cracks *c, int h) { return cracks_struts_wet(&c->struts, h) >= 0; }

/* Both lists ascend. */
void cracks_outlet_set(struct cracks *c, int n, const int *h, const double *flow, const double *conductance) {
    struct cracks_outlets *m = c->outlets;
    cracks_outlet_reserve(m, n);
    double *rate = m->storage; /* work */
    for (int k = 0, j = 0; k < n; k++) {
        while (j < m->n && m->h[j] < h[k]) j++;
        rate[k] = j < m->n && m->h[j] == h[k] ? m->rate[j] : 0;
    }
    m->n = n;
    memset(m->gain, 0, (size_t)c->solid->n * sizeof *m->gain);
    for (int k = 0; k < n; k++) {
        m->h[k] = h[k];
        m->rate[k] = rate[k];
        m->conductance[k] = conductance[k];
        m->pressure[k] = fmax(fmax(flow[k], c->in.least_pressure) + rate[k] / conductance[k], c->in.least_pressure);
        m->volume[k] = 0;
    }
}

void cracks_outlet_begin(struct cracks *c, double dt) {
    struct cracks_outlets *m = c->outlets;
    for (int k = 0; k < m->n; k++) {
        double *storage = &c->storage[cracks_struts_wet(&c->struts, m->h[k])];
        m->storage[k] = *storage;
        *storage += dt * m->conductance[k];
    }
}

void cracks_outlet_source(const struct cracks *c, double dt, double *source) {
    const struct cracks_outlets *m = c->outlets;
    for (int k = 0; k < m->n; k++)
        source[cracks_struts_wet(&c->struts, m->h[k])] += dt * m->conductance[k] * m->pressure[k];
}

void cracks_outlet_end(struct cracks *c) {
    const struct cracks_outlets *m = c->outlets;
    for (int k = 0; k < m->n; k++) c->storage[cracks_struts_wet(&c->struts, m->h[k])] = m->storage[k];
}

void cracks_outlet_fill(struct cracks *c, double dt) {
    struct cracks_outlets *m = c->outlets;
    for (int k = 0; k < m->n; k++) {
        const int i = cracks_struts_wet(&c->struts, m->h[k]);
        const double entered = dt * m->conductance[k] * (m->pressure[k] - c->p[i]);
        c->content[i] += entered;
        m->volume[k] += entered;
        m->gain[m->h[k]] += entered;
    }
}

void cracks_outlet_end_step(struct cracks *c, double dt) {
    struct cracks_outlets *m = c->outlets;
    double sum = 0;
    for (int k = 0; k < m->n; k++) {
        sum += m->volume[k];
        m->rate[k] = m->volume[k] / dt;
        m->volume[k] = 0;
    }
    c->entered += par_sum(sum);
}
