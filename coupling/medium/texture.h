/* Porosity and wetted surface of parts of the medium's box: slices across each direction, and sub-volumes of growing
 * size. All of these are collective, with the same result on every rank. */
#pragma once
#include "coupling/medium/medium.h"

/* The sections of direction c that the box holds: their number, and then of each its middle (m, of its part in the box)
 * and porosity. at, porosity [count] */
int medium_texture_slices(const struct medium *m, int c);
void medium_texture_slice(const struct medium *m, int c, double *at, double *porosity);

/* Sub-volumes of one size: the box cut into parts[3] equal ones. */
struct medium_texture_size {
    int parts[3];
    double edge;                             /* cube root of a sub-volume, m */
    double porosity[4], specific_surface[4]; /* mean, standard deviation, least, largest; 1 and 1/m */
    double carman[4];                        /* phi^3/(5 S^2), m2; NaN of a sub-volume without surface or void */
};
/* Cuts the box in two along each direction, again and again while a part is at least MEDIUM_TEXTURE_CELLS cells wide
 * there: up to MEDIUM_TEXTURE_SIZES sizes, the smallest first. area [n] m2 of wetted surface at x [3][n] m, on any
 * rank, wrapped in periodic directions. Returns the number of sizes; the last is the whole box. */
enum { MEDIUM_TEXTURE_CELLS = 4, MEDIUM_TEXTURE_SIZES = 6 };
int medium_texture_sizes(const struct medium *m, int n, const double *const x[3], const double *area,
                         struct medium_texture_size size[MEDIUM_TEXTURE_SIZES]);
