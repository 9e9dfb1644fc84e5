/* Tells whether a table's rows are those that it had at a checkpoint. */
#include "base/files/table_rows.h"
#include "base/ensure.h"
#include "base/par.h"
#include "base/files/plain_file.h"
#include "base/files/table.h"

#include <errno.h>
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { HEAD = 2 }; /* lines before the rows: names and units */

/* Before the first row. */
static const uint64_t nothing = 14695981039346656037u;

static char expected_text[4096];

void table_rows_add(struct table_rows *rows, const char *row, size_t bytes) {
    uint64_t sum = rows->n == 0 ? nothing : rows->sum;
    for (size_t k = 0; k < bytes; k++) sum = (sum ^ (unsigned char)row[k]) * 1099511628211u;
    rows->sum = sum;
    rows->n++;
}

static double step_of(const char *row, int step_column) {
    for (int c = 0; c < step_column && row; c++) {
        row = strchr(row, ',');
        if (row) row++;
    }
    char *end = NULL;
    const double step = row ? strtod(row, &end) : NAN;
    return row && end != row ? step : NAN;
}

struct table_rows table_rows_copy(FILE *from, FILE *to, int step_column, long last_step,
                                  const struct table_rows *expected) {
    struct table_rows rows = {0};
    char *line = NULL;
    size_t room = 0;
    for (ssize_t n, number = 0; (n = getline(&line, &room, from)) > 0; number++) {
        if (line[n - 1] != '\n' || (expected && rows.n == expected->n)) break;
        if (number < HEAD || !(step_of(line, step_column) <= (double)last_step)) continue;
        if (to) fwrite(line, 1, (size_t)n, to);
        table_rows_add(&rows, line, (size_t)n);
    }
    free(line);
    return rows;
}

static const char *name_of(const char *path) {
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

void table_rows_describe(char *text, size_t size, const char *path, const struct table_rows *rows) {
    const size_t n = strlen(text);
    const int more = snprintf(text + n, size - n, "%s %ld %016" PRIx64 "\n", name_of(path), rows->n, rows->sum);
    ENSURE(more > 0 && n + (size_t)more < size, "the tables' rows do not fit in %zu bytes", size);
}

void table_rows_set_expected(const char *text) {
    ENSURE(strlen(text) < sizeof expected_text, "%zu bytes on tables", strlen(text));
    snprintf(expected_text, sizeof expected_text, "%s", text);
}

const struct table_rows *table_rows_expected(const char *path) {
    static struct table_rows rows;
    for (const char *line = expected_text; *line; line += strcspn(line, "\n"), line += *line == '\n') {
        char name[64];
        if (sscanf(line, "%63s %ld %" SCNx64, name, &rows.n, &rows.sum) == 3 && strcmp(name, name_of(path)) == 0)
            return &rows;
    }
    return NULL;
}

/* On rank 0: the sentence, "" if the rows are there. */
static void compare(const char *path, long step, const struct table_rows *expected, char sentence[256]) {
    const char *why = NULL;
    FILE *file = plain_file_read(path);
    if (!file && errno == ENOENT) return;
    if (!file) why = plain_file_why(errno);
    struct table_data *data = file ? table_read(path, &why) : NULL;
    if (!data) {
        snprintf(sentence, 256, "cannot be continued: %s", why);
        if (file) fclose(file);
        return;
    }
    const int column = table_read_column(data, "step");
    const struct table_rows rows = table_rows_copy(file, NULL, column < 0 ? 0 : column, step, expected);
    fclose(file);
    table_read_free(data);
    if (rows.n < expected->n)
        snprintf(sentence, 256, "has %ld rows up to step %ld, and %ld were written", rows.n, step, expected->n);
    else if (rows.sum != expected->sum)
        snprintf(sentence, 256, "has other rows up to step %ld than were written", step);
}

const char *table_rows_check(const char *path, long step) {
    static char sentence[256];
    const struct table_rows *expected = table_rows_expected(path);
    sentence[0] = '\0';
    if (par_rank() == 0 && expected) compare(path, step, expected, sentence);
    par_bcast(sentence, sizeof sentence, 0);
    return sentence[0] ? sentence : NULL;
}
