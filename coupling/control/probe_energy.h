/* Watches the energy that the coupling by probes makes: the forcing on the fluid and the loads on the solid act between
 * both, so what one gets the other loses. The loads are read at the probes' tips when the step begins, so they differ
 * from the force of the forcing: where they miss a part of it, and much more where bonds vibrate that nothing damps.
 *
 * The solid gets the work of the loads. The fluid outside gets that of the markers' force, less what the fluid inside
 * the bodies, which moves as they do, has taken of it:
 *
 *     sum F.V - d/dt (rho/2 sum V v^2) + (rho b sum V + T).v ,
 *
 * with b the fluid's body force, and T what the forcing takes of it inside (ibm_inside_undriven). */
#pragma once

struct run;
struct step_status;

struct probe_energy {
    int begun;
    double kinetic;        /* of the displaced fluid at the start, this rank's share, J */
    double momentum[3];    /* of the displaced fluid after the last step, this rank's share, N s */
    double forcing, loads; /* works since the start, of this rank, J */
    double inside;         /* work of b and T since the start, J */
    double exchanged;      /* sum of the sizes of the works of the loads in each window, J */
    double fluid, solid;   /* at the last check: what they have got since the start, J */
    long step;             /* of the last check, or of the start */
    double rate;           /* of what was made then, J a step */
};

/* After an accepted step in which the solid has moved. Does nothing but with loads by probes. Collective. */
void probe_energy_note(struct run *r);
/* Every so many steps, and at the end of a stage, after watch_check. Returns 1, and sets status, if more energy has
 * been made than there is: the run is to end. Collective. */
int probe_energy_check(struct run *r, struct step_status *status);
