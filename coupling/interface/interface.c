/* Sets markers and probes from the interface, and turns traction into loads.  (001: secs 3.5.2, 3.5.3) */
#include "base/clock.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/interface/acceleration.h"
#include "coupling/load/balance.h"
#include "coupling/interface/interface.h"
#include "coupling/interface/crack_outlets.h"
#include "coupling/load/reaction.h"
#include "coupling/run.h"
#include "fluid/scheme.h"
#include "physics/retraction.h"
#include "solid/imposed/given.h"

#include <math.h>
#include <string.h>

/* Whether the load is carried from the probes to the wall. */
static int is_at_wall(const struct run *r) {
    switch (r->scene->coupling->load) {
    case SCENE_LOAD_REACTION:
    case SCENE_LOAD_PROBE:
        return 0;
    case SCENE_LOAD_WALL:
    case SCENE_LOAD_BALANCED:
        return 1;
    }
    ENSURE(0, "load form %d", (int)r->scene->coupling->load);
}

static void grow(double **array, int count) {
    memory_free(*array);
    *array = memory_new(MEMORY_COUPLING, (size_t)count, sizeof **array);
}

static void reserve(struct run_markers *m, int markers) {
    if (markers > m->capacity) {
        m->capacity = markers + markers / 4 + 64;
        for (int c = 0; c < 3; c++) {
            grow(&m->x[c], m->capacity);
            grow(&m->v[c], m->capacity);
            grow(&m->force[c], m->capacity);
        }
        grow(&m->volume, m->capacity);
    }
    if (2 * markers > m->probe_capacity) {
        m->probe_capacity = 2 * m->capacity;
        for (int c = 0; c < 3; c++) {
            grow(&m->root[c], m->probe_capacity);
            grow(&m->root_v[c], m->probe_capacity);
            grow(&m->normal[c], m->probe_capacity);
            grow(&m->traction[c], m->probe_capacity);
        }
        grow(&m->acceleration_n, m->probe_capacity);
        grow(&m->added, m->probe_capacity);
        grow(&m->pressure, m->probe_capacity);
        memory_free(m->owner);
        memory_free(m->particle);
        memory_free(m->active);
        m->particle = memory_new(MEMORY_COUPLING, (size_t)m->probe_capacity, sizeof *m->particle);
        m->owner = memory_new(MEMORY_COUPLING, (size_t)m->probe_capacity, sizeof *m->owner);
        m->active = memory_new(MEMORY_COUPLING, (size_t)m->probe_capacity, 1);
    }
}

void interface_markers_free(struct run *r) {
    struct run_markers *m = &r->markers;
    for (int c = 0; c < 3; c++) {
        memory_free(m->x[c]);
        memory_free(m->v[c]);
        memory_free(m->force[c]);
        memory_free(m->root[c]);
        memory_free(m->root_v[c]);
        memory_free(m->normal[c]);
        memory_free(m->traction[c]);
    }
    memory_free(m->volume);
    memory_free(m->acceleration_n);
    memory_free(m->added);
    memory_free(m->particle);
    memory_free(m->pressure);
    memory_free(m->owner);
    memory_free(m->active);
}

/* The probe's dp/dn|_m = -rho_f dV/dt.n acts as an added mass, rho_f l/2 A_h, which the particle carries with its own
 * acceleration. The rest of the fluid's reaction to an acceleration comes with p|_e, in the explicit scheme one step
 * late; if fluid and solid have similar masses, this delay alone makes the coupling unstable. So half as much again is
 * carried there, and given back as a load with the acceleration of the last step. The mean force is unchanged; short
 * waves are damped. The strong scheme has no such delay. It carries the added mass alone: what would be given back,
 * with the change of the mean velocity over a step, would be half a step late, and feed slow waves. */
static const double MORE = 0.5;

static double more_carried(const struct run *r) { return r->strong ? 0 : MORE; }

/* Marker volume, m3, of a particle without bonds, which is smaller than a cell and a probe. The forcing is applied
 * N_s times in each stage of a step. With this volume it exchanges between fluid and particle the Stokes drag 3 pi mu d
 * (V - U) of a sphere of the particle's volume, or the force that removes half of their velocity difference, if that is
 * less. */
static double set_free_volume(const struct run *r, int h) {
    const struct solid *s = r->solid;
    const struct fluid_input *fluid = fluid_input_of(r->fluid);
    const double diameter = cbrt(6 / M_PI * s->volume[h]);
    const double drag = 3 * M_PI * fluid->viscosity * diameter * r->dt;
    const double half = 0.5 * solid_density(s, h) / fluid->density * s->volume[h];
    double times = fluid_scheme_stages(r->fluid) * r->scene->coupling->forcing_iterations;
    if (r->reaction) times = reaction_weights(r);
    return fmin(drag, half) / times;
}

/* The centre of a particle is `depth` inside its wetted face; its marker is r_d inside the face, and more where a
 * shape's surface is curved: it is moved by depth - r_d - 1/2 curvature dx^2 along the outward normal. A wall wetted on
 * both faces has its marker at the centre and one probe on each side. A particle without bonds has no probe. A probe's
 * root is r_d inside the face, or the face itself if loads are carried to the wall. */
void interface_markers_update(struct run *r) {
    const struct solid *s = r->solid;
    const struct solid_surface *surface = r->surface;
    struct run_markers *m = &r->markers;
    const double dx = fluid_grid_of(r->fluid)->d[0];
    const double retraction = r->scene->coupling->retraction * dx;
    const double layer = 0.5 * fluid_input_of(r->fluid)->density * r->scene->coupling->probe_length * dx;
    const double over = acceleration_time(r);
    const int at_wall = is_at_wall(r);
    reserve(m, surface->n);
    m->n = surface->n;
    m->probes = 0;
    for (int i = 0; i < surface->n; i++) {
        const int h = surface->h[i], faces = surface->two_sided[i];
        const double bend = surface->curvature ? PHYSICS_RETRACTION_CURVED * surface->curvature[i] * dx * dx : 0;
        const double shift = surface->depth[i] - retraction - bend,
                     root = surface->depth[i] - (at_wall ? 0 : retraction);
        double x[3], a_n = 0;
        solid_position(s, h, x);
        m->volume[i] = faces == SOLID_SET_FREE ? set_free_volume(r, h) : surface->area[i] * dx;
        for (int c = 0; c < 3; c++) {
            m->x[c][i] = x[c] + (faces == SOLID_ONE_FACE ? shift * surface->normal[c][i] : 0);
            m->v[c][i] = s->v[c][h];
            if (r->v_last[0] && over > 0) a_n += (s->v[c][h] - r->v_last[c][h]) / over * surface->normal[c][i];
        }
        if (faces == SOLID_SET_FREE || r->reaction) continue;
        for (int side = 1; side >= (faces == SOLID_TWO_FACES ? -1 : 1); side -= 2) {
            const int q = m->probes++;
            m->owner[q] = i;
            m->particle[q] = h;
            m->added[q] = (1 + more_carried(r)) * layer * surface->area[i] / s->volume[h];
            m->acceleration_n[q] = side * a_n;
            for (int c = 0; c < 3; c++) {
                m->normal[c][q] = side * surface->normal[c][i];
                m->root[c][q] = x[c] + side * root * surface->normal[c][i];
                m->root_v[c][q] = s->v[c][h];
            }
        }
    }
}

/* F_h = t_h A_h / V_h  (001: eq. 3.96, mended), less the added mass. sum: the force on the whole solid, with
 * the added mass. */
static void load_by_probe(struct run *r, double sum[3]) {
    struct solid *s = r->solid;
    struct run_markers *m = &r->markers;
    for (int q = 0; q < m->probes; q++) {
        const int h = m->particle[q];
        if (!m->active[q]) {
            m->added[q] = 0;
            continue;
        }
        const double per_volume = r->surface->area[m->owner[q]] / s->volume[h];
        const double last = m->added[q] * m->acceleration_n[q] / (1 + more_carried(r));
        for (int c = 0; c < 3; c++) {
            const double load = m->traction[c][q] * per_volume, n = m->normal[c][q];
            s->load[c][h] += load + more_carried(r) * last * n;
            sum[c] += (load - last * n) * s->volume[h];
        }
    }
}

/* The load of a particle without bonds is the reaction to the forcing. */
static void load_by_forcing(struct run *r, double sum[3]) {
    struct solid *s = r->solid;
    struct run_markers *m = &r->markers;
    ibm_forcing_by_marker(r->ibm, r->dt, m->force);
    for (int i = 0; i < m->n; i++) {
        if (r->surface->two_sided[i] != SOLID_SET_FREE) continue;
        const int h = r->surface->h[i];
        for (int c = 0; c < 3; c++) {
            s->load[c][h] -= m->force[c][i] / s->volume[h];
            sum[c] -= m->force[c][i];
        }
    }
}

void interface_probe(struct run *r) {
    struct solid *s = r->solid;
    struct run_markers *m = &r->markers;
    struct ibm_probe_input in = {.n = m->probes,
                                 .x = {m->root[0], m->root[1], m->root[2]},
                                 .normal = {m->normal[0], m->normal[1], m->normal[2]},
                                 .length = r->scene->coupling->probe_length,
                                 .is_carried = 1};
    if (is_at_wall(r)) {
        in.acceleration_n = m->acceleration_n;
        for (int c = 0; c < 3; c++) in.velocity[c] = m->root_v[c];
    }
    ibm_probe(r->ibm, &in, m->traction, m->pressure, m->active);
    clock_begin(CLOCK_PROBE);
    if (r->crack_outlets && s->push) {
        crack_outlets_find(r);
        crack_outlets_correct_tractions(r);
    }
    for (int c = 0; c < 3; c++) {
        if (!s->given) memset(s->load[c], 0, (size_t)s->n * sizeof(double));
        for (int h = 0; s->given && h < s->n; h++) s->load[c][h] = solid_given_of(s, h, c);
        r->load[c] = 0;
    }
    load_by_probe(r, r->load);
    if (r->scene->coupling->load == SCENE_LOAD_BALANCED) balance_loads(r, r->load);
    if (r->surface->set_free > 0) load_by_forcing(r, r->load);
    par_sum_array(r->load, 3);
    m->added_mass = (struct solid_added_mass){
        .n = m->probes, .h = m->particle, .normal = {m->normal[0], m->normal[1], m->normal[2]}, .density = m->added};
    s->added = &m->added_mass;
    clock_end(CLOCK_PROBE);
}
