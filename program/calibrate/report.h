/* What a calibration has measured, as a table and in sentences. */
#pragma once
#include "scene/scene.h"
#include <stdio.h>

struct calibrate_row {
    int material;         /* index in the scene */
    const char *quantity; /* borrowed */
    double degrees;       /* of the crack's path; NaN: none */
    double value;         /* NaN: not measured */
    const char *over;     /* borrowed: what it is divided by */
    double measured;      /* in the scene's units */
    const char *unit;     /* borrowed: of the latter */
};
struct calibrate_rows {
    int n;
    struct calibrate_row *row; /* owned */
};

void calibrate_report_add(struct calibrate_rows *rows, struct calibrate_row row);
/* One line on the screen. */
void calibrate_report_print(const struct scene *s, const struct calibrate_row *row);
/* calibration.csv, whole; what is measured so far. Not collective. */
void calibrate_report_csv(const char *out, const struct scene *s, const struct calibrate_rows *rows);
/* The table, and what to enter. */
void calibrate_report_page(FILE *to, const struct scene *s, const struct calibrate_rows *rows);
