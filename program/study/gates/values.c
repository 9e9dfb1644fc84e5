/* Looks up cells of the tables of studies and measured numbers. */
#include "program/study/gates/parts.h"
#include "base/die.h"
#include "base/arena.h"
#include "base/files/folder.h"
#include "base/files/read_file.h"
#include "program/study/expression.h"
#include "program/study/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PARTS = 5, CELLS = 64 };

/* The text of a key in measured.csv; NULL: there is none. */
static char *measured(const char *file, const char *key) {
    char *text = read_file(file), *rest = text, *head = arena_text("\"%s\",", key), *found = NULL;
    for (char *line; !found && (line = strsep(&rest, "\n"));)
        if (!strncmp(line, head, strlen(head))) found = arena_text("%s", line + strlen(head));
    free(text);
    return found;
}

/* The cell in the row of the method, level and quantity; NULL: none. */
static char *cell_of(char *text, char *const part[PARTS]) {
    const char *column = part[4] ? part[4] : "value";
    int at = -1;
    for (char *line; (line = strsep(&text, "\n"));) {
        if (*line == '#' || !*line) continue;
        char *cell[CELLS];
        int n = 0;
        while (line && n < CELLS) cell[n++] = study_text_cell(&line);
        const int is_head = at < 0;
        for (int c = 0; is_head && c < n; c++)
            if (!strcmp(cell[c], column)) at = c;
        if (is_head && at < 0) return NULL;
        if (!is_head && n > 3 && at < n && !strcmp(cell[0], part[1]) && !strcmp(cell[1], part[2]) &&
            !strcmp(cell[3], part[3]))
            return arena_text("%s", cell[at]);
    }
    return NULL;
}

/* What the text between brackets stands for. */
static char *looked_up(const struct study_gates_values *v, const char *reference, int line) {
    char *copy = arena_text("%s", reference), *rest = copy, *part[PARTS] = {NULL}, *found = NULL;
    int n = 0;
    while (rest && n < PARTS) part[n++] = strsep(&rest, "|");
    if (n == 1) found = measured(v->measured, reference);
    if (n > 3 && !rest) {
        char path[FOLDER_PATH], *name = arena_text("%s.csv", part[0]);
        char *table = read_file(folder_path(path, v->tables, name));
        if (table) found = cell_of(table, part);
        free(table);
    }
    if (!found)
        die_all(EXIT_CODE_FILE, "%s:%d: [%s]: is not in %s", v->path, line, reference,
                n == 1 ? v->measured : v->tables);
    return found;
}

struct place {
    const struct study_gates_values *v;
    int line;
};

static double number_of(const char *reference, const void *with) {
    const struct place *p = with;
    char *text = looked_up(p->v, reference, p->line);
    const double value = study_text_number(text);
    return value;
}

char *study_gates_values_text(const struct study_gates_values *v, const char *text, int line) {
    const size_t length = strlen(text);
    const char *end = strchr(text, ']');
    if (*text == '[' && end == text + length - 1) {
        char *reference = arena_text("%.*s", (int)length - 2, text + 1), *found = looked_up(v, reference, line);
        return found;
    }
    const struct place place = {v, line};
    const char *why = NULL;
    const double value = study_expression_value(text, number_of, &place, &why);
    if (why) die_all(EXIT_CODE_SCENE, "%s:%d: %s: %s", v->path, line, text, why);
    return arena_text("%.12g", value);
}
