/* Checks of a scene. Each check continues after a mistake, so that all mistakes are reported at once. A wrong value is
 * replaced by a valid one and marked bad, and the checks that depend on it are left out. */
#pragma once
#include "scene/scene.h"
#include "scene/text/path.h"
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

/* Whether the key at a path, a text, exists and has no mistake. */
#define CLEAN(c, path) scene_node_is_clean((c)->root, path)
/* Reports a mistake at a path: PROBLEM(c, path, format, ...). */
#define PROBLEM(c, ...) scene_problem_at((c)->problems, (c)->root, __VA_ARGS__)
/* Whether a vector is 0 in every direction. */
int scene_check_parts_is_zero(const double v[3]);
/* Whether the word at the path is one of the names of a list of the scene; if not, that is reported. */
int scene_check_parts_name(const struct scene_check *c, struct scene_path path, const char *word, const char *list,
                           int n, const char *const *name);
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
