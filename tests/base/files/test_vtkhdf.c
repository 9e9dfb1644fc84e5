/* VTKHDF files written by all ranks are read back by one. */
#include "base/memory.h"
#include "base/files/vtkhdf.h"
#include "tests/check.h"
#include "tests/base/files/files.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

static const char *folder;

/* A value that depends on position and component. */
static double sample(long id, int c) { return sin(0.37 * (double)id) + 10 * c; }

static void write_image(const char *path, int wide, const int n[3], int empty) {
    long first, count;
    files_split(n[2], empty, &first, &count);
    const struct vtkhdf_image_input in = {.path = path,
                                          .time = 0.125,
                                          .step = 40,
                                          .n = {n[0], n[1], n[2]},
                                          .origin = {0.5, 0.25, -1},
                                          .spacing = {1, 0.5, 2},
                                          .lo = {0, 0, (int)first},
                                          .m = {n[0], n[1], (int)count},
                                          .wide = wide};
    const long plane = (long)n[0] * n[1], items = plane * count;
    double *p = malloc((size_t)(items + 1) * sizeof *p), *u = malloc((size_t)(3 * items + 1) * sizeof *u);
    for (long i = 0; i < items; i++) {
        p[i] = sample(first * plane + i, 0);
        for (int c = 0; c < 3; c++) u[3 * i + c] = sample(first * plane + i, c);
    }
    struct vtkhdf *f = vtkhdf_image_begin(&in);
    vtkhdf_add(f, "pressure", 1, p);
    vtkhdf_add(f, "velocity", 3, u);
    vtkhdf_end(f);
    free(p);
    free(u);
}

static void check_field(struct vtkhdf_source *s, const char *name, int comps, double tolerance) {
    double *value = vtkhdf_read_double(s, name);
    assert_non_null(value);
    for (long i = 0; i < s->points; i++)
        for (int c = 0; c < comps; c++) check_close(value[i * comps + c], sample(i, c), tolerance);
    free(value);
}

static void image_reads_back(void **state) {
    (void)state;
    const int n[3] = {5, 3, 7};
    char path[FOLDER_PATH];
    folder_path(path, folder, "fields/fluid_000040.hdf");
    for (int wide = 0; wide < 2; wide++)
        for (int empty = 0; empty < 3; empty++) {
            write_image(path, wide, n, empty);
            struct vtkhdf_source *s = vtkhdf_read_open(path, NULL);
            assert_non_null(s);
            assert_int_equal(s->image, 1);
            assert_int_equal(s->points, 105);
            assert_memory_equal(s->n, n, sizeof n);
            check_equal(s->time, 0.125);
            check_equal(s->step, 40);
            check_equal(s->origin[2], -1);
            check_equal(s->spacing[1], 0.5);
            assert_int_equal(s->fields, 2);
            /* a float has 24 bits, values are below 32: half a unit of the last place is 2^-20 */
            check_field(s, "pressure", 1, wide ? 0 : 0x1p-20);
            check_field(s, "velocity", 3, wide ? 0 : 0x1p-20);
            assert_null(vtkhdf_read_double(s, "no_such"));
            double(*x)[3] = vtkhdf_read_points(s);
            check_equal(x[104][0], 4.5);
            check_equal(x[104][1], 1.25);
            check_equal(x[104][2], 11);
            free(x);
            vtkhdf_read_close(s);
            par_barrier();
        }
}

static void write_points(const char *path, long n, int empty) {
    long first, count;
    files_split(n, empty, &first, &count);
    double(*x)[3] = malloc((size_t)(count + 1) * sizeof *x), *stress = malloc((size_t)(6 * count + 1) * sizeof *stress);
    int64_t *id = malloc((size_t)(count + 1) * sizeof *id);
    uint8_t *body = malloc((size_t)count + 1);
    for (long i = 0; i < count; i++) {
        const long g = first + i;
        for (int c = 0; c < 3; c++) x[i][c] = 0.1 * (double)g + c;
        for (int c = 0; c < 6; c++) stress[6 * i + c] = sample(g, c);
        id[i] = g + (1L << 40);
        body[i] = (uint8_t)(g % 251);
    }
    struct vtkhdf *f = vtkhdf_points_begin(
        &(struct vtkhdf_points_input){.path = path, .time = 2, .step = 7, .n = count, .x = (const double(*)[3])x});
    vtkhdf_add_long(f, "id", 1, id);
    vtkhdf_add_byte(f, "body", 1, body);
    vtkhdf_add(f, "stress", 6, stress);
    vtkhdf_end(f);
    free(x);
    free(stress);
    free(id);
    free(body);
}

static void points_read_back(void **state) {
    (void)state;
    const long count[] = {0, 1, 2, 1000};
    char path[FOLDER_PATH];
    folder_path(path, folder, "fields/solid_000007.hdf");
    for (int k = 0; k < 4; k++) {
        write_points(path, count[k], k);
        struct vtkhdf_source *s = vtkhdf_read_open(path, NULL);
        assert_non_null(s);
        assert_int_equal(s->image, 0);
        assert_int_equal(s->points, count[k]);
        assert_int_equal(s->fields, 3);
        check_field(s, "stress", 6, 0x1p-19);
        int64_t *id = vtkhdf_read_long(s, "id");
        double *body = vtkhdf_read_double(s, "body"), (*x)[3] = vtkhdf_read_points(s);
        assert_null(vtkhdf_read_long(s, "stress"));
        for (long g = 0; g < count[k]; g++) {
            check_equal(id[g], g + (1L << 40));
            check_equal(body[g], (double)(g % 251));
            for (int c = 0; c < 3; c++) check_equal(x[g][c], 0.1 * (double)g + c);
        }
        free(id);
        free(body);
        free(x);
        vtkhdf_read_close(s);
        par_barrier();
    }
}

static void bad_files_are_refused(void **state) {
    (void)state;
    char path[FOLDER_PATH];
    const char *error = NULL;
    assert_null(vtkhdf_read_open(folder_path(path, folder, "fields/none.hdf"), &error));
    assert_non_null(strstr(error, "No such file"));
    folder_path(path, folder, "fields/text.hdf");
    if (par_rank() == 0) {
        FILE *f = fopen(path, "w");
        fputs("not HDF5", f);
        fclose(f);
    }
    par_barrier();
    assert_null(vtkhdf_read_open(path, &error));
    assert_string_equal(error, "it is not an HDF5 file");
}

static void series_keeps_names_and_times(void **state) {
    (void)state;
    char path[FOLDER_PATH];
    struct vtkhdf_series_entry *list;
    folder_path(path, folder, "fields/fluid.hdf.series");
    assert_int_equal(vtkhdf_series_read(path, &list), -1);
    par_barrier();
    for (int k = 0; k < 5; k++) {
        char name[32];
        snprintf(name, sizeof name, "fluid_%06d.hdf", k);
        vtkhdf_series_add(path, name, 0.1 * k);
    }
    vtkhdf_series_add(path, "fluid_000004.hdf", 0.7); /* written again: replaced, not doubled */
    assert_int_equal(vtkhdf_series_read(path, &list), 5);
    assert_string_equal(list[3].file, "fluid_000003.hdf");
    check_close(list[3].time, 0.3, 1e-15);
    check_equal(list[4].time, 0.7);
    free(list);
    par_barrier();
    vtkhdf_series_cut(path, 0.1 + 0.2); /* 0.30000000000000004 keeps 0.3 */
    assert_int_equal(vtkhdf_series_read(path, &list), 4);
    free(list);
    par_barrier();
    vtkhdf_series_cut(path, -1);
    assert_int_equal(vtkhdf_series_read(path, &list), 0);
    free(list);
    par_barrier();
    vtkhdf_series_add(path, "fluid_000009.hdf", 1);
    assert_int_equal(vtkhdf_series_read(path, &list), 1);
    free(list);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("vtkhdf");
    const struct CMUnitTest tests[] = {cmocka_unit_test(image_reads_back), cmocka_unit_test(points_read_back),
                                       cmocka_unit_test(bad_files_are_refused),
                                       cmocka_unit_test(series_keeps_names_and_times)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
