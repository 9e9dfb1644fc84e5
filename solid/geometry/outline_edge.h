/* Edges of a plate's outline in units of a lattice. For solid/ only.
 *
 * Coordinates are multiples of 2^-48 (or of their last digit, if that is larger), so that sums of the heights of edges
 * within a row of cells are exact: a cell that no edge enters has exactly the area 0 or 1. */
#pragma once
#include "solid/state.h"

enum { SOLID_OUTLINE_PIECES = 5 }; /* largest number of pieces of an arc, once divided */

struct solid_outline_edge {
    double a[2], b[2];
    int turn;                                    /* 0: straight, +1: arc counterclockwise, -1: clockwise */
    long double centre[2], radius, start, sweep; /* arc: from the angle start by sweep > 0 in the sense of turn */
    int side[2];                                 /* piece of an arc: the signs of x - centre */
};

/* Edge k of the outline. An arc's centre is moved along the chord until both ends are equally far from it. */
struct solid_outline_edge solid_outline_edge(const struct solid_outline *o, int k, const double origin[2],
                                             double spacing);
struct solid_outline_edge solid_outline_edge_straight(const double a[2], const double b[2]);
/* The part from one fraction of the edge (0: a, 1: b) to another. */
struct solid_outline_edge solid_outline_edge_part(const struct solid_outline_edge *e, long double from, long double to);
/* Divides an edge into pieces that are monotone in x and in y. Returns how many. */
int solid_outline_edge_split(const struct solid_outline_edge *e, struct solid_outline_edge piece[SOLID_OUTLINE_PIECES]);
/* The same of edge k of the outline. */
int solid_outline_edge_pieces(const struct solid_outline *o, int k, const double origin[2], double spacing,
                              struct solid_outline_edge piece[SOLID_OUTLINE_PIECES]);

void solid_outline_edge_point(const struct solid_outline_edge *e, long double fraction, double x[2]);
/* Position along the edge, as a fraction, of the point of the edge's line or circle nearest to x; below 0 or above 1
 * beyond the ends. */
long double solid_outline_edge_fraction(const struct solid_outline_edge *e, const double x[2]);
double solid_outline_edge_distance(const struct solid_outline_edge *e, const double x[2]);
/* The other coordinate of the point of a piece whose coordinate c has the value. */
double solid_outline_edge_at(const struct solid_outline_edge *piece, int c, double value);
/* For a part of a piece: integral of (x - x0) dy; length. */
double solid_outline_edge_integral(const struct solid_outline_edge *piece, const double from[2], const double to[2],
                                   double x0);
double solid_outline_edge_length(const struct solid_outline_edge *piece, const double from[2], const double to[2]);
/* Points common to both edges, to the tolerance: crossings, touching ends, and at least one point of an overlap.
 * Returns how many. */
int solid_outline_meet(const struct solid_outline_edge *e, const struct solid_outline_edge *f, double tolerance,
                       double point[8][2]);

/* +1: the body is on the left of the outline, in the order of its corners; -1: on the right. */
int solid_outline_sense(const struct solid_outline *o);
/* 1: an odd number of the outlines encloses x. */
int solid_outline_parity(const struct solid_outline *outline, int n, const double x[2], double spacing);

/* The parts of a piece between lattice lines, in order. Only the lines low .. high of each direction count: all cells
 * beyond count as one, low - 1 or high. */
struct solid_outline_walk {
    const struct solid_outline_edge *piece; /* borrowed */
    int cell[2];                            /* cell of the present part */
    double from[2], to[2];                  /* ends of the present part */
    int low[2], high[2], step[2], next[2], is_done;
};

struct solid_outline_walk solid_outline_walk_begin(const struct solid_outline_edge *piece, const int low[2],
                                                   const int high[2]);
int solid_outline_walk_next(struct solid_outline_walk *w); /* 0: there is no further part */
