/* Reads the run time of a whole run from its run.json. */
#include "program/bench/whole.h"
#include "base/die.h"
#include "base/files/folder.h"
#include "base/files/whole.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Copies the text behind "key": in a line of the file, without quotes and commas. Returns whether the key was found, at
 * the beginning of a word. */
static int value_of(const char *line, const char *key, char *to, size_t size) {
    const char *at = strstr(line, key);
    while (at && at > line && (isalnum((unsigned char)at[-1]) || at[-1] == '_')) at = strstr(at + 1, key);
    if (!at) return 0;
    at += strlen(key);
    at += strspn(at, "\": ");
    snprintf(to, size, "%.*s", (int)strcspn(at, "\",\r\n"), at);
    return 1;
}

/* By the load and the integrator of the last stage that names one, in the scene beside the run.json. */
static enum bench_whole_kind kind_of(const char *path) {
    char scene[FOLDER_PATH], line[1024], word[64] = "rk3", load[64] = "";
    const char *slash = strrchr(path, '/');
    const int folder = slash ? (int)(slash - path) + 1 : 0;
    snprintf(scene, sizeof scene, "%.*sscene.resolved.yaml", folder, path);
    FILE *file = fopen(scene, "r");
    while (file && fgets(line, sizeof line, file)) {
        value_of(line, "integrator:", word, sizeof word);
        value_of(line, "load:", load, sizeof load);
    }
    if (file) fclose(file);
    if (!strncmp(load, "reaction", 8)) return BENCH_WHOLE_ECONOMICAL;
    return strncmp(word, "verlet", 6) ? BENCH_WHOLE_RK3 : BENCH_WHOLE_VERLET;
}

struct bench_whole bench_whole_read(const char *path) {
    struct bench_whole whole = {.kind = kind_of(path)};
    char line[1024], text[64], status[64] = "";
    FILE *file = whole_is_no_file(path) ? NULL : fopen(path, "r");
    if (!file) die(EXIT_CODE_FILE, "%s: cannot be opened", path);
    while (fgets(line, sizeof line, file)) {
        if (strstr(line, "\"wall_seconds\"") && value_of(line, "\"wall_seconds\"", text, sizeof text))
            whole.wall_seconds = strtod(text, NULL);
        if (strstr(line, "\"ranks\"") && value_of(line, "\"ranks\"", text, sizeof text))
            whole.ranks = strtod(text, NULL);
        if (value_of(line, "\"resumed_at_step\"", text, sizeof text)) whole.from = strtol(text, NULL, 10);
        value_of(line, "\"title\"", whole.title, sizeof whole.title);
        value_of(line, "\"status\"", status, sizeof status);
    }
    fclose(file);
    if (strcmp(status, "done") || whole.wall_seconds <= 0)
        die(EXIT_CODE_FILE, "%s: is not of a run that is done", path);
    whole.text = whole_new(path);
    return whole;
}

void bench_whole_free(struct bench_whole *w) { free(w->text); }

double bench_whole_number(const struct bench_whole *w, const char *path) {
    const char *at = w->text;
    for (const char *key = path; at && *key; key += strcspn(key, "/"), key += *key == '/') {
        char quoted[64];
        snprintf(quoted, sizeof quoted, "\"%.*s\"", (int)strcspn(key, "/"), key);
        at = strstr(at, quoted);
        if (at) at += strlen(quoted);
    }
    if (!at || *at != ':') return NAN;
    char *end;
    const double number = strtod(at + 1, &end);
    return end > at + 1 ? number : NAN;
}

double bench_whole_part(const struct bench_whole *w, const char *stage, const char *part) {
    char path[128];
    double sum = 0;
    for (int waiting = 0; waiting < 2; waiting++) {
        snprintf(path, sizeof path, "timeline/%s/%s/%s", stage, waiting ? "waiting" : "working", part);
        sum += bench_whole_number(w, path);
    }
    return sum;
}

double bench_whole_sweeps(const struct bench_whole *w) {
    return 1e9 * bench_whole_number(w, "wall_seconds_by_part/solid") * w->ranks /
           (bench_whole_number(w, "ns_per_directed_bond_sweep") * bench_whole_number(w, "directed_bonds"));
}
