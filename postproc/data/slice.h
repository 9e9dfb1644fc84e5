/* A plane of cells of a fluid's field file. */
#pragma once
#include "postproc/data/flow.h"
#include "postproc/data/stream.h"

/* Cells across direction `axis`; across[0], across[1] are the other two in rising order: (1, 2), (0, 2), (0, 1).
 * Values are [n1][n0]; NaN in the solid, that is, where the solid fraction is at least one half. */
struct postproc_slice {
    int axis, across[2], index; /* index of the plane of cells along axis */
    int n[2];
    double d[2], place;                /* m; place: of the cells' centres along axis */
    double (*u)[2];                    /* velocity in the plane, m/s; also in the solid; owned, as all below */
    double *speed;                     /* |u| of all three components, m/s */
    double *pressure;                  /* Pa; NULL if the file has none */
    double *vorticity;                 /* |curl u|, 1/s */
    unsigned char *solid;              /* 1 in the solid */
    enum postproc_beyond beyond[2][2]; /* of the low and the high side of both directions */
    double wall[2][2][2];              /* velocity of a wall in the plane, m/s */
    double time;
    long step;
};

/* The plane of cells that holds the place (NAN: the middle; the lower one of two), of fluid file k. Reads this plane
 * and, of the velocity, its two neighbours. NULL if the file cannot be read or has no velocity. */
struct postproc_slice *postproc_slice_new(const struct postproc_history *h, int k, int axis, double place);
void postproc_slice_free(struct postproc_slice *s);
/* A quantile, 0 ... 1, of the finite ones of the slice's values; NAN if there is none. */
double postproc_slice_quantile(const struct postproc_slice *s, const double *value, double q);
/* Lines along the velocity in the plane, spread evenly: no two are nearer to each other than about the side of a
 * square, of which `squares` fill the longer side. Points are (x, y, 0) in the plane, m, a tenth of a cell apart. */
struct postproc_stream postproc_slice_lines(const struct postproc_slice *s, int squares);
