/* Sets the probes from the interface.  (001: sec. 3.5.3) */
#include "coupling/interface/wall_probes.h"
#include "base/memory.h"
#include "coupling/run.h"

static void reserve(struct wall_probes *p, int probes) {
    double **const array[] = {&p->root[0],   &p->root[1],     &p->root[2],     &p->normal[0],   &p->normal[1],
                              &p->normal[2], &p->traction[0], &p->traction[1], &p->traction[2], &p->acceleration_n,
                              &p->added,     &p->pressure,    &p->lost,        &p->lost_before, &p->moved_from};
    if (probes <= p->capacity) return;
    const size_t capacity = (size_t)(p->capacity = probes + probes / 4 + 128);
    for (size_t a = 0; a < sizeof array / sizeof *array; a++) {
        memory_free(*array[a]);
        *array[a] = memory_new(MEMORY_COUPLING, capacity, sizeof **array[a]);
    }
    MEMORY_FREE(p->owner, p->particle, p->active);
    p->particle = memory_new(MEMORY_COUPLING, capacity, sizeof *p->particle);
    p->owner = memory_new(MEMORY_COUPLING, capacity, sizeof *p->owner);
    p->active = memory_new(MEMORY_COUPLING, capacity, 1);
}

void wall_probes_free(struct wall_probes *p) {
    for (int c = 0; c < 3; c++) MEMORY_FREE(p->root[c], p->normal[c], p->traction[c]);
    MEMORY_FREE(p->acceleration_n, p->added, p->lost, p->lost_before, p->moved_from, p->particle, p->pressure, p->owner,
                p->active);
}

/* The probe's dp/dn|_m = -rho_f dV/dt.n acts as an added mass, rho_f l/2 A_h, which the particle carries with its own
 * acceleration. The rest of the fluid's reaction to an acceleration comes with p|_e, in the explicit scheme one step
 * late; if fluid and solid have similar masses, this delay alone makes the coupling unstable. So half as much again is
 * carried there, and given back as a load with the acceleration of the last step. The mean force is unchanged; short
 * waves are damped. */
const double wall_probes_carried_more = 0.5;

/* dV/dt . n of particle i of the surface, m/s2. */
static double acceleration_of(const struct run *r, int i, double time) {
    const int h = r->surface->h[i];
    double a_n = 0;
    if (!r->v_last[0] || !(time > 0)) return 0;
    for (int c = 0; c < 3; c++) a_n += (r->solid->v[c][h] - r->v_last[c][h]) / time * r->surface->normal[c][i];
    return a_n;
}

/* side: 1, or -1 for the other face. inside: how far the root is inside the face, m. layer: added mass of the probe's
 * formula, kg/m2. */
static void add_probe(struct run *r, int i, int side, double a_n, double inside, double layer) {
    const struct solid *s = r->solid;
    const struct solid_surface *surface = r->surface;
    struct wall_probes *p = &r->probes;
    const int h = surface->h[i], q = p->n++;
    const double root = surface->depth[i] - inside;
    double x[3];
    solid_position(s, h, x);
    p->owner[q] = i;
    p->particle[q] = h;
    p->added[q] = (1 + wall_probes_carried_more) * layer * surface->area[i] / s->volume[h];
    p->acceleration_n[q] = side * a_n;
    for (int c = 0; c < 3; c++) {
        p->normal[c][q] = side * surface->normal[c][i];
        p->root[c][q] = x[c] + side * root * surface->normal[c][i];
    }
}

/* A probe's root is r_d inside the face. */
void wall_probes_update(struct run *r) {
    const struct solid_surface *surface = r->surface;
    const struct scene_coupling *scene = r->scene->coupling;
    const double dx = fluid_grid_of(r->fluid)->d[0];
    const double inside = scene->retraction * dx;
    const double layer = 0.5 * fluid_input_of(r->fluid)->density * scene->probe_length * dx;
    const double time = r->dt_last > 0 ? r->dt_last : r->dt;
    r->probes.n = 0;
    if (!r->load_kind->has_probes) return;
    reserve(&r->probes, 2 * surface->n);
    for (int i = 0; i < surface->n; i++) {
        if (surface->two_sided[i] == SOLID_ISOLATED) continue;
        const double a_n = acceleration_of(r, i, time);
        add_probe(r, i, 1, a_n, inside, layer);
        if (surface->two_sided[i] == SOLID_TWO_FACES) add_probe(r, i, -1, a_n, inside, layer);
    }
}
