/* Load by probes: turns the traction at the wetted faces into loads of the particles.  (001: sec. 3.5.3) */
#include "coupling/load/probe.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/interface/crack_outlets.h"
#include "coupling/interface/wall_probes.h"
#include "coupling/run.h"
#include "fluid/scheme.h"
#include "solid/imposed/external_loads.h"

#include <string.h>

static void begin(struct run *r) {
    if (!r->needs.bonds) return;
    for (int c = 0; c < 3; c++) {
        r->v_last[c] = memory_new(MEMORY_COUPLING, (size_t)r->solid->n + 1, sizeof(double));
        memcpy(r->v_last[c], r->solid->v[c], (size_t)r->solid->n * sizeof(double));
    }
}

static void end(struct run *r) {
    for (int c = 0; c < 3; c++) memory_free(r->v_last[c]);
}

static double forcing_times(const struct run *r) {
    return fluid_scheme_stages(r->fluid) * r->scene->coupling->forcing_iterations;
}

/* Reads traction and pressure at the probes. */
static void read_tractions(struct run *r) {
    struct wall_probes *p = &r->probes;
    const struct ibm_probe_input in = {.n = p->n,
                                       .x = {p->root[0], p->root[1], p->root[2]},
                                       .normal = {p->normal[0], p->normal[1], p->normal[2]},
                                       .length = r->scene->coupling->probe_length,
                                       .is_carried = 1};
    ibm_probe(r->ibm, &in, p->traction, p->pressure, p->active);
}

/* Sets the loads to those that the scene gives. */
static void begin_loads(struct run *r) {
    struct solid *s = r->solid;
    for (int c = 0; c < 3; c++) {
        if (!s->external_loads) memset(s->load[c], 0, (size_t)s->n * sizeof(double));
        for (int h = 0; s->external_loads && h < s->n; h++) s->load[c][h] = solid_external_loads_on(s, h, c);
        r->load[c] = 0;
    }
}

/* F_h = t_h A_h / V_h  (001: eq. 3.96, mended), less the added mass. sum: the force on the whole solid, with
 * the added mass. */
static void add_tractions(struct run *r, double sum[3]) {
    struct solid *s = r->solid;
    struct wall_probes *p = &r->probes;
    const double more = wall_probes_carried_more;
    for (int q = 0; q < p->n; q++) {
        const int h = p->particle[q];
        if (!p->active[q]) {
            p->added[q] = 0;
            continue;
        }
        const double per_volume = r->surface->area[p->owner[q]] / s->volume[h];
        const double last = p->added[q] * p->acceleration_n[q] / (1 + more);
        for (int c = 0; c < 3; c++) {
            const double load = p->traction[c][q] * per_volume, n = p->normal[c][q];
            s->load[c][h] += load + more * last * n;
            sum[c] += (load - last * n) * s->volume[h];
        }
    }
}

/* The load of a particle without bonds is the reaction to the forcing. */
static void add_reaction_of_isolated(struct run *r, double sum[3]) {
    struct solid *s = r->solid;
    struct markers *m = &r->markers;
    ibm_forcing_by_marker(r->ibm, r->dt, m->force);
    for (int i = 0; i < m->n; i++) {
        if (r->surface->two_sided[i] != SOLID_ISOLATED) continue;
        const int h = r->surface->h[i];
        for (int c = 0; c < 3; c++) {
            s->load[c][h] -= m->force[c][i] / s->volume[h];
            sum[c] -= m->force[c][i];
        }
    }
}

/* Of the load in a step, J: F_h V_h (v^n + v^(n+1))/2 dt; of a particle without bonds what the forcing takes. */
static void set_work(struct run *r) {
    const struct solid *s = r->solid;
    struct wall_probes *p = &r->probes;
    const struct markers *m = &r->markers;
    double power = 0;
    for (int q = 0; q < p->n; q++) {
        const int h = p->particle[q];
        if (!p->active[q]) continue;
        const double area = r->surface->area[p->owner[q]],
                     last = p->added[q] * p->acceleration_n[q] / (1 + wall_probes_carried_more) * s->volume[h];
        for (int c = 0; c < s->dim; c++)
            power += (p->traction[c][q] * area - last * p->normal[c][q]) * 0.5 * (r->v_last[c][h] + s->v[c][h]);
    }
    for (int i = 0; r->surface->isolated > 0 && i < m->n; i++)
        for (int c = 0; r->surface->two_sided[i] == SOLID_ISOLATED && c < 3; c++) power -= m->force[c][i] * m->v[c][i];
    p->work = r->dt * power;
}

/* Gives the solid the added mass of the probes. */
static void set_added_mass(struct run *r) {
    struct wall_probes *p = &r->probes;
    p->added_mass = (struct solid_added_mass){.n = p->n,
                                              .h = p->particle,
                                              .normal = {p->normal[0], p->normal[1], p->normal[2]},
                                              .density = p->added,
                                              .lost = p->lost,
                                              .before = p->lost_before,
                                              .from = p->moved_from};
    r->solid->added = &p->added_mass;
}

static void sample(struct run *r) {
    read_tractions(r);
    clock_begin(CLOCK_PROBE);
    if (r->crack_outlets && r->solid->push) {
        crack_outlets_find(r);
        crack_outlets_correct_tractions(r);
    }
    begin_loads(r);
    add_tractions(r, r->load);
    if (r->surface->isolated > 0) add_reaction_of_isolated(r, r->load);
    par_sum_array(r->load, 3);
    set_added_mass(r);
    clock_end(CLOCK_PROBE);
}

const struct load_kind probe_kind = {.has_probes = 1,
                                     .begin = begin,
                                     .end = end,
                                     .sample = sample,
                                     .set_work = set_work,
                                     .forcing_times = forcing_times};
