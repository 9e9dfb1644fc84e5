/* A fixed fine grid of pixels (voxels) over a domain, and who of some points is nearest to each: the quadrature of
 * Voronoi cells. Each rank holds a part of the pixels; sums over them are sums of whole numbers, so that every number
 * of ranks gets the same to the bit. */
#pragma once
#include "meshless/arrange/arrange.h"

struct meshless_pixels {
    int dim, n[3];
    double low[3], width[3]; /* m */
    double measure;          /* of a pixel, m^dim */
    long from, to;           /* this rank's lines of pixels along x */
    int *owner;              /* [(to - from) n[0]] point nearest to a pixel; -1: the pixel is outside the domain */
    long inside;             /* pixels inside, of all ranks */
};

/* The moments of each point's cell about the pixel that holds the point, in whole numbers of pixels. */
struct meshless_moments {
    long *count, *first, *second; /* [n], [n][dim], [n][dim]; one array, owned by count */
};

struct meshless_pixels *meshless_pixels_new(const struct meshless_domain *domain, double spacing); /* Collective. */
void meshless_pixels_free(struct meshless_pixels *g);
/* Finds the nearest of n points for each pixel (of several equally near the lowest number), and the moments over the
 * pixels of all ranks. m: by meshless_pixels_moments. Collective. */
void meshless_pixels_assign(struct meshless_pixels *g, long n, double *const x[3], double spacing,
                            struct meshless_moments *m);
struct meshless_moments meshless_pixels_moments(const struct meshless_pixels *g, long n);
void meshless_pixels_moments_free(struct meshless_moments *m);
/* The pixel that holds x in direction c, which may lie outside the grid. Pure. */
long meshless_pixels_at(const struct meshless_pixels *g, int c, double x);
