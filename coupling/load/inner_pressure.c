/* The pressure of the fluid inside a body, which the load by reaction leaves out and the pressure in a crack does not.
 */
/* The reaction is the traction of the flow less the pressure p_i of the fluid inside the body: the bonds have the
 * stress sigma + p_i I, with sigma the solid's. Where the real solid bears the traction -p n, these bonds bear
 * -(p - p_i) n. So
 *
 *     the faces of a crack take  -(p_crack - p_i) n ,   a face outside the domain takes  p_i n ,
 *
 * and a pressure that is the same all around opens nothing. In a body at rest p_i does not vary. It is taken as its
 * mean over the particles deep in the body, or over all of them in a body that has no such. */
#include "coupling/load/inner_pressure.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/interface/place.h"
#include "coupling/load/inner_fluid.h"
#include "coupling/run.h"
#include "cracks/project.h"
#include "cracks/sums.h"

#include <math.h>
#include <string.h>

/* Particles of a body that are read, about. */
enum { READ = 4096, SUMS = 5 };
/* Of a probe that reads where it stands, cells. */
static const double SHORT = 1e-6;

struct inner_pressure {
    struct ibm *ibm; /* its route for the places that are read */
    int n, capacity;
    int *h;                         /* [n] the particles that are read */
    double *x[3], *normal[3];       /* [n] m; any unit vector */
    double *traction[3], *pressure; /* [n] Pa */
    uint8_t *active;                /* [n] */
    long *stride;                   /* [bodies] one of so many particles is read */
    double *sum;     /* [bodies][SUMS] of all that are read: pressures, number; of the deep: the same, squares */
    double *of_body; /* [bodies] p_i, Pa */
    double uneven;   /* largest standard deviation deep in a body, Pa */
    int wet_capacity;
    double *of_wet;           /* [wet particles and ghosts] -p_i, Pa */
    cracks_vec *of_wet_force; /* [wet particles] N */
    double *load[3];          /* [n of the solid] N/m3 */
};

static void find_strides(struct inner_pressure *k, const struct solid *s) {
    const int bodies = s->in.bodies;
    for (int b = 0; b < bodies; b++) k->of_body[b] = 0;
    for (int h = 0; h < s->n; h++) k->of_body[s->body[h]]++;
    par_sum_array(k->of_body, bodies);
    for (int b = 0; b < bodies; b++) k->stride[b] = 1 + (long)k->of_body[b] / READ;
}

struct inner_pressure *inner_pressure_new(struct run *r) {
    if (!r->cracks) return NULL;
    struct inner_pressure *k = memory_new(MEMORY_COUPLING, 1, sizeof *k);
    const struct solid *s = r->solid;
    const size_t n = (size_t)s->n + 1, bodies = (size_t)s->in.bodies;
    k->ibm = ibm_new(r->fluid, 0);
    k->h = memory_new(MEMORY_COUPLING, n, sizeof *k->h);
    k->pressure = memory_new(MEMORY_COUPLING, n, sizeof *k->pressure);
    k->active = memory_new(MEMORY_COUPLING, n, 1);
    k->stride = memory_new(MEMORY_COUPLING, bodies, sizeof *k->stride);
    k->sum = memory_new(MEMORY_COUPLING, SUMS * bodies, sizeof *k->sum);
    k->of_body = memory_new(MEMORY_COUPLING, bodies, sizeof *k->of_body);
    for (int c = 0; c < 3; c++) {
        k->x[c] = memory_new(MEMORY_COUPLING, n, sizeof(double));
        k->normal[c] = memory_new(MEMORY_COUPLING, n, sizeof(double));
        k->traction[c] = memory_new(MEMORY_COUPLING, n, sizeof(double));
        k->load[c] = memory_new(MEMORY_COUPLING, n, sizeof(double));
    }
    for (size_t h = 0; h < n; h++) k->normal[0][h] = 1;
    find_strides(k, s);
    return k;
}

void inner_pressure_free(struct inner_pressure *k) {
    if (!k) return;
    ibm_free(k->ibm);
    for (int c = 0; c < 3; c++) MEMORY_FREE(k->x[c], k->normal[c], k->traction[c], k->load[c]);
    MEMORY_FREE(k->h, k->pressure, k->active, k->stride, k->sum, k->of_body, k->of_wet, k->of_wet_force, k);
}

/* The pressure at the particles that are read. */
static void read_pressures(struct inner_pressure *k, const struct run *r) {
    const struct solid *s = r->solid;
    k->n = 0;
    for (int h = 0; h < s->n; h++) {
        double x[3];
        if ((s->first[par_rank()] + h) % k->stride[s->body[h]] != 0) continue;
        solid_position(s, h, x);
        for (int c = 0; c < 3; c++) k->x[c][k->n] = x[c];
        k->h[k->n++] = h;
    }
    const struct ibm_probe_input in = {.n = k->n,
                                       .x = {k->x[0], k->x[1], k->x[2]},
                                       .normal = {k->normal[0], k->normal[1], k->normal[2]},
                                       .is_carried = 1,
                                       .length = SHORT};
    ibm_probe(k->ibm, &in, k->traction, k->pressure, k->active);
}

static void take_means(struct inner_pressure *k, const struct run *r, const struct inner_fluid *inner) {
    const int bodies = r->solid->in.bodies;
    memset(k->sum, 0, SUMS * (size_t)bodies * sizeof *k->sum);
    for (int i = 0; i < k->n; i++) {
        double *sum = k->sum + (size_t)SUMS * r->solid->body[k->h[i]];
        if (!k->active[i]) continue;
        sum[0] += k->pressure[i];
        sum[1]++;
        if (!inner_fluid_is_deep(inner, r, k->h[i])) continue;
        sum[2] += k->pressure[i];
        sum[3]++;
        sum[4] += k->pressure[i] * k->pressure[i];
    }
    par_sum_array(k->sum, SUMS * bodies);
    for (int b = 0; b < bodies; b++) {
        const double *sum = k->sum + (size_t)SUMS * b;
        k->of_body[b] = sum[3] > 0 ? sum[2] / sum[3] : sum[1] > 0 ? sum[0] / sum[1] : 0;
        if (sum[3] > 0) k->uneven = fmax(k->uneven, sqrt(fmax(0, sum[4] / sum[3] - k->of_body[b] * k->of_body[b])));
    }
}

static void push_cracks(struct inner_pressure *k, struct run *r) {
    const struct cracks_struts *t = &r->cracks->struts;
    const struct solid *s = r->solid;
    if (t->n + t->ghosts > k->wet_capacity || !k->of_wet) {
        MEMORY_FREE(k->of_wet, k->of_wet_force);
        k->wet_capacity = t->n + t->ghosts + 64;
        k->of_wet = memory_new(MEMORY_COUPLING, (size_t)k->wet_capacity, sizeof *k->of_wet);
        k->of_wet_force = memory_new(MEMORY_COUPLING, (size_t)k->wet_capacity, sizeof *k->of_wet_force);
    }
    for (int i = 0; i < t->n + t->ghosts; i++) k->of_wet[i] = -k->of_body[s->body[t->h[i]]];
    cracks_sums_force(r->cracks, k->of_wet, k->of_wet_force);
    for (int i = 0; i < t->n; i++)
        for (int c = 0; c < s->dim; c++) k->load[c][t->h[i]] += k->of_wet_force[i][c] / s->volume[t->h[i]];
}

static void push_outside(struct inner_pressure *k, const struct run *r) {
    const struct solid *s = r->solid;
    const struct solid_surface *f = r->surface;
    for (int i = 0; i < f->n; i++) {
        const int h = f->h[i];
        if (f->two_sided[i] != SOLID_ONE_FACE || place_is_inside(fluid_grid_of(r->fluid), s, h)) continue;
        for (int c = 0; c < 3; c++)
            k->load[c][h] += k->of_body[s->body[h]] * f->area[i] / s->volume[h] * f->normal[c][i];
    }
}

void inner_pressure_find(struct inner_pressure *k, struct run *r, const struct inner_fluid *inner) {
    if (!k || !r->solid->push) return;
    for (int c = 0; c < 3; c++) memset(k->load[c], 0, (size_t)r->solid->n * sizeof(double));
    read_pressures(k, r);
    take_means(k, r, inner);
    push_cracks(k, r);
    push_outside(k, r);
}

double inner_pressure_take_uneven(struct inner_pressure *k) {
    const double uneven = k ? k->uneven : 0;
    if (k) k->uneven = 0;
    return uneven;
}

void inner_pressure_add(const struct inner_pressure *k, struct run *r) {
    struct solid *s = r->solid;
    if (!k || !s->push) return;
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < s->n; h++) s->load[c][h] += k->load[c][h];
    cracks_project_load_again(r->cracks);
}
