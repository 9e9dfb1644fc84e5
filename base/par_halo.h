/* Halos: the ghost layers of arrays of [m_z+2h][m_y+2h][m_x+2h] cells, exchanged between ranks in y and z, and copied
 * across periodic sides that stay on a rank. The process grid is ranks[0] = 1 by ranks[1] by ranks[2], y fastest: rank
 * = c_z ranks[1] + c_y. Filling leaves ghosts beyond sides that are not periodic as they are. */
#pragma once
#include <stddef.h>

struct par_halo; /* opaque, owned by the caller */

struct par_halo_input {
    int m[3];                    /* this rank's cells, x y z */
    int halo;                    /* layers of ghosts that the arrays have, at most m wherever ghosts are filled */
    int ranks[3];                /* process grid, ranks[0] = 1 */
    int periodic[3];             /* 1: the direction closes on itself */
    ptrdiff_t first, row, plane; /* where cell 0,0,0 is in an array; strides of y and z */
    struct par_halo *lender;     /* whose buffers these halos use as well, which must live longer; NULL: their own */
};

/* The part of the ghosts that a filling has to fill: `layers` deep, within cells low .. high-1 (ghosts counted as -1,
 * -2, .. and m, m+1, ..) of the other two directions. wanted [direction][side]: this rank needs its ghosts there.
 * asked: the neighbour needs its ghosts there, copies of this rank's cells; it must then have set wanted. */
struct par_halo_part {
    int layers;
    int low[3], high[3];
    int wanted[3][2], asked[3][2];
};

struct par_halo *par_halo_new(const struct par_halo_input *in); /* Collective. */
void par_halo_free(struct par_halo *h);

/* The nearest `layers` ghosts of each field, edges and corners included: x, then y, then z, each over the whole (ghosts
 * included) extent of the other two. field [fields] arrays as above. Collective. */
void par_halo_fill(struct par_halo *h, int fields, double *const *field, int layers);
/* Fills one direction's ghosts in part, so that a side's conditions can be set between the directions. Neighbours in
 * that direction must give the same bounds across it. Collective. */
void par_halo_fill_part(struct par_halo *h, int direction, int fields, double *const *field,
                        const struct par_halo_part *part);
/* All of the nearest `layers` ghosts, as a part. Not collective. */
struct par_halo_part par_halo_whole(const struct par_halo *h, int layers);
/* The adjoint of the filling: the nearest `layers` ghosts are added to the owners' cells, then set to zero. Ghosts
 * beyond sides that are not periodic are dropped. Collective. */
void par_halo_add(struct par_halo *h, int fields, double *const *field, int layers);
/* Whether this rank's low (side 0) or high (side 1) end of the direction is an end of the domain that is not periodic.
 */
int par_halo_at_side(const struct par_halo *h, int direction, int side);
