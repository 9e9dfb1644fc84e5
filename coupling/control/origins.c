/* Sets the origins of times that count from the start of a stage. */
#include "coupling/control/origins.h"
#include "coupling/run.h"
#include "cracks/cracks.h"

#include <math.h>
#include <stdint.h>

static int is_used(const struct scene *scene) {
    int any = 0;
    for (int k = 0; scene->solid && k < scene->solid->loads; k++) any |= scene->solid->load[k].time.stage > 0;
    for (int k = 0; scene->solid && k < scene->solid->constraints; k++)
        any |= scene->solid->constraint[k].time.stage > 0;
    for (int k = 0; scene->crack_fluid && k < scene->crack_fluid->injections; k++)
        any |= scene->crack_fluid->injection[k].time.stage > 0;
    return any;
}

/* Of a time that counts from a stage; before that stage it is not known. */
static double origin_of(const struct run *r, const struct scene_time *time) {
    if (time->stage == 0) return 0;
    return time->stage - 1 <= r->stage ? r->began[time->stage - 1] : INFINITY;
}

static void set(const struct run *r, const struct scene_time *from, const struct solid_time *to) {
    ((struct solid_time *)(uintptr_t)to)->origin = origin_of(r, from);
}

void origins_set(struct run *r) {
    const struct scene *scene = r->scene;
    if (r->stage_step == 0 && r->stage < SCENE_TIMED_MAX) r->began[r->stage] = r->t;
    if (!is_used(scene)) return;
    for (int k = 0; r->needs.bonds && k < scene->solid->loads; k++)
        set(r, &scene->solid->load[k].time, &r->solid->in.load[k].time);
    for (int k = 0; r->needs.bonds && k < scene->solid->constraints; k++)
        set(r, &scene->solid->constraint[k].time, &r->solid->in.constraint[k].time);
    for (int k = 0; r->cracks && k < scene->crack_fluid->injections; k++)
        set(r, &scene->crack_fluid->injection[k].time, &r->cracks->in.injection[k].time);
}
