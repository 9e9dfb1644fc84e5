/* Nodes of a plate: a square lattice in the outline, with finer ones about the tips.
 *
 * Level k halves the spacing of level k - 1 within `patch` of its spacings, along x and y, from a tip; with a direction
 * of the tip, along and across it: then every tip has the same nodes about it, however its crack lies. */
#pragma once
#include "meshless/galerkin/galerkin.h"

struct meshless_nodes {
    int n;
    double (*x)[2]; /* [n] m */
    double *size;   /* [n] spacing about each node, m */
};
/* Nodes at (i + 1/2 + offset) spacing inside the outline or on it. tip [tips] places of the tips; along [tips] their
 * directions, unit vectors, or NULL. Not collective. */
struct meshless_nodes meshless_nodes_new(const struct galerkin_input *in, const double offset[2], int tips,
                                         const double (*tip)[2], const double (*along)[2]);
