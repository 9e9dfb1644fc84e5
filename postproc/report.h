/* The report as Markdown and as HTML, with the same content. */
#pragma once
#include "postproc/facts.h"

struct postproc_report; /* opaque: the two open files */

/* Opens folder/report.md and folder/report.html. NULL if they cannot be written (errno). */
struct postproc_report *postproc_report_begin(const char *folder, const char *title);
void postproc_report_heading(struct postproc_report *r, const char *text);
void postproc_report_text(struct postproc_report *r, const char *text);
/* Facts first <= i < last as a table of quantity, value, unit. */
void postproc_report_facts(struct postproc_report *r, const struct postproc_facts *f, int first, int last);
/* A PNG of the folder, path relative to it. The HTML page holds its bytes, and needs no other file. */
void postproc_report_image(struct postproc_report *r, const char *path, const char *title);
/* Pictures of a film, of which the page shows one at a time, with a slider. */
void postproc_report_film(struct postproc_report *r, int n, const char *const *path, const char *title);
/* A table of n rows and m columns, cell by cell, the first row a header. */
void postproc_report_table(struct postproc_report *r, int n, int m, const char *const *cell);
int postproc_report_end(struct postproc_report *r); /* 0, or -1 (errno); also if an image could not be read */
