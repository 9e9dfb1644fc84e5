/* The energy that a step of RK3 takes, from the accelerations of its stages. */
#include "solid/step/rk3_loss.h"
#include "base/memory.h"
#include "base/vec.h"
#include "solid/bonds/store.h"

#include <string.h>

struct solid_rk3_loss {
    int capacity;
    double *first[3]; /* [n] a of the first stage, m/s2 */
};

void solid_rk3_loss_free(struct solid_rk3_loss *loss) {
    if (!loss) return;
    for (int c = 0; c < 3; c++) memory_free(loss->first[c]);
    memory_free(loss);
}

void solid_rk3_loss_begin(struct solid *s) {
    if (!s->rk3_loss) s->rk3_loss = memory_new(MEMORY_SOLID, 1, sizeof *s->rk3_loss);
    struct solid_rk3_loss *loss = s->rk3_loss;
    for (int c = 0; c < s->dim; c++) {
        if (loss->capacity < s->n) {
            memory_free(loss->first[c]);
            loss->first[c] = memory_new(MEMORY_SOLID, (size_t)s->n, sizeof(double));
        }
        if (s->n > 0) memcpy(loss->first[c], s->a[c], (size_t)s->n * sizeof(double));
    }
    if (loss->capacity < s->n) loss->capacity = s->n;
}

/* The sum of volume times what the particles lose over density dt^2, m5/s4. With rate = -dt K v and curve = dt^2 K a_0.
 * [n] */
static double lost(int n, const double *restrict volume, const double *restrict a0, const double *restrict a1,
                   const double *restrict a2) {
    vec lanes = vec_set(0);
    int h = 0;
    for (; h + VEC_LANES <= n; h += VEC_LANES) {
        const vec first = vec_load(a0 + h), second = vec_load(a1 + h), e1 = second - first, rate = 15. / 8 * e1,
                  curve = 4.5 * (0.25 * e1 - (vec_load(a2 + h) - second));
        lanes += vec_load(volume + h) * ((rate * rate + first * curve) * (1. / 24) - curve * curve * (1. / 36));
    }
    double sum = vec_sum(lanes);
    for (; h < n; h++) {
        const double e1 = a1[h] - a0[h], rate = 15. / 8 * e1, curve = 4.5 * (0.25 * e1 - (a2[h] - a1[h]));
        sum += volume[h] * ((rate * rate + a0[h] * curve) * (1. / 24) - curve * curve * (1. / 36));
    }
    return sum;
}

void solid_rk3_loss_end(struct solid *s, double dt) {
    const int *first = s->family->first;
    double sum = 0;
    for (int b = 0; b < s->in.bodies; b++)
        for (int from = first[b], n; from < first[b + 1]; from += n) {
            n = solid_density_end(s, from, first[b + 1]) - from;
            for (int c = 0; c < s->dim; c++)
                sum += solid_density(s, from) *
                       lost(n, s->volume + from, s->rk3_loss->first[c] + from, s->a_old[c] + from, s->a[c] + from);
        }
    s->e_integrator += dt * dt * sum;
}
