/* Short inputs of fluids, and a pseudo-random field that depends on the global position only. */
#pragma once
#include "base/par.h"
#include "fluid/fluid.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
/* after the above */
#include <cmocka.h>

/* In [-1/2, 1/2), the same on any number of ranks. */
static inline double random_at(long a, long b, long c, long d) {
    uint64_t h = (uint64_t)a * 0x9E3779B97F4A7C15u ^ (uint64_t)b * 0xC2B2AE3D27D4EB4Fu ^
                 (uint64_t)c * 0x165667B19E3779F9u ^ (uint64_t)d * 0x27D4EB2F165667C5u;
    h = (h ^ (h >> 31)) * 0xBF58476D1CE4E5B9u;
    h = (h ^ (h >> 29)) * 0x94D049BB133111EBu;
    return (double)((h ^ (h >> 32)) >> 11) * 0x1p-53 - 0.5;
}

static inline void all_sides(struct fluid_input *in, int d, enum fluid_side_type type) {
    in->side[d][0].type = in->side[d][1].type = type;
}

static inline double *component(struct fluid *f, int c) {
    struct fluid_state *s = fluid_state_of(f);
    return c == 0 ? s->u : c == 1 ? s->v : c == 2 ? s->w : s->p;
}

/* Adds up to 0.05 m/s to the velocity, the same on any number of ranks. */
static inline void stir(struct fluid *f) {
    const struct fluid_grid *g = fluid_grid_of(f);
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++)
                    component(f, c)[fluid_grid_at(g, i, j, k)] += 0.1 * random_at(i, j + g->lo[1], k + g->lo[2], c);
    fluid_state_refresh(f);
}

/* Mean velocity along a direction over the cells, m/s. Collective. */
static inline double bulk_velocity_along(struct fluid *f, int direction) {
    const struct fluid_grid *g = fluid_grid_of(f);
    const ptrdiff_t before = direction == 0 ? 1 : direction == 1 ? g->row : g->plane;
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) {
                const double *q = component(f, direction) + fluid_grid_at(g, i, j, k);
                sum += 0.5 * (q[0] + q[-before]);
            }
    return par_sum(sum) / (double)fluid_grid_cells(g);
}

#define FLUID_TEST_MAIN(...)                                                                                           \
    int main(int argc, char **argv) {                                                                                  \
        const struct CMUnitTest tests[] = {__VA_ARGS__};                                                               \
        par_begin(&argc, &argv);                                                                                       \
        const int failed = cmocka_run_group_tests(tests, NULL, NULL);                                                  \
        par_end();                                                                                                     \
        return failed;                                                                                                 \
    }
