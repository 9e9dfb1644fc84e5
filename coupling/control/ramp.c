/* Finds loads and constraints whose factors of time change in steps in which the solid does not move. */
#include "coupling/control/ramp.h"
#include "coupling/run.h"
#include "solid/imposed/time.h"

#include <math.h>
#include <stdio.h>

/* The least jump or remainder that is reported, as a part of the largest factor. */
static const double PART = 0.05;

static double largest(const struct solid_time *time) {
    double most = 0;
    for (int k = 0; k < time->n; k++) most = fmax(most, fabs(time->factor[k]));
    return most;
}

/* Whether the factor has left its first value before t; whether it reaches its largest value only after t. */
static int jumps(const struct solid_time *time, double t) {
    return time->n > 1 && fabs(solid_time_factor(time, t) - time->factor[0]) > PART * largest(time);
}

static int is_unfinished(const struct solid_time *time, double t) {
    double reached = fabs(solid_time_factor(time, t));
    for (int k = 0; k < time->n && time->origin + time->t[k] <= t; k++) reached = fmax(reached, fabs(time->factor[k]));
    return time->n > 1 && reached < (1 - PART) * largest(time);
}

static int describe(const struct run *r, const char *key, int k, const struct solid_time *time, int ends,
                    char sentence[RAMP_SENTENCE]) {
    if (ends ? !is_unfinished(time, r->t) : !jumps(time, r->t)) return 0;
    if (ends)
        snprintf(sentence, RAMP_SENTENCE,
                 "solid.%s[%d].time: the run ends at t = %.4g s, when the factor is %.3g of its largest value, %.3g: "
                 "it would change until %.4g s",
                 key, k, r->t, solid_time_factor(time, r->t) / largest(time), largest(time),
                 time->origin + time->t[time->n - 1]);
    else
        snprintf(sentence, RAMP_SENTENCE,
                 "solid.%s[%d].time: the factor changes from %.4g s on, but stage %s, in which the solid first moves, "
                 "begins at "
                 "t = %.4g s: the factor then is %.3g at once. Times count from the start of the run; with time_from: "
                 "%s they count from the stage's start",
                 key, k, time->origin + time->t[0], run_stage(r)->name, r->t, solid_time_factor(time, r->t),
                 run_stage(r)->name);
    return 1;
}

int ramp_of(const struct run *r, int ends, char sentence[RAMP_SENTENCE]) {
    if (!r->solid || !r->needs.bonds || run_stage(r)->solid != SCENE_SOLID_ELASTIC || run_stage(r)->relax) return 0;
    if (!ends && (r->moved > 0 || r->stage_step > 0)) return 0;
    for (int k = 0; k < r->solid->in.loads; k++)
        if (describe(r, "loads", k, &r->solid->in.load[k].time, ends, sentence)) return 1;
    for (int k = 0; k < r->solid->in.constraints; k++)
        if (describe(r, "constraints", k, &r->solid->in.constraint[k].time, ends, sentence)) return 1;
    return 0;
}

/* Whether times that count from the present stage, begun at `begin`, are still on the way to their largest factor at
 * `end`. */
static int outlasts(const struct run *r, const struct scene_time *from, const struct solid_time *time, double begin,
                    double end) {
    struct solid_time shifted = *time;
    if (from->stage != r->stage + 1) return 0;
    shifted.origin = begin;
    return is_unfinished(&shifted, end);
}

static int describe_stage(const struct run *r, const char *key, int k, const struct solid_time *time, double length,
                          char sentence[RAMP_SENTENCE]) {
    snprintf(sentence, RAMP_SENTENCE,
             "solid.%s[%d].time: the factor changes until %.4g s after the start of stage %s, which lasts %.4g s: give "
             "the stage more steps, or the factor earlier times",
             key, k, time->t[time->n - 1], run_stage(r)->name, length);
    return 1;
}

int ramp_of_stage(const struct run *r, double begin, double end, char sentence[RAMP_SENTENCE]) {
    const struct scene_solid *s = r->scene->solid;
    if (!r->solid || !r->needs.bonds) return 0;
    for (int k = 0; k < s->loads; k++)
        if (outlasts(r, &s->load[k].time, &r->solid->in.load[k].time, begin, end))
            return describe_stage(r, "loads", k, &r->solid->in.load[k].time, end - begin, sentence);
    for (int k = 0; k < s->constraints; k++)
        if (outlasts(r, &s->constraint[k].time, &r->solid->in.constraint[k].time, begin, end))
            return describe_stage(r, "constraints", k, &r->solid->in.constraint[k].time, end - begin, sentence);
    return 0;
}
