/* Finds bodies in a flow that nothing holds, in a stage that damps the solid until it is at rest. */
#include "coupling/control/braked.h"
#include "base/memory.h"
#include "base/par.h"

#include <stdio.h>

/* 1 for each body with a held particle, and for those that interfaces bond to it. Collective. */
static void find_held(const struct solid *s, double *held) {
    for (int h = 0; h < s->n; h++)
        if (s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z)) held[s->body[h]] = 1;
    par_max_array(held, s->in.bodies);
    for (int round = 0; round < s->in.interfaces; round++)
        for (int k = 0; k < s->in.interfaces; k++) {
            const int *body = s->in.interface[k].body;
            if (held[body[0]] > 0 || held[body[1]] > 0) held[body[0]] = held[body[1]] = 1;
        }
}

int braked_of(const struct run *r, char sentence[BRAKED_SENTENCE]) {
    const struct scene_stage *stage = run_stage(r);
    if (!r->needs.immersed || stage->solid != SCENE_SOLID_ELASTIC || stage->damping_absolute >= 0) return 0;
    const int bodies = r->solid->in.bodies;
    double *held = memory_new(MEMORY_COUPLING, (size_t)bodies, sizeof *held);
    find_held(r->solid, held);
    int first = -1, n = 0;
    for (int b = 0; b < bodies; b++)
        if (held[b] == 0 && n++ == 0) first = b;
    memory_free(held);
    if (n == 0) return 0;
    snprintf(sentence, BRAKED_SENTENCE,
             "stage %s: the damping that brings the solid to rest brakes %d of %d bodies that nothing holds (%s%s) and "
             "that would go with the flow: their velocity and the load on them are those of bodies held back. Hold "
             "them, or give the stage damping_absolute: 0 and its steps in place of until",
             stage->name, n, bodies, r->solid->in.body[first].name, n > 1 ? ", ..." : "");
    return 1;
}
