/* Arrangements of points in a domain of any shape, in one, two or three dimensions: lattice, hexagonal, perturbed,
 * centroidal (Lloyd's iteration), random.  (004: sec. 2) */
#pragma once
#include "physics/choice_points.h"

/* The shape that the points fill. */
struct meshless_domain {
    int dim;
    double low[3], high[3];                                /* bounds, m */
    int (*is_inside)(const void *with, const double x[3]); /* pure */
    const void *with;
    double measure; /* m^dim; 0: found on the pixels */
};

struct meshless_arrange_input {
    enum meshless_arrangement kind;
    enum meshless_volume volume; /* measure / n, or each point's Voronoi cell in the domain */
    struct meshless_domain domain;
    double spacing;   /* h, m; 0: from `points` */
    long points;      /* centroidal, random: their number; 0: measure / h^dim, rounded. Other kinds: h is taken so that
                       * this number of cells h^dim fills the domain, and the points inside it are counted */
    double origin[3]; /* lattice, perturbed: points at origin + (i + 1/2) h; hexagonal: it is symmetric about it */
    double perturbation; /* spacings: each point is moved by at most this in each direction */
    int seed;
};

/* Points in the order of their making; on every rank all of them, and the same ones. */
struct meshless_points {
    int dim;
    long n;
    double spacing; /* h, m */
    double measure; /* of the domain, m^dim */
    double *x[3];   /* [n] m; in directions beyond dim NULL */
    double *volume; /* [n] m^dim */
    int iterations; /* of Lloyd's */
    double *energy; /* [iterations + 1] sum over the pixels of the squared distance to their point, times the pixel,
                     * m^(dim + 2); NULL: none */
};

/* Dies (exit 2) on a domain without a point, and with more than 2^31 pixels. Collective (same input on all ranks). */
struct meshless_points *meshless_arrange_new(const struct meshless_arrange_input *in);
void meshless_arrange_free(struct meshless_points *p);
