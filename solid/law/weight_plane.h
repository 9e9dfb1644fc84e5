/* Partial areas in a plate.  (000: eq. 22; 001: eq. 3.33, mended) */
#pragma once

/* The fraction of a square (with this side, centred at xi from the origin, sides along x and y) inside the disc of this
 * radius about the origin, in closed form. Symmetric under exchange and signs of xi to the bit. Not collective. */
double solid_weight_plane_fraction(const double xi[2], double side, double radius);
