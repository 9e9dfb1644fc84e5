/* Checks the solid at the start of a stage in which bonds may break, and at the end of one in which none broke. */
#include "coupling/control/early_breakage.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/run.h"
#include "solid/measure/energy.h"
#include "solid/measure/motion.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* Kinetic over strain energy of a solid that is taken to be at rest. */
static const double AT_REST = 0.01;
/* Of a body that flies, what is left of its kinetic energy by rounding. */
static const double ROUND_OFF = 1e-12;

static int is_elastic(const struct run *r) { return r->needs.bonds && run_stage(r)->solid == SCENE_SOLID_ELASTIC; }

static int moves(const struct run *r) { return is_elastic(r) && !run_stage(r)->relax; }

/* Whether a bond has broken in the run; those that initial cracks cut have no part in it. */
static int has_broken(const struct run *r) { return par_sum(r->solid->crack_area) > 0; }

/* Kinetic energy of the solid without that of free bodies as a whole, which fly or sink and need not come to rest: J.
 */
static double kinetic_of_deformation(struct solid *s, double kinetic) {
    const int bodies = s->in.bodies;
    struct solid_motion *motion = memory_new(MEMORY_OUTPUT, (size_t)bodies, sizeof *motion);
    double *held = memory_new(MEMORY_OUTPUT, (size_t)bodies, sizeof *held);
    for (int h = 0; h < s->n; h++)
        if (s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z)) held[s->body[h]] = 1;
    par_max_array(held, bodies);
    solid_motion_measure(s, motion);
    for (int b = 0; b < bodies; b++)
        for (int c = 0; c < s->dim && held[b] == 0 && s->in.interfaces == 0; c++)
            kinetic -= 0.5 * motion[b].momentum[c] * motion[b].momentum[c] / motion[b].mass;
    MEMORY_FREE(held, motion);
    return fmax(kinetic, 0);
}

int early_breakage_of(struct run *r, char sentence[EARLY_BREAKAGE_SENTENCE]) {
    const char *name = run_stage(r)->name;
    if (r->stage == 0 || r->stage_step > 0 || !moves(r) || !scene_stage_may_break(r->scene, r->stage)) return 0;
    if (r->moved == 0) {
        if (!r->needs.immersed) return 0;
        snprintf(sentence, EARLY_BREAKAGE_SENTENCE,
                 "stage %s: bonds may break, and the solid moves for the first time: the load of the flow acts at "
                 "once, and stretches bonds up to twice as far as at rest. Put a stage with breakage: false and until: "
                 "{quantity: rest} before it, in which the solid settles",
                 name);
        return 1;
    }
    if (scene_stage_may_break(r->scene, r->stage - 1) || has_broken(r)) return 0;
    const struct solid_energy e = solid_energy_measure(r->solid);
    const double kinetic = kinetic_of_deformation(r->solid, e.kinetic);
    if (!(kinetic > fmax(AT_REST * e.strain, ROUND_OFF * e.kinetic))) return 0;
    snprintf(sentence, EARLY_BREAKAGE_SENTENCE,
             "stage %s: bonds may break from here on, and the solid is not at rest: its kinetic energy of %.3g J is "
             "%.2g of its strain energy (at rest: below %.2g). Give the stage before it until: {quantity: rest}, so "
             "that the solid settles",
             name, kinetic, kinetic / e.strain, AT_REST);
    return 1;
}

/* Part of a load that may change within a stage that breaks. */
static const double STEADY = 0.05;

void early_breakage_load_add(struct early_breakage_load *u, double t, const double force[3]) {
    u->t[0] = u->t[1];
    u->t[1] = t;
    memcpy(u->force[0], u->force[1], sizeof u->force[0]);
    memcpy(u->force[1], force, sizeof u->force[1]);
    if (u->samples < 2) u->samples++;
}

int early_breakage_flow_of(const struct run *r, const struct early_breakage_load *u, long every,
                           char sentence[EARLY_BREAKAGE_SENTENCE]) {
    const struct scene_stage *stage = run_stage(r);
    const double interval = u->t[1] - u->t[0];
    double change = 0, force = 0;
    if (r->stage == 0 || r->stage_step > 0 || !r->needs.immersed || !moves(r) || u->samples < 2) return 0;
    if (!scene_stage_may_break(r->scene, r->stage) || scene_stage_may_break(r->scene, r->stage - 1)) return 0;
    for (int c = 0; c < 3; c++) {
        change = hypot(change, u->force[1][c] - u->force[0][c]);
        force = hypot(force, u->force[1][c]);
    }
    const double all = (double)stage->steps * (r->dt > 0 ? r->dt : interval / (double)every),
                 seconds = stage->duration > 0 ? fmin(stage->duration, all) : all;
    const double part = change / interval * seconds / force;
    if (!(interval > 0) || !(part > STEADY)) return 0;
    snprintf(
        sentence, EARLY_BREAKAGE_SENTENCE,
        "stage %s: bonds may break from here on, and the flow is not steady: its load of %.4g N changes by %.3g N/s, "
        "which would be %.2g of it within the stage's %.3g s. Give the stage before it until: {quantity: rest}, so "
        "that the flow becomes steady",
        stage->name, force, change / interval, part, seconds);
    return 1;
}

struct solid_reach early_breakage_reach(struct run *r) {
    if (!is_elastic(r) || r->moved == 0 || has_broken(r)) return (struct solid_reach){.part = 0};
    return solid_reach_find(r->solid);
}
