/* Drag of listed particles towards given velocities, implicit in the particle's velocity. */
#include "solid/force/drag.h"
#include "solid/imposed/reactions.h"
#include "solid/state.h"

static int is_imposed(const struct solid *s, int h, int c) { return s->flag[h] >> c & SOLID_HELD_X; }

/* The work of an impulse, m/s times the particle's mass, while its velocity goes from `first` to `last`: the impulse's
 * part of the change of kinetic energy. */
static void add_work(struct solid *s, int h, double impulse, double first, double last) {
    s->work_load += s->volume[h] * solid_density(s, h) * impulse * 0.5 * (first + last);
}

void solid_drag_begin(struct solid *s) {
    const struct solid_drag *drag = s->drag;
    for (int i = 0; i < drag->n; i++)
        for (int c = 0; c < s->dim; c++) {
            const int h = drag->h[i];
            if (!is_imposed(s, h, c)) s->a[c][h] += drag->rate[i] * (drag->u[i][c] - s->v[c][h]);
        }
}

void solid_drag_keep(struct solid *s) {
    for (int i = 0; i < s->drag->n; i++)
        for (int c = 0; c < s->dim; c++) s->drag->start[i][c] = s->v[c][s->drag->h[i]];
}

/* v = v_half + dt/2 (a + z (U - v)), solved for v; v_half = v_old + dt/2 a_old, plus what contact has added between the
 * two halves of the drag's impulse. */
void solid_drag_end(struct solid *s, double dt, double *const a_old[3]) {
    const struct solid_drag *drag = s->drag;
    const double half = 0.5 * dt;
    for (int i = 0; i < drag->n; i++)
        for (int c = 0; c < s->dim; c++) {
            const int h = drag->h[i];
            const double z = drag->rate[i], u = drag->u[i][c], first = drag->start[i][c];
            double last = s->v[c][h];
            if (!is_imposed(s, h, c)) {
                const double by_contact = s->v[c][h] - dt * a_old[c][h] - first;
                const double free = s->v[c][h] + half * (s->a[c][h] - a_old[c][h]);
                last = (free + half * z * u) / (1 + half * z);
                s->a[c][h] += z * (u - last);
                add_work(s, h, half * z * (u - first), first, last - by_contact);
                add_work(s, h, half * z * (u - last), first + by_contact, last);
            }
            drag->path[i][c] += half * (first + last - 2 * u);
        }
}

void solid_drag_stage(struct solid *s, double gamma_dt) {
    const struct solid_drag *drag = s->drag;
    for (int i = 0; i < drag->n; i++)
        for (int c = 0; c < s->dim; c++) {
            const int h = drag->h[i];
            const double z = drag->rate[i], u = drag->u[i][c];
            if (!is_imposed(s, h, c)) {
                const double before = s->v[c][h], after = (before + gamma_dt * z * u) / (1 + gamma_dt * z);
                s->v[c][h] = after;
                add_work(s, h, after - before, before, after);
            }
            drag->path[i][c] += gamma_dt * (s->v[c][h] - u);
        }
}

void solid_drag_react(struct solid *s) {
    for (int i = 0; i < s->drag->n; i++) {
        const int h = s->drag->h[i];
        double impulse[3] = {0};
        for (int c = 0; c < s->dim; c++)
            impulse[c] = -solid_density(s, h) * s->volume[h] * s->drag->rate[i] * s->drag->path[i][c];
        solid_reactions_give(s, h, impulse);
    }
}
