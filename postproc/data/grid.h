/* Values of particles on a regular grid. */
#pragma once

/* Node (i, j) stands at origin + (i, j) h; NaN where there is nothing. */
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

/* On the coarsest of the lattices spacing, spacing/2, spacing/4 ... that all particles stand on; of particles on none
 * the nodes take the means of those nearest to them. Nodes between particles of coarser lattices take the means of two
 * or four neighbours, and one row of nodes all round the particles the values of what is next to them. */
struct postproc_grid *postproc_grid_new(const struct postproc_grid_input *in);
/* All NaN. */
struct postproc_grid *postproc_grid_empty(int n0, int n1, const double origin[2], double h);
void postproc_grid_free(struct postproc_grid *g);
/* NaN outside the grid. */
double postproc_grid_value(const struct postproc_grid *g, int i, int j);
/* Bilinear; NaN where a node that counts has none. */
double postproc_grid_at(const struct postproc_grid *g, const double x[2]);
/* The same field with the first axis along a direction of length 1, about the plane's origin:
 * node (i, j) is at (origin[0] + i h) e + (origin[1] + j h) e', e' to the left of e. */
struct postproc_grid *postproc_grid_turn(const struct postproc_grid *g, const double direction[2]);
