/* Reads a number from a table of a run. */
#include "program/study/gates/cell.h"
#include "base/die.h"
#include "base/text.h"
#include "base/files/folder.h"
#include "base/files/table.h"
#include "program/study/runs/quantity.h"
#include "program/study/text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* NAN and *why if the table has no such column or row; row NULL: the last. */
static double of_table(const char *path, const char *column, const char *row, const char **why) {
    struct table_data *d = table_read(path, why);
    double value = NAN;
    if (!d) return NAN;
    const int at = table_read_column(d, column);
    const double k = row ? study_text_number(row) : (double)d->rows;
    if (at < 0)
        *why = "has no such column";
    else if (k >= 1 && k <= (double)d->rows)
        value = d->value[((long)k - 1) * d->columns + at];
    else
        *why = "has no such row";
    table_read_free(d);
    return value;
}

/* The value of a row that a quantity names. */
static double of_quantity(const struct study_gates *g, char *file, char *quantity, char **why) {
    struct study_quantity q = {.name = quantity, .file = file, .row = quantity, .factor = 1};
    int wrong;
    return study_quantity_value(&q, g->runs, why, &wrong);
}

char *study_gates_cell_text(const struct study_gates *g, const struct scene_node *item,
                            const struct study_gates_name *names) {
    static const char *const key[] = {"file", "column", "row", "quantity", "factor"};
    enum { FILE_OF, COLUMN, ROW, QUANTITY, FACTOR, KEYS };
    char path[FOLDER_PATH], *text[KEYS], *said = NULL;
    const char *why = NULL;
    for (int k = 0; k < KEYS; k++) text[k] = study_gates_items_text(item, key[k], names);
    if (!text[COLUMN] == !text[QUANTITY])
        die_all(EXIT_CODE_SCENE, "%s:%d: file: give column or quantity, and not both", g->path, item->line);
    double value = text[COLUMN] ? of_table(folder_path(path, g->runs, text[FILE_OF]), text[COLUMN], text[ROW], &why)
                                : of_quantity(g, text[FILE_OF], text[QUANTITY], &said);
    if (text[FACTOR]) value *= study_text_number(text[FACTOR]);
    if (!isfinite(value))
        die_all(EXIT_CODE_FILE, "%s:%d: %s: %s", g->path, item->line, text[FILE_OF],
                said  ? said
                : why ? why
                      : "not a number");
    for (int k = 0; k < KEYS; k++) free(text[k]);
    free(said);
    return text_new("%.10g", value);
}
