/* Keeps the rates of solids from run to run, in a file in the user's cache folder. */
#include "solid/step/rates_cache.h"
#include "base/par.h"
#include "base/files/cache.h"
#include "base/files/read_file.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MARKS = sizeof(struct solid_rates_mark) / sizeof(double), RATES = 4, NUMBERS = MARKS + RATES, LINES = 100 };
#define NAME "rates.txt"
#define HEAD "# marks of a solid, and its rates: stiffness, damping, sum, difference\n"

struct line {
    double number[NUMBERS];
};

/* Opens the file if it is one, and not a pipe, which one would wait for. */
static FILE *open_file(void) {
    char path[CACHE_PATH];
    return cache_path(path, NAME, 0) && !read_file_is_special(path) ? fopen(path, "r") : NULL;
}

/* The last LINES solids of the file, the oldest first; a line that is damaged is left out. Returns their number. */
static int read_lines(struct line all[LINES]) {
    char text[64 * NUMBERS];
    int n = 0;
    FILE *file = open_file();
    while (file && fgets(text, sizeof text, file)) {
        struct line line;
        char *at = text, *end;
        int k = 0;
        for (; k < NUMBERS; k++, at = end) {
            line.number[k] = strtod(at, &end);
            if (end == at || !isfinite(line.number[k])) break;
        }
        if (k < NUMBERS || *at != '\n') continue;
        if (n == LINES) memmove(all, all + 1, (size_t)--n * sizeof *all);
        all[n++] = line;
    }
    if (file) fclose(file);
    return n;
}

/* The rates of the newest line whose first `count` marks are these; 0: there is none. By rank 0. */
static int lookup(const struct solid_rates_mark *mark, size_t count, double rates[RATES]) {
    struct line *all = calloc(LINES, sizeof *all);
    int found = 0;
    for (int k = all ? read_lines(all) - 1 : -1; k >= 0 && !found; k--) {
        found = memcmp(all[k].number, mark, count * sizeof(double)) == 0;
        if (found) memcpy(rates, all[k].number + MARKS, RATES * sizeof(double));
    }
    free(all);
    return found;
}

static int lookup_together(const struct solid_rates_mark *mark, size_t count, double rates[RATES]) {
    int found = par_rank() == 0 && lookup(mark, count, rates);
    par_bcast(&found, sizeof found, 0);
    if (found) par_bcast(rates, RATES * sizeof(double), 0);
    return found;
}

int solid_rates_cache_like(const struct solid_rates_mark *mark) {
    double rates[RATES];
    return lookup_together(mark, SOLID_RATES_MARK, rates);
}

int solid_rates_cache_find(const struct solid_rates_mark *mark, struct solid_rates *rates) {
    double found[RATES];
    if (!lookup_together(mark, MARKS, found)) return 0;
    *rates = (struct solid_rates){.stiffness = found[0],
                                  .damping = found[1],
                                  .sum = found[2],
                                  .difference = found[3],
                                  .absolute = rates->absolute};
    return 1;
}

static void write_line(FILE *file, const struct line *line) {
    for (int k = 0; k < NUMBERS; k++) fprintf(file, "%a%c", line->number[k], k + 1 < NUMBERS ? ' ' : '\n');
}

void solid_rates_cache_add(const struct solid_rates_mark *mark, const struct solid_rates *rates) {
    struct cache_file file;
    struct line *all = par_rank() == 0 ? calloc(LINES, sizeof *all) : NULL;
    if (!all) return;
    const int n = read_lines(all);
    if (cache_begin(&file, NAME)) {
        struct line last;
        memcpy(last.number, mark, sizeof *mark);
        memcpy(last.number + MARKS, (double[RATES]){rates->stiffness, rates->damping, rates->sum, rates->difference},
               RATES * sizeof(double));
        fputs(HEAD, file.file);
        for (int k = n == LINES; k < n; k++) write_line(file.file, &all[k]);
        write_line(file.file, &last);
        cache_end(&file);
    }
    free(all);
}
