/* What enters the cracks through the wet particles of a box. */
#include "cracks/inject.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "cracks/solve.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/time.h"

#include <math.h>

/* The volumes of the particles in the box. Returns their sum. Collective. */
static double weigh_by_volume(const struct cracks *c, const struct cracks_injection *in, double *weight) {
    const struct solid_turn unturned = {0};
    double sum = 0;
    for (int i = 0; i < c->struts.n; i++) {
        const int h = c->struts.h[i], inside = solid_constraint_inside(c->solid, h, in->low, in->high, &unturned);
        weight[i] = inside ? c->solid->volume[h] : 0;
        sum += weight[i];
    }
    return par_sum(sum);
}

/* Parts by area. With pores the parts of a pressure, and of a rate where all areas are 0, by the particles' volume. */
void cracks_inject_renew(struct cracks *c) {
    const struct cracks_struts *t = &c->struts;
    const struct solid_turn unturned = {0};
    const size_t n = (size_t)t->n + 1;
    c->weight = memory_renew(MEMORY_SOLID, c->weight, n * (size_t)c->in.injections + 1, sizeof *c->weight);
    for (int q = 0; q < c->in.injections; q++) {
        const struct cracks_injection *in = &c->in.injection[q];
        double *weight = c->weight + n * (size_t)q, sum[2] = {0, 0};
        for (int i = 0; i < t->n; i++) {
            if (!solid_constraint_inside(c->solid, t->h[i], in->low, in->high, &unturned)) continue;
            weight[i] = t->area_size[i];
            sum[0] += weight[i];
            sum[1]++;
        }
        par_sum_array(sum, 2);
        if (c->in.porous && (in->is_pressure || sum[0] == 0)) sum[0] = weigh_by_volume(c, in, weight);
        c->particles[q] = (long)sum[1];
        for (int i = 0; i < t->n; i++) weight[i] = sum[0] > 0 ? weight[i] / sum[0] : 0;
    }
}

void cracks_inject_check(const struct cracks *c) {
    for (int q = 0; q < c->in.injections; q++)
        if (c->particles[q] == 0)
            die_all(EXIT_CODE_SCENE,
                    "crack_fluid.injections[%d]: no particle with a broken bond stands between low and high: put an "
                    "initial crack (solid.cracks) there",
                    q);
}

double cracks_inject_begin(struct cracks *c, double time, double dt) {
    const struct cracks_struts *t = &c->struts;
    double sum = 0;
    for (int q = 0; q < c->in.injections; q++) {
        const struct cracks_injection *in = &c->in.injection[q];
        const double *weight = c->weight + ((size_t)t->n + 1) * (size_t)q;
        if (!in->is_pressure) {
            c->rate[q] = in->value * solid_time_mean(&in->time, time, time + dt);
            sum += dt * fabs(c->rate[q]);
            continue;
        }
        const double p = fmax(in->value * solid_time_factor(&in->time, time + dt), c->in.least_pressure);
        c->work->force_holds = 0;
        for (int i = 0; i < t->n; i++) {
            if (!(weight[i] > 0)) continue;
            c->p[i] = p;
            c->work->set[i] = CRACKS_GIVEN;
        }
    }
    return sum;
}

void cracks_inject_source(const struct cracks *c, double dt, double *source) {
    const struct cracks_struts *t = &c->struts;
    for (int q = 0; q < c->in.injections; q++) {
        const double *weight = c->weight + ((size_t)t->n + 1) * (size_t)q;
        for (int i = 0; i < t->n && !c->in.injection[q].is_pressure; i++) source[i] += dt * c->rate[q] * weight[i];
    }
}

/* Whether a later injection gives the pressure of strut particle i too: that one holds, and the fluid enters by it. */
static int has_later_pressure(const struct cracks *c, int q, int i) {
    const size_t n = (size_t)c->struts.n + 1;
    for (int later = q + 1; later < c->in.injections; later++)
        if (c->in.injection[later].is_pressure && c->weight[n * (size_t)later + (size_t)i] > 0) return 1;
    return 0;
}

void cracks_inject_fill(struct cracks *c, double dt, const double *residual) {
    const struct cracks_struts *t = &c->struts;
    for (int q = 0; q < c->in.injections; q++) {
        const struct cracks_injection *in = &c->in.injection[q];
        const double *weight = c->weight + ((size_t)t->n + 1) * (size_t)q;
        double entered = 0;
        for (int i = 0; i < t->n; i++) {
            if (!(weight[i] > 0) || (in->is_pressure && has_later_pressure(c, q, i))) continue;
            const double dq = in->is_pressure ? -residual[i] : dt * c->rate[q] * weight[i];
            c->content[i] += dq;
            entered += dq;
        }
        if (in->is_pressure) c->rate[q] = par_sum(entered) / dt;
        c->injected[q] += dt * c->rate[q];
    }
}
