/* Reads a measured quantity from a run folder: from a table, a file, or a command's output. */
#include "program/study/runs/quantity.h"
#include "base/arena.h"
#include "base/files/folder.h"
#include "base/files/read_file.h"
#include "scene/text/yaml.h"
#include "program/study/runs/child.h"
#include "program/study/runs/curve.h"
#include "program/study/runs/window.h"
#include "program/study/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WHY(...) (*why = arena_text(__VA_ARGS__))

static double of_table(const struct study_quantity *q, const char *folder, char **why, int *wrong) {
    char path[FOLDER_PATH];
    struct study_curve c;
    folder_path(path, folder, q->file ? q->file : "series.csv");
    if (!study_curve_read(&c, path, q->column, q->where, why, wrong)) return NAN;
    const struct study_samples s = {c.n, 1, c.t, c.x};
    const double value = study_window(&s, q->at, q->after, q->before, q->above);
    if (!isfinite(value)) WHY("%s: column %s has no such value in the rows asked for", path, q->column);
    study_curve_free(&c);
    return value;
}

/* The row of that quantity, in the column value (or ours, in a case's summary). */
static double of_csv(const struct study_quantity *q, const char *path, char *text, char **why) {
    int name = -1, number = -1;
    for (char *line; (line = strsep(&text, "\n"));) {
        if (!*line || *line == '#') continue;
        line[strcspn(line, "\r")] = '\0';
        const int header = name < 0;
        const char *its = NULL, *value = NULL;
        for (int c = 0; line; c++) {
            const char *word = study_text_cell(&line);
            if (header && !strcmp(word, "quantity")) name = c;
            if (header && (!strcmp(word, "value") || !strcmp(word, "ours"))) number = c;
            if (!header && c == name) its = word;
            if (!header && c == number) value = word;
        }
        if (name < 0 || number < 0) break;
        if (its && !strcmp(its, q->row)) return study_text_number(value);
    }
    if (name < 0 || number < 0)
        WHY("%s: its first line names no columns quantity and value", path);
    else
        WHY("%s: has no quantity %s", path, q->row);
    return NAN;
}

static double of_file(const struct study_quantity *q, const char *folder, char **why) {
    char path[FOLDER_PATH];
    const char *ending = strrchr(q->file, '.');
    folder_path(path, folder, q->file);
    if (ending && !strcmp(ending, ".json")) {
        struct scene_node *root = scene_yaml_read(path);
        const struct scene_node *node = root ? scene_node_find(root, q->row) : NULL;
        const double value = node && node->kind == SCENE_NODE_SCALAR ? study_text_number(node->value) : NAN;
        if (isnan(value)) WHY("%s: %s", path, root ? "has no such number" : "cannot be read");
        scene_node_free(root);
        return value;
    }
    char *text = arena_keep(read_file(path));
    if (!text) WHY("%s: cannot be read", path);
    return text ? of_csv(q, path, text, why) : NAN;
}

/* The last line printed by a shell command run in the run folder. */
static double of_command(const struct study_quantity *q, const char *folder, char **why) {
    char shell[] = "/bin/sh", option[] = "-c", output[FOLDER_PATH], errors[FOLDER_PATH];
    char *const argv[] = {shell, option, q->command, NULL};
    folder_path(output, folder, arena_text("quantity_%s.txt", study_text_slug(q->name)));
    const int code =
        study_child_run(&(struct study_child){argv, folder, output, folder_path(errors, folder, "screen.log")});
    char *text = code == 0 ? arena_keep(read_file(output)) : NULL;
    double value = NAN;
    if (text) {
        size_t end = strlen(text);
        while (end > 0 && strchr(" \t\r\n", text[end - 1])) text[--end] = '\0';
        const char *line = strrchr(text, '\n');
        value = study_text_number(line ? line + 1 : text);
    }
    if (code != 0)
        WHY("%s: the command of %s ended with exit code %d; what it said is in screen.log", folder, q->name, code);
    else if (!isfinite(value))
        WHY("%s: the last line of the command of %s is not a number; it is in %s", folder, q->name, output);
    return value;
}

double study_quantity_value(const struct study_quantity *q, const char *folder, char **why, int *wrong) {
    *wrong = 0;
    *why = NULL;
    const double value = q->column ? of_table(q, folder, why, wrong)
                         : q->file ? of_file(q, folder, why)
                                   : of_command(q, folder, why);
    if (!isfinite(value) && !*why) WHY("%s: %s is not a number", folder, q->name);
    return isfinite(value) ? q->factor * value : NAN;
}
