/* Coefficients of the low-storage Runge-Kutta scheme of third order.  (001: eqs 3.47-3.48, 3.70; Wesseling 2001) */
#include "physics/rk3.h"

const double physics_rk3_alpha[3] = {8.0 / 15, 5.0 / 12, 3.0 / 4};
const double physics_rk3_beta[3] = {0, -17.0 / 60, -5.0 / 12};
const double physics_rk3_gamma[3] = {8.0 / 15, 2.0 / 15, 1.0 / 3};
