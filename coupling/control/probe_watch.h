/* Watches the load by probes: compares it with the force that the forcing takes from the fluid.
 *
 * The probes read the stress at their tips, so they miss a part of the load wherever this differs from the stress at
 * the wall. What the fluid loses is exact: the force on the solid is
 *
 *     -F + rho d/dt (sum V v) - rho b sum V ,
 *
 * with F the force of the forcing on the fluid, and rho, V, v and b the fluid's density, the volume and the velocity of
 * the particles in the domain, and the fluid's body force: the forcing also drives the fluid inside the bodies. */
#pragma once

struct run;

struct probe_watch {
    int begun;
    double since;                /* when, s */
    double first[3];             /* rho sum V v of this rank then, N s */
    double loads[3], forcing[3]; /* impulses since then: of the loads; of the forcing, this rank's share, N s */
    double missing;              /* at the last check: difference of load and force, over the force */
    double logged;               /* the last one that the log has of this stage */
};

/* After an accepted step in which the solid has moved. Does nothing but with loads by probes. Not collective. */
void probe_watch_note(struct run *r);
/* Every so many steps, and at the end of a stage: the log warns where the load differs by more than 5 % of the force,
 * by means since the last check; of a solid at rest by a sample, at the end of its stage. Collective. */
void probe_watch_check(struct run *r, int stage_ends);
