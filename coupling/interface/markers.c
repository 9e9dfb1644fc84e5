/* Sets the markers from the interface.  (001: sec. 3.5.2) */
#include "coupling/interface/markers.h"
#include "base/memory.h"
#include "coupling/run.h"
#include "physics/retraction.h"

#include <math.h>

static void reserve(struct markers *m, int markers) {
    double **const array[] = {&m->x[0], &m->x[1],     &m->x[2],     &m->v[0],     &m->v[1],
                              &m->v[2], &m->force[0], &m->force[1], &m->force[2], &m->volume};
    if (markers <= m->capacity) return;
    m->capacity = markers + markers / 4 + 64;
    for (size_t a = 0; a < sizeof array / sizeof *array; a++) {
        memory_free(*array[a]);
        *array[a] = memory_new(MEMORY_COUPLING, (size_t)m->capacity, sizeof **array[a]);
    }
}

void markers_free(struct markers *m) {
    for (int c = 0; c < 3; c++) {
        memory_free(m->x[c]);
        memory_free(m->v[c]);
        memory_free(m->force[c]);
    }
    memory_free(m->volume);
}

/* Marker volume, m3, of a particle without bonds, which is smaller than a cell and a probe. In a step the forcing
 * exchanges the volume's momentum `times` times. With this volume it exchanges between fluid and particle the Stokes
 * drag 3 pi mu d (V - U) of a sphere of the particle's volume, or the force that removes half of their velocity
 * difference, if that is less. */
static double isolated_volume(const struct run *r, int h, double times) {
    const struct solid *s = r->solid;
    const struct fluid_input *fluid = fluid_input_of(r->fluid);
    const double diameter = cbrt(6 / M_PI * s->volume[h]);
    const double drag = 3 * M_PI * fluid->viscosity * diameter * r->dt;
    const double half = 0.5 * solid_density(s, h) / fluid->density * s->volume[h];
    return fmin(drag, half) / times;
}

/* How far the marker is from the particle's centre along the outward normal, m. The centre is `depth` inside the wetted
 * face; the marker is r_d inside the face, and more where a shape's surface is curved: depth - r_d - 1/2 curvature
 * dx^2. A wall wetted on both faces and a particle without bonds have theirs at the centre. */
static double shift_of(const struct solid_surface *surface, int i, double retraction, double dx) {
    const double bend = surface->curvature ? PHYSICS_RETRACTION_CURVED * surface->curvature[i] * dx * dx : 0;
    return surface->depth[i] - retraction - bend;
}

void markers_update(struct run *r) {
    const struct solid *s = r->solid;
    const struct solid_surface *surface = r->surface;
    struct markers *m = &r->markers;
    const double dx = fluid_grid_of(r->fluid)->d[0];
    const double retraction = r->scene->coupling->retraction * dx;
    reserve(m, surface->n);
    m->n = surface->n;
    for (int i = 0; i < surface->n; i++) {
        const int h = surface->h[i], faces = surface->two_sided[i];
        const double shift = shift_of(surface, i, retraction, dx);
        double x[3];
        solid_position(s, h, x);
        m->volume[i] =
            faces == SOLID_ISOLATED ? isolated_volume(r, h, r->load_kind->forcing_times(r)) : surface->area[i] * dx;
        for (int c = 0; c < 3; c++) {
            m->x[c][i] = x[c] + (faces == SOLID_ONE_FACE ? shift * surface->normal[c][i] : 0);
            m->v[c][i] = s->v[c][h];
        }
    }
}
