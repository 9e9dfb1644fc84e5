/* Compares the load by probes with the force that the forcing takes from the fluid. */
#include "coupling/control/probe_watch.h"
#include "base/files/log.h"
#include "base/par.h"
#include "coupling/interface/displaced.h"
#include "coupling/run.h"

#include <math.h>
#include <string.h>

/* WARN: of the force. AGAIN: as in coupling/control/watch.c. LEAST: the least force that counts, as a part of the sum
 * of the magnitudes of the particles' loads; pressures that balance each other leave less. ROUND_OFF: of the momentum
 * of the displaced fluid, in a step: bodies that move along with the fluid. */
static const double WARN = 0.05, AGAIN = 2, LEAST = 0.01, ROUND_OFF = 1e-9;

static void begin(struct run *r) {
    struct probe_watch *w = &r->watch.probes;
    const struct displaced d = displaced_by_solid(r);
    *w = (struct probe_watch){
        .begun = 1, .since = r->t, .missing = w->missing, .logged = r->stage_step > 1 ? w->logged : 0};
    memcpy(w->first, d.momentum, sizeof w->first);
}

void probe_watch_note(struct run *r) {
    struct probe_watch *w = &r->watch.probes;
    double force[3];
    if (!r->needs.immersed || !r->load_kind->has_probes || r->moved != r->step) return;
    if (!w->begun || r->stage_step == 1) { /* the first step of a stage may stop the fluid inside bodies at once */
        begin(r);
        return;
    }
    ibm_forcing_share(r->ibm, force);
    for (int c = 0; c < 3; c++) {
        w->loads[c] += r->dt * r->load[c];
        w->forcing[c] += r->dt * force[c];
    }
}

static double norm(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/* least: the least force that counts, N. */
static void warn_of_missing(struct run *r, const double load[3], const double force[3], double least, int stage_ends) {
    struct probe_watch *w = &r->watch.probes;
    const double off[3] = {force[0] - load[0], force[1] - load[1], force[2] - load[2]};
    if (!(norm(force) > least)) return;
    w->missing = norm(off) / norm(force);
    if (!(w->missing > WARN) || (w->missing <= AGAIN * w->logged && !stage_ends)) return;
    w->logged = w->missing;
    log_line("warning: step %ld: the loads by probes add up to %.3g N, where the fluid acts on the solid with %.3g N; "
             "the difference is %.3g %% of it. The probes read the stress at their tips, not at the wall; "
             "coupling.load: reaction has the whole force",
             r->step, norm(load), norm(force), 100 * w->missing);
}

/* The sum of the magnitudes of the loads of this rank, N. */
static double sizes_of(const struct solid *s) {
    double sum = 0;
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) sum += fabs(s->load[c][h]) * s->volume[h];
    return sum;
}

enum { MASS = 3, SIZES = 4, SUMS = 5 };

void probe_watch_check(struct run *r, int stage_ends) {
    struct probe_watch *w = &r->watch.probes;
    const int moves = r->moved == r->step;
    double now[SUMS] = {0}, given[3] = {0}, force[3], load[3];
    if (!r->needs.immersed || !r->load_kind->has_probes) return;
    if (moves ? !w->begun || !(r->t > w->since) : !stage_ends) return;
    const double passed = moves ? r->t - w->since : 1;
    const struct displaced d = displaced_by_solid(r);
    memcpy(now, d.momentum, sizeof d.momentum);
    now[MASS] = d.mass;
    if (moves) {
        for (int c = 0; c < 3; c++) given[c] = now[c] - w->first[c] - w->forcing[c];
        for (int c = 0; c < 3; c++) load[c] = w->loads[c] / passed;
    } else {
        r->load_kind->sample(r);
        memcpy(load, r->load, sizeof load);
        ibm_forcing_share(r->ibm, force);
        for (int c = 0; c < 3; c++) given[c] = -force[c];
    }
    now[SIZES] = sizes_of(r->solid);
    par_sum_array(now, SUMS);
    par_sum_array(given, 3);
    for (int c = 0; c < 3; c++) force[c] = given[c] / passed - now[MASS] * fluid_input_of(r->fluid)->body_force[c];
    warn_of_missing(r, load, force, LEAST * now[SIZES] + ROUND_OFF * norm(now) / r->dt, stage_ends);
    if (moves) begin(r);
}
