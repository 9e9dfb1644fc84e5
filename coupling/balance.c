/* Corrects the probes' loads so that each body receives the force that the forcing takes from the fluid. */
/* The probes say where on a body the fluid pulls, but their sum is only as good as the cells resolve the body. The
 * forcing's sum is the fluid's own. For the markers' shell and the fluid within, which moves with the body,
 *
 *     rho V dU/dt = T + f + V (rho g + G),      so  T = rho V dU/dt - f - V (rho g + G),                     (after
 * Uhlmann 2005)
 *
 * T the outer fluid's force on the body, f the forcing's on the fluid, G the driving gradient, which the solved
 * pressure leaves out. T less the probes' sum is spread evenly over the volume that is in the domain: it moves the body
 * and strains nothing that is free. A body is what the scene calls one, whole or in pieces. dU/dt is of the step
 * before. So is the acceleration of the carried mass, which is the probes' too: a step gives back, body by body, just
 * what the one before has taken, so that nothing is lost where normals turn or particles come off meanwhile. */
#include "coupling/balance.h"
#include "base/ensure.h"
#include "base/par.h"
#include "physics/limits.h"
#include "solid/imposed/given.h"

#include <string.h>

enum { VOLUME = 0, LACK, COLUMNS = LACK + 3 };

static int is_inside(const struct run *r, int h) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    double x[3];
    solid_position(r->solid, h, x);
    for (int c = 0; c < 3; c++)
        if (!g->periodic[c] && (x[c] < 0 || x[c] > g->length[c])) return 0;
    return 1;
}

/* The next bonded particle in the domain from h on, or n. i: place among the surface's, which rise. */
static int next_from(const struct run *r, int h, int *i) {
    const struct solid_surface *f = r->surface;
    for (; h < r->solid->n; h++) {
        while (*i < f->n && f->h[*i] < h) ++*i;
        const int is_set_free = *i < f->n && f->h[*i] == h && f->two_sided[*i] == SOLID_SET_FREE;
        if (!is_set_free && is_inside(r, h)) break;
    }
    return h;
}

/* T less the probes' sum, of what a particle holds: the fluid within it, and its load. */
static void add_particle(const struct run *r, int h, double sum[COLUMNS]) {
    const struct fluid_input *in = fluid_input_of(r->fluid);
    const struct solid *s = r->solid;
    sum[VOLUME] += s->volume[h];
    for (int c = 0; c < 3; c++) {
        const int has_last = r->v_last[0] && r->dt > 0;
        const double acceleration = has_last ? (s->v[c][h] - r->v_last[c][h]) / r->dt : 0;
        const int driven = in->driving.type != FLUID_DRIVING_NONE && in->driving.direction == c;
        const double push = in->density * in->body_force[c] + (driven ? fluid_state_of(r->fluid)->driving : 0);
        const double probed = s->load[c][h] - solid_given_of(s, h, c);
        sum[LACK + c] += (in->density * acceleration - push - probed) * s->volume[h];
    }
}

/* What the mass that a probe's particle carries takes at an acceleration along the normal, N. */
static void add_carried(const struct run *r, int q, double a_n, double sum[3]) {
    const struct run_markers *m = &r->markers;
    const double force = m->added[q] * a_n * r->solid->volume[m->particle[q]];
    for (int c = 0; c < 3; c++) sum[c] += force * m->normal[c][q];
}

static void sum_bodies(struct run *r, double (*sum)[COLUMNS]) {
    const struct solid *s = r->solid;
    const struct run_markers *m = &r->markers;
    for (int i = 0, h = next_from(r, 0, &i); h < s->n; h = next_from(r, h + 1, &i)) add_particle(r, h, sum[s->body[h]]);
    for (int i = 0; i < m->n; i++) {
        const int h = r->surface->h[i];
        if (r->surface->two_sided[i] == SOLID_SET_FREE) continue;
        for (int c = 0; c < 3; c++) sum[s->body[h]][LACK + c] -= m->force[c][i];
    }
    for (int q = 0; q < m->probes && r->strong; q++) /* of this very step */
        add_carried(r, q, m->acceleration_n[q], &sum[s->body[m->particle[q]]][LACK]);
}

void balance_keep(struct run *r) {
    const struct solid *s = r->solid;
    const struct run_markers *m = &r->markers;
    if (!r->carried) return;
    memset(r->carried, 0, (size_t)s->in.bodies * sizeof *r->carried);
    for (int q = 0; q < m->probes; q++) {
        const int h = m->particle[q];
        double a_n = 0;
        for (int c = 0; c < 3; c++) a_n += (s->v[c][h] - r->v_last[c][h]) / r->dt * m->normal[c][q];
        add_carried(r, q, a_n, r->carried[s->body[h]]);
    }
    par_sum_array(r->carried[0], 3 * s->in.bodies);
}

void balance_loads(struct run *r, double sum[3]) {
    struct solid *s = r->solid;
    double body[PHYSICS_BODIES_MAX][COLUMNS] = {{0}};
    ENSURE(s->in.bodies <= PHYSICS_BODIES_MAX, "%d bodies", s->in.bodies);
    ibm_forcing_by_marker(r->ibm, r->dt, r->markers.force);
    sum_bodies(r, body);
    par_sum_array(body[0], s->in.bodies * COLUMNS);
    for (int b = 0; b < s->in.bodies && r->carried; b++)
        for (int c = 0; c < 3; c++) body[b][LACK + c] += r->carried[b][c];
    for (int i = 0, h = next_from(r, 0, &i); h < s->n; h = next_from(r, h + 1, &i))
        for (int c = 0; c < 3; c++) {
            const double lack = body[s->body[h]][LACK + c] / body[s->body[h]][VOLUME];
            s->load[c][h] += lack;
            sum[c] += lack * s->volume[h];
        }
}
