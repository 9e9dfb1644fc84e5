/* The division of cells over pieces: as even as it can be, or by weight; the same on every rank. */
#pragma once

/* First of the cells of piece c, of n cells cut into `pieces` pieces; c = pieces gives n. */
static inline int par_piece_low(int n, int pieces, int c) { return (int)((long)n * c / pieces); }

/* Cuts n cells into pieces of at least `least` cells so that the largest sum of weight [n] is as small as it can be:
 * piece c has the cells first[c] .. first[c+1]-1, first [pieces + 1]. weight NULL: pieces of equal numbers of cells. */
void par_piece_cut(int n, const double *weight, int pieces, int least, int *first);
/* The piece that holds cell i. */
int par_piece_of(const int *first, int pieces, int i);
