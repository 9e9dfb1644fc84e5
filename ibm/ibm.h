/* Immersed boundary: multidirect forcing at markers, and the normal probe.  (001: sec. 3.5; Breugem 2012) */
#pragma once
#include "fluid/fluid.h"
#include <stdint.h>

/* Roma, Peskin and Berger (1999): three cells wide.  (001: eq. 3.79) */
double ibm_kernel(double t);

struct ibm; /* opaque: markers served here, their weights, the exchange */

/* iterations: N_s. Arrays are allocated when the first markers arrive. Collective. */
struct ibm *ibm_new(struct fluid *f, int iterations);
void ibm_free(struct ibm *b);

/* The markers of this time step, each rank its own: position (wrapped where periodic; one outside the domain is left
 * out), velocity, and volume A_h dx (m3). Weights are kept when no marker has moved since the last call. Collective. */
void ibm_markers_set(struct ibm *b, int n, const double *const x[3], const double *const v[3], const double *volume);

/* With implicit diffusion, in the place of ibm_forcing_stage: first what the markers forced at the last stage's end is
 * given to the predicted velocity, to diffuse with it; then, once it has diffused, what that lacks (ibm/implicit.c).
 * Collective. */
void ibm_implicit_force_again(struct ibm *b, int r, double dt);
void ibm_implicit_force(struct ibm *b, int r, double dt);
/* What that goes on from, by marker in the order of ibm_markers_set, m/s2 (0 for what is no number); and set, from a
 * checkpoint. [n] each. Collective. */
int ibm_demand_is_set(const struct ibm *b); /* Some rank has had some. Not collective. */
void ibm_demand(struct ibm *b, double *const demand[3]);
void ibm_demand_set(struct ibm *b, const double *const demand[3]);
/* Multidirect forcing of the fluid's predicted velocity at RK stage r; dt_r = gamma_r dt. Collective. */
void ibm_forcing_stage(struct ibm *b, int r, double dt);
/* Mean over the last step's stages (weights gamma_r, which sum to one) of the force that the forcing put on the fluid,
 * N. Collective. */
void ibm_forcing_total(struct ibm *b, double force[3]);
/* The same by marker, in the order of ibm_markers_set, N: [n] each, zero for a marker outside the domain. What falls
 * beside the domain is counted. Collective. */
void ibm_forcing_by_marker(struct ibm *b, double dt, double *const force[3]);
double
ibm_forcing_slip(struct ibm *b); /* root mean square of V_h - U_h after the last stage's forcing, m/s. Collective. */

/* The root's pressure gradient is rho (f - dV_h/dt).n, f the fluid's body force and driving; pressures and tractions
 * include the linear part of a driving pressure gradient, -G x (x as given, not wrapped), so that it pushes on a body
 * as on the fluid. Tractions at n points with outward unit normals, from the fluid's state, whose ghosts are refreshed
 * here as far as the tips read them. acceleration_n [n]: dV_h/dt . n at the root, m/s2, may be NULL (at rest). A point
 * whose tip lies outside the domain gets 0 and active[i] = 0. Collective.  (001: eqs 3.83-3.95, signs as in SPEC 4)
 * Given the wall's velocity, pressure and stress are carried from the tip to the wall in second order (ibm/probe.c);
 * without it the tip's stress stands for the wall's, and the pressure is that of a boundary layer. */
struct ibm_probe_input {
    int n;
    const double *x[3], *normal[3]; /* [n] root m on the interface, outward unit normal */
    const double *acceleration_n;   /* [n] */
    const double *velocity[3];      /* [n] of the wall at the root, m/s; or NULL */
    int is_carried;                 /* who calls has -rho dV_h/dt.n in his own equation of motion: left out here */
    double length;                  /* probe length / dx, default 2 */
};
void ibm_probe(struct ibm *b, const struct ibm_probe_input *in, double *const traction[3], double *pressure,
               uint8_t *active);
