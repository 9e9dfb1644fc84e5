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
    int n, is_injection;
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

/* Whether there is something to say of item k of a list, over the times from `begin` to `end`; writes the sentence. */
typedef int says(const struct run *r, const struct timed *list, int k, double begin, double end,
                 char sentence[RAMP_SENTENCE]);

/* The first item of which there is something to say. Returns whether there is one. */
static int first_said(const struct run *r, says *say, double begin, double end, char sentence[RAMP_SENTENCE]) {
    const struct scene *s = r->scene;
    if (!r->solid || !r->needs.bonds) return 0;
    const struct timed list[] = {
        {"solid.loads", s->solid->loads, 0, load, scene_load},
        {"solid.constraints", s->solid->constraints, 0, constraint, scene_constraint},
        {"crack_fluid.injections", r->cracks ? s->crack_fluid->injections : 0, 1, injection, scene_injection}};
    for (size_t l = 0; l < sizeof list / sizeof *list; l++)
        for (int k = 0; k < list[l].n; k++)
            if (say(r, &list[l], k, begin, end, sentence)) return 1;
    return 0;
}

static int is_elastic(const struct run *r, int stage) { return r->scene->stage[stage].solid == SCENE_SOLID_ELASTIC; }

/* Whether the present stage is the first in which the solid moves, or in which fluid flows in cracks. */
static int acts_first(const struct run *r, int is_injection) {
    if (r->stage_step > 0) return 0;
    if (!is_injection) return r->moved == 0 && is_elastic(r, r->stage);
    for (int k = 0; k < r->stage; k++)
        if (r->scene->stage[k].crack_fluid) return 0;
    return run_stage(r)->crack_fluid;
}

/* That the factor has changed before it acts at all. */
static int says_start(const struct run *r, const struct timed *list, int k, double begin, double end,
                      char sentence[RAMP_SENTENCE]) {
    const struct solid_time *time = list->its(r, k);
    (void)end;
    if (!acts_first(r, list->is_injection) || !jumps(time, begin)) return 0;
    snprintf(sentence, RAMP_SENTENCE,
             "%s[%d].time: the factor changes from %.4g s on, but stage %s, in which %s, begins at t = %.4g s: the "
             "factor then is %.3g at once. Times count from the start of the run; with time_from: %s they count from "
             "the stage's start",
             list->key, k, time->origin + time->t[0], run_stage(r)->name,
             list->is_injection ? "fluid first flows in the cracks" : "the solid first moves", begin,
             solid_time_factor(time, begin), run_stage(r)->name);
    return 1;
}

/* That it would change after the run. */
static int says_end(const struct run *r, const struct timed *list, int k, double begin, double end,
                    char sentence[RAMP_SENTENCE]) {
    const struct solid_time *time = list->its(r, k);
    (void)begin;
    if (!is_elastic(r, r->stage) || !is_unfinished(time, end)) return 0;
    snprintf(sentence, RAMP_SENTENCE,
             "%s[%d].time: the run ends at t = %.4g s, when the factor is %.3g of its largest value, %.3g: it would "
             "change until %.4g s%s",
             list->key, k, end, solid_time_factor(time, end) / largest(time), largest(time),
             time->origin + time->t[time->n - 1],
             run_stage(r)->relax && run_stage(r)->increment == 0
                 ? ". A relaxation takes no time: with `increment` it raises the loads"
                 : "");
    return 1;
}

/* That times which count from the present stage, from `begin` to `end`, are then still on the way. */
static int says_outlasting(const struct run *r, const struct timed *list, int k, double begin, double end,
                           char sentence[RAMP_SENTENCE]) {
    struct solid_time shifted = *list->its(r, k);
    if (list->of_scene(r->scene, k)->stage != r->stage + 1) return 0;
    shifted.origin = begin;
    if (!is_unfinished(&shifted, end)) return 0;
    snprintf(sentence, RAMP_SENTENCE,
             "%s[%d].time: the factor changes until %.4g s after the start of stage %s, which lasts %.4g s: "
             "give the stage more steps, or the factor earlier times",
             list->key, k, shifted.t[shifted.n - 1], run_stage(r)->name, end - begin);
    return 1;
}

int ramp_of(const struct run *r, int ends, char sentence[RAMP_SENTENCE]) {
    return first_said(r, ends ? says_end : says_start, r->t, r->t, sentence);
}

int ramp_of_stage(const struct run *r, double begin, double end, char sentence[RAMP_SENTENCE]) {
    return first_said(r, says_outlasting, begin, end, sentence);
}
