/* Tables whose columns are given as a text. */
#include "base/files/table_columns.h"
#include "base/ensure.h"
#include "base/files/folder.h"

#include <stdio.h>
#include <string.h>

enum { COLUMNS_MAX = 32, WORD = 32 };

/* Names and units of columns; returns how many there are. */
static int read_columns(const char *columns, int dim, char name[COLUMNS_MAX][WORD], char unit[COLUMNS_MAX][WORD]) {
    int n = 0;
    for (const char *at = columns; *at; at += strcspn(at, "|"), at += *at == '|') {
        char column[WORD], its[WORD];
        ENSURE(sscanf(at, "%31s %31[^|]", column, its) == 2, "columns %s", columns);
        char *star = strchr(column, '*');
        for (int c = 0; c < (star ? dim : 1); c++, n++) {
            ENSURE(n < COLUMNS_MAX, "more than %d columns", COLUMNS_MAX);
            if (star) *star = "xyz"[c];
            strcpy(name[n], column);
            strcpy(unit[n], its);
        }
    }
    return n;
}

int table_columns_count(const char *columns, int dim) {
    char text[2][COLUMNS_MAX][WORD];
    return read_columns(columns, dim, text[0], text[1]);
}

struct table *table_columns_new(const char *folder, const char *file, const char *columns, int dim, long resume_step) {
    char text[2][COLUMNS_MAX][WORD], path[FOLDER_PATH];
    const char *name[COLUMNS_MAX], *unit[COLUMNS_MAX];
    const int n = read_columns(columns, dim, text[0], text[1]);
    for (int k = 0; k < n; k++) {
        name[k] = text[0][k];
        unit[k] = text[1][k];
    }
    return table_new(folder_path(path, folder, file), n, name, unit, resume_step);
}
