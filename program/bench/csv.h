/* A CSV file as text: reads the tables that a bench has written. */
#pragma once

struct bench_csv {
    int columns, rows;
    char **name; /* [columns], owned */
    char **cell; /* [rows][columns], owned */
};

/* Appends the rows of another file with the same columns to `cells`, which is NULL at first. Dies with exit code 4 on a
 * file that is missing or has other columns. Not collective. */
struct bench_csv *bench_csv_read(struct bench_csv *cells, const char *path);
void bench_csv_free(struct bench_csv *cells);

/* "" if there is no such row or column. row may be -1. */
const char *bench_csv_text(const struct bench_csv *cells, int row, const char *column);
double bench_csv_number(const struct bench_csv *cells, int row, const char *column); /* NAN: none */
/* The first row with this part, size ("": any) and number of ranks (0: any), or -1. Repeated measurements follow the
 * first one. */
int bench_csv_find(const struct bench_csv *cells, const char *part, const char *size, int ranks);
