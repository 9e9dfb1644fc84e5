/* Rays through voxels. */
#pragma once
#include "postproc/draw/voxels.h"

/* A ray as the list of the cells that it meets, relative to the cell in whose centre it starts. */
enum { POSTPROC_RAY_CELLS = 192 };
struct postproc_ray {
    int cells;
    signed char step[POSTPROC_RAY_CELLS][3];
    float distance[POSTPROC_RAY_CELLS]; /* cells, to where the ray enters the cell */
};
/* The cells that the ray meets within `length` cells along the direction, without the first.  (Amanatides and Woo
 * 1987) */
void postproc_ray_cast(struct postproc_ray *ray, const double direction[3], double length);
/* Distance to the first cell with a particle, or -1. */
double postproc_ray_hit(const struct postproc_ray *ray, const struct postproc_voxels *v, const int cell[3]);
