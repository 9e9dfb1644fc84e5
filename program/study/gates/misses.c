/* Reads how far a known miss may go. */
#include "program/study/gates/parts.h"
#include "base/arena.h"
#include "program/study/text.h"

#include <math.h>
#include <string.h>

enum { CELLS = 8 };

/* Splits a copy of the line, which the caller frees. Returns the number of cells; those that are not there are "". */
static int split(char *copy, const char *cell[CELLS]) {
    int n = 0;
    while (copy && n < CELLS) cell[n++] = study_text_cell(&copy);
    for (int k = n; k < CELLS; k++) cell[k] = "";
    return n;
}

/* Without a range the row has no number, and may not get a wrong one. */
static int is_within(const char *ours, const char *low, const char *high) {
    const double x = study_text_number(ours);
    if (!*low) return !*ours;
    return isfinite(x) && x >= study_text_number(low) && (!strcmp(high, "inf") || x <= study_text_number(high));
}

int study_gates_misses_hold(const char *table, const char *line) {
    const char *row[CELLS], *cell[CELLS];
    char *copy = arena_text("%s", table), *rest = copy, *its = arena_text("%s", line);
    int held = 0;
    split(its, row);
    for (char *next; !held && (next = strsep(&rest, "\n"));)
        held = split(next, cell) > 2 && !strcmp(cell[0], row[0]) && is_within(row[2], cell[1], cell[2]);
    return held;
}
