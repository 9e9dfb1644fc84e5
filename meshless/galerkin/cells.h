/* Background cells: convex pieces, and quadrature in them and along their edges.
 *
 * A grid of cells over the body's bounds is clipped by the outline and the holes and cut by the straight lines of the
 * cracks; a crack of several parts cuts only the cells that it or its extension crosses. A tip becomes a corner of the
 * pieces that it touches, and so do corners of pieces on their neighbours' edges. At a tip the quadrature is that of
 * triangles collapsed at the tip, whose Jacobian takes the singularity 1/r of the energy away.
 *
 * Points along an edge depend on the edge alone, so that two pieces that share it have the same ones. */
#pragma once
#include "meshless/galerkin/galerkin.h"

enum { MESHLESS_CELLS_CORNERS = 24, MESHLESS_CELLS_GAUSS = 16 };

/* Makes the pieces. Dies (exit 2) where the cells do not fit the body. Collective. */
void meshless_cells_new(struct galerkin *g);
void meshless_cells_free(struct galerkin *g);

/* Points and weights of a piece: at most MESHLESS_CELLS_CORNERS GAUSS^2. Returns how many. */
int meshless_cells_inside(const struct galerkin *g, int piece, struct galerkin_place *at, double *weight);
/* Points, weights (m) and the unit normal of the edge from corner k of a piece to the next; points are seen from inside
 * the piece. Returns how many. */
int meshless_cells_edge(const struct galerkin *g, int piece, int k, struct galerkin_place *at, double *weight,
                        double normal[2]);
double meshless_cells_area(const struct galerkin *g, int piece);
/* Whether the middle of the edge is on the segment from a to b (within 1e-6 spacings). */
int meshless_cells_is_on(const struct galerkin *g, int piece, int k, const double a[2], const double b[2]);
/* Gauss points in (0, 1) and weights of sum 1; n at most MESHLESS_CELLS_GAUSS. */
void meshless_cells_gauss(int n, double *x, double *w);
