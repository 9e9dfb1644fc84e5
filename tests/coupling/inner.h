/* What the fluid within the body gives back, by the rule of coupling/load/reaction.c for steps of one length: for stage
 * q of length gamma_q dt, with the gain G of the fluid's velocity since the same stage of the step before,
 *
 *     given = gamma G + C gamma G - excess ,   excess <- gamma G - (1 - C) gamma G ,
 *
 * with C = 1/2, and of particles deep in a body 0.7 with three stages, 0.95 with one.
 *
 * In the first step G is counted from the step's beginning, c_q dt before, so that gamma/c_q stands for the first
 * gamma of both. */
#pragma once
#include "coupling/run.h"
#include "solid/bonds/broken_tracker.h"
#include "solid/surface/deep.h"
#include "solid/surface/surface.h"

#include <stdlib.h>

struct inner {
    double last[3][3], excess[3][3]; /* [stage][direction], m/s */
    int is_deep;
};

/* Before a step. */
static inline void inner_note(const struct run *r, struct inner *inner) {
    uint16_t *least = calloc((size_t)r->solid->n + 1, sizeof *least);
    solid_deep_least_bonds(r->solid, least);
    for (int h = 0; h < r->solid->n; h++) {
        inner[h].is_deep = r->surface->tracker->intact[h] >= least[h];
        for (int q = 0; q < 3 && r->inner[q].velocity[0]; q++)
            for (int c = 0; c < 3; c++) inner[h].last[q][c] = r->inner[q].velocity[c][h];
    }
    free(least);
}

/* After it: the impulse per mass that particle h has been given, along c, m/s. */
static inline double inner_given(const struct run *r, struct inner *inner, int h, int c, int stages, int is_first) {
    static const double gamma[2][3] = {{8. / 15, 2. / 15, 1. / 3}, {1, 0, 0}}, begins[3] = {0, 8. / 15, 2. / 3};
    const double more = inner->is_deep ? (stages == 1 ? 0.95 : 0.7) : 0.5;
    double sum = 0;
    for (int q = is_first; q < stages; q++) {
        const double g = gamma[stages == 1][q], start = is_first ? r->inner[0].velocity[c][h] : inner->last[q][c];
        const double gain = r->inner[q].velocity[c][h] - start, ahead = is_first ? g / begins[q] : g;
        sum += ahead * gain + more * g * gain - inner->excess[q][c];
        inner->excess[q][c] = ahead * gain - (1 - more) * g * gain;
    }
    return sum;
}
