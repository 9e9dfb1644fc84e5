/* Judges the numbers of a case and writes them to tables. */
#include "base/die.h"
#include "base/arena.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"
#include "base/files/read_file.h"
#include "program/study/gates/parts.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char head_of_summary[] = "quantity,unit,ours,reference,source,tolerance,pass\n";
static const char head_of_shown[] = "quantity,unit,ours,reference,source\n";

struct judge {
    const struct study_gates *g;
    struct study_gates_values values;
    int digits;
    FILE *summary, *shown; /* in memory */
    int any_shown;
};

static const char *or_empty(const char *text) { return text ? text : ""; }

/* Arithmetic if the text holds a bracket; text may be NULL. */
static char *evaluated(const struct judge *j, char *text, int line) {
    return text && strchr(text, '[') ? study_gates_values_text(&j->values, text, line) : text;
}

/* Reads the gate's one rule and its limits. */
static void read_rule(const struct judge *j, struct study_gates_gate *gate, const struct scene_node *item,
                      const struct study_gates_name *names) {
    static const char *const key[] = {"", "relative", "between", "at_least", "at_most", "same"};
    for (int rule = STUDY_GATES_RELATIVE; rule <= STUDY_GATES_SAME; rule++) {
        if (!scene_node_child(item, key[rule])) continue;
        if (gate->rule)
            die_all(EXIT_CODE_SCENE, "%s:%d: a gate has one rule, and not both %s and %s", j->g->path, item->line,
                    key[gate->rule], key[rule]);
        gate->rule = (enum study_gates_rule)rule;
    }
    char *low = study_gates_items_text(item, key[gate->rule], names), *high = NULL;
    const struct scene_node *between = scene_node_child(item, "between");
    if (between && between->kind == SCENE_NODE_LIST && between->n == 2) {
        struct scene_node *pair = scene_node_new(SCENE_NODE_MAPPING, NULL, NULL);
        scene_node_append(pair, scene_node_new(SCENE_NODE_SCALAR, "low", between->child[0]->value));
        scene_node_append(pair, scene_node_new(SCENE_NODE_SCALAR, "high", between->child[1]->value));
        low = study_gates_items_text(pair, "low", names);
        high = study_gates_items_text(pair, "high", names);
        scene_node_free(pair);
    }
    gate->limit = evaluated(j, low, item->line);
    gate->high = evaluated(j, high, item->line);
}

static void judge_item(const struct scene_node *item, const struct study_gates_name *names, void *with) {
    struct judge *j = with;
    char *quantity = study_gates_items_text(item, "quantity", names),
         *unit = study_gates_items_text(item, "unit", names), *ours = study_gates_items_text(item, "ours", names),
         *reference = study_gates_items_text(item, "reference", names),
         *source = study_gates_items_text(item, "source", names);
    if (!quantity || !ours) die_all(EXIT_CODE_SCENE, "%s:%d: a gate needs quantity and ours", j->g->path, item->line);
    if (!strchr(ours, '['))
        die_all(EXIT_CODE_SCENE, "%s:%d: ours = %s: a gate needs a number in brackets", j->g->path, item->line, ours);
    struct study_gates_gate gate = {.digits = j->digits};
    char *value = study_gates_values_text(&j->values, ours, item->line);
    read_rule(j, &gate, item, names);
    gate.quantity = quantity;
    gate.unit = unit ? unit : "1";
    gate.ours = value;
    gate.reference = or_empty(evaluated(j, reference, item->line));
    gate.source = or_empty(source);
    if (gate.rule == STUDY_GATES_BETWEEN && !gate.high)
        die_all(EXIT_CODE_SCENE, "%s:%d: between must be a list of two numbers", j->g->path, item->line);
    j->any_shown |= gate.rule == STUDY_GATES_SHOWN;
    study_gates_verdict_put(gate.rule == STUDY_GATES_SHOWN ? j->shown : j->summary, &gate);
}

/* The quantity of a line that ends in ",no", with the comma after it; NULL: another line. */
static char *missed(const char *line) {
    const size_t length = strlen(line);
    if (length < 3 || strcmp(line + length - 3, ",no") != 0) return NULL;
    size_t end = 0;
    for (int quoted = 0; line[end] && (quoted || line[end] != ','); end++) quoted ^= line[end] == '"';
    return arena_text("%.*s", (int)end + 1, line);
}

static int holds_miss(const char *table, const char *quantity) {
    char *copy = arena_text("%s", table), *rest = copy;
    int found = 0;
    for (char *line; (line = strsep(&rest, "\n"));) {
        char *its = missed(line);
        found |= its && !strcmp(its, quantity);
    }
    return found;
}

/* Misses of the summary that the known one does not have, or that have left their range; known and ranges, the text of
 * misses.csv, may be NULL. */
static int count_misses(char *summary, const char *known, const char *ranges) {
    int n = 0;
    for (char *line; (line = strsep(&summary, "\n"));) {
        char *quantity = missed(line);
        const int is_new = quantity && !(known && holds_miss(known, quantity)),
                  is_worse = quantity && !is_new && ranges && !study_gates_misses_hold(ranges, line);
        if (is_new && known) fprintf(stderr, "missed here, met in results/summary.csv: %s\n", quantity);
        if (is_worse) fprintf(stderr, "missed by more than misses.csv allows: %s\n", line);
        n += is_new || is_worse;
    }
    return n;
}

static void put_file(const struct study_gates *g, const char *name, const char *text) {
    char path[FOLDER_PATH];
    struct atomic_write a;
    atomic_write_begin(&a, folder_path(path, g->results, name));
    fputs(text, a.file);
    atomic_write_end(&a);
    fputs(text, stdout);
}

/* results/summary.csv beside the file if its misses are known ones; else NULL. */
static char *known_of(const struct study_gates *g) {
    char path[FOLDER_PATH], *beside = arena_text("%s/results", g->folder), *real = arena_keep(realpath(beside, NULL)),
                            *ours = arena_keep(realpath(g->results, NULL));
    const int same = real && ours && !strcmp(real, ours);
    return same && !g->quick ? NULL : arena_keep(read_file(folder_path(path, beside, "summary.csv")));
}

int study_gates_judge(const struct study_gates *g) {
    char *summary = NULL, *shown = NULL, path[FOLDER_PATH];
    size_t bytes[2];
    const struct scene_node *digits = scene_node_child(g->root, "digits");
    struct judge j = {.g = g,
                      .values = {g->path, g->collects ? g->results : g->runs, g->measured},
                      .digits = digits ? atoi(digits->value) : 10,
                      .summary = open_memstream(&summary, &bytes[0]),
                      .shown = open_memstream(&shown, &bytes[1])};
    fputs(head_of_summary, j.summary);
    fputs(head_of_shown, j.shown);
    const struct study_gates_visit visit = {judge_item, &j, "gates", g->quick};
    study_gates_items_visit(scene_node_child(g->root, "gates"), NULL, &visit);
    fclose(j.summary);
    fclose(j.shown);
    arena_keep(summary);
    arena_keep(shown);
    const char *name = g->quick ? "quick_shown.csv" : "shown.csv";
    unlink(folder_path(path, g->results, name));
    char *known = known_of(g);
    put_file(g, g->quick ? "quick.csv" : "summary.csv", summary);
    if (j.any_shown) put_file(g, name, shown);
    char *ranges = arena_keep(read_file(folder_path(path, g->folder, "misses.csv")));
    const int missing = count_misses(summary, known, ranges);
    return missing;
}
