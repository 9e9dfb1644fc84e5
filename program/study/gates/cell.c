/* Reads a number from a table of a run. */
#include "program/study/gates/parts.h"
#include "base/die.h"
#include "base/arena.h"
#include "base/files/folder.h"
#include "program/study/file/parts.h"
#include "program/study/runs/curve.h"
#include "program/study/runs/quantity.h"
#include "program/study/text.h"

#include <math.h>
#include <stdlib.h>

/* The texts of an item. */
enum { FILE_OF, COLUMN, WHERE, ROW, AT, AFTER, BEFORE, ABOVE, QUANTITY, FACTOR, KEYS };
static const char *const key[KEYS] = {"file",  "column", "where", "row",      "at",
                                      "after", "before", "above", "quantity", "factor"};

static double number(const char *text, double fallback) { return text ? study_text_number(text) : fallback; }

/* The value in the row of this number, from 1. */
static double of_row(const char *path, char *const text[KEYS], char **why) {
    struct study_curve c;
    int wrong;
    const double k = study_text_number(text[ROW]);
    if (!study_curve_read(&c, path, text[COLUMN], text[WHERE], why, &wrong)) return NAN;
    const double value = k >= 1 && k <= (double)c.n ? c.x[(long)k - 1] : NAN;
    if (isnan(value)) *why = arena_text("has no such row");
    study_curve_free(&c);
    return value;
}

char *study_gates_cell_text(const struct study_gates *g, const struct scene_node *item,
                            const struct study_gates_name *names) {
    char path[FOLDER_PATH], *text[KEYS], *why = NULL;
    int wrong = 0;
    for (int k = 0; k < KEYS; k++) text[k] = study_gates_items_text(item, key[k], names);
    if (!text[COLUMN] == !text[QUANTITY])
        die_all(EXIT_CODE_SCENE, "%s:%d: file: give column or quantity, and not both", g->path, item->line);
    const int at = text[AT] ? study_quantities_at(text[AT]) : STUDY_LAST;
    if (at < 0 || (at == STUDY_TIME) != !!text[ABOVE])
        die_all(EXIT_CODE_SCENE, "%s:%d: at = %s: must be last, first, max, min, mean or time_max, or time with above",
                g->path, item->line, text[AT] ? text[AT] : "last");
    struct study_quantity q = {.name = text[QUANTITY] ? text[QUANTITY] : text[COLUMN],
                               .column = text[COLUMN],
                               .where = text[WHERE],
                               .file = text[FILE_OF],
                               .row = text[QUANTITY],
                               .at = (enum study_at)at,
                               .after = number(text[AFTER], -INFINITY),
                               .before = number(text[BEFORE], INFINITY),
                               .above = number(text[ABOVE], 0),
                               .factor = 1};
    double value = text[ROW] ? of_row(folder_path(path, g->runs, text[FILE_OF]), text, &why)
                             : study_quantity_value(&q, g->runs, &why, &wrong);
    value *= number(text[FACTOR], 1);
    if (!isfinite(value))
        die_all(EXIT_CODE_FILE, "%s:%d: %s: %s", g->path, item->line, text[FILE_OF], why ? why : "not a number");
    return arena_text("%.15g", value);
}
