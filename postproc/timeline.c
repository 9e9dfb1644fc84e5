/* Prints the timeline of run.json: seconds by part of the program and by span of the run, and how much was waiting. */
#include "postproc/timeline.h"
#include "base/arena.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CELL = 64, SPANS = 14, PATH = 160 };

struct cells {
    int n, m;
    char (*text)[CELL]; /* [n][m] */
};

static double seconds_of(const struct json_read *t, int span, const char *kind, const char *part) {
    char path[PATH];
    snprintf(path, sizeof path, "timeline.%d.%s.%s", span, kind, part);
    const double value = json_read_number(t, path);
    return isnan(value) ? 0 : value;
}

/* "12.3", or "12.3, 31 % waiting"; empty: nothing. */
static void put(char text[CELL], double working, double waiting) {
    const double sum = working + waiting;
    if (!(sum > 0)) return;
    if (waiting < 0.005 * sum)
        snprintf(text, CELL, "%.3g", sum);
    else
        snprintf(text, CELL, "%.3g, %.0f %% waiting", sum, 100 * waiting / sum);
}

/* A row: a part's seconds in each span, and in all; part NULL: of all parts. */
static void row(struct cells *c, int at, const struct json_read *t, const char *part) {
    char(*text)[CELL] = c->text + (size_t)at * (size_t)c->m;
    double all[2] = {0, 0};
    snprintf(text[0], CELL, "%s", part ? part : "all");
    for (int s = 0; s < c->m - 2; s++) {
        double sums[2] = {0, 0};
        const char *key;
        for (int k = 0; (key = json_read_key(t, "timeline.0.working", k)); k++) {
            if (part && strcmp(part, key)) continue;
            sums[0] += seconds_of(t, s, "working", key);
            sums[1] += seconds_of(t, s, "waiting", key);
        }
        put(text[1 + s], sums[0], sums[1]);
        for (int k = 0; k < 2; k++) all[k] += sums[k];
    }
    put(text[c->m - 1], all[0], all[1]);
}

void postproc_timeline_report(struct postproc_report *report, const struct json_read *t) {
    char path[PATH];
    struct cells c = {.n = 2, .m = 2};
    const char *name, *part;
    for (; c.m - 2 < SPANS; c.m++) {
        snprintf(path, sizeof path, "timeline.%d.span", c.m - 2);
        if (!json_read_text(t, path)) break;
    }
    if (c.m == 2) return;
    while (json_read_key(t, "timeline.0.working", c.n - 2)) c.n++;
    c.text = arena_new((size_t)c.n * (size_t)c.m, sizeof *c.text);
    const char **cell = arena_new((size_t)c.n * (size_t)c.m, sizeof *cell);
    snprintf(c.text[0], CELL, "seconds, mean over the ranks");
    for (int s = 0; s < c.m - 2; s++) {
        snprintf(path, sizeof path, "timeline.%d.span", s);
        if ((name = json_read_text(t, path))) snprintf(c.text[1 + s], CELL, "%s", name);
    }
    snprintf(c.text[c.m - 1], CELL, "all");
    for (int k = 0; (part = json_read_key(t, "timeline.0.working", k)); k++) row(&c, 1 + k, t, part);
    row(&c, c.n - 1, t, NULL);
    for (int k = 0; k < c.n * c.m; k++) cell[k] = c.text[k];
    postproc_report_table(report, c.n, c.m, cell);
}
