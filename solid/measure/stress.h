/* Stress and strain tensors of particles. */
#pragma once
#include "solid/state.h"

/* Bond-force flux stress and least-squares strain, each [n][6] as xx yy zz xy yz zx; Pa and 1. A plate has no yz and
 * zx; its zz follows from the plane model: sigma_zz = nu (sigma_xx + sigma_yy) in plane strain, with nu = 1/4, and in
 * plane stress eps_zz = -nu/(1 - nu) (eps_xx + eps_yy), with nu = 1/3 (small strain). Not collective. */
void solid_stress_measure(const struct solid *s, double (*stress)[6]);
void solid_stress_strain(const struct solid *s, double (*strain)[6]);
