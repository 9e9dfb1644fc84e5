/* Lines of the table of speed: each kind of number by hand from a few rows, what is reached, which files belong to
 * which machine. */
#include "program/bench/line.h"
#include "tests/check.h"

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

enum { MADE = 8 };
static char folder[256];
static struct {
    char path[MADE][300];
    const char *read[MADE];
    int files;
} made;

static void put(const char *name, const char *text) {
    char *path = made.path[made.files];
    snprintf(path, sizeof *made.path, "%s/%s", folder, name);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
    made.read[made.files++] = path;
}

/* A folder of one machine with a run below it. Times such that each number below is easily computed; the run has 10 +
 * 10 + 10 steps, 90 sweeps, 30 of them in settle. */
static struct bench_files measured(long from) {
    char below[300], run[1024];
    struct bench_files f = {0};
    made.files = 0;
    snprintf(folder, sizeof folder, FRANA_BINARY_DIR "/bench_line_%ld", (long)getpid());
    assert_int_equal(mkdir(folder, 0777), 0);
    snprintf(below, sizeof below, "%s/s3", folder);
    assert_int_equal(mkdir(below, 0777), 0);
    snprintf(run, sizeof run,
             "{\n\"status\": \"done\",\n\"steps\": 30,\n\"substeps\": 7,\n\"ranks\": 2,\n\"wall_seconds\": 2,\n"
             "\"resumed_at_step\": %ld,\n"
             "\"wall_seconds_by_part\": {\"solid\": 0.9, \"output\": 0.05},\n\"directed_bonds\": 1000,\n"
             "\"ns_per_directed_bond_sweep\": 2e4,\n\"timeline\": [\n"
             "{\"span\": \"flow\", \"steps\": 10, \"working\": {\"probe\": 0.02}, \"waiting\": {\"probe\": 0.01}},\n"
             "{\"span\": \"settle\", \"steps\": 10, \"working\": {\"contact\": 0}, \"waiting\": {\"contact\": 0}},\n"
             "{\"span\": \"fracture\", \"steps\": 10, \"working\": {\"contact\": 0.5}, \"waiting\": {\"contact\": "
             "0.2}}]\n}\n",
             from);
    put("s3/run.json", run); /* read after the tables, wherever it stands */
    put("machine-2.csv", "part,size,ranks,median_ms,ns_per_unit,units,bytes_per_unit,fraction_of_limit\n"
                         "fluid_step,128x64x64,2,8,4,,504,0.5\n"
                         "sweep_full,54872,1,2,0.5,,,\n"
                         "sweep_full,54872,2,1.25,0.625,,,\n"
                         "sweep_full_double,54872,1,2,0.5,,,\n"
                         "sweep_full_mixed,54872,1,1,0.25,,,\n"
                         "forcing,128x64x64,2,3,,,,\n"
                         "probe,128x64x64,2,2,,,,\n"
                         "markers,128x64x64,2,1,,,,\n"
                         "interface,128x64x64,2,0.5,,,,\n"
                         "interface_broken,128x64x64,2,1.5,,,,\n"
                         "solid_substeps,128x64x64,2,6,,3000,,\n"
                         "contact_broken,128x64x64,2,0.25,,,,\n"
                         "crack_sweep,1000000,1,100,,,,\n"
                         "crack_pressures,1000000,1,21,,,,\n"
                         "memory_fluid,128x64x64,2,,,,84,\n");
    put("machine-2-traffic.csv", "part,size,ranks,kind,messages,collectives,bytes\n");
    put("lammps.csv", "code,bonds,theirs_ns,ours_ns,ratio,spread\nLAMMPS,1000,14,0.5,28,27-29\n");
    put("cans.csv", "code,part,size,ranks,theirs_ms,ours_ms,ratio,spread\nCaNS,fluid_step,128x64x64,2,40,12,3.3,\n");
    bench_files_read(&f, made.files, made.read);
    for (int k = 0; k < made.files; k++) assert_int_equal(remove(made.path[k]), 0);
    assert_int_equal(rmdir(below), 0);
    assert_int_equal(rmdir(folder), 0);
    assert_int_equal(f.machines, 1);
    assert_string_equal(f.machine[0].folder, folder);
    f.machine[0].run[0].kind = BENCH_WHOLE_VERLET; /* there is no scene beside the file */
    return f;
}

static double value(const struct bench_files *f, struct bench_line line) {
    return bench_line_value(&line, &f->machine[0]);
}

static void values(void **state) {
    (void)state;
    struct bench_files f = measured(0);
    const struct bench_line fluid = {.part = "fluid_step", .size = "128x64x64", .ranks = 2};
    const struct bench_line full = {.part = "sweep_full", .size = "54872", .ranks = 1};
    struct bench_line l = fluid;
    check_close(value(&f, (l.kind = BENCH_LINE_MS, l)), 8, 1e-12);
    check_close(value(&f, (l.kind = BENCH_LINE_NS, l)), 4, 1e-12);
    check_close(value(&f, (l.kind = BENCH_LINE_BYTES, l)), 504, 1e-12);
    check_close(value(&f, (l.kind = BENCH_LINE_LIMIT, l)), 0.5, 1e-12);
    check_close(value(&f, (l.kind = BENCH_LINE_CANS, l)), 3.3, 1e-12);
    l = full;
    l.kind = BENCH_LINE_RATIO;
    check_close(value(&f, (l.over_ranks = 2, l)), 2 / 2.5, 1e-12); /* a core's speed on two ranks */
    l = full;
    check_close(value(&f, (l.kind = BENCH_LINE_LAMMPS, l)), 28, 1e-12);
    l.part = "sweep_full_mixed";
    check_close(value(&f, (l.over = "sweep_full_double", l)), 28 * 0.5 / 0.25, 1e-12);
    l = (struct bench_line){.kind = BENCH_LINE_RATIO, .part = "forcing+probe", .size = "128x64x64", .ranks = 2};
    check_close(value(&f, (l.over = "fluid_step", l)), 5.0 / 8, 1e-12);
    l = (struct bench_line){.kind = BENCH_LINE_RATIO, .part = "crack_pressures", .size = "1000000", .ranks = 1};
    check_close(value(&f, (l.over = "crack_sweep", l)), 0.21, 1e-12);
    assert_true(isnan(value(&f, (l.part = "crack_pressure", l))));
    bench_files_free(&f);
}

static void values_of_runs(void **state) {
    (void)state;
    struct bench_files f = measured(0);
    const struct bench_results *r = &f.machine[0];
    struct bench_line l = {.run = BENCH_WHOLE_VERLET};
    check_close(value(&f, (l.kind = BENCH_LINE_MINUTES, l)), 2.0 / 60, 1e-12);
    check_close(value(&f, (l.kind = BENCH_LINE_STEPS, l)), 2 / (30 * 8e-3), 1e-12);
    check_close(value(&f, (l.kind = BENCH_LINE_RUNS, l)), 1, 1e-12);
    check_close(value(&f, (l.kind = BENCH_LINE_CONTACT, l)), 0.7 / 2, 1e-12);
    check_close(value(&f, (l.kind = BENCH_LINE_OUTPUT, l)), (0.05 + 0.02 + 0.01) / 2, 1e-12);
    check_close(bench_whole_sweeps(&r->run[0]), 90, 1e-10);
    check_close(bench_line_substeps(r, &r->run[0]), 3, 1e-12);
    check_close(bench_line_sweeps(r, &r->run[0]), 6, 1e-12);
    /* 30 (8 + 3) + 20 (1 + 2) + 10 0.5 + 10 1.5 + 90 6/3 + 60 0.25 ms of 2 s */
    const double ms = 330 + 60 + 5 + 15 + 180 + 15;
    check_close(value(&f, (l.kind = BENCH_LINE_PARTS, l)), 1e-3 * ms / 2, 1e-9);
    assert_true(isnan(value(&f, (l.run = BENCH_WHOLE_RK3, l))));
    bench_files_free(&f);
    f = measured(10); /* a run that was resumed is no whole one: its time has no ratio */
    l = (struct bench_line){.run = BENCH_WHOLE_VERLET};
    assert_true(isnan(value(&f, (l.kind = BENCH_LINE_RUNS, l))));
    check_close(value(&f, (l.kind = BENCH_LINE_STEPS, l)), 2 / (20 * 8e-3), 1e-12);
    bench_files_free(&f);
}

static void targets(void **state) {
    (void)state;
    const struct bench_line most = {.most = 8}, least = {.least = 0.8}, none = {.most = 0};
    assert_true(bench_line_is_reached(&most, 8));
    assert_false(bench_line_is_reached(&most, 8.01));
    assert_true(bench_line_is_reached(&least, 0.8));
    assert_false(bench_line_is_reached(&least, 0.79));
    assert_false(bench_line_is_reached(&none, 0));
    assert_false(bench_line_is_reached(&most, NAN));
    assert_false(bench_line_is_reached(&least, NAN));
}

/* Every line was measured on a machine of the repository, and no line has two targets. A folder within another is a
 * machine of its own. */
static void repository(void **state) {
    (void)state;
    struct bench_files f = {0};
    glob_t found;
    assert_int_equal(glob(FRANA_SOURCE_DIR "/bench/results/*/*-[12]*.csv", 0, NULL, &found), 0);
    assert_int_equal(glob(FRANA_SOURCE_DIR "/bench/results/*/lammps.csv", GLOB_APPEND, NULL, &found), 0);
    assert_int_equal(glob(FRANA_SOURCE_DIR "/bench/results/*/cans.csv", GLOB_APPEND, NULL, &found), 0);
    assert_int_equal(glob(FRANA_SOURCE_DIR "/bench/results/*/*/run.json", GLOB_APPEND, NULL, &found), 0);
    bench_files_read(&f, (int)found.gl_pathc, (const char *const *)found.gl_pathv);
    globfree(&found);
    assert_int_equal(f.machines, 4);
    for (int m = 0; m < f.machines; m++) assert_true(f.machine[m].runs >= 2);
    for (int k = 0; k < bench_lines_count; k++) {
        int values_there = 0;
        for (int m = 0; m < f.machines; m++) values_there += !isnan(bench_line_value(&bench_lines[k], &f.machine[m]));
        if (!values_there) fail_msg("not measured anywhere: %s", bench_lines[k].what);
        assert_false(bench_lines[k].most > 0 && bench_lines[k].least > 0);
    }
    bench_files_free(&f);
}

/* A run's load and integrator are those of the scene beside it. */
static void kinds(void **state) {
    (void)state;
    static const struct {
        const char *scene;
        enum bench_whole_kind kind;
    } of[] = {
        {"coupling:\n  load: probe\nstages:\n  - {integrator: rk3}\n  - {integrator: verlet}\n", BENCH_WHOLE_VERLET},
        {"stages:\n- name: a\n  integrator: verlet\n  fluid_integrator: rk3\n", BENCH_WHOLE_VERLET},
        {"coupling:\n  load: wall\nstages:\n  - {integrator: verlet}\n  - {integrator: rk3}\n", BENCH_WHOLE_RK3},
        {"coupling:\n  load: reaction\nstages:\n  - {integrator: verlet}\n", BENCH_WHOLE_ECONOMICAL}};
    char path[2][300];
    snprintf(folder, sizeof folder, FRANA_BINARY_DIR "/bench_kinds_%ld", (long)getpid());
    assert_int_equal(mkdir(folder, 0777), 0);
    snprintf(path[0], sizeof path[0], "%s/run.json", folder);
    snprintf(path[1], sizeof path[1], "%s/scene.resolved.yaml", folder);
    for (size_t k = 0; k < sizeof of / sizeof *of; k++) {
        const char *text[] = {"{\n\"status\": \"done\",\n\"wall_seconds\": 2\n}\n", of[k].scene};
        for (int f = 0; f < 2; f++) {
            FILE *file = fopen(path[f], "w");
            assert_non_null(file);
            fputs(text[f], file);
            assert_int_equal(fclose(file), 0);
        }
        struct bench_whole whole = bench_whole_read(path[0]);
        assert_int_equal(whole.kind, of[k].kind);
        bench_whole_free(&whole);
    }
    for (int f = 0; f < 2; f++) assert_int_equal(remove(path[f]), 0);
    assert_int_equal(rmdir(folder), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(values), cmocka_unit_test(values_of_runs),
                                       cmocka_unit_test(targets), cmocka_unit_test(kinds),
                                       cmocka_unit_test(repository)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
