/* The closed curves that bound a plate's bodies: rectangles, discs and polygons as corners and arcs. */
#pragma once
#include "scene/scene.h"

/* All curves of the body: its own, then those of its pieces, then those of its holes; none for a shape in 3D. Owned by
 * the body. */
void scene_outline_make(struct scene_body *body);
void scene_outline_free(struct scene_body *body);
void scene_outline_bounds(const struct scene_outline *o, double low[2], double high[2]); /* m */
/* What the body's curves enclose, less its holes, m2; 0 for a shape in 3D. */
double scene_outline_area(const struct scene_body *body);
