/* Checks that stages have distinct names and run with the parts the scene has. */
#include "scene/check/check.h"

#include <string.h>

/* Whether the name of a stage can be a part of a file name: the stage's checkpoint is named after the stage. */
static int can_name_a_file(const char *name) {
    while (*name && *name != '/' && (unsigned char)*name >= ' ') name++;
    return !*name;
}

/* A stage that raises loads goes from rest to rest: what moves with a given velocity has no place in it. */
static void check_increment(const struct scene_check *c, int i) {
    const struct scene_stage *s = &c->scene->stage[i];
    const struct scene_solid *solid = c->scene->solid;
    const struct scene_path path = PATH("stages[%d].increment", i);
    if (!(s->increment > 0) || !solid || !CLEAN(c, path.text)) return;
    if (!s->relax) {
        PROBLEM(c, path.text, "only with relax: true");
        return;
    }
    for (int k = 0; k < solid->constraints && CLEAN(c, "solid.constraints"); k++) {
        if (scene_check_parts_is_zero(solid->constraint[k].velocity)) continue;
        PROBLEM(c, path.text,
                "solid.constraints[%d] has a velocity, which moves nothing in increments: needs displacement", k);
    }
}

/* Adams and Bashforth's scheme has no form for implicit diffusion. */
static void check_fluid_integrator(const struct scene_check *c, int i) {
    const struct scene_fluid *fluid = c->scene->fluid;
    const struct scene_path path = PATH("stages[%d].fluid_integrator", i);
    if (!fluid || c->scene->stage[i].fluid_integrator != FLUID_AB2 || !CLEAN(c, path.text)) return;
    if (fluid->diffusion == SCENE_DIFFUSION_IMPLICIT)
        PROBLEM(c, path.text, "does not go with fluid.diffusion: implicit");
}

/* The time at which a stage began is stored for the first stages. */
static void check_duration(const struct scene_check *c, int i) {
    const struct scene_stage *s = &c->scene->stage[i];
    const struct scene_path path = PATH("stages[%d].duration", i);
    if (!(s->duration > 0) || !CLEAN(c, path.text)) return;
    if (s->relax)
        PROBLEM(c, path.text, "does not go with relax: true: a relaxation takes no time, and increments have theirs");
    else if (i >= SCENE_TIMED_MAX)
        PROBLEM(c, path.text, "only in the first %d stages", SCENE_TIMED_MAX);
}

/* A quantity needs its parts; a solid that relaxes is at rest anyway. */
static void check_until(const struct scene_check *c, int i) {
    const struct scene_stage *s = &c->scene->stage[i];
    const struct scene_path path = PATH("stages[%d].until", i), damping = PATH("stages[%d].damping_absolute", i);
    const int elastic = c->scene->solid && s->solid == SCENE_SOLID_ELASTIC;
    if (s->has_until && CLEAN(c, path.text)) {
        if (s->until_quantity == SCENE_UNTIL_PERMEABILITY && !(c->scene->fluid && c->scene->solid))
            PROBLEM(c, path.text, "the permeability needs a fluid and a solid; quantity: rest needs one of them");
        else if (s->relax)
            PROBLEM(c, path.text, "does not go with relax: true, which ends at rest");
    }
    if (s->damping_absolute >= 0 || !c->scene->solid || !CLEAN(c, damping.text)) return;
    if (!scene_stage_rests(s) || !elastic)
        PROBLEM(c, damping.text, "needs until: {quantity: rest} and an elastic solid, or a number");
    else if (c->scene->solid->refinement)
        PROBLEM(c, damping.text, "does not go with solid.refinement: needs a number");
}

void scene_check_stages(const struct scene_check *c) {
    for (int i = 0; i < c->scene->stages; i++) {
        const struct scene_stage *s = &c->scene->stage[i];
        if (!CLEAN(c, AT("stages[%d].name", i))) continue;
        if (!can_name_a_file(s->name))
            PROBLEM(c, AT("stages[%d].name", i),
                    "must not hold a slash or a control character: its checkpoint is named after it");
        for (int k = 0; k < i; k++)
            if (!strcmp(c->scene->stage[k].name, s->name)) {
                PROBLEM(c, AT("stages[%d].name", i), "is the name of stages[%d] too", k);
                break;
            }
        check_increment(c, i);
        check_fluid_integrator(c, i);
        check_duration(c, i);
        check_until(c, i);
        if (c->scene->solid && !c->scene->fluid && s->solid == SCENE_SOLID_RIGID && CLEAN(c, AT("stages[%d].solid", i)))
            PROBLEM(c, AT("stages[%d].solid", i), "a rigid solid without a fluid does nothing: must be elastic");
    }
}
