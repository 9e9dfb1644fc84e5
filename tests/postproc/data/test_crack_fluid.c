/* frana post on made-up runs of an injection into a crack, in a plate and in space: breakdown, shut-in, closure, the
 * band's permeability, the picture's columns. */
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/table.h"
#include "base/files/vtkhdf.h"
#include "physics/growth.h"
#include "postproc/data/injection.h"
#include "postproc/data/crack_fluid.h"
#include "postproc/post.h"
#include "tests/check.h"
#include "tests/postproc/made.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>
#include <sys/stat.h>
#include <zlib.h>

static const char base[] = FRANA_BINARY_DIR "/tests/postproc/wet";
static char folder[FOLDER_PATH];
static const double h = 1e-3, thick = 2e-3, wide = 2e-5; /* spacing, thickness, aperture */
enum { LONG = 40, HIGH = 24, DEEP = 12, CRACK = 16, ROWS = 100 };

static void scene_of(int dim) {
    char path[FOLDER_PATH];
    FILE *f = fopen(folder_path(path, folder, "scene.yaml"), "w");
    fprintf(f,
            "title: A made-up injection\n"
            "domain: {size: [0.04, 0.024%s]}\n"
            "solid:\n  spacing: 1.0e-3\n%s"
            "  materials: [{name: rock, youngs_modulus: 2.0e10, density: 2500, fracture_energy: 50}]\n"
            "  bodies: [{shape: %s, low: [0, 0%s], high: [0.04, 0.024%s]}]\n"
            "  cracks: [{points: %s}]\n"
            "crack_fluid:\n  viscosity: 1.0e-3\n  least_aperture: 1.0e-6\n"
            "  injections: [{low: [0.015, 0.009%s], high: [0.025, 0.015%s], rate: 1.0e-6}]\n"
            "stages: [{name: pump, steps: %d, integrator: verlet, crack_fluid: true}]\n",
            dim == 3 ? ", 0.012" : "", dim == 3 ? "" : "  model: plane_strain\n  thickness: 2.0e-3\n",
            dim == 3 ? "box" : "rectangle", dim == 3 ? ", 0" : "", dim == 3 ? ", 0.012" : "",
            dim == 3 ? "[[0.016, 0.012, 0.003], [0.024, 0.012, 0.003], [0.024, 0.012, 0.009], [0.016, 0.012, 0.009]]"
                     : "[[0.016, 0.012], [0.024, 0.012]]",
            dim == 3 ? ", 0" : "", dim == 3 ? ", 0.012" : "", ROWS);
    fclose(f);
    struct scene *scene = scene_new(path, 0, NULL);
    f = fopen(folder_path(path, folder, "scene.resolved.yaml"), "w");
    fputs(scene->resolved, f);
    fclose(f);
    scene_free(scene);
}

/* A peak of inertia at 5 us; the first bond breaks at 30 us, the pressure is largest at 33 us, when no bond breaks;
 * that at 36 us is the impulse of bonds that break; nothing is injected from 60 us on, and the aperture falls below 1
 * um at 80 us. The half length grows by 0.4 mm a us from 40 to 60 us. */
static void series_of(int dim) {
    static const char *const name[] = {"step",
                                       "t",
                                       "bonds_broken",
                                       "injected_volume",
                                       "crack_volume",
                                       "volume_residual",
                                       "injection_pressure",
                                       "injection_rate",
                                       "crack_area_wet",
                                       "aperture_mean"};
    static const char *const unit[] = {"1", "s", "1", "m3", "m3", "m3", "Pa", "m3/s", "m2", "m"};
    char path[FOLDER_PATH];
    struct table *series = table_new(folder_path(path, folder, "series.csv"), 10, name, unit, -1);
    for (int us = 0; us <= ROWS; us++) {
        const double t = 1e-6 * us, length = 4e-3 + 400 * fmin(fmax(t - 40e-6, 0), 20e-6);
        const double p = us == 5 || us == 36 ? 9e6
                         : us <= 33          ? 2e5 * us
                         : us < 60           ? 6.6e6 - 1e5 * (us - 33)
                                             : 3e6 - 4e4 * (us - 60);
        table_row(series,
                  (double[]){us, t,
                             us < 30    ? 40
                             : us == 33 ? 43
                                        : 11 + us,
                             1e-6 * t, us < 55 ? 1e-6 * t : 0, us == 7 ? 1e-22 : 0, p, us < 60 ? 1e-6 : 0,
                             dim == 2 ? 2 * length * thick : acos(-1) * length * length, us < 80 ? wide : 0.5e-6});
    }
    table_free(series);
}

/* Of a crack of CRACK spacings in the middle, three layers on either side with the shares of a plane's area; in space
 * over the inner half of z. */
static void field_of(int dim, int us) {
    static const double share[3] = {0.292, 0.170, 0.038};
    const int deep = dim == 3 ? DEEP : 1;
    const long n = (long)LONG * HIGH * deep;
    double(*x)[3] = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *x),
    (*u)[3] = memory_new(MEMORY_OUTPUT, (size_t)n, sizeof *u);
    double *value = memory_new(MEMORY_OUTPUT, 5 * (size_t)n, sizeof *value);
    for (long i = 0; i < n; i++) {
        const int a = (int)(i % LONG), b = (int)(i / LONG % HIGH), c = (int)(i / LONG / HIGH);
        const int layer = b < HIGH / 2 ? HIGH / 2 - 1 - b : b - HIGH / 2;
        const int wet = layer < 3 && abs(2 * a + 1 - LONG) < CRACK && (dim == 2 || abs(2 * c + 1 - DEEP) < DEEP / 2);
        u[i][1] = (b < HIGH / 2 ? -0.5 : 0.5) * wide;
        u[i][0] = u[i][2] = 0;
        x[i][0] = (a + 0.5) * h;
        x[i][1] = (b + 0.5) * h + u[i][1];
        x[i][2] = dim == 3 ? (c + 0.5) * h : 0;
        value[i] = wet ? 1e6 * (1 + a) : 0;
        value[n + i] = wet ? wide : 0;
        value[2 * n + i] = wet ? share[layer] * h * (dim == 3 ? h : thick) : 0;
        value[3 * n + i] = h * h * (dim == 3 ? h : thick);
        value[4 * n + i] = wet ? 0.4 : 0;
    }
    char name[64], path[FOLDER_PATH], file[96];
    snprintf(name, sizeof name, "solid_%08d.hdf", us);
    snprintf(file, sizeof file, "fields/%s", name);
    struct vtkhdf *f = vtkhdf_points_begin(&(struct vtkhdf_points_input){.path = folder_path(path, folder, file),
                                                                         .time = 1e-6 * us,
                                                                         .step = us,
                                                                         .n = n,
                                                                         .x = (const double(*)[3])x,
                                                                         .wide = 1});
    static const char *const field[] = {"crack_pressure", "crack_aperture", "crack_area", "volume", "damage"};
    vtkhdf_add(f, "displacement", 3, &u[0][0]);
    for (int k = 0; k < 5; k++) vtkhdf_add(f, field[k], 1, value + k * n);
    vtkhdf_end(f);
    vtkhdf_series_add(folder_path(path, folder, "fields/solid.hdf.series"), name, 1e-6 * us);
    memory_free(x);
    memory_free(u);
    memory_free(value);
}

static void make(const char *name, int dim) {
    folder_path(folder, base, name);
    folder_make(folder);
    folder_clear(folder);
    scene_of(dim);
    series_of(dim);
    field_of(dim, 50);
    field_of(dim, 100);
}

static long size_of(const char *file) { return made_size(folder, file); }

/* Of post/summary.csv. */
static double summary(const char *quantity) { return made_value(folder, "post/summary.csv", quantity); }

static void record_of_a_plate(void **state) {
    (void)state;
    make("plate", 2);
    const struct postproc_options film = {.film = 1, .film_named = 1, .film_quantity = POSTPROC_APERTURE, .width = 280};
    assert_int_equal(postproc_post(folder, &film), EXIT_CODE_DONE);
    check_relative(summary("pressure as the first bond broke"), 6e6, 1e-9);
    check_relative(summary("breakdown pressure"), 6.6e6, 1e-9);
    check_relative(summary("breakdown pressure, t"), 33e-6, 1e-9);
    check_relative(summary("shut-in pressure"), 3e6, 1e-9);
    check_relative(summary("shut-in pressure, t"), 60e-6, 1e-9);
    check_relative(summary("closure pressure"), 2.2e6, 1e-9);
    check_relative(summary("closure pressure, t"), 80e-6, 1e-9);
    check_relative(summary("error of the volumes over the injected one"), 1e-22 / 1e-10, 1e-9);
    check_relative(summary("speed of the tips over five spacings, largest"), 400, 1e-9);
    /* a plane crack conducts w^3/12 by its area, and the band is six spacings thick */
    check_relative(summary("hydraulic aperture"), wide, 1e-9);
    check_relative(summary("band of broken bonds, thickness"), 6 * h, 1e-9);
    check_relative(summary("band of broken bonds, permeability along the crack"), pow(wide, 3) / 12 / (6 * h), 1e-9);
    check_relative(summary("field of the pictures of the cracks, t"), 50e-6, 1e-9); /* the crack is emptied later */
    /* K'/(mu' E'^3 Q0)^(1/4) */
    const double e = 2e10 * 16 / 15, k = 4 * sqrt(2 / acos(-1)) * sqrt(50 * e);
    check_relative(summary("dimensionless toughness K'/(mu' E'^3 Q0)^(1/4)"),
                   k / pow(12e-3 * pow(e, 3) * 1e-6 / thick, 0.25), 1e-9);
    static const char *const files[] = {"post/plots/injection.png",         "post/plots/injection.pdf",
                                        "post/plots/crack_pressure.png",    "post/pictures/aperture.png",
                                        "post/pictures/crack_pressure.svg", "post/film/aperture_0001.png",
                                        "post/film/aperture_0002.png"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        if (size_of(files[i]) < 500) fail_msg("%s is missing or empty", files[i]);
    assert_int_equal(size_of("post/film/aperture_0003.png"), -1);
}

/* The film that the test before has made is one file of two frames: it holds the first picture's chunks and the second
 * one's as they are, in a numbered order, with right check sums. */
static void film_of_a_plate(void **state) {
    (void)state;
    char path[FOLDER_PATH], all[64] = "";
    unsigned char head[8], *data = NULL;
    long bytes[2] = {0, 0}, next = 0;
    FILE *f = fopen(folder_path(path, folder, "post/film/aperture.png"), "rb");
    assert_non_null(f);
    assert_int_equal(fread(head, 1, 8, f), 8);
    while (fread(head, 1, 8, f) == 8) {
        const size_t n = ((size_t)head[0] << 24) + ((size_t)head[1] << 16) + ((size_t)head[2] << 8) + head[3];
        data = realloc(data, n + 8);
        memcpy(data, head + 4, 4);
        assert_int_equal(fread(data + 4, 1, n + 4, f), n + 4);
        const unsigned long sum = crc32(0, data, (unsigned)n + 4);
        for (int k = 0; k < 4; k++) assert_int_equal(data[n + 4 + (size_t)k], sum >> (24 - 8 * k) & 255);
        if (memcmp(data, "fcTL", 4) == 0 || memcmp(data, "fdAT", 4) == 0) assert_int_equal(data[7], next++);
        if (memcmp(data, "acTL", 4) == 0) assert_int_equal(data[7], 2);
        if (memcmp(data, "IDAT", 4) == 0) bytes[0] += (long)n;
        if (memcmp(data, "fdAT", 4) == 0) bytes[1] += (long)n - 4;
        if (strlen(all) < 40) strncat(all, (char *)data, 1);
        if (memcmp(data, "IDAT", 4) == 0 && all[strlen(all) - 2] == 'I') all[strlen(all) - 1] = '\0';
    }
    fclose(f);
    free(data);
    assert_true(strncmp(all, "IafI", 4) == 0 && all[strlen(all) - 1] == 'I');
    for (int k = 0; k < 2; k++) /* a PNG: signature, IHDR, IDAT, IEND, and perhaps some more */
        check_between((double)(size_of(k ? "post/film/aperture_0002.png" : "post/film/aperture_0001.png") - bytes[k]),
                      57, 400);
}

/* The columns across the crack's plane: their number, places and means. */
static void columns_of_a_block(void **state) {
    (void)state;
    char error[256];
    make("block", 3);
    struct postproc_history *run = postproc_history_new(folder, error, sizeof error);
    struct postproc_crack_fluid *w = postproc_crack_fluid_new(run, 0, NULL);
    assert_non_null(w);
    assert_int_equal(w->along, 1);
    assert_int_equal(w->particles, CRACK * 6 * DEEP / 2);
    check_relative(w->area, CRACK * h * DEEP / 2 * h, 1e-9);
    check_close(w->plate.low[0], (LONG - CRACK) / 2 * h - 6 * h, 1e-9);
    check_close(w->plate.high[1], DEEP * h, 1e-9); /* the margin ends at the block */
    assert_int_equal(w->plate.n, (CRACK + 12) * DEEP);
    long wet = 0;
    for (long i = 0; i < w->plate.n; i++) {
        const int a = (int)floor(w->plate.x[i][0] / h);
        check_close(w->plate.x[i][0], (a + 0.5) * h, 1e-9);
        if (isnan(w->aperture[i])) continue;
        wet++;
        check_relative(w->aperture[i], wide, 1e-9);
        check_relative(w->pressure[i], 1e6 * (1 + a), 1e-9);
    }
    assert_int_equal(wet, CRACK * DEEP / 2);
    postproc_crack_fluid_free(w);
    const struct postproc_injection in = postproc_injection_new(run, postproc_crack_fluid_least_aperture(run));
    check_relative(in.speed, 400, 1e-9);
    postproc_history_free(run);
}

/* A length that sticks for 9 s and slips by 3 m in 2 s: the shortest time for 6 m is that of two slips and the rest
 * between, 13 s. */
static void sticks_and_slips(void **state) {
    (void)state;
    double t[60], l[60], most = 0;
    long first = 0;
    for (int i = 0; i < 60; i++) {
        t[i] = i;
        l[i] = 3 * (i / 11 + (i % 11 == 10 ? 0.5 : 0));
        most = fmax(most, physics_growth_speed(t, l, i, 6, &first));
    }
    check_relative(most, 6 / 13., 1e-12);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(record_of_a_plate), cmocka_unit_test(film_of_a_plate),
                                       cmocka_unit_test(columns_of_a_block), cmocka_unit_test(sticks_and_slips)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
