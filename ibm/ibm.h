/* Immersed boundary: multidirect forcing at markers, and the normal probe.  (001: sec. 3.5; Breugem 2012) */
#pragma once
#include "fluid/fluid.h"
#include <stdint.h>

/* Roma, Peskin and Berger (1999): three cells wide, IBM_KERNEL_REACH to either side.  (001: eq. 3.78) */
#define IBM_KERNEL_REACH 1.5
double ibm_kernel(double t);

struct ibm; /* opaque: markers served here, their weights, the exchange */

/* iterations: N_s. Arrays are allocated when the first markers arrive. Collective. */
struct ibm *ibm_new(struct fluid *f, int iterations);
void ibm_free(struct ibm *ibm);

/* Sets the markers of this time step, each rank its own: position (wrapped in periodic directions; a marker outside the
 * domain is left out), velocity, and volume A_h dx (m3). The weights are kept if no marker has moved since the last
 * call. Collective. */
void ibm_markers_set(struct ibm *ibm, int n, const double *const x[3], const double *const v[3], const double *volume);
/* The next call sorts the markers, as the first one does: the order decides how sums in a cell are rounded, and else
 * depends on the steps before. Not collective, on all ranks. */
void ibm_markers_sort_again(struct ibm *ibm);

/* The fraction p of the kernel along direction d at x, m, that is within the domain: 1, less what belongs to faces
 * whose normal velocity a side gives, and beyond them. These are neither read nor written (ibm/edge.c). So a body's
 * marker has p times its velocity along d, and the body gets p times its force. Not collective. */
double ibm_markers_fraction(const struct ibm *ibm, int d, double x);

/* From now on the driving and the body force along direction c act only on the part of a cell that is not solid. For a
 * body at rest. part[c]  as fluid/grid/grid.h, centres, one ghost layer, 1, borrowed  the solid part; NULL: they act on
 * all of it. Not collective. */
void ibm_inside_undriven(struct ibm *ibm, const double *const part[3]);

/* Begin to count what the fluid inside the bodies is given in a step; count what it was given in a stage: sum, m/s
 * times cells, of this rank (ibm_transfer_spread). Not collective. */
void ibm_inside_begin(struct ibm *ibm);
void ibm_inside_count(struct ibm *ibm, double dt, const double sum[3]);
/* The part of ibm_forcing_share that is taken or counted so, N. Not collective. */
void ibm_inside_share(const struct ibm *ibm, double force[3]);

/* With implicit diffusion these replace ibm_forcing_stage. First the force of the last stage's end is added to the
 * predicted velocity, and diffuses with it; after the diffusion the rest of the force is added (ibm/implicit.c).
 * slip_time, s: as of ibm_feedback_set, set before the first stage. Collective. */
void ibm_implicit_set(struct ibm *ibm, double slip_time);
void ibm_implicit_force_again(struct ibm *ibm, int r, double dt);
void ibm_implicit_force(struct ibm *ibm, int r, double dt);
/* The force that each marker keeps from step to step: with feedback and with implicit diffusion, for which it is the
 * first guess of its iteration. One vector per marker in the order of ibm_markers_set, m/s2 (0 for NaN); and
 * its setting from a checkpoint. [n] each. Collective. */
int ibm_marker_force_is_kept(const struct ibm *ibm); /* 1: the forcing keeps one. Not collective. */
int ibm_marker_force_is_set(const struct ibm *ibm);  /* 1: some rank has markers. Not collective. */
void ibm_marker_force_get(struct ibm *ibm, double *const force[3]);
void ibm_marker_force_set(struct ibm *ibm, const double *const force[3]);
/* The forces of the n markers that the next call of ibm_markers_set gets, [n] each. Not collective. */
void ibm_marker_force_set_next(struct ibm *ibm, int n, const double *const force[3]);
/* Multidirect forcing of the fluid's predicted velocity at RK stage r; dt_r = gamma_r dt. Collective. */
void ibm_forcing_stage(struct ibm *ibm, int r, double dt);
/* Mean over the last step's stages (weights gamma_r, which sum to one) of the force that the forcing put on the fluid,
 * N. Collective. */
void ibm_forcing_total(struct ibm *ibm, double force[3]);
/* This rank's share of it. Not collective. */
void ibm_forcing_share(const struct ibm *ibm, double force[3]);
/* Work of the markers' force on the fluid in the last step, at the velocities that the markers were given, J; this
 * rank's share. Not collective. */
double ibm_forcing_work(const struct ibm *ibm);
/* The couple of the markers' force about the domain's centre, N m, of the faces that it acts on: without what is taken
 * from the fluid inside a body (ibm_inside_undriven) or counted by ibm_inside_count. Collective. */
void ibm_couple_forcing(struct ibm *ibm, double dt, double couple[3]);
/* The same by marker, in the order of ibm_markers_set, N: [n] each, zero for a marker outside the domain. The part of
 * the force that is not spread, beyond the domain's sides, counts as well. Collective. */
void ibm_forcing_by_marker(struct ibm *ibm, double dt, double *const force[3]);
/* U of field u on the faces at all markers, in the order of ibm_markers_set [n], m/s; 0 for a marker outside the
 * domain. No ghost is read. Collective. */
void ibm_transfer_sample(struct ibm *ibm, double *const u[3], double (*out)[3]);
/* In stage r of a step u on the faces += the markers' volumes times value, spread over the kernel: value [n][3], m/s,
 * in the order of ibm_markers_set. The sum over the stages is kept for ibm_couple_forcing. What belongs beyond the
 * domain's sides is left out. sum <- what u has got, m/s times cells, of the markers that this rank counts; whole <-
 * the same with what was left out. No ghost is written. Collective. */
void ibm_transfer_spread(struct ibm *ibm, int r, double *const u[3], const double (*value)[3], double sum[3],
                         double whole[3]);
double
ibm_forcing_slip(struct ibm *ibm); /* root mean square of V_h - U_h after the last stage's forcing, m/s. Collective. */

/* Tractions at n points with outward unit normals, from the fluid's state. Refreshes the state's ghosts that the tips
 * read. The pressure gradient at the root is rho (f - dV_h/dt).n, with f the fluid's body force and driving. Pressures
 * and tractions include the linear part of a driving pressure gradient, -G x (x as given, not wrapped), so that it acts
 * on a body as on the fluid. acceleration_n [n]: dV_h/dt . n at the root, m/s2; may be NULL (at rest). A point whose
 * tip lies outside the domain gets 0 and active[i] = 0. Collective.  (001: eqs 3.83-3.95; 3.85, 3.87, 3.93
 * mended)
 * With the wall's velocity given, pressure and stress are extrapolated from the tip to the wall in second order
 * (ibm/probe.c). Without it the stress at the tip is used for the wall's, and the pressure gradient is that of a
 * boundary layer. */
struct ibm_probe_input {
    int n;
    const double *x[3], *normal[3]; /* [n] root m on the interface, m; outward unit normal */
    const double *acceleration_n;   /* [n] */
    const double *velocity[3];      /* [n] of the wall at the root, m/s; or NULL */
    int is_carried;                 /* 1: the caller's equation of motion contains -rho dV_h/dt.n, so it is left out
                                     * here */
    double length;                  /* probe length / dx, default 2 */
};
void ibm_probe(struct ibm *ibm, const struct ibm_probe_input *in, double *const traction[3], double *pressure,
               uint8_t *active);
