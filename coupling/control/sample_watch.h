/* Watches what a row of series.csv has measured and what is exact: the balances of the fluid's momentum and angular
 * momentum over the step, its divergence, and the volume of the fluid in cracks. They close to round-off. */
#pragma once

struct run;

enum { SAMPLE_WATCH_MOMENTUM, SAMPLE_WATCH_ANGULAR, SAMPLE_WATCH_DIVERGENCE, SAMPLE_WATCH_CRACKS, SAMPLE_WATCHES };

struct sample_watch {
    double logged[SAMPLE_WATCHES]; /* the last off over exchanged that the log has since the stage began */
};

/* The log warns of an `off` of more than 1 % of what was exchanged, less for the last two, and again when it is four
 * times as large. The numbers are the same on all ranks.
 * Mean force on the fluid in the last step that changed its momentum and that neither sides, sources nor the forcing
 * account for, N; and the same of couples, N m. NaN: not known. */
void sample_watch_momentum(struct run *r, double off, double exchanged);
void sample_watch_angular(struct run *r, double off, double exchanged);
/* Largest divergence and largest rate of convection, 1/s. */
void sample_watch_divergence(struct run *r, double divergence, double rate);
/* Volume of the fluid in cracks that no one has given or that is nowhere, and the largest volume that it consists of,
 * m3. */
void sample_watch_cracks(struct run *r, double off, double volume);
