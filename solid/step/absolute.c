/* The work of absolute damping over a substep of velocity Verlet, from the displacement. */
#include "solid/step/absolute.h"
#include "base/memory.h"
#include "base/vec.h"
#include "solid/bonds/store.h"
#include "solid/contact/implicit.h"

#include <string.h>

struct solid_absolute {
    int capacity;
    double *u[3]; /* [n] velocity with which damping acted at the beginning of the substep, m/s */
};

void solid_absolute_free(struct solid_absolute *absolute) {
    if (!absolute) return;
    for (int c = 0; c < 3; c++) memory_free(absolute->u[c]);
    memory_free(absolute);
}

static void keep(struct solid *s) {
    for (int c = 0; c < s->dim; c++)
        if (s->n > 0) memcpy(s->absolute->u[c], s->v[c], (size_t)s->n * sizeof(double));
}

void solid_absolute_begin(struct solid *s) {
    if (!(s->stage.damping_absolute > 0)) return;
    if (!s->absolute) s->absolute = memory_new(MEMORY_SOLID, 1, sizeof *s->absolute);
    for (int c = 0; c < s->dim && s->absolute->capacity < s->n; c++) {
        memory_free(s->absolute->u[c]);
        s->absolute->u[c] = memory_new(MEMORY_SOLID, (size_t)s->n, sizeof(double));
    }
    if (s->absolute->capacity < s->n) s->absolute->capacity = s->n;
    keep(s);
}

/* The sum of volume ((u + v).(v - dt/2 a_old) - u^2 - v^2), m5/s2. [n] */
static double along(int n, double dt, const double *restrict volume, const double *restrict u, const double *restrict v,
                    const double *restrict a_old) {
    vec lanes = vec_set(0);
    int h = 0;
    for (; h + VEC_LANES <= n; h += VEC_LANES) {
        const vec before = vec_load(u + h), now = vec_load(v + h);
        lanes += vec_load(volume + h) *
                 ((before + now) * (now - 0.5 * dt * vec_load(a_old + h)) - before * before - now * now);
    }
    double sum = vec_sum(lanes);
    for (; h < n; h++) sum += volume[h] * ((u[h] + v[h]) * (v[h] - 0.5 * dt * a_old[h]) - u[h] * u[h] - v[h] * v[h]);
    return sum;
}

void solid_absolute_end(struct solid *s, double dt) {
    if (!(s->stage.damping_absolute > 0)) return;
    const int *first = s->family->first;
    double sum = -0.5 * dt * solid_contact_implicit_along(s, s->absolute->u, 1, s->v);
    for (int b = 0; b < s->in.bodies; b++)
        for (int from = first[b], n; from < first[b + 1]; from += n) {
            n = solid_density_end(s, from, first[b + 1]) - from;
            for (int c = 0; c < s->dim; c++)
                sum += solid_density(s, from) *
                       along(n, dt, s->volume + from, s->absolute->u[c] + from, s->v[c] + from, s->a_old[c] + from);
        }
    s->damped_missed += 0.5 * dt * s->stage.damping_absolute * sum;
    keep(s);
}
