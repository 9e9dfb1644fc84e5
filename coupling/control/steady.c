/* Decides when a stage that waits for a quantity has become steady, or when all is at rest. */
#include "coupling/control/steady.h"
#include "base/ensure.h"
#include "coupling/interface/deposit.h"
#include "coupling/run.h"

#include "solid/imposed/time.h"
#include "solid/measure/energy.h"

#include <math.h>
#include <string.h>

/* Samples a window, and the largest factor between the spreads of two windows that counts: a spread of round-off does
 * not fall any more. */
enum { SAMPLES = 20 };
#define SLOWEST 0.99
/* A value whose change from a window's first sample to its last is more than this part of the spread drifts; any
 * other only varies about a mean. */
#define ON_ITS_WAY 0.8

/* The slowest flow in a slit of width h decays in h^2/(pi^2 nu) = 1.2 k/(phi nu), in a tube in 1.4 k/(phi nu). */
#define DECAY 1.4
enum { WINDOWS = 2 /* that the permeability must be quiet for, at least */ };
enum { QUIET = 3 /* windows at whose ends all must be steady in a flow */ };

static const struct scene_stage *stage_of(const struct run *r) { return &r->scene->stage[r->stage]; }

void steady_begin(struct run *r) { r->steady = (struct steady){0}; }

struct steady_found steady_nothing(void) {
    struct steady_found found = {.moving = NAN};
    for (int q = 0; q < STEADY_QUANTITIES; q++) found.value[q] = found.spread[q] = found.left[q] = NAN;
    return found;
}

int steady_may_end(const struct run *r, long stage_step) {
    return stage_of(r)->has_until && stage_step % stage_of(r)->until_window == 0;
}

int steady_is_due(const struct run *r, long stage_step) {
    const struct scene_stage *s = stage_of(r);
    if (!s->has_until) return 0;
    const int every = s->until_window > SAMPLES ? s->until_window / SAMPLES : 1;
    return steady_may_end(r, stage_step) || stage_step % s->until_window % every == 0;
}

int steady_has_ended(const struct run *r) { return stage_of(r)->has_until && r->steady.ended; }

static int rests(const struct run *r) { return stage_of(r)->until_quantity == SCENE_UNTIL_REST; }

static double size_of(const double v[3]) { return sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); }

/* Sets the quantities of all that is to come to rest, NaN for parts that are not there; returns kinetic over strain
 * energy. A strain energy that has nearly gone counts as a part of the largest one. */
static double measure_rest(struct run *r, double value[STEADY_QUANTITIES]) {
    const struct scene_stage *stage = stage_of(r);
    const int moves = r->solid && stage->solid == SCENE_SOLID_ELASTIC;
    double moving = 0;
    if (r->fluid) value[STEADY_FLOW] = fluid_measures_kinetic_energy(r->fluid);
    if (r->needs.immersed && !moves) r->load_kind->sample(r);
    if (r->needs.immersed) value[STEADY_LOAD] = size_of(r->load);
    if (moves) {
        const struct solid_energy e = solid_energy_measure(r->solid);
        const double strain = fmax(e.strain, stage->until_kinetic * r->steady.most[STEADY_STRAIN]);
        value[STEADY_STRAIN] = e.strain;
        moving = e.kinetic > 0 ? e.kinetic / strain : 0;
    }
    return moving;
}

static double measure(struct run *r, double value[STEADY_QUANTITIES]) {
    for (int q = 0; q < STEADY_QUANTITIES; q++) value[q] = NAN;
    switch (stage_of(r)->until_quantity) {
    case SCENE_UNTIL_PERMEABILITY:
        value[STEADY_PERMEABILITY] = deposit_measure(r).permeability;
        return 0;
    case SCENE_UNTIL_REST:
        return measure_rest(r, value);
    }
    ENSURE(0, "quantity %d", (int)stage_of(r)->until_quantity);
}

/* 1: a load or constraint of this stage changes after now. */
static int ramps_on(const struct run *r) {
    const struct solid *s = r->solid;
    int any = 0;
    if (!s || !r->needs.bonds || stage_of(r)->solid != SCENE_SOLID_ELASTIC) return 0;
    for (int k = 0; k < s->in.loads; k++) any |= solid_time_ends(&s->in.load[k].time) > r->t;
    for (int k = 0; k < s->in.constraints; k++) any |= solid_time_ends(&s->in.constraint[k].time) > r->t;
    return any;
}

/* How far the value is still from its final one.
 *
 *  value
 *   |         _ _ _ _ _ _ _  end
 *   |      .  - - -  left = spread r/(1 - r)
 *   |   .     - - -
 *   | .       spread
 *   +-------+--------+----   windows; r: this spread over the one before
 *
 * A value that varies about a mean, as with implicit diffusion, is as far from it as its spread. */
static double left_after(const struct steady *s, int q, double value) {
    const double spread = s->high[q] - s->low[q],
                 ratio = s->windows && spread < s->spread[q] ? spread / s->spread[q] : 1;
    const double r = spread == 0 ? 0 : fmin(ratio, SLOWEST);
    return fabs(value - s->first[q]) < ON_ITS_WAY * spread ? spread : spread * r / (1 - r);
}

static void begin_window(struct steady *s, const double value[STEADY_QUANTITIES], double moving) {
    memcpy(s->first, value, sizeof s->first);
    memcpy(s->low, value, sizeof s->low);
    memcpy(s->high, value, sizeof s->high);
    s->moving = moving;
    s->samples = 1;
}

static void add(struct steady *s, const double value[STEADY_QUANTITIES], double moving) {
    if (s->samples == 0) begin_window(s, value, moving);
    for (int q = 0; q < STEADY_QUANTITIES; q++) {
        s->low[q] = fmin(s->low[q], value[q]);
        s->high[q] = fmax(s->high[q], value[q]);
        s->most[q] = fmax(s->most[q], fabs(value[q]));
    }
    s->moving = fmax(s->moving, moving);
    s->samples++;
}

/* The spread and what is left of a quantity, over its size. */
static int is_steady(struct run *r, int q, double value, struct steady_found *found) {
    const struct steady *s = &r->steady;
    const double change = stage_of(r)->until_change, size = s->most[q];
    found->value[q] = value;
    if (isnan(value)) return 1; /* no such part */
    const double spread = s->high[q] - s->low[q];
    found->spread[q] = size > 0 ? spread / size : spread;
    if (s->windows) found->left[q] = size > 0 ? left_after(s, q, value) / size : left_after(s, q, value);
    return s->windows && found->spread[q] <= change && found->left[q] <= change;
}

/* A body that swings must have been quiet for half a period of its slowest motion, within which it is seen to move. A
 * flow alone must have been quiet for some windows: what decays fast at its start hides what decays slowly. */
static int has_been_quiet(const struct run *r) {
    static const double PI = 3.14159265358979324;
    const double windows = (QUIET - 0.5) * stage_of(r)->until_window * r->dt;
    const double half = r->settle.frequency > 0 ? PI / r->settle.frequency : 0;
    return r->steady.quiet >= fmax(half, r->fluid ? windows : 0);
}

/* The periods that hold the least number of windows and the time in which the pores' flow decays. Collective. */
static long tail_of(const struct run *r, double k) {
    const double each = (double)r->steady.trend.each;
    const double decay = DECAY * fabs(k) / (medium_measure_porosity(r->medium) * fluid_input_of(r->fluid)->viscosity);
    const double period = r->dt * (double)stage_of(r)->until_window * each;
    return (long)fmin(ceil(fmax(WINDOWS / each, decay / period)), TREND_PERIODS);
}

/* Returns 1 if the permeability is steady with this sample. Collective. */
static int sample_permeability(struct run *r, double k, int ends, struct steady_found *found) {
    struct steady *s = &r->steady;
    if (ends) *found = steady_nothing();
    if (ends) found->value[STEADY_PERMEABILITY] = k;
    if (!isfinite(k)) {
        *s = (struct steady){0};
        return 0;
    }
    const int is_period = trend_add(&s->trend, k, ends);
    if (!ends) return 0;
    struct trend_found is = trend_estimate(&s->trend, tail_of(r, k));
    found->windows = is.windows;
    found->spread[STEADY_PERMEABILITY] = is.spread /= fabs(k);
    found->left[STEADY_PERMEABILITY] = is.left /= fabs(k);
    s->ended = is_period && trend_count(&s->trend, &is, stage_of(r)->until_change);
    return (int)s->ended;
}

int steady_sample(struct run *r, struct steady_found *found) {
    struct steady *s = &r->steady;
    double value[STEADY_QUANTITIES];
    const double moving = measure(r, value);
    const int ends = steady_may_end(r, r->stage_step);
    if (!rests(r)) return sample_permeability(r, value[STEADY_PERMEABILITY], ends, found);
    add(s, value, moving);
    if (!ends) return 0;
    *found = steady_nothing();
    found->moving = s->moving;
    found->windows = 1;
    found->ramps = ramps_on(r);
    int all = s->moving <= stage_of(r)->until_kinetic && !found->ramps;
    for (int q = 0; q < STEADY_QUANTITIES; q++) all &= is_steady(r, q, value[q], found);
    s->quiet = all ? s->quiet + stage_of(r)->until_window * r->dt : 0;
    s->ended = all && has_been_quiet(r);
    for (int q = 0; q < STEADY_QUANTITIES; q++) {
        s->left[q] = all ? fmax(s->left[q], found->left[q]) : 0;
        if (all && !isnan(value[q])) found->left[q] = s->left[q];
        s->spread[q] = s->high[q] - s->low[q];
    }
    begin_window(s, value, moving);
    s->windows++;
    return (int)s->ended;
}
