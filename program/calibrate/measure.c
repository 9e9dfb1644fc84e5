/* Reads energies over the tip's path, loads of a notch and the strength of a bar from the tables of a run. */
#include "program/calibrate/measure.h"
#include "base/die.h"
#include "base/files/folder.h"
#include "base/files/table.h"
#include "program/calibrate/scenes.h"

#include <math.h>
#include <stdlib.h>

static struct table_data *table_of(const char *folder, const char *name) {
    char path[FOLDER_PATH];
    const char *why;
    struct table_data *t = table_read(folder_path(path, folder, name), &why);
    if (!t) die(EXIT_CODE_FILE, "%s: %s", path, why);
    return t;
}

static double value_at(const struct table_data *t, long row, const char *name) {
    const int c = table_read_column(t, name);
    return c < 0 ? 0 : t->value[row * t->columns + c];
}

/* A straight line by least squares. */
struct line {
    double n, x, y, xx, xy;
};
static void add_point(struct line *l, double x, double y) {
    l->n++;
    l->x += x;
    l->y += y;
    l->xx += x * x;
    l->xy += x * y;
}
static double slope(const struct line *l) {
    return (l->n * l->xy - l->x * l->y) / (l->n * l->xx - l->x * l->x); /* NaN without two places */
}

struct calibrate_measure_crack calibrate_measure_crack(const char *folder, const struct calibrate_scene *c) {
    struct table_data *series = table_of(folder, "series.csv"), *crack = table_of(folder, "crack.csv");
    const struct calibrate_sizes z = calibrate_sample_sizes(c);
    const struct calibrate_frame w = calibrate_scenes_frame(c);
    const double unit = calibrate_sample_g0(c->sample) * z.depth;
    struct calibrate_measure_crack found = {.reached = -INFINITY};
    struct line balance = {0}, bonds = {0}, path = {0};
    long row = 0;
    for (long i = 0; i < crack->rows; i++) {
        double along, across;
        const double step = value_at(crack, i, "step");
        while (row < series->rows && value_at(series, row, "step") < step) row++;
        if (row == series->rows || value_at(series, row, "step") != step) continue;
        calibrate_scenes_local(&w, (const double[]){value_at(crack, i, "tip_x"), value_at(crack, i, "tip_y")}, &along,
                               &across);
        if (isnan(along)) continue;
        found.reached = fmax(found.reached, along);
        if (along < z.from || along > z.to) continue;
        /* what relaxations take where a creeping crack jumps is part of what must be supplied */
        const double damped = c->kind == CALIBRATE_CREEPING ? 0 : value_at(series, row, "e_damped");
        found.samples++;
        add_point(&balance, along,
                  value_at(series, row, "e_constraint") + value_at(series, row, "work_load") - damped -
                      value_at(series, row, "e_strain") - value_at(series, row, "e_kinetic_solid"));
        add_point(&bonds, along, value_at(series, row, "e_fracture"));
        add_point(&path, along, across);
    }
    found.balance = slope(&balance) / unit;
    found.bonds = slope(&bonds) / unit;
    found.deflection = atan(slope(&path)) * 180 / M_PI;
    table_read_free(series);
    table_read_free(crack);
    return found;
}

double calibrate_measure_energy(const char *folder) {
    struct table_data *series = table_of(folder, "series.csv");
    const double energy = series->rows ? value_at(series, series->rows - 1, "e_strain") : NAN;
    table_read_free(series);
    return energy;
}

/* The mean size of both constraints' forces in the rows i and i + 1. */
static double force_of(const struct table_data *reactions, long i, const char *name) {
    return 0.5 * (fabs(value_at(reactions, i, name)) + fabs(value_at(reactions, i + 1, name)));
}

struct calibrate_measure_notch calibrate_measure_notch(const char *folder, const struct calibrate_scene *c,
                                                       double griffith) {
    struct table_data *series = table_of(folder, "series.csv"), *crack = table_of(folder, "crack.csv"),
                      *reactions = table_of(folder, "reactions.csv");
    const struct calibrate_sizes z = calibrate_sample_sizes(c);
    struct calibrate_measure_notch found = {NAN, 0};
    long tip = 0;
    for (long i = 0; i < series->rows && 2 * i + 1 < reactions->rows; i++) {
        const double step = value_at(series, i, "step");
        while (tip + 1 < crack->rows && value_at(crack, tip + 1, "step") <= step) tip++;
        if (value_at(crack, tip, "tip_x") > z.crack + 2 * c->sample->m) break;
        found.largest = fmax(found.largest, force_of(reactions, 2 * i, "force_y") / griffith);
        const int broken = i > 0 ? value_at(series, i, "bonds_broken") > value_at(series, 0, "bonds_broken")
                                 : c->sample->length == 0 && value_at(series, i, "e_fracture") > 0;
        if (isnan(found.first) && broken) found.first = found.largest;
    }
    table_read_free(series);
    table_read_free(crack);
    table_read_free(reactions);
    return found;
}

double calibrate_measure_strength(const char *folder, const struct calibrate_scene *c) {
    struct table_data *reactions = table_of(folder, "reactions.csv");
    const struct calibrate_sizes z = calibrate_sample_sizes(c);
    double most = 0;
    for (long i = 0; i + 1 < reactions->rows; i += 2) most = fmax(most, force_of(reactions, i, "force_x"));
    table_read_free(reactions);
    return most / ((double)z.height * z.depth);
}
