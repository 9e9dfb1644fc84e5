/* Transposes between x and y pencils of a box of n[0] x n[1] x n[2] values over a process grid ranks[1] x ranks[2]:
 *
 *     x pencil  [planes][m_y][n_x]     the fluid's layout: y cut in ranks[1], z in ranks[2]
 *     y pencil  [planes][n_y][m_x]     x cut in ranks[1], z in ranks[2]
 *
 * both tight, x fastest. With slabs, ranks[1] = 1, no transpose is needed: the two pencils have one shape then. */
#pragma once

struct par_pencil; /* opaque, owned by the caller */

/* From so many doubles (128 kB) on, threads share the copies between a pencil and the messages. To be called outside of
 * threads_run. */
enum { PAR_PENCIL_SHARED = 16384 };

struct par_pencil_input {
    int n[3];          /* values of the whole box */
    int ranks[3];      /* ranks[0] = 1; rank = c_z ranks[1] + c_y */
    const int *cut[3]; /* of y, of z: first cells of the pieces (par_piece_cut), borrowed; NULL: even ones */
    int extra;         /* planes beyond this rank's own that a transpose may include */
};

struct par_pencil *par_pencil_new(const struct par_pencil_input *in); /* Collective. */
void par_pencil_free(struct par_pencil *p);
/* Shapes on this rank: extents of the x pencil and of the y pencil. Not collective. */
void par_pencil_shape(const struct par_pencil *p, int x_pencil[3], int y_pencil[3]);
/* First global x of the y pencil's piece. Not collective. */
int par_pencil_low(const struct par_pencil *p);
/* Whether both pencils have the same shape. Not collective. */
int par_pencil_same(const struct par_pencil *p);

/* x -> y pencil, and back. from and to do not overlap. Collective. */
void par_pencil_forward(struct par_pencil *p, int planes, const double *x_pencil, double *y_pencil);
void par_pencil_backward(struct par_pencil *p, int planes, const double *y_pencil, double *x_pencil);
