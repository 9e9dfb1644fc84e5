/* The rows that each table had at a checkpoint: how many, and their checksum. A resumed run goes on with a table only
 * if its first rows are these, whatever has been written after them. */
#pragma once
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

struct table_rows {
    long n;
    uint64_t sum; /* of their bytes, FNV-1a (Fowler, Noll, Vo) */
};

/* A row of so many bytes follows, its end of line included. Not collective, as those below but for table_rows_check.
 */
void table_rows_add(struct table_rows *rows, const char *row, size_t bytes);
/* Copies the rows of a table that are to stay: those whose step is at most last_step, and of these as many as expected
 * has (NULL: all). A last row without an end of line was cut off by a crash, and is dropped. from: at its first line.
 * to: NULL: they are only counted. */
struct table_rows table_rows_copy(FILE *from, FILE *to, int step_column, long last_step,
                                  const struct table_rows *expected);

/* Adds the rows of a table to the text of a checkpoint: "series.csv 10 00c0ffee00c0ffee\n". */
void table_rows_describe(char *text, size_t size, const char *path, const struct table_rows *rows);
/* The text of the checkpoint that is resumed; "": it has none. The same on every rank. */
void table_rows_set_expected(const char *text);
/* The rows of this table at the checkpoint; NULL: the checkpoint has none of it. Borrowed until the next call. */
const struct table_rows *table_rows_expected(const char *path);
/* NULL if the first rows of the table are those of the checkpoint at this step, else a sentence. A file that is
 * missing, or of which the checkpoint does not know, passes. The same on every rank. Collective. */
const char *table_rows_check(const char *path, long step);
