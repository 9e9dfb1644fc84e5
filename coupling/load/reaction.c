/* Load by reaction: what the forcing takes from the fluid is given to the solid, within the stage. */
/* In stage r of the fluid's step, of length g = gamma_r dt, the forcing with feedback (ibm/feedback.c) gives the fluid
 * at a marker of volume W the impulse rho W (g f + w e). In the solid's substeps of the stage, T long together, the
 * marker is under the force
 *
 *     F = - rho W p (f + w (p V_m - U)/T) ,   V_m = N V ,
 *
 * which the particles that carry it take as N^T F (solid/force/attachment.h). p is 1, and less across a side of the
 * domain that the kernel reaches over (coupling/interface/markers.h). f is the same in all stages of a step; the part
 * with V_m is a drag, implicit in the markers' velocities (solid/force/drag.c). e makes the fluid's impulse the
 * opposite of the solid's. So momentum is kept to round-off, marker by marker, and the work that is done on the solid
 * is taken from the fluid but for the slip's loss and the drag's own. In the linear model without the inner fluid no
 * step creates energy for w J S <= 1, whatever the densities and the stiffness are. (compare Tschisgale et al. 2017)
 */
#include "coupling/load/reaction.h"
#include "base/clock.h"
#include "base/files/log.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/interface/place.h"
#include "coupling/interface/slip.h"
#include "coupling/load/inner_fluid.h"
#include "coupling/load/inner_pressure.h"
#include "coupling/load/inner_watch.h"
#include "coupling/run.h"
#include "fluid/scheme.h"
#include "ibm/feedback.h"
#include "ibm/feedback_work.h"
#include "solid/force/attachment.h"
#include "solid/force/drag.h"
#include "solid/imposed/reactions.h"
#include "solid/step/integrate.h"

#include <math.h>
#include <string.h>

struct reaction {
    struct inner_fluid *inner;       /* NULL: the solid is rigid in every stage */
    struct inner_pressure *pressure; /* NULL unless cracks are open to the flow */
    struct solid_drag drag;
    int capacity;
    double *strength;            /* [markers] Z, kg/s */
    double (*u)[3];              /* [markers] U, m/s */
    double (*impulse)[3];        /* [markers] of the drag in the stage, N s; then the slip e, m/s */
    double (*marker_force)[3];   /* [markers] reaction to the marker force f, on the solid in this step, N */
    double (*drag_force)[3];     /* [markers] mean force of the drag on the solid in the step, N */
    double *load[3];             /* [n] either of them, by particle, N/m3 */
    int adds_works;              /* 1: the next step adds up its works */
    long works_of;               /* number of the last step that did */
    double by_markers, by_inner; /* works in it, J: of the markers, on solid and fluid; of what the inner fluid gives
                                  * back; this rank's share */
};

static void begin(struct run *r) {
    struct reaction *k = r->reaction = memory_new(MEMORY_COUPLING, 1, sizeof *k);
    if (!fluid_input_of(r->fluid)->implicit || r->needs.bonds) ibm_feedback_set(r->ibm, slip_time_of(r));
    if (!r->needs.bonds) return;
    k->inner = inner_fluid_new(r);
    k->pressure = inner_pressure_new(r);
    markers_attach(r);
    for (int c = 0; c < 3; c++) k->load[c] = memory_new(MEMORY_COUPLING, (size_t)r->solid->n + 1, sizeof(double));
}

static void end(struct run *r) {
    struct reaction *k = r->reaction;
    inner_fluid_free(k->inner, r);
    inner_pressure_free(k->pressure);
    MEMORY_FREE(k->strength, k->u, k->impulse, k->marker_force, k->drag_force, k->load[0], k->load[1], k->load[2], k);
}

static void reserve(struct reaction *k, int n) {
    if (n <= k->capacity && k->u) return;
    const size_t capacity = (size_t)(k->capacity = n + n / 4 + 64);
    MEMORY_FREE(k->strength, k->u, k->impulse, k->marker_force, k->drag_force);
    k->strength = memory_new(MEMORY_COUPLING, capacity, sizeof *k->strength);
    k->u = memory_new(MEMORY_COUPLING, capacity, sizeof *k->u);
    k->impulse = memory_new(MEMORY_COUPLING, capacity, sizeof *k->impulse);
    k->marker_force = memory_new(MEMORY_COUPLING, capacity, sizeof *k->marker_force);
    k->drag_force = memory_new(MEMORY_COUPLING, capacity, sizeof *k->drag_force);
}

/* Sum of the weights w_r of the stages. */
static double sum_of_weights(const struct run *r) {
    double sum = 0;
    for (int stage = 0; stage < fluid_scheme_stages(r->fluid); stage++)
        sum += ibm_feedback_weight(r->ibm, stage, r->dt);
    return sum;
}

/* The substeps of each fluid stage, out of at least as many: in proportion to gamma_r, at least one each; the first
 * stage gets the rest. */
static void split(const struct fluid *f, int substeps, int of_stage[3]) {
    of_stage[0] = substeps;
    for (int stage = 1; stage < fluid_scheme_stages(f); stage++) {
        of_stage[stage] = (int)fmax(1, floor(fluid_scheme_gamma(f, stage) * substeps + 0.5));
        of_stage[0] -= of_stage[stage];
    }
}

/* Adds N^T force to the loads; force [markers][3], N. Collective. */
static void add_to_load(struct run *r, const double (*force)[3]) {
    struct solid *s = r->solid;
    solid_attachment_spread(r->markers.attachment, s, force);
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < s->n; h++) {
            r->reaction->load[c][h] = r->markers.attachment->given[c][h] / s->volume[h];
            s->load[c][h] += r->reaction->load[c][h];
        }
}

static void add_again_to_load(struct run *r) {
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < r->solid->n; h++) r->solid->load[c][h] += r->reaction->load[c][h];
}

/* Takes U of the markers, and f before the first stage: sets the drag, and adds the marker force to the load. */
static void set_drag(struct run *r, int stage, double length) {
    struct reaction *k = r->reaction;
    const struct markers *m = &r->markers;
    const double density = fluid_input_of(r->fluid)->density;
    const double w = ibm_feedback_weight(r->ibm, stage, r->dt);
    const double(*f)[3] = ibm_feedback_force(r->ibm);
    ibm_feedback_velocity(r->ibm, k->u);
    for (int i = 0; i < m->n; i++) {
        const double mass = ibm_feedback_is_in_domain(r->ibm, i) ? density * m->volume[i] : 0;
        k->strength[i] = w * mass / length;
        for (int c = 0; c < 3; c++) {
            k->impulse[i][c] = 0;
            if (stage == 0) k->marker_force[i][c] = -mass * m->fraction[i][c] * f[i][c];
        }
    }
    if (stage == 0)
        add_to_load(r, (const double(*)[3])k->marker_force);
    else
        add_again_to_load(r);
    k->drag = (struct solid_drag){m->attachment, k->strength, (const double(*)[3])k->u, k->impulse,
                                  (const double(*)[3])m->fraction};
}

/* Gives the impulse of the substeps to the fluid; adds the load of the stage to sum, which is an impulse. */
static void apply_slip(struct run *r, int stage, double length, double impulse[3]) {
    struct reaction *k = r->reaction;
    const struct markers *m = &r->markers;
    for (int i = 0; i < m->n; i++)
        for (int c = 0; c < 3; c++) {
            const double by_drag = k->impulse[i][c], all = k->strength[i] * m->fraction[i][c] * length;
            impulse[c] += length * k->marker_force[i][c] + by_drag;
            k->drag_force[i][c] = (stage == 0 ? 0 : k->drag_force[i][c]) + by_drag / r->dt;
            k->impulse[i][c] = all > 0 ? -by_drag / all : 0;
        }
    ibm_feedback_apply_slip(r->ibm, stage, r->dt, (const double(*)[3])k->impulse);
}

double reaction_take_uneven(const struct run *r) {
    return r->reaction ? inner_pressure_take_uneven(r->reaction->pressure) : 0;
}

/* Whether the inner fluid was followed in the last step: not in a rigid stage, whose first step stops the solid. */
static int has_given(const struct run *r) { return r->moved == r->step && r->inner[0].time >= 0; }

void reaction_inner_couple(const struct run *r, double couple[3]) {
    couple[0] = couple[1] = couple[2] = 0;
    if (r->reaction && r->reaction->inner && has_given(r)) inner_fluid_couple(r->reaction->inner, r, couple);
}

void reaction_watch_note(struct run *r) {
    if (r->reaction && r->reaction->inner && has_given(r)) inner_watch_note(r->reaction->inner, r);
}

/* Whether the kernel of a marker of this rank reaches over a side that takes a part of its force: over an outflow, and,
 * of a particle without bonds, which keeps all of its drag, over any side but a periodic one. */
static int reaches_side(const struct run *r) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const struct markers *m = &r->markers;
    int reaches = 0;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            const enum fluid_side_type type = fluid_input_of(r->fluid)->side[d][side].type;
            const double at = side ? g->length[d] : 0;
            for (int i = 0; i < m->n && type != FLUID_PERIODIC; i++)
                if (type == FLUID_OUTFLOW || r->surface->two_sided[i] == SOLID_ISOLATED)
                    reaches |= (side ? at - m->x[d][i] : m->x[d][i]) < 2 * g->d[d];
        }
    return reaches;
}

/* In the last step the markers gave the solid the opposite of what they gave the fluid, to round-off. `load` and the
 * forcing contain what the inner fluid gave as well. What is compared: the larger one of them, or a millionth of the
 * sizes of the markers' forces, which may cancel. */
static void warn_of_reaction(struct run *r) {
    static const double WARN = 0.01, AGAIN = 4, LEAST = 1e-6; /* as in coupling/control/watch.c */
    const struct reaction *k = r->reaction;
    double forcing[3], received[5] = {0}, off = 0, exchanged = 0;
    if (!has_given(r)) return;
    memcpy(received, inner_fluid_last_exchange(k->inner)->received, 3 * sizeof *received);
    for (int i = 0; i < r->markers.n; i++)
        for (int c = 0; c < 3; c++) received[3] += fabs(k->marker_force[i][c]) + fabs(k->drag_force[i][c]);
    received[4] = reaches_side(r);
    par_sum_array(received, 5);
    if (received[4] > 0) return;
    ibm_forcing_total(r->ibm, forcing);
    for (int c = 0; c < 3; c++) {
        off = fmax(off, fabs(r->load[c] + forcing[c] - received[c] / r->dt));
        exchanged = fmax(exchanged, fmax(fabs(r->load[c]), fabs(forcing[c])));
    }
    exchanged = fmax(exchanged, LEAST * received[3]);
    const double part = exchanged > 0 ? off / exchanged : 0;
    if (!(part > WARN) || part <= AGAIN * r->watch.logged_reaction) return;
    r->watch.logged_reaction = part;
    log_line("warning: step %ld: the forces of the markers on solid and fluid are not opposite: they differ by %.3g N, "
             "%.3g %% of %.3g N: momentum is not conserved",
             r->step, off, 100 * part, exchanged);
}

void reaction_watch_check(struct run *r) {
    if (!r->reaction || !r->reaction->inner) return;
    inner_watch_check(r->reaction->inner, r);
    warn_of_reaction(r);
}

void reaction_sort_again(struct run *r) {
    if (r->reaction && r->reaction->inner) inner_fluid_sort_again(r->reaction->inner);
}

void reaction_add_works(struct run *r) {
    if (r->reaction) r->reaction->adds_works = 1;
}

static int has_works(const struct run *r) { return r->reaction && r->reaction->works_of == r->step && r->step > 0; }

double reaction_slip_loss(struct run *r) {
    return has_works(r) ? -par_sum(r->reaction->by_markers) / r->dt : ibm_feedback_slip_loss(r->ibm, r->dt);
}

double reaction_inner_power(const struct run *r) { return has_works(r) ? par_sum(r->reaction->by_inner) / r->dt : 0; }

static void begin_works(struct run *r) {
    struct reaction *k = r->reaction;
    k->works_of = r->step + 1;
    k->by_markers = k->by_inner = 0;
    ibm_feedback_work_begin(r->ibm);
}

/* After the solid's substeps of a stage: of the markers on this rank's particles, from where they were at its start. */
static void add_work_on_solid(struct run *r) {
    struct reaction *k = r->reaction;
    const struct solid *s = r->solid;
    const double *restrict volume = s->volume;
    double sum = 0;
    for (int c = 0; c < 3; c++) {
        const double *restrict load = k->load[c], *restrict x0 = s->x0[c], *restrict d = s->d[c],
                               *restrict from = r->position[c];
#pragma omp simd reduction(+ : sum)
        for (int h = 0; h < s->n; h++) sum += volume[h] * load[h] * (x0[h] + d[h] - from[h]);
    }
    k->by_markers += sum + r->markers.attachment->work_of_drag;
}

/* After the last stage, which took `last`, s. */
static void end_works(struct run *r, double last) {
    struct reaction *k = r->reaction;
    inner_fluid_read_last(k->inner, r);
    k->by_inner += inner_fluid_work(k->inner, r, fluid_scheme_stages(r->fluid) - 1, last);
    k->by_markers += ibm_feedback_work_sum(r->ibm);
}

/* A step of fluid and solid. The markers stand at X^n. */
static void step(struct run *r) {
    struct reaction *k = r->reaction;
    struct solid *s = r->solid;
    const double h = r->dt / r->substeps;
    const int adds_works = k->adds_works;
    double impulse[3] = {0}, last = 0;
    int substeps[3];
    reserve(k, r->markers.n);
    split(r->fluid, r->substeps, substeps);
    fluid_state_of(r->fluid)->t = s->t = r->t;
    s->drag = &k->drag;
    solid_reactions_begin(s);
    inner_pressure_find(k->pressure, r, k->inner);
    ibm_inside_begin(r->ibm);
    if (adds_works) begin_works(r);
    for (int stage = 0; stage < fluid_scheme_stages(r->fluid); stage++) {
        const double length = substeps[stage] * h;
        clock_begin(CLOCK_PROBE);
        if (stage == 0) inner_fluid_begin(r);
        inner_fluid_read(k->inner, r, stage);
        if (stage > 0) {
            if (adds_works) k->by_inner += inner_fluid_work(k->inner, r, stage - 1, last);
            inner_fluid_begin(r);
        }
        inner_fluid_set_loads(k->inner, r, stage, length, impulse);
        inner_pressure_add(k->pressure, r);
        clock_end(CLOCK_PROBE);
        fluid_predict(r->fluid, stage, r->dt);
        inner_fluid_push(k->inner, r, stage, length);
        ibm_feedback_begin(r->ibm, stage, r->dt);
        set_drag(r, stage, length);
        r->markers.attachment->work_of_drag = 0;
        solid_integrate(s, h, substeps[stage]);
        if (adds_works) add_work_on_solid(r);
        apply_slip(r, stage, length, impulse);
        fluid_project(r->fluid, stage, r->dt);
        if (adds_works) ibm_feedback_work_add(r->ibm);
        last = length;
    }
    if (adds_works) end_works(r, last);
    s->drag = NULL;
    add_to_load(r,
                (const double(*)[3])k->drag_force); /* the load of the step, for whoever looks at it after the step */
    k->adds_works = 0;
    for (int c = 0; c < 3; c++) r->load[c] = impulse[c] / r->dt;
    par_sum_array(r->load, 3);
    r->dt_last = r->dt;
    r->moved = r->step + 1;
}

/* The force on a solid at rest. The inner fluid is at rest with the body, but it is pushed. */
static void sample(struct run *r) {
    const struct solid *s = r->solid;
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    double volume = 0;
    for (int h = 0; h < s->n; h++) volume += place_is_inside(g, s, h) ? s->volume[h] : 0;
    volume = par_sum(volume);
    ibm_forcing_total(r->ibm, r->load);
    for (int c = 0; c < 3; c++) r->load[c] = -r->load[c] - inner_fluid_body_force(r, c) * volume;
}

const struct load_kind reaction_kind = {
    .keeps_force = 1, .begin = begin, .end = end, .step = step, .sample = sample, .forcing_times = sum_of_weights};
