/* The report of a study: NAME.csv, NAME.md, and a plot for each quantity. */
#pragma once
#include "program/study/result/result.h"

#include <stdio.h>

enum { STUDY_ROUND_ERRORS = 24 }; /* round errors, from large to small, at which run times are compared */

/* The machine and the build of the measurements. */
struct study_maker {
    char processor[128], compiler[128], flags[512], version[64], revision[64], mpi[128], fftw[128], date[32];
    int cores;
};
struct study_maker study_report_maker(void);

void study_csv_write(const struct study_result *r, const struct study_maker *maker, const char *out);
void study_page_write(const struct study_result *r, const struct study_maker *maker, const char *out);
/* Plots error against wall time, both logarithmic; marks the tables that are plotted. Returns 0 if gnuplot is missing
 * or has failed. */
int study_chart_draw(struct study_result *r, const char *out);

/* The report of a sweep: NAME.csv with medians and bands, NAME_runs.csv with the value of each run, NAME.md, and a plot
 * of each quantity against the swept key. Returns 0 if gnuplot is missing or has failed. */
int study_sweep_write(struct study_result *r, const struct study_maker *maker, const char *out);
/* The head of a table: title, machine, build, date, in lines with # before them. */
void study_csv_put_head(FILE *f, const struct study *s, const struct study_maker *m);
/* The columns of a row that name method, level with its number, quantity and unit. */
void study_csv_put_names(FILE *f, const struct study *s, const struct study_table *t, int method, int level,
                         double number);
void study_csv_put(FILE *f, double x, int digits); /* a comma and the number; nothing after it if there is none */

/* NAME, or NAME_QUANTITY if there are several quantities. */
char *study_report_name(const struct study_result *r, const struct study_table *t);
const char *study_report_status(const struct study_point *p, char status[32]); /* "done", "failed 3", "no value" */
/* The reference in words. */
char *study_report_reference(const struct study_result *r, const struct study_table *t);
/* A sentence for the user: the cheapest run below each of the smallest round errors that were reached, its wall time,
 * and what the other methods would have cost. Empty if no run reaches one. */
char *study_advice_write(const struct study_result *r, const struct study_table *t);
