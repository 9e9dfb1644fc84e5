/* The force of absolute damping on all particles together, and its impulse over a step. */
#include "solid/imposed/damping.h"
#include "base/vec.h"
#include "solid/bonds/store.h"

#include <string.h>

/* The sum of volume v. [n] */
static double flow(int n, const double *restrict volume, const double *restrict v) {
    vec lanes = vec_set(0);
    int h = 0;
    for (; h + VEC_LANES <= n; h += VEC_LANES) lanes += vec_load(volume + h) * vec_load(v + h);
    double sum = vec_sum(lanes);
    for (; h < n; h++) sum += volume[h] * v[h];
    return sum;
}

void solid_damping_find(struct solid *s) {
    const int *first = s->family->first;
    memcpy(s->damping_then, s->damping_now, sizeof s->damping_then);
    memset(s->damping_now, 0, sizeof s->damping_now);
    if (!(s->stage.damping_absolute > 0)) return;
    for (int b = 0; b < s->in.bodies; b++)
        for (int from = first[b], n; from < first[b + 1]; from += n) {
            n = solid_density_end(s, from, first[b + 1]) - from;
            for (int c = 0; c < s->dim; c++)
                s->damping_now[c] -=
                    s->stage.damping_absolute * solid_density(s, from) * flow(n, s->volume + from, s->v[c] + from);
        }
}

void solid_damping_impulse_begin(struct solid *s) { memset(s->damping_impulse, 0, sizeof s->damping_impulse); }

void solid_damping_impulse_add(struct solid *s, double now, double then) {
    for (int c = 0; c < s->dim; c++) s->damping_impulse[c] += now * s->damping_now[c] + then * s->damping_then[c];
}

void solid_damping_impulse(const struct solid *s, double impulse[3]) {
    for (int c = 0; c < s->dim; c++) impulse[c] += s->damping_impulse[c];
}
