/* Corrects the probes' loads so that each body receives the force that the forcing takes from the fluid. */
/* The probes give the distribution of the fluid's load on a body, but the error of their sum grows with the cells' size
 * over the body's size. The forcing's sum is exact. For the markers' shell and the fluid within it, which moves with
 * the body,
 *
 *     rho V dU/dt = T + f + V rho g,      so  T = rho V dU/dt - f - V rho g,      (after Uhlmann 2005)
 *
 * T is the force of the outer fluid on the body, with that of a driving gradient, which the probes' pressure contains
 * and the solved pressure does not; f is the force of the forcing on the fluid. Where the fluid inside is not driven
 * (ibm/inside.c), f contains what is taken from it, in proportion to the bodies' volumes. T minus the probes' sum is
 * spread evenly over the body's volume in the domain: it moves the body without straining free parts. A body is one of
 * the scene's bodies, whole or in pieces. dU/dt is that of the last step. The carried mass uses the last step's
 * acceleration as well, as the probes do: for each body a step gives back exactly the force that the step before has
 * taken, so that no momentum is lost if normals turn or particles break off. Where the step has changed, momenta are
 * what is kept: the shell and the fluid within it go from one velocity to the next within the present step, and the
 * momentum that the carried mass has taken is given back. */
#include "coupling/load/balance.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/interface/place.h"
#include "coupling/load/probe.h"
#include "coupling/run.h"
#include "physics/limits.h"
#include "solid/imposed/external_loads.h"

#include <string.h>

enum { VOLUME = 0, LACK, COLUMNS = LACK + 3 };

/* The next particle with bonds in the domain from h on, or n. i: index into the surface's particles, which are in
 * ascending order. */
static int next_from(const struct run *r, int h, int *i) {
    const struct solid_surface *f = r->surface;
    for (; h < r->solid->n; h++) {
        while (*i < f->n && f->h[*i] < h) ++*i;
        const int is_set_free = *i < f->n && f->h[*i] == h && f->two_sided[*i] == SOLID_ISOLATED;
        if (!is_set_free && place_is_inside(fluid_grid_of(r->fluid), r->solid, h)) break;
    }
    return h;
}

/* Adds a particle's part of T minus the probes' sum: the fluid in its volume, minus its load. */
static void add_particle(const struct run *r, int h, double sum[COLUMNS]) {
    const struct fluid_input *in = fluid_input_of(r->fluid);
    const struct solid *s = r->solid;
    sum[VOLUME] += s->volume[h];
    for (int c = 0; c < 3; c++) {
        const int has_last = r->v_last[0] && r->dt > 0;
        const double acceleration = has_last ? (s->v[c][h] - r->v_last[c][h]) / r->dt : 0;
        const double push = in->density * in->body_force[c];
        const double probed = s->load[c][h] - solid_external_loads_on(s, h, c);
        sum[LACK + c] += (in->density * acceleration - push - probed) * s->volume[h];
    }
}

/* Adds the force that accelerates the carried mass of a probe's particle at a_n along the normal, N. */
static void add_carried(const struct run *r, int q, double a_n, double sum[3]) {
    const struct wall_probes *p = &r->probes;
    const double force = p->added[q] * a_n * r->solid->volume[p->particle[q]];
    for (int c = 0; c < 3; c++) sum[c] += force * p->normal[c][q];
}

static void sum_bodies(struct run *r, double (*sum)[COLUMNS]) {
    const struct solid *s = r->solid;
    const struct markers *m = &r->markers;
    for (int i = 0, h = next_from(r, 0, &i); h < s->n; h = next_from(r, h + 1, &i)) add_particle(r, h, sum[s->body[h]]);
    for (int i = 0; i < m->n; i++) {
        const int h = r->surface->h[i];
        if (r->surface->two_sided[i] == SOLID_ISOLATED) continue;
        for (int c = 0; c < 3; c++) sum[s->body[h]][LACK + c] -= m->force[c][i];
    }
}

/* After the solid's substeps: stores the force that accelerated each body's carried mass, which the next step gives
 * back. */
static void store_carried(struct run *r) {
    const struct solid *s = r->solid;
    const struct wall_probes *p = &r->probes;
    if (!r->carried) return;
    memset(r->carried, 0, (size_t)s->in.bodies * sizeof *r->carried);
    for (int q = 0; q < p->n; q++) {
        const int h = p->particle[q];
        double a_n = 0;
        for (int c = 0; c < 3; c++) a_n += (s->v[c][h] - r->v_last[c][h]) / r->dt * p->normal[c][q];
        add_carried(r, q, a_n, r->carried[s->body[h]]);
    }
    par_sum_array(r->carried[0], 3 * s->in.bodies);
}

/* Adds the part of -f that no marker has: what was taken from the driving inside the bodies. */
static void add_taken(const struct run *r, double (*body)[COLUMNS]) {
    double taken[3], volume = 0;
    ibm_inside_taken(r->ibm, taken);
    par_sum_array(taken, 3);
    for (int b = 0; b < r->solid->in.bodies; b++) volume += body[b][VOLUME];
    for (int b = 0; b < r->solid->in.bodies && volume > 0; b++)
        for (int c = 0; c < 3; c++) body[b][LACK + c] -= taken[c] * body[b][VOLUME] / volume;
}

/* Corrects the loads after those of the probes and before those of particles without bonds, which come from the forcing
 * and are left out. sum: the probes' force on the whole solid, this rank's share, N; corrected. */
static void correct_loads(struct run *r, double sum[3]) {
    struct solid *s = r->solid;
    double body[PHYSICS_BODIES_MAX][COLUMNS] = {{0}};
    ENSURE(s->in.bodies <= PHYSICS_BODIES_MAX, "%d bodies", s->in.bodies);
    ibm_forcing_by_marker(r->ibm, r->dt, r->markers.force);
    sum_bodies(r, body);
    par_sum_array(body[0], s->in.bodies * COLUMNS);
    add_taken(r, body);
    const double to_step = (r->dt_last > 0 ? r->dt_last / r->dt : 1);
    for (int b = 0; b < s->in.bodies && r->carried; b++)
        for (int c = 0; c < 3; c++) body[b][LACK + c] += to_step * r->carried[b][c];
    for (int i = 0, h = next_from(r, 0, &i); h < s->n; h = next_from(r, h + 1, &i))
        for (int c = 0; c < 3; c++) {
            const double lack = body[s->body[h]][LACK + c] / body[s->body[h]][VOLUME];
            s->load[c][h] += lack;
            sum[c] += lack * s->volume[h];
        }
}

static void begin(struct run *r) {
    probe_begin(r);
    if (r->needs.bonds) r->carried = memory_new(MEMORY_COUPLING, (size_t)r->solid->in.bodies, sizeof *r->carried);
}

static void end(struct run *r) {
    memory_free(r->carried);
    probe_end(r);
}

const struct load_kind balance_kind = {.has_probes = 1,
                                       .is_at_wall = 1,
                                       .begin = begin,
                                       .end = end,
                                       .sample = probe_sample,
                                       .correct = correct_loads,
                                       .end_step = store_carried,
                                       .forcing_times = probe_forcing_times};
