/* Where a crack goes on to under mixed mode: along the largest hoop stress.  (Erdogan and Sih 1963) */
#pragma once

/* Angle from straight ahead to the crack's next part, counterclockwise, in radians. */
double physics_kink_angle(const double k[2]);
/* K of the hoop stress in that direction, sigma_tt sqrt(2 pi r): the crack grows where it reaches the toughness. */
double physics_kink_equivalent(const double k[2]);
