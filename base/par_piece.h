/* The division of cells over pieces: as even as it can be, the same on every rank. */
#pragma once

/* First of the cells of piece c, of n cells cut into `pieces` pieces; c = pieces gives n. */
static inline int par_piece_low(int n, int pieces, int c) { return (int)((long)n * c / pieces); }
/* The piece that holds cell i. */
static inline int par_piece_of(int n, int pieces, int i) { return (int)((((long)i + 1) * pieces - 1) / n); }
