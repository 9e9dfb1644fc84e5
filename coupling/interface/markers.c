/* Sets the markers from the interface.  (001: sec. 3.5.2) */
#include "coupling/interface/markers.h"
#include "base/memory.h"
#include "coupling/run.h"
#include "physics/retraction.h"
#include "solid/force/attachment.h"
#include "solid/surface/attach.h"

#include <math.h>

static void reserve(struct markers *m, int markers) {
    double **const array[] = {&m->x[0],     &m->x[1],     &m->x[2],     &m->v[0],   &m->v[1], &m->v[2],
                              &m->force[0], &m->force[1], &m->force[2], &m->volume, &m->shift};
    if (markers <= m->capacity) return;
    m->capacity = markers + markers / 4 + 64;
    memory_free(m->fraction);
    m->fraction = memory_new(MEMORY_COUPLING, (size_t)m->capacity, sizeof *m->fraction);
    for (size_t a = 0; a < sizeof array / sizeof *array; a++) {
        memory_free(*array[a]);
        *array[a] = memory_new(MEMORY_COUPLING, (size_t)m->capacity, sizeof **array[a]);
    }
}

void markers_free(struct markers *m) {
    for (int c = 0; c < 3; c++) MEMORY_FREE(m->x[c], m->v[c], m->force[c]);
    MEMORY_FREE(m->fraction, m->volume, m->shift);
    solid_attach_free(m->attachment);
}

void markers_attach(struct run *r) { r->markers.attachment = solid_attach_new(r->solid); }

/* Marker volume, m3, of a particle without bonds, which is smaller than a cell and a probe. In a step the forcing
 * exchanges the volume's momentum `times` times. With this volume it exchanges between fluid and particle the Stokes
 * drag 3 pi mu d (V - U) of a sphere of the particle's volume, or the force that removes half of their velocity
 * difference, if that is less. A stage with the solid at rest begins with a step of 0: then no force is exchanged. */
static double isolated_volume(const struct run *r, int h, double times) {
    const struct solid *s = r->solid;
    const struct fluid_input *fluid = fluid_input_of(r->fluid);
    const double diameter = cbrt(6 / M_PI * s->volume[h]);
    const double drag = 3 * M_PI * fluid->viscosity * diameter * r->dt;
    const double half = 0.5 * solid_density(s, h) / fluid->density * s->volume[h];
    return times > 0 ? fmin(drag, half) / times : 0;
}

/* How far the marker is from the particle's centre along the outward normal, m. The centre is `depth` inside the wetted
 * face; the marker is r_d inside the face, and more where a shape's surface is curved: depth - r_d - 1/2 curvature
 * dx^2. A wall wetted on both faces and a particle without bonds have theirs at the centre. */
static double shift_of(const struct solid_surface *surface, int i, double retraction, double dx) {
    const double bend = surface->curvature ? PHYSICS_RETRACTION_CURVED * surface->curvature[i] * dx * dx : 0;
    return surface->depth[i] - retraction - bend;
}

/* Markers along the present normals, with the velocities of their particles. */
static void place(struct markers *m, const struct solid *s, const struct solid_surface *surface) {
    for (int i = 0; i < m->n; i++) {
        const int h = surface->h[i];
        double x[3];
        solid_position(s, h, x);
        for (int c = 0; c < 3; c++) {
            m->x[c][i] = x[c] + (surface->two_sided[i] == SOLID_ONE_FACE ? m->shift[i] * surface->normal[c][i] : 0);
            m->v[c][i] = s->v[c][h];
        }
    }
}

/* Markers that near particles carry: they turn with the body, and move as it does there. */
static void carry(struct markers *m, struct solid *s, const struct solid_surface *surface) {
    solid_attach_update(m->attachment, s, surface, m->shift);
    solid_attachment_refresh(s);
    for (int i = 0; i < m->n; i++) {
        double x[3], arm[3], v[3];
        solid_position(s, surface->h[i], x);
        solid_attachment_arm(m->attachment, s, i, arm);
        solid_attachment_velocity(m->attachment, s, i, v);
        for (int c = 0; c < 3; c++) {
            m->x[c][i] = x[c] + arm[c];
            m->v[c][i] = v[c];
        }
    }
}

static void scale_velocities(struct markers *m, const struct ibm *ibm, const struct solid_surface *surface) {
    for (int i = 0; i < m->n; i++)
        for (int c = 0; c < 3; c++) {
            const int is_isolated = surface->two_sided[i] == SOLID_ISOLATED;
            m->fraction[i][c] = is_isolated ? 1 : ibm_markers_fraction(ibm, c, m->x[c][i]);
            m->v[c][i] *= m->fraction[i][c];
        }
}

void markers_update(struct run *r) {
    const struct solid_surface *surface = r->surface;
    struct markers *m = &r->markers;
    const double dx = fluid_grid_of(r->fluid)->d[0];
    const double retraction = r->scene->coupling->retraction * dx;
    reserve(m, surface->n);
    m->n = surface->n;
    for (int i = 0; i < m->n; i++) {
        const int is_isolated = surface->two_sided[i] == SOLID_ISOLATED;
        m->shift[i] = shift_of(surface, i, retraction, dx);
        m->volume[i] =
            is_isolated ? isolated_volume(r, surface->h[i], r->load_kind->forcing_times(r)) : surface->area[i] * dx;
    }
    if (m->attachment)
        carry(m, r->solid, surface);
    else
        place(m, r->solid, surface);
    scale_velocities(m, r->ibm, surface);
}
