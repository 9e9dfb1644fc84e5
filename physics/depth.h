/* Depth of a lattice site below a body's surface, from the number of its neighbours that belong to the body.
 *
 * The sites with r^2 <= R^2, r in spacings, have the weight w(r) = (b - r^2)^2, b = R^2 + 1: R = 2, 32 neighbours, or
 * less where a family does not reach so far. A half-space whose face is d above the site holds the fraction F(d) of the
 * integral of w over the ball,
 *
 *     F(d) = 1/2 + G(d) / (2 G(R)),   G(z) = z - z^3/b + 3 z^5/(5 b^2) - z^7/(7 b^3) - z/b^3 .
 *
 * F = (weights present) / (all weights) is solved for d. A constant is added so that a site in a face along the lattice
 * has exactly 1/2. The result is limited to 0 .. 1, the depths that the outermost sites of a smooth body have.
 *
 * Error in spacings for R = 2, for the outermost sites of planes of any direction, balls and cavities: standard
 * deviation 0.10 (0.25 if every site is taken to be 1/2 deep), mean -0.02 - 0.6 H, H the mean curvature over spacings
 * (1/a of a ball of radius a, negative in a cavity). The part with H is wanted: a curved face needs its markers about
 * 0.5 H deeper (docs/retraction.md). R^2 = 3: 0.11, -0.03 - 0.5 H; R^2 = 2: 0.13, -0.06 - 0.35 H. With R = 2 a face of
 * a wall two particles thick has 0.49; next to an edge 0.48 to 0.49; along a straight edge 0.07 to 0.08 and at a corner
 * 0, so edges are rounded. */
#pragma once

enum { PHYSICS_DEPTH_REACH2 = 4 }; /* R^2 where the family reaches as far */

/* Whole numbers, so that their sum does not depend on its order. reach2: R^2, 2 to 4. */
int physics_depth_weight(int r2, int reach2); /* of a site at the distance sqrt(r2) spacings */
/* The depth in spacings; present: sum of the weights of the sites that belong to the body, itself included. */
double physics_depth(int present, int reach2);
