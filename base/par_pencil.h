/* Transposes between pencils of a box of n[0] x n[1] x n[2] values over a process grid ranks[1] x ranks[2]:
 *
 *     x pencil  [m_z][m_y][n_x]     the home of the fluid: y cut in ranks[1], z in ranks[2]
 *     y pencil  [m_z][n_y][m_x]     x cut in ranks[1], z in ranks[2]
 *     z pencil  [n_z][m_y'][m_x]    x cut in ranks[1], y in ranks[2]
 *
 * all tight, x fastest. A direction with one rank needs no transpose: the two pencils have one shape then, and the caller
 * uses one array for both (par_pencil_same). */
#pragma once

/* First of the cells that piece c of `pieces` holds of n; c = pieces gives n. */
static inline int par_piece_low(int n, int pieces, int c) { return (int)((long)n * c / pieces); }
/* The piece that holds cell i. */
static inline int par_piece_of(int n, int pieces, int i) { return (int)((((long)i + 1) * pieces - 1) / n); }

struct par_pencil; /* opaque, owned by the caller */

struct par_pencil_input {
    int n[3];     /* values of the whole box */
    int ranks[3]; /* ranks[0] = 1; rank = c_z ranks[1] + c_y */
};

enum par_pencil_step { PAR_PENCIL_XY, PAR_PENCIL_YZ };

struct par_pencil *par_pencil_new(const struct par_pencil_input *in); /* Collective. */
void par_pencil_free(struct par_pencil *p);
/* Shapes on this rank: the extents of the x, y and z pencil. Not collective. */
void par_pencil_shape(const struct par_pencil *p, int x_pencil[3], int y_pencil[3], int z_pencil[3]);
/* First global index of the z pencil's piece, in x and y. Not collective. */
void par_pencil_z_low(const struct par_pencil *p, int *x, int *y);
int par_pencil_same(const struct par_pencil *p, enum par_pencil_step step);

/* x -> y pencil (XY), y -> z pencil (YZ); backward the other way. from and to do not overlap. Collective. */
void par_pencil_forward(struct par_pencil *p, enum par_pencil_step step, const double *from, double *to);
void par_pencil_backward(struct par_pencil *p, enum par_pencil_step step, const double *from, double *to);
