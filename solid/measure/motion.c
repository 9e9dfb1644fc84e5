/* Sums mass, momentum, kinetic energy, mean displacement and forces over each body's particles. */
#include "solid/measure/motion.h"
#include "base/memory.h"
#include "base/par.h"
#include "solid/bonds/store.h"
#include "solid/bonds/ghosts.h"
#include "solid/contact/contact.h"

#include <string.h>

enum { NUMBERS = sizeof(struct solid_motion) / sizeof(double) };

/* Adds the sums over particles of one density; of the displacement times the mass. */
static void add(const struct solid *s, int from, int to, struct solid_motion *m) {
    const double density = solid_density(s, from);
    const double *restrict volume = s->volume;
    for (int h = from; h < to; h++) m->mass += density * volume[h];
    for (int c = 0; c < s->dim; c++) {
        const double *restrict v = s->v[c], *restrict d = s->d[c], *restrict load = s->load[c];
        double momentum = 0, moved = 0, force = 0, v2 = 0;
        for (int h = from; h < to; h++) {
            momentum += volume[h] * v[h];
            moved += volume[h] * d[h];
            v2 += volume[h] * v[h] * v[h];
            force += volume[h] * (load[h] + density * s->in.body_force[c]);
        }
        m->momentum[c] += density * momentum;
        m->displacement[c] += density * moved;
        m->load[c] += force;
        m->kinetic += 0.5 * density * v2;
    }
}

void solid_motion_measure(struct solid *s, struct solid_motion *motion) {
    const int bodies = s->in.bodies;
    memset(motion, 0, (size_t)bodies * sizeof *motion);
    double(*contact)[3] = memory_new(MEMORY_SOLID, (size_t)bodies, sizeof *contact);
    solid_ghosts_update(s);
    solid_contact_force_on_bodies(s, contact);
    for (int b = 0; b < bodies; b++) {
        for (int h = s->family->first[b], end; h < s->family->first[b + 1]; h = end) {
            end = solid_density_end(s, h, s->family->first[b + 1]);
            add(s, h, end, &motion[b]);
        }
        memcpy(motion[b].contact, contact[b], sizeof contact[b]);
    }
    par_sum_array(&motion[0].mass, bodies * NUMBERS);
    for (int b = 0; b < bodies; b++)
        for (int c = 0; c < s->dim; c++) motion[b].displacement[c] /= motion[b].mass;
    memory_free(contact);
}

void solid_motion_angular_momentum(const struct solid *s, const double about[3], double out[3]) {
    for (int c = 0; c < 3; c++) out[c] = 0;
    for (int h = 0; h < s->n; h++) {
        const double mass = solid_density(s, h) * s->volume[h];
        double x[3] = {0, 0, 0}, v[3] = {0, 0, 0};
        for (int c = 0; c < s->dim; c++) {
            x[c] = s->x0[c][h] + s->d[c][h] - about[c];
            v[c] = s->v[c][h];
        }
        for (int c = 0; c < 3; c++) {
            const int a = (c + 1) % 3, b = (c + 2) % 3;
            out[c] += mass * (x[a] * v[b] - x[b] * v[a]);
        }
    }
    par_sum_array(out, 3);
}
