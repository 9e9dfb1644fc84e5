/* What is looked at in a scene before it is believed. All of these go on after a mistake, so that all mistakes are said
 * at once: what was wrong is replaced by something that can be loaded and marked bad, and what rests on it is not
 * looked at. */
#pragma once
#include "scene/scene.h"
#include "scene/text/problem.h"

/* Keys, types, ranges, what is missing; fills in the defaults of scene/rules/rule.h and puts keys into their order. */
void scene_check_keys(struct scene_node *root, struct scene_problems *problems);

/* What one needs to look at a loaded scene and to say what is wrong with it. */
struct scene_check {
    const struct scene *scene;
    const struct scene_node *root;
    struct scene_problems *problems;
};

/* Combinations of keys that cannot be. */
void scene_check_parts(const struct scene_check *c);
void scene_check_fluid(const struct scene_check *c);
void scene_check_solid(const struct scene_check *c);
void scene_check_stages(const struct scene_check *c);
void scene_check_body(const struct scene_check *c, int b); /* parts of scene_check_solid */
void scene_check_region(const struct scene_check *c);

/* A path made as by printf, for the calls below: scene_check_parts_path("solid.bodies[%d].low", b).text */
struct scene_path {
    char text[96];
};
struct scene_path scene_check_parts_path(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Whether the key at the path is there and free of mistakes. */
int scene_check_parts_clean(const struct scene_check *c, struct scene_path path);
/* Whether low is below high; said of path.low. */
int scene_check_body_box(const struct scene_check *c, struct scene_path path, const double low[3],
                         const double high[3]);
/* The bounds of a body; 0 for one of points, whose bounds only its particles know. */
int scene_check_body_bounds(const struct scene_body *body, double low[3], double high[3]);
