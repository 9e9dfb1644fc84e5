/* Checks the indenters against the stages. */
#include "scene/check/check.h"

void scene_check_indenter(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    if (s->indenters == 0 || !CLEAN(c, "solid.indenters")) return;
    for (int i = 0; i < c->scene->stages; i++)
        if (c->scene->stage[i].relax) {
            PROBLEM(c, "solid.indenters",
                    "cannot go with stages[%d].relax: indenters push in time steps only; a constraint with a "
                    "displacement presses from rest to rest",
                    i);
            return;
        }
}
