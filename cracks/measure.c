/* The numbers of the series. */
#include "cracks/measure.h"
#include "base/par.h"
#include "cracks/aperture.h"
#include "cracks/outlet.h"
#include "cracks/solve.h"
#include "cracks/struts.h"
#include "cracks/sums.h"

#include <math.h>
#include <string.h>

const char *const cracks_measure_field_name[CRACKS_FIELDS] = {"crack_pressure", "crack_aperture", "crack_area",
                                                              "crack_cavity"};

void cracks_measure_field(const struct cracks *c, int field, double *value) {
    const struct cracks_struts *t = &c->struts;
    memset(value, 0, (size_t)c->solid->n * sizeof *value);
    for (int i = 0; i < t->n; i++) {
        const double values[CRACKS_FIELDS] = {c->p[i], cracks_aperture_of(c, i), t->area_size[i], c->cavity[i]};
        value[t->h[i]] = values[field];
    }
}

static void measure_outlets(const struct cracks *c, struct cracks_values *v) {
    const struct cracks_outlets *m = c->outlets;
    const int n = c->solid->push ? m->n : 0; /* else nothing goes through them */
    double sum[3] = {0, 0, 0};
    for (int k = 0; k < n; k++) {
        const int i = cracks_struts_wet(&c->struts, m->h[k]);
        sum[0] += m->rate[k];
        if (i >= 0) sum[1] += c->p[i], sum[2]++;
    }
    par_sum_array(sum, 3);
    v->outlet_rate = sum[0];
    v->outlet_pressure = sum[2] > 0 ? sum[1] / sum[2] : 0;
    v->outlets = sum[2];
    v->entered = c->entered;
    v->resolved = c->resolved;
    v->handed = c->handed;
    v->unshared = v->volume + v->resolved - v->handed;
}

/* Of the present struts: those that broke in the last substep do not push yet, but count in `volume`. What a drift adds
 * to F.d is in the sum of its sizes, and cancels but for round-off. */
static void measure_works(const struct cracks *c, const double *volume, double sum[3]) {
    static const double ROUNDED = 1e-9;
    const struct solid *s = c->solid;
    cracks_vec *force = c->work->u;
    cracks_struts_update(&c->struts, sizeof *c->p, c->p);
    cracks_sums_force(c, c->p, force);
    sum[0] = sum[1] = sum[2] = 0;
    for (int i = 0; i < c->struts.n; i++) {
        const int h = c->struts.h[i];
        for (int k = 0; k < s->dim; k++) {
            const double work = force[i][k] * s->d[k][h];
            sum[0] += work;
            sum[2] += ROUNDED * fabs(work);
        }
        sum[1] += c->p[i] * volume[i];
        sum[2] += fabs(c->p[i] * volume[i]);
    }
    par_sum_array(sum, 3);
}

struct cracks_values cracks_measure(const struct cracks *c) {
    const struct cracks_struts *t = &c->struts;
    struct cracks_values v = {0};
    double sum[9] = {0}, work[3] = {0}, *volume = c->work->b;
    const double *cracks = c->open ? c->open : volume;
    cracks_aperture_volume(c, volume);
    if (c->open) cracks_aperture_open(c);
    const int flows = c->solid->push && c->began; /* while it does not, the voids take what the volumes change by */
    for (int i = 0; i < t->n; i++) {
        sum[0] += volume[i];
        sum[1] += c->cavity[i] + (flows ? 0 : volume[i] - c->volume[i]);
        sum[2] += c->storage[i] * c->p[i];
        sum[3] += t->area_size[i];
        sum[4] += t->area_size[i] * c->p[i];
        sum[5] += t->area_size[i] > 0 || !c->in.porous;
        if (c->in.injections > 0) sum[6] += c->weight[i] * c->p[i];
        sum[7] += cracks[i];
        sum[8] += flows ? fabs(volume[i] - c->volume[i]) : 0;
        v.aperture_max = fmax(v.aperture_max, cracks_aperture_of(c, i));
    }
    par_sum_array(sum, 9);
    if (flows) measure_works(c, volume, work);
    par_max_array(&v.aperture_max, 1);
    v.volume = sum[7];
    v.cavity = sum[1] - (c->open && !c->began ? sum[0] - sum[7] : 0); /* the pores are not void */
    v.stored = sum[2];
    for (int q = 0; q < c->in.injections; q++) {
        v.injected += c->injected[q];
        v.injection_rate += c->rate[q];
    }
    v.leaked = c->leaked;
    if (c->outlets) measure_outlets(c, &v);
    v.residual = sum[0] - sum[1] + v.stored + v.leaked + v.resolved - v.injected - v.entered - c->filled;
    v.misplaced = sum[8];
    v.on_solid = work[0];
    v.on_fluid = work[1];
    v.on_size = work[2];
    v.injection_pressure = sum[6];
    v.area = sum[3];
    v.pressure_mean = sum[3] > 0 ? sum[4] / sum[3] : 0;
    v.aperture_mean = sum[3] > 0 ? sum[7] / sum[3] : 0;
    v.wet_particles = sum[5];
    return v;
}
