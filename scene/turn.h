/* Rotations of boxes, cylinders, ellipsoids and regions: what follows from their keys. */
#pragma once
#include "scene/scene.h"
#include "scene/text/node.h"

/* Sets the members of all rotations of the scene that follow from others: the edges and, where it is left out, the
 * point that stays. A rotation with a mistake turns nothing. */
void scene_turn_derive(struct scene *s, const struct scene_node *root);
/* Where x goes to. */
void scene_turn_point(const struct scene_turn *turn, const double x[3], double y[3]);
/* The bounds of the turned box low ... high. */
void scene_turn_box(const struct scene_turn *turn, const double low[3], const double high[3], double its_low[3],
                    double its_high[3]);
/* Whether the rotation of the mapping at path has directions that determine it; if not, what is wrong, and at which of
 * its keys. */
const char *scene_turn_fault(const struct scene_turn *turn, const struct scene_node *root, const char *path,
                             const char **key);
