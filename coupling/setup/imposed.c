/* Translates loads, imposed and initial displacements and refinement from the scene to the solid's input. */
#include "coupling/setup/imposed.h"
#include "base/ensure.h"
#include "coupling/setup/parts.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static struct solid_time time_of(const struct scene_time *from) {
    return (struct solid_time){from->n, from->t, from->factor, 0};
}

static void load_add(const struct scene_load *from, struct solid_load *to) {
    *to = (struct solid_load){.kind = from->kind, .over_horizon = from->over_horizon, .time = time_of(&from->time)};
    memcpy(to->low, from->low, sizeof to->low);
    memcpy(to->high, from->high, sizeof to->high);
    to->turn = setup_body_turn(&from->turn);
    memcpy(to->force, from->force, sizeof to->force);
    memcpy(to->edge, from->edge, sizeof to->edge);
    memcpy(to->traction, from->traction, sizeof to->traction);
}

static struct solid_refinement *refinement_of(const struct scene_refinement *from) {
    if (!from) return NULL;
    struct solid_refinement *to = calloc(1, sizeof *to);
    struct solid_refined *start = calloc((size_t)from->starts + 1, sizeof *start);
    ENSURE(to && start, "no memory for a refinement");
    for (int k = 0; k < from->starts; k++) {
        memcpy(start[k].low, from->start[k].low, sizeof start[k].low);
        memcpy(start[k].high, from->start[k].high, sizeof start[k].high);
        start[k].level = from->start[k].level;
        start[k].turn = setup_body_turn(&from->start[k].turn);
    }
    *to = (struct solid_refinement){.levels = from->levels,
                                    .energy = from->energy,
                                    .damage = from->damage,
                                    .horizon_kept = from->horizon_kept,
                                    .interface_corrected = from->interface_corrected,
                                    .held_refine = from->held_refine,
                                    .starts = from->starts,
                                    .start = start};
    memcpy(to->low, from->low, sizeof to->low);
    memcpy(to->high, from->high, sizeof to->high);
    to->turn = setup_body_turn(&from->turn);
    return to;
}

void imposed_add(const struct scene *scene, struct solid_input *in) {
    const struct scene_solid *s = scene->solid;
    struct solid_load *load = calloc((size_t)s->loads + 1, sizeof *load);
    struct solid_initial *initial = calloc((size_t)s->initials + 1, sizeof *initial);
    ENSURE(load && initial, "no memory for %d loads", s->loads);
    for (int k = 0; k < s->loads; k++) load_add(&s->load[k], &load[k]);
    for (int k = 0; k < s->initials; k++) {
        initial[k].shape = s->initial[k].shape;
        initial[k].along = s->initial[k].along;
        initial[k].centre = s->initial[k].centre;
        initial[k].width = s->initial[k].width;
        memcpy(initial[k].displacement, s->initial[k].displacement, sizeof initial[k].displacement);
    }
    for (int k = 0; k < s->constraints; k++) {
        struct solid_constraint *to = (struct solid_constraint *)(uintptr_t)&in->constraint[k];
        to->has_displacement = s->constraint[k].has_displacement;
        to->time = time_of(&s->constraint[k].time);
        memcpy(to->displacement, s->constraint[k].displacement, sizeof to->displacement);
    }
    in->loads = s->loads;
    in->load = load;
    in->initials = s->initials;
    in->initial = initial;
    in->refinement = refinement_of(s->refinement);
}

void imposed_free(struct solid_input *in) {
    free((void *)(uintptr_t)in->load);
    free((void *)(uintptr_t)in->initial);
    if (in->refinement) free((void *)(uintptr_t)in->refinement->start);
    free((void *)(uintptr_t)in->refinement);
    in->refinement = NULL;
    in->load = NULL;
    in->initial = NULL;
}
