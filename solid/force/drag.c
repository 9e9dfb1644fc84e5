/* Drag of markers towards given velocities, implicit in the markers' velocities. */
#include "solid/force/drag.h"
#include "base/par_ghost.h"
#include "solid/force/attachment.h"
#include "solid/imposed/reactions.h"
#include "solid/state.h"

#include <math.h>
#include <string.h>

enum { HELD = SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z };

static int is_imposed(const struct solid *s, int h, int c) { return s->flag[h] >> c & SOLID_HELD_X; }

/* The markers' impulses, and N^T J in `given`; adds J.NV to the work at markers. */
static void find_impulses(const struct solid *s, const struct solid_drag *drag, double dt) {
    struct solid_attachment *a = drag->markers;
    for (int c = 0; c < 3; c++) memset(a->given[c], 0, sizeof(double) * (size_t)(s->n + s->n_ghost));
    for (int i = 0; i < a->n; i++) {
        const struct solid_attachment_weights *w = a->weights[i];
        const double z = dt * drag->strength[i], whole = z / (1 + z * a->inverse_mass[i]);
        double v[3], impulse[3];
        solid_attachment_velocity(a, s, i, v);
        for (int c = 0; c < 3; c++) {
            const double p = drag->fraction[i][c];
            const double gain = p == 1 ? whole : p * z / (1 + p * p * z * a->inverse_mass[i]);
            impulse[c] = gain * (drag->u[i][c] - p * v[c]);
            drag->impulse[i][c] += impulse[c];
            a->work_at_markers += impulse[c] * v[c];
            a->work_size += fabs(impulse[c] * v[c]);
            a->given[c][a->h[i]] += w->own * impulse[c];
        }
        for (int k = 0; k < w->n; k++)
            for (int c = 0; c < 3; c++) a->given[c][w->other[k]] += w->share[k] * impulse[c];
    }
    par_ghost_add(s->ghost, 3, a->given, s->n);
}

void solid_drag_kick(struct solid *s, double dt) {
    struct solid_attachment *a = s->drag->markers;
    double work = 0, at_particles = 0, whole = 0;
    solid_attachment_refresh(s);
    find_impulses(s, s->drag, dt);
    for (int h = 0; h < s->n; h++) {
        const double impulse[3] = {a->given[0][h], a->given[1][h], a->given[2][h]};
        const double mass = s->volume[h] * solid_density(s, h);
        for (int c = 0; c < 3; c++) {
            const double dv = is_imposed(s, h, c) ? 0 : impulse[c] / mass;
            at_particles += impulse[c] * s->v[c][h];
            work += mass * dv * (s->v[c][h] + 0.5 * dv);
            whole += impulse[c] * (s->v[c][h] + 0.5 * dv);
            s->v[c][h] += dv;
        }
        if (s->reactions && s->flag[h] & HELD) solid_reactions_add_impulse(s, h, impulse);
    }
    s->work_load += work;
    a->work_at_particles += at_particles;
    a->work_of_drag += whole;
}
