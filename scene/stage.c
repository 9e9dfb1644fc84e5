/* What a stage of a scene does. */
#include "scene/scene.h"

#include <math.h>

int scene_stage_may_break(const struct scene *s, int k) {
    int may = 0;
    if (!s->solid || s->stage[k].solid != SCENE_SOLID_ELASTIC || !s->stage[k].breakage) return 0;
    for (int m = 0; m < s->solid->materials; m++)
        may |= isfinite(s->solid->material[m].fracture_energy) || s->solid->material[m].s00 > 0;
    for (int i = 0; i < s->solid->interfaces; i++) may |= isfinite(s->solid->interface[i].fracture_energy);
    return may;
}

int scene_stage_rests(const struct scene_stage *s) { return s->has_until && s->until_quantity == SCENE_UNTIL_REST; }
