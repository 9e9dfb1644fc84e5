/* Neighbours among points that stand on no lattice. Used while a solid is set up. */
#pragma once
#include "solid/family.h"
#include "solid/body.h"

struct solid_points; /* opaque: the body's points sorted into cells */

struct solid_points_near {
    int n;
    long number[SOLID_FAMILY_MAX];   /* of the neighbour in the body's numbering, ascending */
    double xi[SOLID_FAMILY_MAX][3];  /* m */
    int image[SOLID_FAMILY_MAX][3];  /* the neighbour's period, -1, 0 or 1 */
    double weight[SOLID_FAMILY_MAX]; /* Gamma V_l, m3 */
};

/* Every point has the horizon given; the store allows each its own. Collective (all ranks alike). */
struct solid_points *solid_points_new(const struct solid_input *in, const struct solid_body *body,
                                      const struct solid_sites *sites, double horizon);
void solid_points_free(struct solid_points *points);
/* The family of the point with the number in the body's numbering. Dies when it holds more than SOLID_FAMILY_MAX. */
void solid_points_near(const struct solid_points *points, long number, struct solid_points_near *near);
