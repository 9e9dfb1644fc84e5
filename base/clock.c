/* Wall time by part of the program, with nested clocks, and by phase of a run's beginning. */
#include "base/clock.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/par_wait.h"
#include "base/threads.h"

enum { DEPTH = 16 };

static double seconds[CLOCK_ALL], waiting[CLOCK_ALL];
static enum clock_part stack[DEPTH], rest = CLOCK_OTHER;
static int depth, cleared; /* cleared: `since` is known, outside of all clocks too */
static double since, wait_since;

static double phase_seconds[CLOCK_PHASES + 1], phase_since;
static enum clock_phase phase_now;
static int phase_known; /* 1: phase_since is a time */

/* Counts the time since the last switch in what has run since then. */
static void count(double now) {
    const double waited = par_wait_seconds();
    const enum clock_part part = depth > 0 ? stack[depth - 1] : rest;
    if (depth > 0 || cleared) {
        seconds[part] += now - since;
        waiting[part] += waited - wait_since;
    }
    since = now;
    wait_since = waited;
}

enum clock_part clock_owner(enum clock_part detail) {
    static const enum clock_part owner[CLOCK_ALL - CLOCK_PARTS] = {CLOCK_POISSON, CLOCK_POISSON, CLOCK_POISSON,
                                                                   CLOCK_SOLID,   CLOCK_OUTPUT,  CLOCK_OUTPUT,
                                                                   CLOCK_OUTPUT,  CLOCK_OUTPUT,  CLOCK_OUTPUT};
    return detail < CLOCK_PARTS ? detail : owner[detail - CLOCK_PARTS];
}

/* The clock that a part runs on: the innermost one, if that is a detail of the part. */
static enum clock_part runs_as(enum clock_part part) {
    return depth > 0 && clock_owner(stack[depth - 1]) == part ? stack[depth - 1] : part;
}

void clock_begin(enum clock_part part) {
    if (threads_me() > 0) return; /* the first thread's time counts */
    ENSURE(depth < DEPTH, "clocks nest %d deep", depth);
    count(par_seconds());
    const enum clock_part as = runs_as(part);
    stack[depth++] = as;
}

void clock_end(enum clock_part part) {
    if (threads_me() > 0) return;
    ENSURE(depth > 0 && runs_as(part) == stack[depth - 1], "the %s clock ends out of order", clock_name(part));
    count(par_seconds());
    depth--;
}

void clock_default(enum clock_part part) {
    clock_count();
    rest = part;
}

void clock_clear(void) {
    ENSURE(depth == 0, "the %s clock runs", clock_name(stack[depth - 1]));
    for (int p = 0; p < CLOCK_ALL; p++) seconds[p] = waiting[p] = 0;
    rest = CLOCK_OTHER;
    cleared = 1;
    since = par_seconds();
    wait_since = par_wait_seconds();
    if (phase_now != CLOCK_PHASE_STEPS) return; /* the process's first run: launch and scene count in it */
    for (int p = 0; p < CLOCK_PHASES; p++) phase_seconds[p] = 0;
    phase_now = CLOCK_PHASE_SCENE;
    phase_since = since;
}

void clock_count(void) { count(par_seconds()); }

static double with_details(const double *value, enum clock_part part) {
    double sum = value[part];
    for (int detail = CLOCK_PARTS; detail < CLOCK_ALL && part < CLOCK_PARTS; detail++)
        if (clock_owner((enum clock_part)detail) == part) sum += value[detail];
    return sum;
}

double clock_seconds(enum clock_part part) { return with_details(seconds, part); }

double clock_waiting(enum clock_part part) { return with_details(waiting, part); }

const char *clock_name(enum clock_part part) {
    static const char *const name[CLOCK_ALL] = {
        "momentum", "poisson", "halo",    "forcing", "probe",      "solid", "contact",     "interface",
        "coupling", "judging", "keeping", "output",  "setup",      "other", "forward",     "columns",
        "backward", "cracks",  "series",  "fields",  "checkpoint", "log",   "permeability"};
    return name[part];
}

enum clock_phase clock_phase(enum clock_phase phase) {
    const enum clock_phase before = phase_now;
    if (before == CLOCK_PHASE_STEPS) return before;
    const double now = par_seconds();
    if (phase_known) phase_seconds[before] += now - phase_since;
    phase_known = 1;
    phase_since = now;
    phase_now = phase;
    return before;
}

double clock_phase_seconds(enum clock_phase phase) { return phase_seconds[phase]; }

const char *clock_phase_name(enum clock_phase phase) {
    static const char *const name[CLOCK_PHASES] = {"launch", "scene",   "fluid",   "plans",  "solid",
                                                   "bonds",  "surface", "forcing", "limits", "output"};
    return name[phase];
}
