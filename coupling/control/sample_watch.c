/* Warns of balances that close to round-off, if those that a row of series.csv has measured do not. */
#include "coupling/control/sample_watch.h"
#include "base/files/log.h"
#include "coupling/run.h"

#include <math.h>

/* Parts of what was exchanged from which on the log warns. Of a flow's divergence, of a crack's volume and of the
 * work in it a step makes little, so less of them counts: round-off leaves 1e-12, 1e-13 and 1e-15. Again when it is
 * AGAIN times as large. */
static const double WARN[SAMPLE_WATCHES] = {0.01, 0.01, 1e-5, 1e-4, 1e-5, 1e-4, 0.01}, AGAIN = 4;
/* The least change of the Courant number by a cell's divergence in a step that counts: round-off leaves 1e-14. */
static const double LEAST_COURANT = 1e-9;

/* The imbalance over what was exchanged if it is to be logged, else 0. */
static double part_to_log(struct run *r, int kind, double off, double exchanged) {
    double *logged = &r->watch.sample.logged[kind];
    if (!(off > WARN[kind] * exchanged)) return 0;
    const double part = exchanged > 0 ? off / exchanged : 1;
    if (part <= AGAIN * *logged) return 0;
    return *logged = part;
}

void sample_watch_momentum(struct run *r, double off, double exchanged) {
    const double part = part_to_log(r, SAMPLE_WATCH_MOMENTUM, off, exchanged);
    if (part > 0)
        log_line("warning: step %ld: the fluid's momentum is off by %.3g N, %.3g %% of the %.3g N that act on it: a "
                 "force is missing from the balance, or the balance has one that does not act",
                 r->step, off, 100 * part, exchanged);
}

void sample_watch_angular(struct run *r, double off, double exchanged) {
    const double part = part_to_log(r, SAMPLE_WATCH_ANGULAR, off, exchanged);
    if (part > 0)
        log_line("warning: step %ld: the fluid's angular momentum is off by %.3g N m, %.3g %% of the %.3g N m that act "
                 "on it: a couple is missing from the balance, or the balance has one that does not act",
                 r->step, off, 100 * part, exchanged);
}

void sample_watch_energy(struct run *r, double off, double dissipation) {
    const double part = part_to_log(r, SAMPLE_WATCH_ENERGY, fabs(off), dissipation);
    if (part > 0)
        log_line(
            "warning: step %ld: the flow's energy is off by %.3g W, %.3g %% of the %.3g W that viscosity takes: the "
            "time step is too long for its fastest eddies (stages[].cfl), or a term of the scheme is wrong",
            r->step, off, 100 * part, dissipation);
}

void sample_watch_divergence(struct run *r, double divergence, double rate) {
    if (!(r->dt * divergence > LEAST_COURANT)) return;
    const double part = part_to_log(r, SAMPLE_WATCH_DIVERGENCE, divergence, rate);
    if (part > 0)
        log_line("warning: step %ld: the flow's divergence is up to %.3g 1/s, %.3g %% of the %.3g 1/s of its fastest "
                 "cell: volume is not conserved",
                 r->step, divergence, 100 * part, rate);
}

void sample_watch_cracks(struct run *r, double off, double volume) {
    const double part = part_to_log(r, SAMPLE_WATCH_CRACKS, off, volume);
    if (part > 0)
        log_line("warning: step %ld: the volume of the fluid in cracks is off by %.3g m3, %.3g %% of %.3g m3: fluid is "
                 "created or lost",
                 r->step, off, 100 * part, volume);
}

void sample_watch_push(struct run *r, double on_solid, double on_fluid, double size) {
    const double part = part_to_log(r, SAMPLE_WATCH_PUSH, fabs(on_solid - on_fluid), size);
    if (part > 0)
        log_line(
            "warning: step %ld: the pressures in cracks do other work on the solid, %.3g J, than by the volume that "
            "they open, %.3g J: energy is not conserved",
            r->step, on_solid, on_fluid);
}

void sample_watch_leak(struct run *r, double leaked, double volume) {
    double *most = &r->watch.sample.leaked;
    *most = fmax(*most, leaked);
    const double part = part_to_log(r, SAMPLE_WATCH_LEAK, *most - leaked, volume);
    if (part > 0)
        log_line(
            "warning: step %ld: %.3g m3 of the fluid that has leaked off the cracks, %.3g %% of %.3g m3, have come "
            "back: leak-off only takes fluid",
            r->step, *most - leaked, 100 * part, volume);
}
