/* Scripts of plots: powers of ten beside the axes, a start-up spike cut off, the legend outside, all formats; many
 * curves, short logarithmic axes. */
#include "base/par.h"
#include "base/files/folder.h"
#include "postproc/charts/plot.h"
#include "tests/check.h"
#include "tests/postproc/charts/script.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>

static const char folder[] = FRANA_BINARY_DIR "/tests/postproc/plots";
enum { N = 500 };

/* The range that a script sets for an axis; NaN without one. */
static void range_of(const char *name, char axis, double range[2]) {
    char path[FOLDER_PATH], file[64], line[1024], form[64];
    snprintf(file, sizeof file, "%s.gp", name);
    snprintf(form, sizeof form, "set %crange [%%lf:%%lf]", axis);
    FILE *f = fopen(folder_path(path, folder, file), "r");
    range[0] = range[1] = NAN;
    while (f && fgets(line, sizeof line, f)) sscanf(line, form, &range[0], &range[1]);
    if (f) fclose(f);
}

static void draw(const char *name, int curves, const struct postproc_curve *curve) {
    folder_make(folder);
    assert_int_equal(postproc_plot_draw(&(struct postproc_plot){.folder = folder,
                                                                .name = name,
                                                                .title = "A plot",
                                                                .xlabel = "t  [s]",
                                                                .ylabel = "p  [Pa]",
                                                                .curves = curves,
                                                                .curve = curve}),
                     POSTPROC_PLOT_DONE);
    static const char *const ends[] = {"png", "svg", "pdf"};
    for (int k = 0; k < 3; k++) {
        char path[FOLDER_PATH], file[64];
        struct stat is;
        snprintf(file, sizeof file, "%s.%s", name, ends[k]);
        assert_int_equal(stat(folder_path(path, folder, file), &is), 0);
        check_above(is.st_size, 1000);
    }
}

/* A wave between 2.9e5 and 3.1e5, with `high` added to the points first ... last - 1. */
static struct postproc_curve wave(double *x, double *y, int first, int last, double high) {
    for (int i = 0; i < N; i++) {
        x[i] = i * 1e-5;
        y[i] = 3e5 + 1e4 * sin(0.05 * i) + (i >= first && i < last ? high : 0);
    }
    return (struct postproc_curve){.title = "a wave", .n = N, .x = x, .y = y};
}

static void powers_of_ten(void **state) {
    (void)state;
    double x[N], y[N];
    const struct postproc_curve one = wave(x, y, 0, 0, 0), two[2] = {one, one};
    draw("powers", 1, &one);
    assert_true(script_says(folder, "powers", "10^{3}' at graph 0, graph 1"));
    assert_true(script_says(folder, "powers", "10^{-3}' at graph 1, graph 0"));
    assert_true(script_says(folder, "powers", "using ($1*1e3):($2*1e-3)"));
    assert_false(script_says(folder, "powers", "set yrange"));
    assert_false(script_says(folder, "powers", "title 'a wave'")); /* one curve needs no legend */
    draw("legend", 2, two);
    assert_true(script_says(folder, "legend", "set key outside right"));
    assert_true(script_says(folder, "legend", "title 'a wave'"));
    struct postproc_curve longer[2] = {one, one};
    longer[1].title = "a wave with a title that would take the plot's room";
    draw("long", 2, longer);
    assert_true(script_says(folder, "long", "set key outside center bottom"));
    assert_false(script_says(folder, "long", "outside right"));
    for (int i = 0; i < N; i++) {
        x[i] *= 1e5;
        y[i] *= 1e-5;
    }
    draw("plain", 1, &one);
    assert_true(script_says(folder, "plain", "using 1:2"));
    assert_false(script_says(folder, "plain", "10^{"));
}

/* A spike at the start does not set the range, and is told of; one in the middle is part of the result. */
static void spikes(void **state) {
    (void)state;
    double x[N], y[N], range[2];
    struct postproc_curve c = wave(x, y, 0, 4, 4e7);
    draw("spike", 1, &c);
    range_of("spike", 'y', range);
    check_between(range[0], 285, 290);
    check_between(range[1], 310, 315);
    assert_true(script_says(folder, "spike", "beyond the axis: 4.03e+07"));
    c = wave(x, y, 0, 4, -4e7);
    draw("spike_down", 1, &c);
    range_of("spike_down", 'y', range);
    check_between(range[0], 285, 290);
    c = wave(x, y, 250, 254, 4e7);
    draw("event", 1, &c);
    range_of("event", 'y', range);
    assert_true(isnan(range[0]));
    assert_true(script_says(folder, "event", "10^{6}'"));
}

/* The eighth curve has the first one's colour, and another form. */
static void many_curves(void **state) {
    (void)state;
    const double x[2] = {1, 2}, y[2] = {1, 2};
    struct postproc_curve curve[8];
    for (int k = 0; k < 8; k++)
        curve[k] = (struct postproc_curve){.title = "a line", .n = 2, .x = x, .y = y, .points = k != 6};
    draw("many", 8, curve);
    assert_true(
        script_says(folder, "many", "$curve0 using 1:2 with linespoints pt 7 ps 1.1 lw 2 dt 1 lc rgb '#0072B2'"));
    assert_true(script_says(folder, "many", "$curve6 using 1:2 with lines lw 2 dt 1 lc rgb '#000000'"));
    assert_true(
        script_says(folder, "many", "$curve7 using 1:2 with linespoints pt 5 ps 1.1 lw 2 dt 2 lc rgb '#0072B2'"));
}

/* A logarithmic axis of few decades names the ends of its data, but not beside a power of ten. */
static void short_axes(void **state) {
    (void)state;
    const double x[2] = {0.89, 20}, y[2] = {2e-3, 1.04e-2};
    const struct postproc_curve c = {.title = "a line", .n = 2, .x = x, .y = y, .points = 1};
    folder_make(folder);
    assert_int_equal(postproc_plot_draw(&(struct postproc_plot){.folder = folder,
                                                                .name = "short",
                                                                .title = "A plot",
                                                                .xlabel = "t  [s]",
                                                                .ylabel = "error",
                                                                .curves = 1,
                                                                .curve = &c,
                                                                .log_x = 1,
                                                                .log_y = 1}),
                     POSTPROC_PLOT_DONE);
    assert_true(script_says(folder, "short", "set xtics add (20)"));
    assert_false(script_says(folder, "short", "(0.89)"));
    assert_true(script_says(folder, "short", "set ytics add (0.002)"));
    assert_false(script_says(folder, "short", "(0.01)"));
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(powers_of_ten), cmocka_unit_test(spikes),
                                       cmocka_unit_test(many_curves), cmocka_unit_test(short_axes)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
