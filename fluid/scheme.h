/* The schemes of the fluid's time step. Stage r of a step of length dt is
 *
 *     u* = u + dt (alpha_r R + beta_r R_old - gamma_r grad pi/rho + gamma_r (g + G/rho))
 *
 * with gamma_r = alpha_r + beta_r, and R_old of the stage before. RK3 has three stages (001: eqs 3.70-3.73; Wesseling
 * 2001). AB2, the second-order scheme of Adams and Bashforth, has one, so a step takes one momentum pass, one forcing
 * and one pressure solve; its R_old is that of the step before, of length dt_old:
 *
 *     alpha = 1 + w/2 ,  beta = -w/2 ,  w = dt/dt_old ;      without a step before alpha = 1, beta = 0 (Euler)
 *
 * On the normal faces of open sides AB2 takes alpha = 1, beta = 0 throughout, because R of a low side's faces lies
 * among the ghosts, which are not part of the state. */
#pragma once
#include "fluid/fluid.h"

/* Whether a step reads R of the step before: it is part of the state then (fluid_input.keeps_rate). */
int fluid_scheme_is_multistep(enum fluid_integrator integrator);
/* The scheme of the next steps. AB2 needs fluid_input.keeps_rate and explicit diffusion. Not collective. */
void fluid_scheme_set(struct fluid *f, enum fluid_integrator integrator);
int fluid_scheme_stages(const struct fluid *f);
/* The part of a step over which stage r goes, and the largest of them. */
double fluid_scheme_gamma(const struct fluid *f, int r);
double fluid_scheme_gamma_max(const struct fluid *f);
