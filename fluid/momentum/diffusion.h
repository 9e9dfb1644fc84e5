/* Implicit viscous term of a stage, for steps far beyond the viscous limit.
 *
 * With R = -div(uu) alone in the explicit part, a stage is
 *     (I - b_r dt nu lap)(u* - u) = dt (alpha R + beta R_old + gamma (nu lap u - grad p/rho + source + force)) ,
 * one Helmholtz equation a component, solved by the transforms of the Poisson solver. The unknown is the change u* - u,
 * which is zero on the sides, except the normal velocity on an outflow: its change is on the right-hand side. */
#pragma once
#include "fluid/fluid.h"

/* nu dt/d^2 of an automatic time step. */
#define FLUID_DIFFUSION_NUMBER 1000.0

struct fluid_diffusion; /* opaque: a solver a component, scratch */

/* Dies (exit 2) if the normal velocity of a side is free. Collective. */
struct fluid_diffusion *fluid_diffusion_new(const struct fluid *f);
void fluid_diffusion_free(struct fluid_diffusion *d);

/* b_r dt nu, m2. */
double fluid_diffusion_length2(const struct fluid *f, int r, double dt);
/* The longest step with an accurate transient to a steady state, s. */
double fluid_diffusion_step(const struct fluid *f);

/* Plane k: rhs = -shift (predicted - q + explicit lap q), 1/(m s) for shift in 1/m2; zero on faces that are not
 * advanced. Pure.
 *     predicted, q   faces of one component, m/s; one ghost layer of q read
 *     weight [3]     gamma dt nu/d^2 along each direction
 *     faces [3]      number of advanced faces, from index 0
 *     rhs            [m_y][m_x] without padding, written */
void fluid_diffusion_plane(const struct fluid_grid *g, int k, double shift, const double weight[3], const int faces[3],
                           const double *predicted, const double *q, double *rhs);
