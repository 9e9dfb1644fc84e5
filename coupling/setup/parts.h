/* Parts of setup_solid: bodies and cracks with the arrays behind them. */
#pragma once
#include "coupling/setup/setup.h"

/* One body; dim: components of a place. Collective: rank 0 reads a point file. */
void setup_body(const struct scene_body *from, int dim, struct solid_body *to);
/* Its name and outlines only. */
void setup_body_outlines(const struct scene_body *from, struct solid_body *to);
void setup_body_free(struct solid_body *body);
void setup_body_cut(const struct scene_crack *from, struct solid_cut *to);
void setup_body_cut_free(struct solid_cut *cut);
/* The particles of a point file. Collective. */
void setup_points(const struct scene_body *from, int dim, struct solid_body *to);
