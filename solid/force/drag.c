/* Drag of listed particles towards given velocities, implicit in the particle's velocity. */
#include "solid/force/drag.h"
#include "solid/imposed/reactions.h"
#include "solid/state.h"

enum { HELD = SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z };

static int is_imposed(const struct solid *s, int h, int c) { return s->flag[h] >> c & SOLID_HELD_X; }

static double mass_of(const struct solid *s, int h) { return s->volume[h] * solid_density(s, h); }

/* The work of an impulse per mass, m/s, while the velocity goes from `first` to `last`, per mass: the impulse's part of
 * the change of kinetic energy. */
static double work_of(double impulse, double first, double last) { return impulse * 0.5 * (first + last); }

void solid_drag_begin(struct solid *s) {
    const struct solid_drag *drag = s->drag;
    for (int i = 0; i < drag->n; i++) {
        const int h = drag->h[i];
        for (int c = 0; c < s->dim; c++)
            if (!is_imposed(s, h, c)) s->a[c][h] += drag->rate[i] * (drag->u[i][c] - s->v[c][h]);
    }
}

void solid_drag_begin_substep(struct solid *s) {
    const struct solid_drag *drag = s->drag;
    for (int i = 0; i < drag->n; i++)
        for (int c = 0; c < s->dim; c++) drag->v_begin[i][c] = s->v[c][drag->h[i]];
}

/* v = v_half + dt/2 (a + z (U - v)), solved for v; v_half = v_old + dt/2 a_old, plus what contact has added between the
 * two halves of the drag's impulse. */
void solid_drag_end(struct solid *s, double dt, double *const a_old[3]) {
    const struct solid_drag *drag = s->drag;
    const double half = 0.5 * dt;
    double all = 0;
    for (int i = 0; i < drag->n; i++) {
        const int h = drag->h[i];
        const double half_z = half * drag->rate[i], part = 1 / (1 + half_z);
        double work = 0;
        for (int c = 0; c < s->dim; c++) {
            const double u = drag->u[i][c], first = drag->v_begin[i][c];
            double last = s->v[c][h];
            if (!is_imposed(s, h, c)) {
                const double by_contact = last - dt * a_old[c][h] - first;
                const double free = last + half * (s->a[c][h] - a_old[c][h]);
                last = (free + half_z * u) * part;
                s->a[c][h] += drag->rate[i] * (u - last);
                work += work_of(half_z * (u - first), first, last - by_contact) +
                        work_of(half_z * (u - last), first + by_contact, last);
            }
            drag->slip_path[i][c] += half * (first + last - 2 * u);
        }
        all += mass_of(s, h) * work;
    }
    s->work_load += all;
}

void solid_drag_stage(struct solid *s, double gamma_dt) {
    const struct solid_drag *drag = s->drag;
    double all = 0;
    for (int i = 0; i < drag->n; i++) {
        const int h = drag->h[i];
        double work = 0;
        for (int c = 0; c < s->dim; c++) {
            const double z = drag->rate[i], u = drag->u[i][c];
            if (!is_imposed(s, h, c)) {
                const double before = s->v[c][h], after = (before + gamma_dt * z * u) / (1 + gamma_dt * z);
                s->v[c][h] = after;
                work += work_of(after - before, before, after);
            }
            drag->slip_path[i][c] += gamma_dt * (s->v[c][h] - u);
        }
        all += mass_of(s, h) * work;
    }
    s->work_load += all;
}

void solid_drag_react(struct solid *s) {
    const struct solid_drag *drag = s->drag;
    for (int i = 0; i < drag->n; i++) {
        const int h = drag->h[i];
        double impulse[3] = {0};
        if ((s->flag[h] & HELD) == 0) continue;
        for (int c = 0; c < s->dim; c++) impulse[c] = -mass_of(s, h) * drag->rate[i] * drag->slip_path[i][c];
        solid_reactions_give(s, h, impulse);
    }
}
