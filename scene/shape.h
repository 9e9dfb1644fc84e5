/* What the scene knows of a shape whose bodies stand on the lattice: its bounds, its volume, how round it is. One entry
 * for each line of SOLID_LATTICE_SHAPES (physics/choice_solid.h). */
#pragma once
#include "scene/scene.h"

struct scene_shape_kind {
    /* Widens low, high to the bounds of the part, m. Returns 0 if a file has them. */
    int (*bounds)(const struct scene_part *p, double low[3], double high[3]);
    double (*volume)(const struct scene_part *p); /* m3; NULL: not known without counting */
    double (*radius)(const struct scene_part *p); /* the least, m; NULL: it has none */
    const char *radius_key;                       /* that gives it */
};

/* NULL for a shape that is not in the table: outlines, images, points. */
const struct scene_shape_kind *scene_shape_of(enum solid_shape shape);
