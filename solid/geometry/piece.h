/* Smooth pieces of the surface of a shape that a body was cut from, and of its cavities (solid/geometry/shape.h). */
#pragma once
#include "solid/state.h"

enum { SOLID_PIECES_MAX = 4, SOLID_PIECE_ALL = 7 };

struct solid_piece {
    /* depth of x below the piece, m, > 0 in the material, and the piece's unit normal out of it there */
    double (*depth)(const struct solid_piece *piece, const double x[3], double normal[3]);
    /* the same, or a number of the same sign that is nearer to 0 and takes less time; NULL: depth takes little time */
    double (*least)(const struct solid_piece *piece, const double x[3]);
    /* mean of the two principal curvatures where the normal is n, 1/m, > 0 where the material bulges */
    double (*curvature)(const struct solid_piece *piece, const double n[3]);
    int mask[3];
    int inside;               /* +1: the material is inside the radius, -1: outside */
    double centre[3], radius; /* m */
    double radii[3];          /* of an ellipsoid, m */
    /* directions of the mask and the radii: NULL: x, y, z, else the edges; borrowed from the body */
    const struct solid_turn *turn;
};

/* The points whose distance from centre is radius, in the directions of the mask alone (bit c: direction c). Three
 * directions: a ball or a cavity; two: the side of a cylinder; one: a pair of planes. Not collective. */
struct solid_piece solid_piece_round(int mask, int inside, const double centre[3], double radius);
/* Turns a piece of an unturned body with the body. */
void solid_piece_turn(struct solid_piece *piece, const struct solid_turn *turn);
