/* A run folder of a plate whose crack is known: it starts at 6 us, runs at 1500 m/s along the middle, and parts at x =
 * 67 mm into branches of 28 degrees to the left and 12 to the right, of 1200 m/s. */
#pragma once
#include "base/memory.h"
#include "base/files/folder.h"
#include "base/files/table.h"
#include "base/files/vtkhdf.h"
#include "scene/scene.h"

#include <math.h>
#include <stdio.h>

static const double plate_start = 6e-6, plate_branch = 0.067, plate_first = 0.05, plate_middle = 0.02;
static const double plate_speed[2] = {1500, 1200}, plate_angle[2] = {28 * M_PI / 180, -12 * M_PI / 180};
enum { PLATE_STEPS = 700, PLATE_EVERY = 2, PLATE_FIELDS = 100 };
static const double plate_dt = 5e-8;

/* Position of a branch's tip. */
static void plate_tip(double t, int side, double x[2]) {
    const double run = plate_speed[0] * fmax(t - plate_start, 0), stem = plate_branch - plate_first;
    const double beyond = run > stem ? (run - stem) / plate_speed[0] * plate_speed[1] : 0;
    x[0] = plate_first + fmin(run, stem) + beyond * cos(plate_angle[side]);
    x[1] = plate_middle + beyond * sin(plate_angle[side]);
}

static double plate_apart(const double x[2], const double a[2], const double b[2]) {
    const double ex = b[0] - a[0], ey = b[1] - a[1], l = ex * ex + ey * ey;
    const double f = l > 0 ? fmin(fmax(((x[0] - a[0]) * ex + (x[1] - a[1]) * ey) / l, 0), 1) : 0;
    return hypot(x[0] - a[0] - f * ex, x[1] - a[1] - f * ey);
}

/* Damage as in a lattice of spacing h. */
static double plate_damage(double t, const double x[2], double h) {
    double tip[2], nearest = INFINITY;
    const double edge[2] = {0, plate_middle}, fork[2] = {plate_branch, plate_middle};
    for (int side = 0; side < 2; side++) {
        plate_tip(t, side, tip);
        const double stem[2] = {fmin(tip[0], plate_branch), plate_middle};
        nearest = fmin(nearest, plate_apart(x, edge, stem));
        if (tip[0] > plate_branch) nearest = fmin(nearest, plate_apart(x, fork, tip));
    }
    return fmax(0, 0.504 * (1 - nearest / (3 * h)));
}

static void plate_scene(const char *folder, double h) {
    char path[FOLDER_PATH];
    FILE *f = fopen(folder_path(path, folder, "scene.yaml"), "w");
    fprintf(f,
            "title: A made-up plate that cracks\n"
            "domain: {size: [0.1, 0.04]}\n"
            "solid:\n  spacing: %g\n  model: plane_stress\n  thickness: 0.002\n"
            "  materials:\n    - {name: glass, youngs_modulus: 7.2e10, density: 2440, fracture_energy: 135}\n"
            "  bodies:\n    - {name: plate, material: glass, shape: rectangle, low: [0, 0], high: [0.1, 0.04]}\n"
            "  cracks:\n    - {name: notch, points: [[0, 0.02], [0.05, 0.02]]}\n"
            "stages:\n  - {name: pull, steps: %d, integrator: verlet, time_step: %g}\n"
            "output:\n  crack: {damage: 0.35, direction: [1, 0], window: 2.0e-6, every: %d}\n",
            h, PLATE_STEPS, plate_dt, PLATE_EVERY);
    fclose(f);
    struct scene *scene = scene_new(path, 0, NULL);
    f = fopen(folder_path(path, folder, "scene.resolved.yaml"), "w");
    fputs(scene->resolved, f);
    fclose(f);
    scene_free(scene);
}

/* As a run writes them, the speeds known. */
static void plate_tables(const char *folder) {
    static const char *const name[] = {
        "step",    "t",       "tip_x",       "tip_y",  "speed",  "left_x",     "left_y",          "left_speed",
        "right_x", "right_y", "right_speed", "fronts", "length", "e_fracture", "energy_per_area", "energy_over_g0"};
    static const char *const unit[] = {"1", "s", "m",   "m", "m/s", "m", "m",    "m/s",
                                       "m", "m", "m/s", "1", "m",   "J", "J/m2", "1"};
    static const char *const series_name[] = {"step", "t", "e_kinetic_solid", "e_strain", "e_fracture", "bonds_broken"};
    static const char *const series_unit[] = {"1", "s", "J", "J", "J", "1"};
    char path[FOLDER_PATH];
    struct table *crack = table_new(folder_path(path, folder, "crack.csv"), 16, name, unit, -1);
    struct table *series = table_new(folder_path(path, folder, "series.csv"), 6, series_name, series_unit, -1);
    for (long step = 0; step <= PLATE_STEPS; step += PLATE_EVERY) {
        const double t = (double)step * plate_dt;
        double left[2], right[2];
        plate_tip(t, 0, left);
        plate_tip(t, 1, right);
        const int apart = right[0] > plate_branch + 0.004; /* seen as two fronts a little late */
        const double length = hypot(right[0] - plate_first, right[1] - plate_middle) * (apart ? 1.5 : 1);
        const double speed = step == 0                 ? NAN
                             : t < plate_start         ? 0
                             : right[0] < plate_branch ? plate_speed[0]
                                                       : plate_speed[1];
        const double broken = t < plate_start - 0.35e-6 ? 40 : 40 + floor(1e4 * length),
                     released = 300 * 0.002 * length;
        const double row[16] = {(double)step,
                                t,
                                right[0],
                                right[1],
                                speed,
                                left[0],
                                left[1],
                                speed,
                                right[0],
                                right[1],
                                speed,
                                1 + apart,
                                length,
                                released + (t > plate_start - 0.35e-6 ? 1e-9 : 0),
                                length > 0 ? 300 : NAN,
                                length > 0 ? 300 / 135. : NAN};
        table_row(crack, row);
        table_row(series, (double[]){(double)step, t, 1e-3 * t / 1e-5, 1e-2, released, broken});
    }
    table_free(crack);
    table_free(series);
}

static void plate_field(const char *folder, long step, double h) {
    const int nx = (int)lround(0.1 / h), ny = (int)lround(0.04 / h);
    const long n = (long)nx * ny;
    const double t = (double)step * plate_dt;
    double(*x)[3] = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *x),
    (*u)[3] = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *u);
    double *value = memory_new(MEMORY_OUTPUT, 4 * (size_t)n, sizeof *value);
    for (long k = 0; k < n; k++) {
        const double at[2] = {((double)(k % nx) + 0.5) * h, ((double)(k / nx) + 0.5) * h};
        u[k][0] = 2e-6 * sin(20 * at[0]);
        u[k][1] = 2e-5 * (at[1] > plate_middle ? 1 : -1) * fmax(0, 1 - at[0] / 0.09) * t / 3e-5;
        for (int c = 0; c < 2; c++) x[k][c] = at[c] + u[k][c];
        value[k] = plate_damage(t, at, h);
        value[n + k] = 1e-3 * exp(-fabs(at[1] - plate_middle) / 0.01);
        value[2 * n + k] = 4e4 * exp(-fabs(at[1] - plate_middle) / 0.01);
        value[3 * n + k] = h * h * 0.002;
    }
    char name[64], path[FOLDER_PATH], file[96];
    snprintf(name, sizeof name, "solid_%08ld.hdf", step);
    snprintf(file, sizeof file, "fields/%s", name);
    struct vtkhdf *f = vtkhdf_points_begin(&(struct vtkhdf_points_input){.path = folder_path(path, folder, file),
                                                                         .time = t,
                                                                         .step = step,
                                                                         .n = n,
                                                                         .x = (const double(*)[3])x,
                                                                         .wide = 0});
    static const char *const field[4] = {"damage", "stretch_max", "energy_density", "volume"};
    vtkhdf_add(f, "displacement", 3, &u[0][0]);
    for (int k = 0; k < 4; k++) vtkhdf_add(f, field[k], 1, value + k * n);
    vtkhdf_end(f);
    vtkhdf_series_add(folder_path(path, folder, "fields/solid.hdf.series"), name, t);
    memory_free(x);
    memory_free(u);
    memory_free(value);
}

/* spacing h, m. */
static void make_plate(const char *folder, double h) {
    folder_make(folder);
    folder_clear(folder);
    plate_scene(folder, h);
    plate_tables(folder);
    for (long step = 0; step <= PLATE_STEPS; step += PLATE_FIELDS) plate_field(folder, step, h);
}
