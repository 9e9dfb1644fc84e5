/* A curve from a table of a run: a column, or arithmetic with columns, in the rows that are asked for. */
#pragma once

struct study_curve {
    long n;
    double *t, *x; /* [n], owned; t: the table's column t, or the number of the row from 1 where it has none */
};

/* column: a name, or arithmetic with names in brackets, such as [e_strain] + [e_kinetic_solid]. where: NULL, or
 * COLUMN = VALUE: only the rows with this number. Returns 1; or 0 with *why, and *wrong 1 if it is the
 * table that has no such column. */
int study_curve_read(struct study_curve *c, const char *path, const char *column, const char *where, char **why,
                     int *wrong);
void study_curve_free(struct study_curve *c);
