/* Griffith's criterion of fracture under stress in all directions. */
#pragma once

/* The uniaxial tension that is as near to fracture as principal stresses p[0] >= p[1] >= p[2], tension positive: a
 * solid full of small flat cracks of all directions, with the strength T under one tension, breaks when it reaches T.
 *     3 p0 + p2 >= 0:  p0                       (a crack opens across the largest tension)
 *     else:            -(p0 - p2)^2/(8 (p0 + p2))   (a slanted crack opens at its rim, though compressed)
 * Under one pressure a solid bears 8 T.  (Griffith 1924) */
double physics_griffith_tension(const double p[3]);
