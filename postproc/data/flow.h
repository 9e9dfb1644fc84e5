/* Velocity of a field file of the fluid, at any place. */
#pragma once
#include "postproc/data/history.h"

/* How the velocity continues beyond a side, from the value half a cell inside. */
enum postproc_beyond {
    POSTPROC_BEYOND_WRAP,   /* periodic: the cell at the other end */
    POSTPROC_BEYOND_MIRROR, /* wall: the velocity that makes the mean the wall's */
    POSTPROC_BEYOND_COPY    /* open or slip: the same value */
};
struct postproc_flow {
    int n[3];
    double d[3];                       /* cell (i, j, k) is centred at ((i + 1/2) d0, (j + 1/2) d1, (k + 1/2) d2), m */
    enum postproc_beyond beyond[3][2]; /* of the low and the high side of each direction */
    double wall[3][2][3];              /* velocity of a wall, m/s */
    float (*u)[3];                     /* [nz][ny][nx] m/s; owned */
    float *solid;                      /* [nz][ny][nx] solid fraction, 0 ... 1; NULL without a solid; owned */
    double time;
    long step;
    /* Over the cells whose solid fraction is below one half: */
    double mean[3], fastest; /* velocity, and the largest speed, m/s */
    double bound;            /* 99.9 % quantile of the speed, m/s */
};

/* From fluid file k; NULL if it cannot be read or has no velocity. Sixteen bytes a cell. */
struct postproc_flow *postproc_flow_new(const struct postproc_history *h, int k);
void postproc_flow_free(struct postproc_flow *f);
/* Copies what the scene says of the sides. */
void postproc_flow_sides(struct postproc_flow *f, const struct scene *scene);
/* Trilinear between the cells' centres. Returns 0 outside the domain (of a direction that is not periodic) and where
 * the solid fraction, trilinear too, is at least one half. */
int postproc_flow_at(const struct postproc_flow *f, const double x[3], double u[3]);
