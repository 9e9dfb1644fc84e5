/* Coefficients of the low-storage Runge-Kutta scheme of third order.  (001: eqs 3.47-3.48, 3.70; Wesseling 2001)
 *     stage r:  q += dt (alpha[r] R + beta[r] R_old),   over gamma[r] dt = (alpha[r] + beta[r]) dt of time */
#pragma once

extern const double physics_rk3_alpha[3], physics_rk3_beta[3], physics_rk3_gamma[3];
