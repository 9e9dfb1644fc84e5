/* Forcing with feedback, in the place of ibm_forcing_stage: its slip does not depend on the step. (ibm/feedback.c;
 * Goldstein et al. 1993) */
#pragma once
#include "ibm/ibm.h"

/* Turns it on, before the first markers. slip_time, s: slip of a steady flow over the force, m/s over m/s2, that is
 * over the force on the fluid per mass of a marker's volume. Explicit diffusion only. */
void ibm_feedback_set(struct ibm *ibm, double slip_time);
/* w of stage r: fraction of the slip that is taken away directly. */
double ibm_feedback_weight(const struct ibm *ibm, int r, double dt);

/* A stage with the velocities that the markers were set with is
 *     fluid_predict; ibm_feedback_begin; ibm_feedback_end; fluid_project
 * and with velocities that follow from the force in the same stage
 *     fluid_predict; ibm_feedback_begin; ibm_feedback_velocity; [the solid] ibm_feedback_apply_slip; fluid_project.
 * begin adds the kept force and reads the fluid's velocity U; end and in add the rest and renew the kept force.
 * Collective. */
void ibm_feedback_begin(struct ibm *ibm, int r, double dt);
void ibm_feedback_end(struct ibm *ibm, int r, double dt);
/* Markers in the order of ibm_markers_set. The fluid takes density * volume * (g f + w slip) from a marker, kg m/s.
 * U [n], m/s, of the stage that has begun; 0 for a marker outside the domain. Collective.
 * f [n], m/s2, as it was when the markers were set: valid until the next call of ibm_markers_set. Not collective.
 * Whether marker i is in the domain, so that the fluid takes anything. Not collective. */
void ibm_feedback_velocity(struct ibm *ibm, double (*velocity)[3]);
const double (*ibm_feedback_force(const struct ibm *ibm))[3];
int ibm_feedback_is_in_domain(const struct ibm *ibm, int i);
/* slip [n][3]: mean of V - U over the stage, m/s. */
void ibm_feedback_apply_slip(struct ibm *ibm, int r, double dt, const double (*slip)[3]);
/* Power that the slip dissipates at walls at rest: the sum over the markers of the last step's force times the slip
 * after it, W. The work of the walls on the markers less this is the forcing's work on the fluid. dt: of that step. Of
 * walls that move in the step: ibm/feedback_work.h. Collective. */
double ibm_feedback_slip_loss(struct ibm *ibm, double dt);
