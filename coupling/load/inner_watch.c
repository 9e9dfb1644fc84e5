/* Compares what the inner fluid has given to particles and fluid with what its recursion says that it has. */
/* With the recursion of inner_fluid_set_loads each stage r of the fluid's step gives, summed over the steps, gamma_r (U
 * - U_start) and the change of `excess`, whatever the steps, the shares and the constants of the prediction are. So the
 * sum over particles and stages of rho V (gamma U + excess) changes by what particles and fluid have been given, but
 * for the body force. Particles that come into the domain, leave it or lose their last bond start again. */
#include "coupling/load/inner_watch.h"
#include "base/files/log.h"
#include "base/par.h"
#include "coupling/load/inner_fluid.h"
#include "coupling/run.h"

#include <math.h>
#include <string.h>

/* As in coupling/control/watch.c. */
static const double WARN = 0.01, AGAIN = 4;
/* The least impulse that counts as given, as a part of the sum of the magnitudes of what it is compared with. */
static const double LEAST = 1e-3;
/* Of the impulse of the fluid on the solid: a solid of particles without bonds carries no fluid inside, and is given
 * nothing but round-off. */
static const double ROUND_OFF = 1e-9;

enum { SIZES = 3, SUMS };

static void begin(const struct inner_fluid *k, struct run *r) {
    struct run_inner_watch *w = &r->watch.inner;
    double sum[SUMS];
    inner_fluid_momentum(k, r, sum);
    par_sum_array(sum, SUMS);
    *w = (struct run_inner_watch){.begun = 1, .carrying = inner_fluid_last_exchange(k)->carrying, .logged = w->logged};
    memcpy(w->first, sum, sizeof w->first);
}

void inner_watch_note(const struct inner_fluid *k, struct run *r) {
    struct run_inner_watch *w = &r->watch.inner;
    const struct inner_fluid_exchange *last = inner_fluid_last_exchange(k);
    if (!w->begun) {
        begin(k, r);
        return;
    }
    w->changed |= last->carrying != w->carrying;
    for (int c = 0; c < 3; c++) {
        w->impulse[c] += last->impulse[c];
        w->load += r->dt * fabs(r->load[c]);
    }
}

void inner_watch_check(const struct inner_fluid *k, struct run *r) {
    struct run_inner_watch *w = &r->watch.inner;
    double sum[SUMS], impulse[3], off = 0, exchanged;
    if (!w->begun) return;
    if (par_max(w->changed) > 0) {
        begin(k, r);
        return;
    }
    memcpy(impulse, w->impulse, sizeof impulse);
    par_sum_array(impulse, 3);
    inner_fluid_momentum(k, r, sum);
    par_sum_array(sum, SUMS);
    for (int c = 0; c < 3; c++) {
        w->largest_impulse = fmax(w->largest_impulse, fabs(impulse[c]));
        off = fmax(off, fabs(sum[c] - w->first[c] - impulse[c]));
    }
    exchanged = fmax(fmax(w->largest_impulse, LEAST * sum[SIZES]), ROUND_OFF * w->load);
    w->off = exchanged > 0 ? off / exchanged : 0;
    if (!(w->off > WARN) || w->off <= AGAIN * w->logged) return;
    w->logged = w->off;
    log_line("warning: step %ld: the fluid inside the solid has given back %.3g N s more or less than its momentum "
             "changed by, %.3g %% of the %.3g N s exchanged",
             r->step, off, 100 * w->off, exchanged);
}
