/* What a user can act on: the cheapest setting for each round error, in one sentence. */
#include "study/iso.h"
#include "study/report.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUND_ERRORS = 24, RUNGS = 3 };

/* The cheapest run of all methods that stays below an error. */
struct rung {
    double at, time;
    int method, level;
};

static struct rung rung_of(const struct study_result *r, const struct study_table *t, double at,
                           double *work) {
    const struct study *s = r->plan->study;
    struct rung best = {.at = at, .time = NAN, .method = -1, .level = -1};
    for (int m = 0; m < s->methods.n; m++) {
        study_result_curve(r, t, m, work, work + s->levels.n);
        const int l = study_iso_cheapest(s->levels.n, work, work + s->levels.n, at);
        if (l < 0 || (best.method >= 0 && work[s->levels.n + l] >= best.time)) continue;
        best = (struct rung){at, work[s->levels.n + l], m, l};
    }
    return best;
}

static char *error_text(const struct study_table *t, double error) {
    return t->has_scale ? scene_text("%.3g %%", 100 * error) : scene_text("%.3g", error);
}

static char *joined(char *a, char *b) {
    char *both = scene_text("%s%s", a, b);
    free(a);
    free(b);
    return both;
}

/* What the other methods would have cost at the last rung's error. */
static char *others(const struct study_result *r, const struct study_table *t, const struct rung *last,
                    double *work) {
    const struct study *s = r->plan->study;
    char *text = scene_text("%s", ""), *error = error_text(t, last->at);
    int said = 0;
    for (int m = 0; m < s->methods.n; m++) {
        if (m == last->method) continue;
        study_result_curve(r, t, m, work, work + s->levels.n);
        const int l = study_iso_cheapest(s->levels.n, work, work + s->levels.n, last->at);
        char *lead = said++ ? scene_text(", ") : scene_text("; at %s ", error);
        text = joined(text, lead);
        const char *name = s->methods.variant[m].name;
        text = joined(text, l < 0 ? scene_text("%s does not get there", name)
                                  : scene_text("%s takes %.2g times as long", name,
                                               work[s->levels.n + l] / last->time));
    }
    free(error);
    return text;
}

char *study_report_advice(const struct study_result *r, const struct study_table *t) {
    const struct study *s = r->plan->study;
    const double floor = t->uncertainty > 0 ? t->uncertainty / t->scale : 0;
    double *work = malloc(2 * (size_t)s->levels.n * sizeof *work);
    struct rung rung[RUNGS];
    int rungs = 0;
    for (int k = 0; k < ROUND_ERRORS && study_iso_round(k) >= floor; k++) {
        const struct rung next = rung_of(r, t, study_iso_round(k), work);
        if (next.method < 0) break;
        if (rungs && next.method == rung[rungs - 1].method && next.level == rung[rungs - 1].level)
            rungs--; /* the same run reaches more */
        if (rungs == RUNGS) memmove(rung, rung + 1, (size_t)(--rungs) * sizeof *rung);
        rung[rungs++] = next;
    }
    char *text = scene_text("%s", "");
    for (int k = 0; k < rungs; k++) {
        char *error = error_text(t, rung[k].at);
        text = joined(text, scene_text(k ? ", %s %.2g s (%s at %s)" : "%s costs %.2g s (%s at %s)", error,
                                       rung[k].time, s->methods.variant[rung[k].method].name,
                                       s->levels.variant[rung[k].level].name));
        free(error);
    }
    if (rungs && s->methods.n > 1) text = joined(text, others(r, t, &rung[rungs - 1], work));
    free(work);
    return text;
}
