/* A table that grows by a row or more a sample: CSV with a row of names and a row of units behind '#'. table_row
 * returns once the row is in the file, so that a killed run loses no row.
 *
 *     step,t,dt
 *     #1,s,s
 *     10,0.00335,0.000335 */
#pragma once
#include <stddef.h>

struct table; /* opaque, owned by the caller */

/* resume_step < 0: a new table, which replaces an old one. Otherwise the old table is cut back to the rows that the
 * checkpoint knows (base/files/table_rows.h) or, if it does not say, to those whose step is at most resume_step, and
 * continued; the step is in the column of that name, or else in the first. A missing file is begun, which the log says;
 * a file with other columns is refused. Dies with exit code 4. Collective. */
struct table *table_new(const char *path, int columns, const char *const *name, const char *const *unit,
                        long resume_step);
/* What a checkpoint of this step stores of all open tables: a text, the same on every rank. Collective. */
void table_all_rows(long step, char *text, size_t size);
/* value [columns], to 15 digits; NaN is written "nan". Rank 0 writes, others return at once. Not collective. */
void table_row(struct table *t, const double *value);
/* The same for one of several rows; table_flush follows, after which all of them are in the file. */
void table_add(struct table *t, const double *value);
void table_flush(struct table *t);
/* The number that a reader of the table finds for this value, which has 15 digits. Not collective. */
double table_written(double value);
void table_free(struct table *t);

/* A table read back. */
struct table_data {
    int columns;
    long rows;
    char **name, **unit; /* [columns], owned */
    double *value;       /* [rows][columns], owned */
};

/* NULL if the file is missing or is not a table; *error (may be NULL) then says why. Not collective. */
struct table_data *table_read(const char *path, const char **error);
int table_read_column(const struct table_data *d, const char *name); /* -1: none */
void table_read_free(struct table_data *d);
