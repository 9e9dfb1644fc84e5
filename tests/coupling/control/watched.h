/* Runs into which a fault may be seeded, and what the watch of the balances has seen of them. */
#pragma once
#include "solid/imposed/reactions.h"
#include "tests/coupling/marching.h"

/* A fault of this size, seeded before a step. */
typedef void fault(struct run *r, double size);

static inline int is_free(const struct solid *s, int h) {
    return !(s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z));
}

/* A wrong factor of the kick: speeds grow. */
static inline void grows(struct run *r, double size) {
    for (int h = 0; h < r->solid->n; h++)
        for (int c = 0; c < 3 && is_free(r->solid, h); c++) r->solid->v[c][h] *= 1 + size;
}
/* A load whose work is not counted. */
static inline void pushes(struct run *r, double size) {
    for (int h = 0; h < r->solid->n; h++)
        if (is_free(r->solid, h)) r->solid->v[0][h] += 1e-3 * size;
}

struct outcome {
    struct watch clean, seen; /* after 50 steps, and at the end */
    int ended;
};

/* 100 steps; from the 51st on the fault before each step. */
static inline struct outcome watch_of(const char *text, const char *stage, fault *spoil, double size) {
    struct marching q = marching_new(text, stage, 0, NULL);
    struct outcome o = {.ended = 0};
    if (q.r->solid->in.constraints > 0) solid_reactions_new(q.r->solid); /* as output.reactions does */
    marching_begin(&q);
    for (int n = 0; n < 100 && !o.ended; n++) {
        if (n >= 50 && spoil) spoil(q.r, size);
        o.ended = !marching_step(&q);
        if (n == 49) o.clean = q.r->watch;
    }
    o.seen = q.r->watch;
    marching_free(&q);
    return o;
}
