/* Adds up the works of the forcing and of the loads by probes. */
#include "coupling/control/probe_energy.h"
#include "base/par.h"
#include "base/step_status.h"
#include "coupling/interface/displaced.h"
#include "coupling/run.h"

#include <math.h>
#include <string.h>

/* What is made ends the run if it is more than so many times what the loads have exchanged, what the solid has, and the
 * fluid's kinetic energy. Loads that miss a part m of a force make m/(1 - m) times what they exchange, on bodies of few
 * cells too; vibrations that grow have made 4 to 30 times, and soon more than there is. */
static const double OF_LOADS = 3, OF_SOLID = 4, OF_FLUID = 1;

/* And if it grows: no less a step than in the window before, and at least by this part in the last window. A flow that
 * starts at once makes 3.1 times what the loads on a wall exchange, and then ever less. */
static const double GROWS = 0.05;

/* The motion of particles that are driven is given: loads on them that miss a part do no harm. */
static int is_driven(const struct solid *s) {
    for (int k = 0; k < s->in.constraints; k++)
        for (int c = 0; c < 3; c++)
            if (s->in.constraint[k].velocity[c] != 0 || s->in.constraint[k].has_displacement) return 1;
    return 0;
}

static int is_watched(const struct run *r) {
    return r->needs.immersed && r->load_kind->set_work && r->watch.begun && r->moved == r->step && !is_driven(r->solid);
}

static void begin(struct run *r) {
    const struct displaced d = displaced_by_solid(r);
    struct probe_energy *e = &r->watch.made;
    *e = (struct probe_energy){.begun = 1, .kinetic = d.kinetic, .step = r->step};
    memcpy(e->momentum, d.momentum, sizeof e->momentum);
}

/* Work of b and T in the last step: the displaced fluid's mean momentum times b; T times its mean velocity. */
static double inside(struct run *r) {
    struct probe_energy *e = &r->watch.made;
    const double *b = fluid_input_of(r->fluid)->body_force;
    enum { MASS = 3, TAKEN, SUMS = TAKEN + 3 };
    const struct displaced d = displaced_by_solid(r);
    double sum[SUMS] = {[MASS] = d.mass}, work = 0;
    ibm_inside_share(r->ibm, sum + TAKEN);
    for (int c = 0; c < 3; c++) sum[c] = 0.5 * (e->momentum[c] + d.momentum[c]);
    memcpy(e->momentum, d.momentum, sizeof e->momentum);
    par_sum_array(sum, SUMS);
    for (int c = 0; c < 3 && sum[MASS] > 0; c++) work += r->dt * sum[c] * (b[c] + sum[TAKEN + c] / sum[MASS]);
    return work;
}

static int has_source(const struct fluid_input *in) {
    const double *b = in->body_force;
    return in->driving.type != FLUID_DRIVING_NONE || b[0] != 0 || b[1] != 0 || b[2] != 0;
}

void probe_energy_note(struct run *r) {
    struct probe_energy *e = &r->watch.made;
    if (!is_watched(r)) return;
    if (!e->begun || r->stage_step == 1) { /* the first step of a stage may stop the fluid inside bodies at once */
        begin(r);
        return;
    }
    e->forcing += ibm_forcing_work(r->ibm);
    e->loads += r->probes.work;
    if (has_source(fluid_input_of(r->fluid))) e->inside += inside(r);
}

static void take(struct run *r) {
    struct probe_energy *e = &r->watch.made;
    double sum[] = {e->forcing - displaced_by_solid(r).kinetic + e->kinetic, e->loads};
    par_sum_array(sum, 2);
    e->exchanged += fabs(sum[1] - e->solid);
    e->fluid = sum[0] + e->inside;
    e->solid = sum[1];
}

/* Whether what is made, J, grows; before: at the last check. */
static int grows(struct probe_energy *e, long step, double before, double made) {
    if (step == e->step) return 0;
    const double rate = (made - before) / (double)(step - e->step);
    const int is = rate >= e->rate && made - before > GROWS * made;
    e->rate = rate;
    e->step = step;
    return is;
}

int probe_energy_check(struct run *r, struct step_status *status) {
    struct probe_energy *e = &r->watch.made;
    if (!is_watched(r) || !e->begun) return 0;
    const double before = e->fluid + e->solid;
    take(r);
    const double made = e->fluid + e->solid;
    if (!grows(e, r->step, before, made)) return 0;
    if (!(made > OF_LOADS * e->exchanged) || !(made > OF_SOLID * r->watch.exchanged)) return 0;
    if (!(made > OF_FLUID * fluid_measures_kinetic_energy(r->fluid))) return 0;
    *status = (struct step_status){.failed = 1, .seen_in = STEP_STATUS_PROBES, .field = "energy", .value = made};
    return 1;
}
