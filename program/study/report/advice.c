/* Writes one sentence for the user: the cheapest setting for each error. */
#include "base/arena.h"
#include "program/study/report/report.h"
#include "program/study/result/iso.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { RUNGS = 3, NAMED_MAX = 4 };

/* The level of the reference, if the method's finest run is the reference itself: its error is zero by definition and
 * tells nothing. */
static int reference_level(const struct study_table *t, int method) {
    return t->method == method && !t->extrapolated ? t->curve[method].finest : -1;
}

/* The cheapest run of all methods with an error below a given one; the reference is left out. */
struct rung {
    double at, time;
    int method, level;
};

static struct rung rung_of(const struct study_result *r, const struct study_table *t, double at, double *work) {
    const struct study *s = r->plan->study;
    struct rung best = {.at = at, .time = NAN, .method = -1, .level = -1};
    for (int m = 0; m < s->methods.n; m++) {
        study_result_curve(r, t, m, work, work + s->levels.n);
        const int own = reference_level(t, m);
        if (own >= 0) work[own] = NAN;
        const int l = study_iso_cheapest(s->levels.n, work, work + s->levels.n, at);
        if (l < 0 || (best.method >= 0 && work[s->levels.n + l] >= best.time)) continue;
        best = (struct rung){at, work[s->levels.n + l], m, l};
    }
    return best;
}

static char *error_text(const struct study_table *t, double error) {
    if (error <= study_iso_round(STUDY_ROUND_ERRORS - 1)) return arena_text("round-off");
    return t->has_scale ? arena_text("%.3g %%", 100 * error) : arena_text("%.3g", error);
}

/* Formats a number with two digits and without exponent. */
enum { DIGITS = 32 };
static const char *two_digits(double x, char text[DIGITS]) {
    const double digit = x > 0 ? pow(10, fmax(floor(log10(x)) - 1, 0)) : 1;
    if (x < 10)
        snprintf(text, DIGITS, "%.2g", x);
    else
        snprintf(text, DIGITS, "%.0f", digit * rint(x / digit));
    return text;
}

/* Time of another method at an error, divided by the time of the cheapest one. */
struct other {
    const char *method;
    double factor; /* NAN: the method does not reach the error */
};

/* For many methods: how many reach the error, and in which range of times. */
static char *counted(const struct other *other, int n, const char *error) {
    double least = INFINITY, most = 0;
    int reached = 0;
    for (int k = 0; k < n; k++) {
        if (!isfinite(other[k].factor)) continue;
        least = fmin(least, other[k].factor);
        most = fmax(most, other[k].factor);
        reached++;
    }
    if (!reached) return arena_text("; none of the %d others gets to %s", n, error);
    char from[DIGITS], to[DIGITS];
    two_digits(least, from);
    two_digits(most, to);
    if (reached == 1) return arena_text("; 1 of the %d others gets to %s, in %s times the time", n, error, to);
    return arena_text("; %d of the %d others get to %s, in %s to %s times the time", reached, n, error, from, to);
}

static char *named(const struct other *other, int n, const char *error) {
    char *text = arena_text("; at %s", error);
    for (int k = 0; k < n; k++) {
        const char *comma = k ? "," : "", *name = other[k].method;
        char times[DIGITS];
        text = arena_text("%s%s", text,
                          isfinite(other[k].factor) ? arena_text("%s %s takes %s times as long", comma, name,
                                                                 two_digits(other[k].factor, times))
                                                    : arena_text("%s %s does not get there", comma, name));
    }
    return text;
}

/* Text on what the other methods would have cost at the last run's error; the reference's own run is left out. */
static char *others(const struct study_result *r, const struct study_table *t, const struct rung *last, double *work) {
    const struct study_variants *methods = &r->plan->study->methods;
    const int levels = r->plan->study->levels.n;
    struct other *other = arena_new((size_t)methods->n, sizeof *other);
    int n = 0;
    for (int m = 0; m < methods->n; m++) {
        if (m == last->method) continue;
        study_result_curve(r, t, m, work, work + levels);
        const int l = study_iso_cheapest(levels, work, work + levels, last->at);
        if (l >= 0 && l == reference_level(t, m)) continue;
        other[n++] = (struct other){methods->variant[m].name, l < 0 ? NAN : work[levels + l] / last->time};
    }
    char *error = error_text(t, last->at);
    char *text = n == 0 ? arena_text("%s", "") : n > NAMED_MAX ? counted(other, n, error) : named(other, n, error);
    return text;
}

static char *of_reference(const struct study_result *r, const struct study_table *t) {
    const struct study *s = r->plan->study;
    const int level = reference_level(t, t->method);
    char seconds[DIGITS];
    if (level < 0) return arena_text("%s", "");
    two_digits(study_result_point(r, t, t->method, level)->wall, seconds);
    return arena_text("; the reference, %s at %s, takes %s s", s->methods.variant[t->method].name,
                      s->levels.variant[level].name, seconds);
}

char *study_advice_write(const struct study_result *r, const struct study_table *t) {
    const struct study *s = r->plan->study;
    const double floor = t->uncertainty > 0 ? t->uncertainty / t->scale : 0;
    double *work = arena_new(2 * (size_t)s->levels.n, sizeof *work);
    struct rung rung[RUNGS];
    int rungs = 0;
    for (int k = 0; k < STUDY_ROUND_ERRORS && study_iso_round(k) >= floor; k++) {
        const struct rung next = rung_of(r, t, study_iso_round(k), work);
        if (next.method < 0) break;
        if (rungs && next.method == rung[rungs - 1].method && next.level == rung[rungs - 1].level)
            rungs--; /* the same run also reaches the smaller error */
        if (rungs == RUNGS) memmove(rung, rung + 1, (size_t)(--rungs) * sizeof *rung);
        rung[rungs++] = next;
    }
    char *text = arena_text("%s", "");
    for (int k = 0; k < rungs; k++) {
        char *error = error_text(t, rung[k].at), seconds[DIGITS];
        text = arena_text("%s%s", text,
                          arena_text(k ? ", %s %s s (%s at %s)" : "%s costs %s s (%s at %s)", error,
                                     two_digits(rung[k].time, seconds), s->methods.variant[rung[k].method].name,
                                     s->levels.variant[rung[k].level].name));
    }
    if (rungs && s->methods.n > 1) text = arena_text("%s%s", text, others(r, t, &rung[rungs - 1], work));
    if (rungs && t->method >= 0) text = arena_text("%s%s", text, of_reference(r, t));
    return text;
}
