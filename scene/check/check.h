/* Checks of a scene. Each check continues after a mistake, so that all mistakes are reported at once. A wrong value is
 * replaced by a valid one and marked bad, and the checks that depend on it are left out. */
#pragma once
#include "scene/scene.h"
#include "scene/text/problem.h"

/* What a check reads: the loaded scene, its tree, and the list of mistakes. */
struct scene_check {
    const struct scene *scene;
    const struct scene_node *root;
    struct scene_problems *problems;
};

/* Checks combinations of keys. */
void scene_check_parts(const struct scene_check *c);
void scene_check_fluid(const struct scene_check *c);
void scene_check_solid(const struct scene_check *c);
void scene_check_stages(const struct scene_check *c);
void scene_check_body(const struct scene_check *c, int b); /* parts of scene_check_solid */
int scene_check_image(const struct scene_check *c, int b); /* part of scene_check_body: whether all is well */
void scene_check_region(const struct scene_check *c);
void scene_check_interface(const struct scene_check *c);
void scene_check_indenter(const struct scene_check *c);
void scene_check_crack_fluid(const struct scene_check *c);

/* Opens the images of the scene's bodies and fills in their sizes, in the tree too. On the rank that reads the files.
 */
void scene_check_image_open(struct scene *s, struct scene_node *root, struct scene_problems *problems);

/* A path made by a printf format, for the calls below: scene_check_parts_path("solid.bodies[%d].low", b).text */
struct scene_path {
    char text[96];
};
struct scene_path scene_check_parts_path(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Whether the key at the path exists and has no mistake. */
int scene_check_parts_clean(const struct scene_check *c, struct scene_path path);
/* Whether the solid is rigid in all stages. */
int scene_check_parts_is_rigid(const struct scene *s);
/* Whether low is below high; if not, that is reported at path.low. */
int scene_check_body_box(const struct scene_check *c, struct scene_path path, const double low[3],
                         const double high[3]);
/* Reports times at path.time that do not ascend. */
void scene_check_region_time(const struct scene_check *c, struct scene_path path, const struct scene_time *time);
/* Whether the rotation in the mapping at the path, if there is one, has directions; if not, that is reported. */
int scene_check_body_turn(const struct scene_check *c, struct scene_path path, const struct scene_turn *turn);
/* The bounds of a body of shape image; 0 if its size is not known. */
int scene_check_image_bounds(const struct scene_body *body, double low[3], double high[3]);
/* The bounds of a body with its pieces. Returns 0 for points and lists in files, whose bounds the scene does not know.
 */
int scene_check_body_bounds(const struct scene_body *body, double low[3], double high[3]);
