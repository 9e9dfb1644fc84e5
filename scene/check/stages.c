/* Checks that stages have distinct names and run with the parts the scene has. */
#include "scene/check/check.h"

#include <string.h>

/* Whether the name of a stage can be a part of a file name: the stage's checkpoint is named after the stage. */
static int can_name_a_file(const char *name) {
    while (*name && *name != '/' && (unsigned char)*name >= ' ') name++;
    return !*name;
}

void scene_check_stages(const struct scene_check *c) {
    for (int i = 0; i < c->scene->stages; i++) {
        const struct scene_stage *s = &c->scene->stage[i];
        if (!scene_check_parts_clean(c, scene_check_parts_path("stages[%d].name", i))) continue;
        if (!can_name_a_file(s->name))
            scene_problem_at(c->problems, c->root, scene_check_parts_path("stages[%d].name", i).text,
                             "must not hold a slash or a control character: its checkpoint is named after it");
        for (int k = 0; k < i; k++)
            if (!strcmp(c->scene->stage[k].name, s->name)) {
                scene_problem_at(c->problems, c->root, scene_check_parts_path("stages[%d].name", i).text,
                                 "is the name of stages[%d] too", k);
                break;
            }
        if (c->scene->solid && !c->scene->fluid && s->solid == SCENE_SOLID_RIGID &&
            scene_check_parts_clean(c, scene_check_parts_path("stages[%d].solid", i)))
            scene_problem_at(c->problems, c->root, scene_check_parts_path("stages[%d].solid", i).text,
                             "a rigid solid without a fluid does nothing: must be elastic");
    }
}
