/* Checks interfaces: bodies that exist, once each pair, and what bonds across them do not go with. */
#include "physics/limits.h"
#include "scene/check/check.h"

static struct scene_path between(int i) { return PATH("solid.interfaces[%d].between", i); }

/* Whether both names are those of two different bodies. */
static int check_names(const struct scene_check *c, int i) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_interface *k = &s->interface[i];
    const char *name[PHYSICS_BODIES_MAX];
    for (int b = 0; b < s->bodies; b++) name[b] = s->body[b].name;
    for (int e = 0; e < 2; e++)
        if (!scene_check_parts_name(c, PATH("%s[%d]", between(i).text, e), k->between[e], "solid.bodies", s->bodies,
                                    name))
            return 0;
    if (k->body[0] != k->body[1]) return 1;
    PROBLEM(c, between(i).text, "must be two different bodies");
    return 0;
}

static void check_bodies(const struct scene_check *c, int i) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_interface *k = &s->interface[i];
    for (int q = 0; q < i; q++) {
        const int *pair = s->interface[q].body;
        if ((pair[0] != k->body[0] || pair[1] != k->body[1]) && (pair[0] != k->body[1] || pair[1] != k->body[0]))
            continue;
        PROBLEM(c, between(i).text, "is the pair of solid.interfaces[%d] too", q);
        return;
    }
    for (int e = 0; e < 2; e++)
        if (s->material[s->body[k->body[e]].material_index].breakage == SCENE_BILINEAR) {
            PROBLEM(c, AT("%s[%d]", between(i).text, e),
                    "has a material with the bilinear law: the bodies of an interface must be brittle");
            return;
        }
    if (s->body[k->body[0]].material_index == s->body[k->body[1]].material_index) return;
    for (int q = 0; q < c->scene->stages; q++)
        if (c->scene->stage[q].damping_relative > 0) {
            PROBLEM(c, AT("stages[%d].damping_relative", q),
                    "does not go with an interface between two materials, solid.interfaces[%d]", i);
            return;
        }
}

void scene_check_interface(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    if (s->interfaces == 0 || !CLEAN(c, "solid.bodies") || !CLEAN(c, "solid.materials") || !CLEAN(c, "stages")) return;
    if (s->refinement) PROBLEM(c, "solid.interfaces", "does not go with solid.refinement");
    if (s->horizons == SOLID_ONE_SIDED) PROBLEM(c, "solid.interfaces", "does not go with solid.horizons: one_sided");
    for (int i = 0; i < s->interfaces; i++)
        if (CLEAN(c, between(i).text) && check_names(c, i)) check_bodies(c, i);
}
