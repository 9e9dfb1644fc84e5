/* Finds loads, constraints and injections whose factors of time change in steps in which they do not act. */
#include "coupling/control/ramp.h"
#include "coupling/run.h"
#include "cracks/cracks.h"
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

/* Whether the factor has left its first value before t. */
static int jumps(const struct solid_time *time, double t) {
    return time->n > 1 && fabs(solid_time_factor(time, t) - time->factor[0]) > PART * largest(time);
}

/* Whether the factor only rises, or only falls. */
static int is_ramp(const struct solid_time *time) {
    int rises = 0, falls = 0;
    for (int k = 1; k < time->n; k++) {
        rises |= time->factor[k] > time->factor[k - 1];
        falls |= time->factor[k] < time->factor[k - 1];
    }
    return rises != falls;
}

/* Whether it reaches its largest value, or the end of a ramp, only after t. */
static int is_unfinished(const struct solid_time *time, double t) {
    const double now = solid_time_factor(time, t), most = largest(time);
    double reached = fabs(now);
    if (time->n < 2) return 0;
    for (int k = 0; k < time->n && time->origin + time->t[k] <= t; k++) reached = fmax(reached, fabs(time->factor[k]));
    return reached < (1 - PART) * most || (is_ramp(time) && fabs(time->factor[time->n - 1] - now) > PART * most);
}

/* What varies in time, by the key of its list. */
struct timed {
    const char *key;
    int n;
    const struct solid_time *(*its)(const struct run *r, int k);
    const struct scene_time *(*of_scene)(const struct scene *scene, int k);
};

static const struct solid_time *load(const struct run *r, int k) { return &r->solid->in.load[k].time; }
static const struct solid_time *constraint(const struct run *r, int k) { return &r->solid->in.constraint[k].time; }
static const struct solid_time *injection(const struct run *r, int k) { return &r->cracks->in.injection[k].time; }
static const struct scene_time *scene_load(const struct scene *s, int k) { return &s->solid->load[k].time; }
static const struct scene_time *scene_constraint(const struct scene *s, int k) { return &s->solid->constraint[k].time; }
static const struct scene_time *scene_injection(const struct scene *s, int k) {
    return &s->crack_fluid->injection[k].time;
}

enum { LISTS = 3, INJECTIONS = 2 };

static void timed_of(const struct run *r, struct timed list[LISTS]) {
    const struct scene *s = r->scene;
    list[0] = (struct timed){"solid.loads", s->solid->loads, load, scene_load};
    list[1] = (struct timed){"solid.constraints", s->solid->constraints, constraint, scene_constraint};
    list[INJECTIONS] = (struct timed){"crack_fluid.injections", r->cracks ? s->crack_fluid->injections : 0, injection,
                                      scene_injection};
}

static int is_elastic(const struct run *r, int stage) { return r->scene->stage[stage].solid == SCENE_SOLID_ELASTIC; }

/* Whether the present stage is the first in which the solid moves, or in which fluid flows in cracks. */
static int acts_first(const struct run *r, int list) {
    if (r->stage_step > 0) return 0;
    if (list != INJECTIONS) return r->moved == 0 && is_elastic(r, r->stage);
    for (int k = 0; k < r->stage; k++)
        if (r->scene->stage[k].crack_fluid) return 0;
    return run_stage(r)->crack_fluid;
}

static void describe_start(const struct run *r, const struct timed *list, int k, int is_injection,
                           char sentence[RAMP_SENTENCE]) {
    const struct solid_time *time = list->its(r, k);
    snprintf(sentence, RAMP_SENTENCE,
             "%s[%d].time: the factor changes from %.4g s on, but stage %s, in which %s, begins at t = %.4g s: the "
             "factor then is %.3g at once. Times count from the start of the run; with time_from: %s they count from "
             "the stage's start",
             list->key, k, time->origin + time->t[0], run_stage(r)->name,
             is_injection ? "fluid first flows in the cracks" : "the solid first moves", r->t,
             solid_time_factor(time, r->t), run_stage(r)->name);
}

static void describe_end(const struct run *r, const struct timed *list, int k, char sentence[RAMP_SENTENCE]) {
    const struct solid_time *time = list->its(r, k);
    snprintf(sentence, RAMP_SENTENCE,
             "%s[%d].time: the run ends at t = %.4g s, when the factor is %.3g of its largest value, %.3g: it would "
             "change until %.4g s%s",
             list->key, k, r->t, solid_time_factor(time, r->t) / largest(time), largest(time),
             time->origin + time->t[time->n - 1],
             run_stage(r)->relax && run_stage(r)->increment == 0
                 ? ". A relaxation takes no time: with `increment` it raises the loads"
                 : "");
}

int ramp_of(const struct run *r, int ends, char sentence[RAMP_SENTENCE]) {
    struct timed list[LISTS];
    if (!r->solid || !r->needs.bonds) return 0;
    timed_of(r, list);
    for (int l = 0; l < LISTS; l++)
        for (int k = 0; k < list[l].n; k++) {
            const struct solid_time *time = list[l].its(r, k);
            if (ends && is_elastic(r, r->stage) && is_unfinished(time, r->t)) {
                describe_end(r, &list[l], k, sentence);
                return 1;
            }
            if (!ends && acts_first(r, l) && jumps(time, r->t)) {
                describe_start(r, &list[l], k, l == INJECTIONS, sentence);
                return 1;
            }
        }
    return 0;
}

/* Whether times that count from the present stage, begun at `begin`, are still on the way at `end`. */
static int outlasts(const struct run *r, const struct scene_time *from, const struct solid_time *time, double begin,
                    double end) {
    struct solid_time shifted = *time;
    if (from->stage != r->stage + 1) return 0;
    shifted.origin = begin;
    return is_unfinished(&shifted, end);
}

int ramp_of_stage(const struct run *r, double begin, double end, char sentence[RAMP_SENTENCE]) {
    struct timed list[LISTS];
    if (!r->solid || !r->needs.bonds) return 0;
    timed_of(r, list);
    for (int l = 0; l < LISTS; l++)
        for (int k = 0; k < list[l].n; k++) {
            const struct solid_time *time = list[l].its(r, k);
            if (!outlasts(r, list[l].of_scene(r->scene, k), time, begin, end)) continue;
            snprintf(sentence, RAMP_SENTENCE,
                     "%s[%d].time: the factor changes until %.4g s after the start of stage %s, which lasts %.4g s: "
                     "give the stage more steps, or the factor earlier times",
                     list[l].key, k, time->t[time->n - 1], run_stage(r)->name, end - begin);
            return 1;
        }
    return 0;
}
