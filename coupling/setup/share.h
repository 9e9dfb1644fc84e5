/* The division of the cells over the ranks by the work of a coupled step: forcing and probes are computed by the rank
 * that holds their cells, so a piece with markers has more to do than one of fluid alone. */
#pragma once
#include "fluid/fluid.h"
#include "scene/scene.h"
#include "solid/surface/surface.h"

/* Work along each row of cells: [n_z][n_y], in cells; by the markers' places at the start. To be freed by memory_free.
 * Collective. */
double *share_work(const struct fluid_grid *g, const struct solid *s, const struct solid_surface *surface);
/* The cuts of y and z that follow from it: cut[d] [ranks[d] + 1]. Not collective. */
void share_cut(const int n[3], int halo, const double *work, const int ranks[3], int *const cut[3]);
/* The largest piece's work over the mean. Not collective. */
double share_imbalance(const int n[3], const double *work, const int ranks[3], const int *const cut[3]);
/* Makes the fluid again, in pieces of equal work, if that takes 3 % off the largest piece. To be called before anything
 * else is made of the fluid. Returns the fluid, or the new one; the old one is then freed. Collective. */
struct fluid *share_divide(const struct scene *scene, struct fluid *fluid, const struct solid *s,
                           const struct solid_surface *surface);
