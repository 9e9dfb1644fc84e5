/* Script and values of a plane of the fluid: the values are over the power of ten that stands at the colour bar. */
#include "base/par.h"
#include "base/files/folder.h"
#include "postproc/charts/slice.h"
#include "tests/check.h"
#include "tests/postproc/charts/script.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const char folder[] = FRANA_BINARY_DIR "/tests/postproc/slices";
enum { NX = 300, NY = 200, REPEAT = 2 }; /* less than 400 cells: each is drawn as two by two pixels */

/* A plane of the values k * unit. Returns the pixels of NAME.bin. */
static float *draw(const char *name, double unit, long *pixels) {
    double *value = malloc(NX * NY * sizeof *value);
    for (int k = 0; k < NX * NY; k++) value[k] = k * unit;
    value[1] = NAN; /* solid */
    const struct postproc_slice slice = {.across = {0, 1}, .n = {NX, NY}, .d = {1e-3, 1e-3}};
    folder_make(folder);
    assert_int_equal(postproc_slice_draw(&(struct postproc_slice_plot){.folder = folder,
                                                                       .name = name,
                                                                       .title = "A plane",
                                                                       .subtitle = "",
                                                                       .label = "p  [Pa]",
                                                                       .slice = &slice,
                                                                       .value = value,
                                                                       .low = 0,
                                                                       .high = NX * NY * unit}),
                     POSTPROC_PLOT_DONE);
    free(value);
    char path[FOLDER_PATH], file[64];
    float *read = malloc((size_t)(NX * NY * REPEAT * REPEAT + 1) * sizeof *read);
    snprintf(file, sizeof file, "%s.bin", name);
    FILE *f = fopen(folder_path(path, folder, file), "rb");
    assert_non_null(f);
    *pixels = (long)fread(read, sizeof *read, (size_t)(NX * NY * REPEAT * REPEAT + 1), f);
    fclose(f);
    return read;
}

static void values_over_a_power_of_ten(void **state) {
    (void)state;
    static const struct {
        const char *name, *factor, *range;
        double unit, of_bar;
    } plane[] = {{"plain", NULL, "set cbrange [0:600]", 0.01, 1},
                 {"small", "10^{-6}", "set cbrange [0:60]", 1e-9, 1e-6},
                 {"large", "10^{6}", "set cbrange [0:60]", 1e3, 1e6}};
    for (size_t p = 0; p < sizeof plane / sizeof *plane; p++) {
        long pixels;
        float *pixel = draw(plane[p].name, plane[p].unit, &pixels);
        assert_int_equal(pixels, NX * NY * REPEAT * REPEAT);
        assert_true(isnan(pixel[REPEAT])); /* the second cell of the lowest row */
        for (int j = 0; j < NY * REPEAT; j++)
            for (int i = 0; i < NX * REPEAT; i++) {
                const int cell = j / REPEAT * NX + i / REPEAT;
                if (cell != 1)
                    check_close(pixel[j * NX * REPEAT + i], cell * plane[p].unit / plane[p].of_bar,
                                1e-6 * cell * plane[p].unit / plane[p].of_bar); /* a float */
            }
        free(pixel);
        assert_true(script_says(folder, plane[p].name, plane[p].range));
        assert_int_equal(script_says(folder, plane[p].name, plane[p].factor ? plane[p].factor : "10^"),
                         plane[p].factor != NULL);
    }
    postproc_gnuplot_end();
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(values_over_a_power_of_ten)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
