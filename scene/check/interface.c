/* Checks interfaces: bodies that exist, once each pair, and what bonds across them do not go with. */
#include "physics/limits.h"
#include "scene/check/check.h"

static struct scene_path between(int i) { return scene_check_parts_path("solid.interfaces[%d].between", i); }

/* Whether both names are those of two different bodies. */
static int check_names(const struct scene_check *c, int i) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_interface *k = &s->interface[i];
    const char *name[PHYSICS_BODIES_MAX];
    for (int b = 0; b < s->bodies; b++) name[b] = s->body[b].name;
    for (int e = 0; e < 2; e++) {
        if (k->body[e] >= 0) continue;
        const char *nearest = scene_problem_nearest(k->between[e], s->bodies, name);
        scene_problem_at(c->problems, c->root, scene_check_parts_path("%s[%d]", between(i).text, e).text,
                         "is no name in solid.bodies%s%s%s", nearest ? "; did you mean " : "", nearest ? nearest : "",
                         nearest ? "?" : "");
        return 0;
    }
    if (k->body[0] != k->body[1]) return 1;
    scene_problem_at(c->problems, c->root, between(i).text, "must be two different bodies");
    return 0;
}

static void check_bodies(const struct scene_check *c, int i) {
    const struct scene_solid *s = c->scene->solid;
    const struct scene_interface *k = &s->interface[i];
    for (int q = 0; q < i; q++) {
        const int *pair = s->interface[q].body;
        if ((pair[0] != k->body[0] || pair[1] != k->body[1]) && (pair[0] != k->body[1] || pair[1] != k->body[0]))
            continue;
        scene_problem_at(c->problems, c->root, between(i).text, "is the pair of solid.interfaces[%d] too", q);
        return;
    }
    for (int e = 0; e < 2; e++)
        if (s->material[s->body[k->body[e]].material_index].breakage == SCENE_BILINEAR) {
            scene_problem_at(c->problems, c->root, scene_check_parts_path("%s[%d]", between(i).text, e).text,
                             "has a material with the bilinear law: the bodies of an interface must be brittle");
            return;
        }
    if (s->body[k->body[0]].material_index == s->body[k->body[1]].material_index) return;
    for (int q = 0; q < c->scene->stages; q++)
        if (c->scene->stage[q].damping_relative > 0) {
            scene_problem_at(c->problems, c->root, scene_check_parts_path("stages[%d].damping_relative", q).text,
                             "does not go with an interface between two materials, solid.interfaces[%d]", i);
            return;
        }
}

void scene_check_interface(const struct scene_check *c) {
    const struct scene_solid *s = c->scene->solid;
    if (s->interfaces == 0 || !scene_node_is_clean(c->root, "solid.bodies") ||
        !scene_node_is_clean(c->root, "solid.materials") || !scene_node_is_clean(c->root, "stages"))
        return;
    if (s->refinement) scene_problem_at(c->problems, c->root, "solid.interfaces", "does not go with solid.refinement");
    if (s->horizons == SOLID_ONE_SIDED)
        scene_problem_at(c->problems, c->root, "solid.interfaces", "does not go with solid.horizons: one_sided");
    for (int i = 0; i < s->interfaces; i++)
        if (scene_check_parts_clean(c, between(i)) && check_names(c, i)) check_bodies(c, i);
}
