/* An artificial run folder: a porous block that cracks from the back, so that the results of frana post are known. */
#pragma once
#include "base/memory.h"
#include "base/files/folder.h"
#include "base/files/json.h"
#include "base/files/table.h"
#include "base/files/vtkhdf.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MAKE_STEPS = 100, MAKE_EVERY = 5, MAKE_FIELDS = 50 }; /* steps of each of the three stages */
static const double make_dt[3] = {3.4e-4, 3.4e-5, 3.4e-5};

struct make_run {
    const char *folder;
    int cells;                        /* over the height: 64 is the main case */
    long stop;                        /* the last step written */
    int no_solid, no_fields, at_rest; /* at_rest: the fluid has neither velocity nor pressure */
    int events;                       /* events.csv */
};

/* The stretch's scale in the fields: a made-up mean of a known law, at a place. */
static double make_strain(const double x0[3], double crack) { return 1e-4 * (1 + x0[0] / 0.1 + crack); }

static double make_time(long step) {
    double t = 0;
    for (int s = 0; s < 3; s++) t += make_dt[s] * fmin(fmax((double)(step - s * MAKE_STEPS), 0), MAKE_STEPS);
    return t;
}

/* 0 until half of the last stage, then growing to 1. */
static double make_progress(long step) { return fmax(0, (double)(step - 5 * MAKE_STEPS / 2) / (0.5 * MAKE_STEPS)); }

static void make_scene(const struct make_run *in) {
    char path[FOLDER_PATH];
    const double d = 0.1 / in->cells;
    FILE *f = fopen(folder_path(path, in->folder, "scene.yaml"), "w");
    fprintf(f,
            "title: \"A made-up block: it's \\\"cracked\\\" | from <the> back\"\n"
            "domain: {size: [0.2, 0.1, 0.1], cells: [%d, %d, %d]}\n"
            "fluid:\n  density: 1000\n  viscosity: 1.0e-3\n  initial: {velocity: [0.1, 0, 0]}\n  sides:\n"
            "    x_low: {type: inflow, profile: poiseuille, bulk_velocity: 0.1}\n    x_high: {type: outflow}\n"
            "    y_low: {type: wall}\n    y_high: {type: wall}\n    z_low: {type: periodic}\n    z_high: {type: "
            "periodic}\n",
            2 * in->cells, in->cells, in->cells);
    if (!in->no_solid)
        fprintf(f,
                "solid:\n  materials:\n    - {name: ceramic, youngs_modulus: 1.0e8, density: 3000, "
                "fracture_energy: 0.02, "
                "horizon_ratio: 3}\n"
                "  bodies:\n    - {name: block, material: ceramic, shape: box, low: [0.025, %g, 0], high: "
                "[0.1, %g, 0.1],"
                " cavities: {period: 0.025, radius: 0.014375, centre: [0.025, 0, 0]}}\n"
                "  constraints:\n    - {low: [0, -0.02, 0], high: [0.2, 0, 0.1], velocity: [0, -0.01, 0]}\n"
                "    - {low: [0, 0.1, 0], high: [0.2, 0.12, 0.1], velocity: [0, 0.01, 0]}\n"
                "coupling:\n  medium: {low: [0.025, 0, 0], high: [0.1, 0.1, 0.1]}\n",
                -3 * d, 0.1 + 3 * d);
    fprintf(f, "stages:\n");
    static const char *const name[3] = {"flow", "settle", "fracture"};
    for (int s = 0; s < 3; s++)
        fprintf(f, "  - {name: %s, steps: %d, time_step: %g%s}\n", name[s], MAKE_STEPS, make_dt[s],
                in->no_solid ? ""
                : s == 0     ? ", solid: rigid"
                : s == 1     ? ", breakage: false"
                             : "");
    fclose(f);
    struct scene *scene = scene_new(path, 0, NULL);
    f = fopen(folder_path(path, in->folder, "scene.resolved.yaml"), "w");
    fputs(scene->resolved, f);
    fclose(f);
    scene_free(scene);
}

static void make_series(const struct make_run *in) {
    static const char *const name[] = {"step",         "t",
                                       "dt",           "dp",
                                       "porosity",     "permeability",
                                       "e_strain",     "e_fracture",
                                       "bonds_intact", "bonds_broken",
                                       "fragments",    "largest_fragment",
                                       "damage_mean",  "specific_surface"};
    static const char *const unit[] = {"1", "s", "s", "Pa", "1", "m2", "J", "J", "1", "1", "1", "1", "1", "1/m"};
    char path[FOLDER_PATH];
    const int columns = in->no_solid ? 4 : 14;
    struct table *t = table_new(folder_path(path, in->folder, "series.csv"), columns, name, unit, -1);
    for (long step = MAKE_EVERY; step <= in->stop; step += MAKE_EVERY) {
        const double p = make_progress(step), broken = floor(1e5 * p);
        const double row[14] = {(double)step,
                                make_time(step),
                                make_dt[(step - 1) / MAKE_STEPS],
                                1900 * (1 - 0.5 * p) * (1 - exp(-(double)step / 20)),
                                0.7 + 0.02 * p,
                                3.9e-6 * (1 + p),
                                1e-5 * (1 + sin((double)step)),
                                1e-6 * p,
                                4e6 - broken,
                                broken,
                                1 + floor(50 * p),
                                54720 - 100 * p,
                                0.1 * p,
                                40};
        table_row(t, row);
    }
    table_free(t);
}

/* Two layers are pulled apart; a piece of a tenth of the block, with the speed 3 m/s, comes off at step 260. */
static void make_breaking(const struct make_run *in) {
    static const char *const fragment[] = {"step", "t", "fragment", "detached", "mass", "speed", "extent"};
    static const char *const units[] = {"1", "s", "1", "s", "kg", "m/s", "m"};
    static const char *const reaction[] = {"step",    "t",       "load",           "index",
                                           "force_x", "force_y", "displacement_x", "displacement_y"};
    static const char *const unit[] = {"1", "s", "1", "1", "N", "N", "m", "m"};
    char path[FOLDER_PATH];
    struct table *t = table_new(folder_path(path, in->folder, "fragments.csv"), 7, fragment, units, -1);
    table_row(t, (double[]){0, 0, 0, 0, 2, 0, 0.1});
    if (in->stop >= 260) table_row(t, (double[]){260, make_time(260), 1, make_time(260), 0.2, 1, 0.02});
    for (int k = 0; k < 2 && in->stop >= 300; k++)
        table_row(t, (double[]){300, make_time(300), k, k ? make_time(260) : 0, k ? 0.2 : 1.8, 3 * k, k ? 0.02 : 0.1});
    table_free(t);
    t = table_new(folder_path(path, in->folder, "reactions.csv"), 8, reaction, unit, -1);
    for (long step = MAKE_EVERY; step <= in->stop; step += MAKE_EVERY)
        for (int k = 0; k < 2; k++)
            table_row(t, (double[]){(double)step, make_time(step), 0, k, 0, (k ? 1 : -1) * 5. * (double)step, 0,
                                    (k ? 1 : -1) * 1e-6 * (double)step});
    table_free(t);
}

/* A hundred events from step 255 on, the k-th of k bonds with k^2 J, along a line; the largest is the last but one. */
static void make_events(const struct make_run *in) {
    static const char *const name[] = {"step", "t", "event", "bonds", "x", "y", "z", "area", "energy"};
    static const char *const unit[] = {"1", "s", "1", "1", "m", "m", "m", "m2", "J"};
    char path[FOLDER_PATH];
    if (!in->events) return;
    struct table *t = table_new(folder_path(path, in->folder, "events.csv"), 9, name, unit, -1);
    for (int k = 0; k < 100; k++) {
        const int size = k < 98 ? k + 1 : 198 - k;
        table_row(t, (double[]){255 + k / 5, make_time(255 + k / 5), k, size, 0.05 + 1e-4 * k, 0.02 + 2e-4 * k, 0.025,
                                1e-6 * size, (double)size * size});
    }
    table_free(t);
}

/* At the end of each stage: slices of 12.5 mm, of porosity 0.5 and 0.05 more each, and in the last stage 0.03 more; and
 * sub-volumes of 12.5 to 100 mm, the smallest of which do not all have a surface. */
static void make_texture(const struct make_run *in) {
    static const char *const slice[] = {"step", "t", "direction", "slice", "at", "porosity"};
    static const char *const units[] = {"1", "s", "1", "1", "m", "1"};
    static const char *const rev[] = {"step",
                                      "t",
                                      "edge",
                                      "porosity_mean",
                                      "porosity_deviation",
                                      "porosity_least",
                                      "porosity_largest",
                                      "carman_mean",
                                      "carman_deviation",
                                      "carman_least",
                                      "carman_largest"};
    static const char *const unit[] = {"1", "s", "m", "1", "1", "1", "1", "m2", "m2", "m2", "m2"};
    char path[FOLDER_PATH];
    struct table *t = table_new(folder_path(path, in->folder, "slices.csv"), 6, slice, units, -1);
    for (int stage = 1; stage <= 3 && stage * MAKE_STEPS <= in->stop; stage++)
        for (int c = 0; c < 3; c++)
            for (int q = 0; q < (c == 0 ? 6 : 8); q++)
                table_row(t, (double[]){stage * MAKE_STEPS, make_time(stage * MAKE_STEPS), c, q,
                                        (c == 0 ? 0.025 : 0) + (q + 0.5) * 0.0125,
                                        0.5 + 0.05 * q + (stage == 3 ? 0.03 : 0)});
    table_free(t);
    t = table_new(folder_path(path, in->folder, "rev.csv"), 11, rev, unit, -1);
    for (int stage = 1; stage <= 3 && stage * MAKE_STEPS <= in->stop; stage++)
        for (int k = 0; k < 4; k++) {
            const double spread = 0.1 * (3 - k), carman = k == 0 ? NAN : 4e-6;
            table_row(t, (double[]){stage * MAKE_STEPS, make_time(stage * MAKE_STEPS), 0.0125 * (1 << k), 0.625,
                                    0.5 * spread, 0.625 - spread, 0.625 + spread, carman, 2 * carman * spread,
                                    carman * (1 - spread), carman * (1 + spread)});
        }
    table_free(t);
}

/* Of the last solid field made: mean x0 by damage, m. */
static double make_onset_x;

/* A block of cubes less the cavities; damaged at its back once the stage is half over. */
static void make_solid(const struct make_run *in, long step) {
    const int n = in->cells, period = n / 4;
    const double d = 0.1 / n, crack = make_progress(step);
    const long most = (long)(3 * n / 4) * (n + 6) * n;
    double(*x)[3] = memory_new(MEMORY_OUTPUT, (size_t)most, sizeof *x);
    double(*u)[3] = memory_new(MEMORY_OUTPUT, (size_t)most, sizeof *u);
    double *value = memory_new(MEMORY_OUTPUT, 3 * (size_t)most, sizeof *value);
    double *damage = value, *strain = value + most, *stress = value + 2 * most;
    uint8_t *held = memory_new(MEMORY_OUTPUT, (size_t)most, 1);
    long m = 0;
    double sum = 0, moment = 0;
    for (int k = 0; k < n; k++)
        for (int j = -3; j < n + 3; j++)
            for (int i = 0; i < 3 * n / 4; i++) {
                const double q[3] = {i + 0.5, j + 0.5, k + 0.5};
                double rr = 0;
                for (int c = 0; c < 3; c++) rr += pow(q[c] - period * rint(q[c] / period), 2);
                if (rr < pow(9.2 / 16 * period, 2)) continue;
                const double x0[3] = {0.025 + q[0] * d, q[1] * d, q[2] * d};
                held[m] = j < 0 || j >= n;
                const double near = 1 - hypot(x0[0] - 0.095, x0[1] - 0.05) / 0.03;
                damage[m] = held[m] ? 0 : fmin(fmax(crack * near * 1.6, 0), 1);
                const int loose = damage[m] > 0.95;
                for (int c = 0; c < 3; c++) {
                    u[m][c] = loose ? 0.008 * sin(0.3 * (double)(i * 7 + j * 3 + k * 5 + 11 * c)) : 0;
                    if (c == 0) u[m][c] += 1e-4 * sin(M_PI * x0[1] / 0.1) + (loose ? 0.02 * crack : 0);
                    x[m][c] = x0[c] + u[m][c];
                }
                strain[m] = make_strain(x0, crack);
                stress[m] = 1e8 * strain[m];
                sum += damage[m];
                moment += damage[m] * x0[0];
                m++;
            }
    make_onset_x = moment / sum;
    char name[64], path[FOLDER_PATH], file[96];
    snprintf(name, sizeof name, "solid_%08ld.hdf", step);
    snprintf(file, sizeof file, "fields/%s", name);
    struct vtkhdf *f = vtkhdf_points_begin(&(struct vtkhdf_points_input){.path = folder_path(path, in->folder, file),
                                                                         .time = make_time(step),
                                                                         .step = step,
                                                                         .n = m,
                                                                         .x = (const double(*)[3])x});
    vtkhdf_add_byte(f, "held", 1, held);
    vtkhdf_add(f, "displacement", 3, &u[0][0]);
    vtkhdf_add(f, "damage", 1, damage);
    vtkhdf_add(f, "strain_max", 1, strain);
    vtkhdf_add(f, "stress_max", 1, stress);
    for (long i = 0; i < m; i++) /* a tension, and across it a pressure: Griffith's criterion takes the tension */
        for (int c = 0; c < 3; c++) u[i][c] = stress[i] * (c == 0 ? 1 : c == 1 ? 0.5 : -2);
    vtkhdf_add(f, "stress_principal", 3, &u[0][0]);
    for (long i = 0; i < m; i++) strain[i] = sqrt(0.5 * (0.25 + 6.25 + 9)) * stress[i];
    vtkhdf_add(f, "von_mises", 1, strain);
    vtkhdf_end(f);
    vtkhdf_series_add(folder_path(path, in->folder, "fields/solid.hdf.series"), name, make_time(step));
    memory_free(x);
    memory_free(u);
    memory_free(value);
    memory_free(held);
}

/* Pressure falls by 1900 Pa over the medium; half of its sections is solid. The velocity is 0.1 m/s along x in the
 * fluid. */
static void make_fluid(const struct make_run *in, long step) {
    const int n[3] = {2 * in->cells, in->cells, in->cells};
    const size_t all = (size_t)n[0] * (size_t)n[1] * (size_t)n[2];
    const double d = 0.1 / in->cells;
    double *pressure = memory_new(MEMORY_OUTPUT, all, sizeof *pressure),
           *solid = memory_new(MEMORY_OUTPUT, all, sizeof *solid);
    double(*velocity)[3] = memory_new(MEMORY_OUTPUT, all, sizeof *velocity);
    for (size_t at = 0; at < all; at++) {
        const int i = (int)(at % (size_t)n[0]), j = (int)(at / (size_t)n[0] % (size_t)n[1]);
        const double x = (i + 0.5) * d;
        solid[at] = x > 0.025 && x < 0.1 && j % 2 == 0 ? 1 : 0;
        pressure[at] = 1900 * fmin(fmax((0.1 - x) / 0.075, 0), 1) + (solid[at] > 0 ? 1000 : 0);
        if (in->at_rest) pressure[at] = 0;
        if (!in->at_rest && !(solid[at] > 0 && !in->no_solid)) velocity[at][0] = 0.1;
    }
    char name[64], path[FOLDER_PATH], file[96];
    snprintf(name, sizeof name, "fluid_%08ld.hdf", step);
    snprintf(file, sizeof file, "fields/%s", name);
    struct vtkhdf *f = vtkhdf_image_begin(&(struct vtkhdf_image_input){.path = folder_path(path, in->folder, file),
                                                                       .time = make_time(step),
                                                                       .step = step,
                                                                       .n = {n[0], n[1], n[2]},
                                                                       .origin = {0.5 * d, 0.5 * d, 0.5 * d},
                                                                       .spacing = {d, d, d},
                                                                       .m = {n[0], n[1], n[2]}});
    vtkhdf_add(f, "velocity", 3, &velocity[0][0]);
    vtkhdf_add(f, "pressure", 1, pressure);
    if (!in->no_solid) vtkhdf_add(f, "solid_fraction", 1, solid);
    vtkhdf_end(f);
    vtkhdf_series_add(folder_path(path, in->folder, "fields/fluid.hdf.series"), name, make_time(step));
    memory_free(velocity);
    memory_free(pressure);
    memory_free(solid);
}

static void make_record(const struct make_run *in) {
    char path[FOLDER_PATH];
    struct json *j = json_begin(folder_path(path, in->folder, "run.json"));
    json_text(j, "status", in->stop == 3 * MAKE_STEPS ? "done" : "running");
    json_long(j, "steps", in->stop);
    json_long(j, "ranks", 2);
    json_number(j, "wall_seconds", 123.5);
    json_object(j, "wall_seconds_by_part");
    json_number(j, "momentum", 20.25);
    json_number(j, "poisson", 31);
    json_close(j);
    json_array(j, "timeline");
    for (int span = 0; span < 2; span++) {
        json_object(j, NULL);
        json_text(j, "span", span ? "flow" : "set-up");
        json_object(j, "working");
        json_number(j, "momentum", span ? 16 : 0.25);
        json_close(j);
        json_object(j, "waiting");
        json_number(j, "momentum", span ? 4 : 0);
        json_close(j);
        json_close(j);
    }
    json_close(j);
    json_text(j, "host", "a machine");
    json_end(j);
}

/* folder must be new or its own. */
static void make_run(const struct make_run *in) {
    folder_make(in->folder);
    folder_clear(in->folder);
    make_scene(in);
    make_series(in);
    if (!in->no_solid) make_breaking(in);
    make_events(in);
    if (!in->no_solid) make_texture(in);
    make_record(in);
    for (long step = 2 * MAKE_STEPS - MAKE_FIELDS; step <= in->stop && !in->no_fields; step += MAKE_FIELDS) {
        if (!in->no_solid) make_solid(in, step);
        make_fluid(in, step);
    }
}
