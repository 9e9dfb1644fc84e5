/* Parts of setup_solid: bodies and cracks with their arrays. */
#pragma once
#include "coupling/setup/setup.h"

/* Body b. Collective: rank 0 reads a point file, all ranks read an image. */
void setup_body(const struct scene *scene, int b, struct solid_body *to);
/* The name and the outlines only. */
void setup_body_outlines(const struct scene_body *from, struct solid_body *to);
struct solid_turn setup_body_turn(const struct scene_turn *turn);
void setup_body_free(struct solid_body *body);
void setup_body_cut(const struct scene_crack *from, struct solid_cut *to);
void setup_body_cut_free(struct solid_cut *cut);
/* Whether the body's particles are put into its shape here, and puts them: `to` becomes a body of points. Collective.
 */
int setup_arrange_is_on(const struct scene *scene, int b);
void setup_arrange(const struct scene *scene, int b, struct solid_body *to);
/* Reads the particles of a point file. What is beyond a periodic side comes in at the opposite one. Dies (exit 2) if no
 * particle is in the domain. Collective. */
void setup_points(const struct scene_body *from, const struct scene_domain *domain, int dim, double spacing,
                  struct solid_body *to);
/* Reads the spheres and ellipsoids of a list, from the scene or its file; name: of the body. Collective. */
void setup_spheres(const struct scene_part *from, const char *name, struct solid_body *to);
