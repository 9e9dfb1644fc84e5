/* Values of particles on a regular grid. */
#pragma once

/* Node (i, j) is at origin + (i, j) h; NaN: no value. */
struct postproc_grid {
    int n[2];
    double origin[2], h; /* m */
    double *value;       /* [n1][n0]; owned */
};

struct postproc_grid_input {
    long n;
    const double (*x)[2]; /* [n] m */
    const double *value;  /* value[i * stride] is the i-th */
    int stride;
    double spacing;  /* of the coarsest lattice, m */
    double first[2]; /* one of its nodes, m */
};

/* The grid is the coarsest of the lattices of spacing, spacing/2, spacing/4 ... on which all particles lie; if there is
 * none, each node takes the mean of the particles nearest to it. Nodes between the particles of coarser lattices take
 * the mean of two or four neighbours. One row of nodes around the particles takes the values of adjacent nodes. */
struct postproc_grid *postproc_grid_new(const struct postproc_grid_input *in);
/* All values NaN. */
struct postproc_grid *postproc_grid_empty(int n0, int n1, const double origin[2], double h);
void postproc_grid_free(struct postproc_grid *g);
/* NaN outside the grid. */
double postproc_grid_value(const struct postproc_grid *g, int i, int j);
/* Bilinear; NaN if a node with nonzero weight has no value. */
double postproc_grid_at(const struct postproc_grid *g, const double x[2]);
/* The same field with the first axis along a direction of length 1, about the plane's origin:
 * node (i, j) is at (origin[0] + i h) e + (origin[1] + j h) e', e' to the left of e. */
struct postproc_grid *postproc_grid_turn(const struct postproc_grid *g, const double direction[2]);
