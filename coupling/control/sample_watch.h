/* Watches what a row of series.csv has measured and what is exact: the balances of the fluid's momentum and angular
 * momentum over the step, its divergence, the volume of the fluid in cracks and the work of its pressures. They close
 * to round-off. */
#pragma once

struct run;

enum {
    SAMPLE_WATCH_MOMENTUM,
    SAMPLE_WATCH_ANGULAR,
    SAMPLE_WATCH_DIVERGENCE,
    SAMPLE_WATCH_CRACKS,
    SAMPLE_WATCH_PUSH,
    SAMPLE_WATCH_LEAK,
    SAMPLE_WATCH_ENERGY,
    SAMPLE_WATCHES
};

struct sample_watch {
    double logged[SAMPLE_WATCHES]; /* the last off over exchanged that the log has since the stage began */
    double leaked;                 /* the largest so far, m3 */
};

/* The log warns of an `off` of more than 1 % of what was exchanged, less of divergence and of cracks, and again when it
 * is four times as large. The numbers are the same on all ranks. Mean force on the fluid in the last step that changed
 * its momentum and that neither sides, sources nor the forcing account for, N; and the same of couples, N m. NaN: not
 * known. */
void sample_watch_momentum(struct run *r, double off, double exchanged);
void sample_watch_angular(struct run *r, double off, double exchanged);
/* Largest divergence and largest rate of convection, 1/s. */
void sample_watch_divergence(struct run *r, double divergence, double rate);
/* Volume of the fluid in cracks that no one has given or that is nowhere, and the largest volume that it consists of,
 * m3. */
void sample_watch_cracks(struct run *r, double off, double volume);
/* The sums over wet particles of the pressures' forces times displacements, and of the pressures times the volumes that
 * these displacements open; the sum of their sizes, J. */
void sample_watch_push(struct run *r, double on_solid, double on_fluid, double size);
/* Power by which the kinetic energy of a flow without bodies grows and that neither viscosity nor a source accounts
 * for; what viscosity takes, W. */
void sample_watch_energy(struct run *r, double off, double dissipation);
/* Volume that has leaked off so far, which only grows, and the largest volume in cracks, m3. */
void sample_watch_leak(struct run *r, double leaked, double volume);
