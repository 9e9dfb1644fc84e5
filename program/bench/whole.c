/* Reads a whole run from its run.json. */
#include "program/bench/whole.h"
#include "base/die.h"
#include "base/files/folder.h"

#include <stdio.h>
#include <string.h>

/* By the load, and by the integrator of the last stage, in the scene beside the run.json. */
static enum bench_whole_kind kind_of(const char *path) {
    char scene[FOLDER_PATH], key[64];
    const char *slash = strrchr(path, '/'), *next;
    snprintf(scene, sizeof scene, "%.*sscene.resolved.yaml", slash ? (int)(slash - path) + 1 : 0, path);
    struct json_read *tree = json_read_new(scene);
    const char *load = json_read_text(tree, "coupling.load"), *last = "rk3";
    for (int k = 0; snprintf(key, sizeof key, "stages.%d.integrator", k), (next = json_read_text(tree, key)); k++)
        last = next;
    const enum bench_whole_kind kind = load && !strcmp(load, "reaction") ? BENCH_WHOLE_ECONOMICAL
                                       : strcmp(last, "verlet") != 0     ? BENCH_WHOLE_RK3
                                                                         : BENCH_WHOLE_VERLET;
    json_read_free(tree);
    return kind;
}

struct bench_whole bench_whole_read(const char *path) {
    struct bench_whole w = {.kind = kind_of(path), .record = json_read_new(path)};
    if (!w.record) die(EXIT_CODE_FILE, "%s: cannot be read", path);
    const char *status = json_read_text(w.record, "status");
    w.wall_seconds = bench_whole_number(&w, "wall_seconds");
    w.ranks = bench_whole_number(&w, "ranks");
    const double from = bench_whole_number(&w, "resumed_at_step");
    w.from = from > 0 ? (long)from : 0;
    if (!status || strcmp(status, "done") != 0 || !(w.wall_seconds > 0))
        die(EXIT_CODE_FILE, "%s: is not of a run that is done", path);
    return w;
}

void bench_whole_free(struct bench_whole *w) { json_read_free(w->record); }

double bench_whole_number(const struct bench_whole *w, const char *path) { return json_read_number(w->record, path); }

double bench_whole_of_stage(const struct bench_whole *w, const char *stage, const char *path) {
    char key[128];
    const char *span = "";
    int k = 0;
    while (snprintf(key, sizeof key, "timeline.%d.span", k), (span = json_read_text(w->record, key))) {
        if (!strcmp(span, stage)) break;
        k++;
    }
    snprintf(key, sizeof key, "timeline.%d.%s", k, path);
    return bench_whole_number(w, key);
}

double bench_whole_part(const struct bench_whole *w, const char *stage, const char *part) {
    char working[64], waiting[64];
    snprintf(working, sizeof working, "working.%s", part);
    snprintf(waiting, sizeof waiting, "waiting.%s", part);
    return bench_whole_of_stage(w, stage, working) + bench_whole_of_stage(w, stage, waiting);
}

double bench_whole_sweeps(const struct bench_whole *w) {
    return 1e9 * bench_whole_number(w, "wall_seconds_by_part.solid") * w->ranks /
           (bench_whole_number(w, "ns_per_directed_bond_sweep") * bench_whole_number(w, "directed_bonds"));
}
