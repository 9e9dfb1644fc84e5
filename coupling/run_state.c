/* The table of a run's own state: its position in time, and the data that a step passes to the next.
 * (docs/design/state.md) */
#include "coupling/run_state.h"
#include "base/par.h"
#include "base/files/table.h"
#include "base/files/table_rows.h"
#include "coupling/interface/marker_force.h"
#include "cracks/state_table.h"
#include "fluid/state_table.h"

#include <stdio.h>
#include <string.h>

_Static_assert((int)STATE_TEXT_BYTES >= (int)SCENE_NAME, "a stage's name has room in the table");

static int load_t(void *owner, const void *value, char *why, size_t capacity) {
    struct run *r = owner;
    (void)why, (void)capacity;
    memcpy(&r->t, value, sizeof r->t);
    if (r->needs.bonds) r->solid->t = r->t;
    return 0;
}

/* A stage is stored by its name: the scene may now have other stages before it. */
static void save_stage(void *owner, void *value) {
    const struct run *r = owner;
    snprintf(value, STATE_TEXT_BYTES, "%s", r->scene->stage[r->stage].name);
}

static int load_stage(void *owner, const void *value, char *why, size_t capacity) {
    struct run *r = owner;
    for (r->stage = 0; r->stage < r->scene->stages; r->stage++)
        if (!strcmp(r->scene->stage[r->stage].name, value)) return 0;
    snprintf(why, capacity, "was written in stage %s, which the scene does not have", (const char *)value);
    return 1;
}

/* How many rows each table has up to this step, and their checksum. */
static void save_tables(void *owner, void *value) {
    table_all_rows(((const struct run *)owner)->step, value, STATE_TEXT_BYTES);
}

static int load_tables(void *owner, const void *value, char *why, size_t capacity) {
    (void)owner, (void)why, (void)capacity;
    table_rows_set_expected(value);
    return 0;
}

static void save_spacing(void *owner, void *value) {
    const struct run *r = owner;
    *(double *)value = r->solid ? r->solid->in.spacing : 0;
}

static int load_spacing(void *owner, const void *value, char *why, size_t capacity) {
    const struct run *r = owner;
    const double spacing = *(const double *)value;
    if (!r->solid || spacing == r->solid->in.spacing) return 0;
    snprintf(why, capacity, "has particles %g m apart, the scene %g m", spacing, r->solid->in.spacing);
    return 1;
}

static void save_beginning(void *owner, void *value) {
    beginning_write(&((const struct run *)owner)->beginning, value, STATE_TEXT_BYTES);
}

static int load_beginning(void *owner, const void *value, char *why, size_t capacity) {
    return beginning_differs(&((const struct run *)owner)->beginning, value, why, capacity);
}

static int is_refined(const void *owner) {
    const struct run *r = owner;
    return r->needs.bonds && r->solid->refine;
}

static int has_bonds(const void *owner) { return ((const struct run *)owner)->needs.bonds; }

static int waits(const void *owner) {
    const struct run *r = owner;
    int any = 0;
    for (int k = 0; k < r->scene->stages; k++) any |= r->scene->stage[k].has_until;
    return any;
}

static int settles(const void *owner) {
    const struct run *r = owner;
    int any = 0;
    for (int k = 0; k < r->scene->stages; k++) any |= scene_stage_rests(&r->scene->stage[k]);
    return any;
}

/* Rank 0 has the rows of all ranks. */
enum { PERIOD_ROW = 3 };
_Static_assert(sizeof(struct trend_period) == PERIOD_ROW * sizeof(double), "a row is a period");
static long period_rows(const void *owner) {
    return par_rank() == 0 ? ((const struct run *)owner)->steady.trend.periods : 0;
}
static void save_periods(void *owner, void *value) {
    const struct run *r = owner;
    memcpy(value, r->steady.trend.period, (size_t)period_rows(r) * sizeof *r->steady.trend.period);
}
static int load_periods(void *owner, long n, const void *value) {
    struct trend *t = &((struct run *)owner)->steady.trend;
    if (n > TREND_PERIODS) return 1;
    memcpy(t->period, value, (size_t)n * sizeof *t->period);
    t->periods = n;
    return 0;
}

static int has_inner(const void *owner) { return ((const struct run *)owner)->inner[0].velocity[0] != NULL; }
static int has_mean(const void *owner) { return ((const struct run *)owner)->follows_inner_mean; }
enum { MEANS = 3, MEAN_ROW = 6 };
_Static_assert(sizeof((struct run *)0)->inner_mean == MEANS * MEAN_ROW * sizeof(double), "a row is a stage");
static long mean_rows(const void *owner) {
    (void)owner;
    return MEANS;
}
static void save_means(void *owner, void *value) {
    const struct run *r = owner;
    memcpy(value, r->inner_mean, sizeof r->inner_mean);
}
static int load_means(void *owner, long n, const void *value) {
    struct run *r = owner;
    if (n != MEANS) return 1;
    memcpy(r->inner_mean, value, sizeof r->inner_mean);
    return 0;
}
static int has_inner_stages(const void *owner) { return ((const struct run *)owner)->inner[1].velocity[0] != NULL; }
static int keeps_marker_force(const void *owner) { return marker_force_is_kept(owner); }
static void save_marker_force(void *owner, void *value) { marker_force_by_particle(owner, value); }
static int load_marker_force(void *owner, const void *value, char *why, size_t capacity) {
    (void)why, (void)capacity;
    marker_force_from_particles(owner, value);
    return 0;
}

static const char of_stage[] = "it is found again when a stage begins";
static const char of_samples[] = "steps that are made again from a saved state have been sampled before";
static const char of_rates[] = "rates change at a stage's begin and with a refinement, which no saved state outlives";

#define OF(member) STATE_MEMBER(struct run, member)
/* The members from one up to another. */
#define MEMBERS(from, to)                                                                                              \
    .offset = offsetof(struct run, from), .bytes = offsetof(struct run, to) - offsetof(struct run, from)
#define OF_QUANTITY(its_name, member)                                                                                  \
    {                                                                                                                  \
        its_name, STATE_DOUBLE, STATE_ONE, OF(member), .in = STATE_CHECKPOINT, .missing = STATE_ZERO,                  \
                                                       .is_part = waits, .why = of_samples                             \
    }
#define OF_BEGIN(k)                                                                                                    \
    {                                                                                                                  \
        "stage_began_" #k, STATE_DOUBLE, STATE_ONE, OF(began[k]), .in = STATE_CHECKPOINT, .missing = STATE_ZERO,       \
                                                                  .why = of_stage                                      \
    }
_Static_assert(SCENE_TIMED_MAX == 8, "an item for each");
#define OF_QUANTITIES(its_name, member)                                                                                \
    OF_QUANTITY(its_name, member[STEADY_STRAIN]), OF_QUANTITY(its_name "_flow", member[STEADY_FLOW]),                  \
        OF_QUANTITY(its_name "_load", member[STEADY_LOAD])

const struct state_item run_state_table[] = {
    /* position of the run in time */
    {"t", STATE_DOUBLE, STATE_ONE, OF(t), .in = STATE_BOTH, .load = load_t},
    {"dt", STATE_DOUBLE, STATE_ONE, OF(dt), .in = STATE_BOTH},
    {"dt_last", STATE_DOUBLE, STATE_ONE, OF(dt_last), .in = STATE_BOTH, .missing = STATE_ZERO},
    {"step", STATE_LONG, STATE_ONE, OF(step), .in = STATE_BOTH},
    {"stage_step", STATE_LONG, STATE_ONE, OF(stage_step), .in = STATE_BOTH},
    {"substeps", STATE_INT, STATE_ONE, OF(substeps), .in = STATE_BOTH, .missing = STATE_ZERO},
    {"approach", STATE_DOUBLE, STATE_ONE, OF(control.approach), .in = STATE_BOTH, .missing = STATE_ZERO},
    {"gap", STATE_DOUBLE, STATE_ONE, OF(control.gap), .in = STATE_BOTH, .missing = STATE_ZERO},
    {"stage", STATE_TEXT, STATE_ONE, OF(stage), .in = STATE_BOTH, .save = save_stage, .load = load_stage},
    {"spacing", STATE_DOUBLE, STATE_ONE, .in = STATE_CHECKPOINT, .save = save_spacing, .load = load_spacing,
     .why = "it is a parameter: a checkpoint of other particles is refused"},
    {"beginning", STATE_TEXT, STATE_ONE, .in = STATE_CHECKPOINT, .missing = STATE_LEFT, .save = save_beginning,
     .load = load_beginning, .why = "it is a parameter: a checkpoint of a run that began otherwise is refused"},
    {"solid_stable", STATE_DOUBLE, STATE_ONE, OF(solid_stable), .in = STATE_SNAPSHOT, .why = of_stage},
    {"solid_bound", STATE_INT, STATE_ONE, OF(solid_bound), .in = STATE_SNAPSHOT, .why = of_stage},
    {"force", STATE_DOUBLE, STATE_ONE, OF(load), .in = STATE_SNAPSHOT, .why = "the next step's probe finds it again"},
    {"moved", STATE_LONG, STATE_ONE, OF(moved), .in = STATE_SNAPSHOT,
     .why = "a run that is resumed deposits its particles again, whether or not they have moved"},
    /* what is known of a stage that waits until a quantity is steady */
    OF_QUANTITIES("steady_first", steady.first),
    OF_QUANTITIES("steady_low", steady.low),
    OF_QUANTITIES("steady_high", steady.high),
    OF_QUANTITIES("steady_spread", steady.spread),
    OF_QUANTITIES("steady_most", steady.most),
    OF_QUANTITIES("steady_left", steady.left),
    {"steady_moving", STATE_DOUBLE, STATE_ONE, OF(steady.moving), .in = STATE_CHECKPOINT, .missing = STATE_ZERO,
     .is_part = waits, .why = of_samples},
    {"steady_quiet", STATE_DOUBLE, STATE_ONE, OF(steady.quiet), .in = STATE_CHECKPOINT, .missing = STATE_ZERO,
     .is_part = waits, .why = of_samples},
    {"steady_samples", STATE_LONG, STATE_ONE, OF(steady.samples), .in = STATE_CHECKPOINT, .missing = STATE_ZERO,
     .is_part = waits, .why = of_samples},
    {"steady_windows", STATE_LONG, STATE_ONE, OF(steady.windows), .in = STATE_CHECKPOINT, .missing = STATE_ZERO,
     .is_part = waits, .why = of_samples},
    {"steady_ended", STATE_LONG, STATE_ONE, OF(steady.ended), .in = STATE_CHECKPOINT, .missing = STATE_ZERO,
     .is_part = waits, .why = of_samples},
    OF_BEGIN(0),
    OF_BEGIN(1),
    OF_BEGIN(2),
    OF_BEGIN(3),
    OF_BEGIN(4),
    OF_BEGIN(5),
    OF_BEGIN(6),
    OF_BEGIN(7),
    /* the windows of one that waits for a permeability */
    {"trend_period", STATE_DOUBLE, STATE_ROWS, MEMBERS(steady.trend.period, steady.trend.each), .comps = PERIOD_ROW,
     .in = STATE_CHECKPOINT, .missing = STATE_LEFT, .is_part = waits, .rows_of = period_rows, .save = save_periods,
     .load_rows = load_periods, .why = of_samples},
    {"trend_each", STATE_LONG, STATE_ONE, OF(steady.trend.each), .in = STATE_CHECKPOINT, .missing = STATE_ZERO,
     .is_part = waits, .why = of_samples},
    {"trend_now_low", STATE_DOUBLE, STATE_ONE, OF(steady.trend.now_low), .in = STATE_CHECKPOINT, .missing = STATE_ZERO,
     .is_part = waits, .why = of_samples},
    {"trend_now_high", STATE_DOUBLE, STATE_ONE, OF(steady.trend.now_high), .in = STATE_CHECKPOINT,
     .missing = STATE_ZERO, .is_part = waits, .why = of_samples},
    {"trend_samples", STATE_LONG, STATE_ONE, OF(steady.trend.samples), .in = STATE_CHECKPOINT, .missing = STATE_ZERO,
     .is_part = waits, .why = of_samples},
    {"trend_windows", STATE_LONG, STATE_ONE, OF(steady.trend.windows), .in = STATE_CHECKPOINT, .missing = STATE_ZERO,
     .is_part = waits, .why = of_samples},
    {"trend_quiet", STATE_LONG, STATE_ONE, OF(steady.trend.quiet), .in = STATE_CHECKPOINT, .missing = STATE_ZERO,
     .is_part = waits, .why = of_samples},
    {"settle_frequency", STATE_DOUBLE, STATE_ONE, OF(settle.frequency), .in = STATE_BOTH, .missing = STATE_ZERO,
     .is_part = settles},
    {"settle_damping", STATE_DOUBLE, STATE_ONE, OF(settle.damping), .in = STATE_BOTH, .missing = STATE_ZERO,
     .is_part = settles},
    /* whether the tables are whole, for a resumed run */
    {"tables", STATE_TEXT, STATE_ONE, .in = STATE_CHECKPOINT, .missing = STATE_LEFT, .save = save_tables,
     .load = load_tables, .why = "rows of steps that are made again have been written before"},
    /* the rates of a refined plate */
    {"rate_level", STATE_LONG, STATE_ONE, OF(refined.level), .in = STATE_CHECKPOINT, .missing = STATE_LEFT,
     .after = "place", .is_part = is_refined, .why = of_rates},
    {"rate_stiffness", STATE_DOUBLE, STATE_ONE, OF(solid_rates.stiffness), .in = STATE_CHECKPOINT,
     .missing = STATE_LEFT, .is_part = is_refined, .why = of_rates},
    {"rate_damping", STATE_DOUBLE, STATE_ONE, OF(solid_rates.damping), .in = STATE_CHECKPOINT, .missing = STATE_LEFT,
     .is_part = is_refined, .why = of_rates},
    {"rate_sum", STATE_DOUBLE, STATE_ONE, OF(solid_rates.sum), .in = STATE_CHECKPOINT, .missing = STATE_LEFT,
     .is_part = is_refined, .why = of_rates},
    {"rate_difference", STATE_DOUBLE, STATE_ONE, OF(solid_rates.difference), .in = STATE_CHECKPOINT,
     .missing = STATE_LEFT, .is_part = is_refined, .why = of_rates},
    {"rate_absolute", STATE_DOUBLE, STATE_ONE, OF(solid_rates.absolute), .in = STATE_CHECKPOINT, .missing = STATE_LEFT,
     .is_part = is_refined, .why = of_rates},
    {"rate_bound", STATE_DOUBLE, STATE_ONE, OF(refined.rate2), .in = STATE_CHECKPOINT, .missing = STATE_LEFT,
     .is_part = is_refined, .why = of_rates},
    /* stretched bonds */
    {"strained_factor", STATE_DOUBLE, STATE_ONE, OF(strained.factor), .in = STATE_BOTH, .missing = STATE_ZERO,
     .is_part = has_bonds},
    {"strained_stretch", STATE_DOUBLE, STATE_ONE, OF(strained.stretch), .in = STATE_BOTH, .missing = STATE_ZERO,
     .is_part = has_bonds},
    {"strained_recent", STATE_DOUBLE, STATE_ONE, OF(strained.recent), .in = STATE_BOTH, .missing = STATE_ZERO,
     .is_part = has_bonds},
    /* data that a step passes to the next */
    {"velocity_last", STATE_DOUBLE, STATE_PARTICLE, OF(v_last), .in = STATE_BOTH, .after = "velocity"},
    {"inner_velocity_1", STATE_DOUBLE, STATE_PARTICLE, OF(inner[0].velocity), .in = STATE_BOTH, .missing = STATE_LEFT,
     .is_part = has_inner},
    {"inner_owed_1", STATE_DOUBLE, STATE_PARTICLE, OF(inner[0].excess), .in = STATE_BOTH, .missing = STATE_LEFT,
     .is_part = has_inner},
    {"inner_time_1", STATE_DOUBLE, STATE_ONE, OF(inner[0].time), .in = STATE_BOTH, .missing = STATE_LEFT,
     .is_part = has_inner},
    {"inner_velocity_2", STATE_DOUBLE, STATE_PARTICLE, OF(inner[1].velocity), .in = STATE_BOTH, .missing = STATE_LEFT,
     .is_part = has_inner_stages},
    {"inner_owed_2", STATE_DOUBLE, STATE_PARTICLE, OF(inner[1].excess), .in = STATE_BOTH, .missing = STATE_LEFT,
     .is_part = has_inner_stages},
    {"inner_time_2", STATE_DOUBLE, STATE_ONE, OF(inner[1].time), .in = STATE_BOTH, .missing = STATE_LEFT,
     .is_part = has_inner_stages},
    {"inner_velocity_3", STATE_DOUBLE, STATE_PARTICLE, OF(inner[2].velocity), .in = STATE_BOTH, .missing = STATE_LEFT,
     .is_part = has_inner_stages},
    {"inner_owed_3", STATE_DOUBLE, STATE_PARTICLE, OF(inner[2].excess), .in = STATE_BOTH, .missing = STATE_LEFT,
     .is_part = has_inner_stages},
    {"inner_time_3", STATE_DOUBLE, STATE_ONE, OF(inner[2].time), .in = STATE_BOTH, .missing = STATE_LEFT,
     .is_part = has_inner_stages},
    {"inner_mean", STATE_DOUBLE, STATE_ROWS, OF(inner_mean), .comps = MEAN_ROW, .in = STATE_BOTH, .missing = STATE_LEFT,
     .is_part = has_mean, .rows_of = mean_rows, .save = save_means, .load_rows = load_means, .is_shared = 1},
    /* after the surface is restored */
    {"demand", STATE_DOUBLE, STATE_PARTICLE, OF(marker_force), .comps = 3, .last = 1, .in = STATE_BOTH,
     .missing = STATE_LEFT, .after = "surface", .is_part = keeps_marker_force, .save = save_marker_force,
     .load = load_marker_force, .by_values = 1},
};

#undef OF

static void size_of(const void *owner, struct state_size *size) {
    const struct run *r = owner;
    if (r->solid) solid_state_table_size(r->solid, size);
}

struct state_part run_state_part(struct run *r) {
    return (struct state_part){.item = run_state_table,
                               .items = sizeof run_state_table / sizeof run_state_table[0],
                               .base = r,
                               .owner = r,
                               .size = size_of};
}

void run_state_of(struct run *r, struct run_state *state) {
    state->parts = 0;
    state->solid = (struct solid_state_owner){r->solid, r->surface};
    state->part[state->parts++] = run_state_part(r);
    if (r->fluid) state->part[state->parts++] = fluid_state_table_part(r->fluid);
    if (r->needs.bonds) state->part[state->parts++] = solid_state_table_part(&state->solid);
    if (r->cracks) state->part[state->parts++] = cracks_state_table_part(r->cracks);
    state_list_make(&state->list, state->part, state->parts);
}
