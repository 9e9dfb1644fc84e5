/* Depth of a lattice site below a body's surface, from the number of its neighbours that belong to the body.
 *
 * The sites within two spacings (32 and the site itself) have the weight w(r) = (5 - r^2)^2, r in spacings; r^2 = 5
 * is the first shell that is not counted. A half-space whose face is d above the site holds the fraction F(d) of the
 * integral of w over the ball,
 *
 *     F(d) = 1/2 + G(d) / (2 G(2)),   G(z) = z - z^3/5 + 3 z^5/125 - z^7/875 - z/125 .
 *
 * F = (weights present) / (all weights) is solved for d. A constant is added so that a site in a face along the lattice
 * has exactly 1/2. The result is limited to 0 .. 1, the depths that the outermost sites of a smooth body have.
 *
 * Error in spacings, for the outermost sites of planes of any direction, balls and cavities: standard deviation 0.10
 * (0.25 if every site is taken to be 1/2 deep), mean -0.02 - 0.6 H, H the mean curvature over spacings (1/a of a ball
 * of radius a, negative in a cavity). The part with H is wanted: a curved face needs its markers about 0.5 H deeper
 * (docs/retraction.md). A face of a wall two particles thick has 0.49; next to an edge 0.48 to 0.49; along a straight
 * edge 0.07 to 0.08 and at a corner 0, so edges are rounded. */
#pragma once

enum { PHYSICS_DEPTH_REACH2 = 4 }; /* r^2 of the farthest site counted */

/* Whole numbers, so that their sum does not depend on its order. */
int physics_depth_weight(int r2); /* of a site at the distance sqrt(r2) spacings; 0 beyond two spacings */
/* The depth in spacings; present: sum of the weights of the sites that belong to the body, itself included. */
double physics_depth(int present);
