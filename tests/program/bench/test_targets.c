/* Targets of speed: each number by hand from a few rows, the verdicts in both directions, the sentences' numbers. */
#include "program/bench/sentence.h"
#include "program/bench/targets.h"
#include "tests/check.h"

#include <glob.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Reads a file with this text, which is then removed. */
static void given(struct bench_page_files *p, const char *ending, const char *text) {
    char path[256];
    snprintf(path, sizeof path, FRANA_BINARY_DIR "/bench_targets_%ld%s", (long)getpid(), ending);
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    assert_int_equal(fclose(file), 0);
    bench_page_read(p, path);
    assert_int_equal(remove(path), 0);
}

/* Times such that each number below is easily computed; the run has 10 + 10 + 10 steps, 90 sweeps, 30 of them in
 * settle. */
static struct bench_page_files measured(void) {
    struct bench_page_files p = {0};
    given(&p, ".csv",
          "part,size,ranks,median_ms,low_ms,high_ms,ns_per_unit,units,bytes_per_unit,fraction_of_limit\n"
          "fluid_step,128x64x64,2,8,7,10,4,,504,0.5\n"
          "sweep_full,54872,1,2,1,4,0.5,,,\n"
          "sweep_full,54872,2,1,1,2,0.625,,,\n"
          "sweep_full_double,54872,1,2,2,2,0.5,,,\n"
          "sweep_full_mixed,54872,1,1,1,1,0.25,,,\n"
          "forcing,128x64x64,2,3,2,4,,,,\n"
          "probe,128x64x64,2,2,1,5,,,,\n"
          "markers,128x64x64,2,1,1,1,,,,\n"
          "interface,128x64x64,2,0.5,0.5,0.5,,,,\n"
          "interface_broken,128x64x64,2,1.5,1.5,1.5,,,,\n"
          "solid_substeps,128x64x64,2,6,6,6,,3000,,\n"
          "contact_broken,128x64x64,2,0.25,0.25,0.25,,,,\n"
          "crack_sweep,1000000,1,100,99,101,,,,\n"
          "crack_pressures,1000000,1,21,20,22,,,,\n"
          "memory_fluid,128x64x64,2,,,,,,84,\n"
          "memory_run,128x64x64,2,,,,,,300,\n");
    given(&p, "_lammps.csv", "code,bonds,theirs_ns,ours_ns,ratio,spread\nLAMMPS,1000,14,0.5,28,27-29\n");
    given(&p, "_cans.csv", "peer,part,size,ranks,theirs_ms,best_ms,ours_ms\nCaNS,fluid_step,128x64x64,2,70,40,12\n");
    given(&p, "_memory.csv",
          "part,size,ranks,bytes_per_unit,unit\nmemory_fluid,128x64x64,2,83.5,cell\nmemory_run,128x64x64,2,300,cell\n");
    given(
        &p, "_run.json",
        "{\n\"status\": \"done\",\n\"steps\": 30,\n\"substeps\": 7,\n\"ranks\": 2,\n\"wall_seconds\": 2,\n"
        "\"wall_seconds_by_part\": {\"solid\": 0.9, \"output\": 0.05},\n\"directed_bonds\": 1000,\n"
        "\"ns_per_directed_bond_sweep\": 2e4,\n\"timeline\": [\n"
        "{\"span\": \"flow\", \"steps\": 10, \"working\": {\"probe\": 0.02}, \"waiting\": {\"probe\": 0.01}},\n"
        "{\"span\": \"settle\", \"steps\": 10, \"working\": {\"contact\": 0}, \"waiting\": {\"contact\": 0}},\n"
        "{\"span\": \"fracture\", \"steps\": 10, \"working\": {\"contact\": 5}, \"waiting\": {\"contact\": 2}}]\n}\n");
    p.run[0].kind = BENCH_WHOLE_VERLET; /* there is no scene beside the file */
    return p;
}

static void check_value(struct bench_value v, double median, double low, double high) {
    check_close(v.median, median, 1e-12 * median);
    if (isnan(low)) {
        assert_true(isnan(v.low) && isnan(v.high));
        return;
    }
    check_close(v.low, low, 1e-12 * low);
    check_close(v.high, high, 1e-12 * high);
}

static void values(void **state) {
    (void)state;
    struct bench_page_files p = measured();
    const struct bench_subject fluid = {"fluid_step", "128x64x64", 2, 0}, sweep = {"sweep_full", "54872", 1, 0},
                               run = {"", "", 2, 0}, rk3 = {"", "", 2, 1};
    check_value(bench_value_ms(&p, &fluid), 8, 7, 10);
    check_value(bench_value_ns(&p, &sweep), 0.5, 0.25, 1);
    check_value(bench_value_roofline(&p, &fluid), 50, 40, 400.0 / 7);
    check_value(bench_value_core_speed(&p, &sweep), 80, 100 * 0.25 / 1.25, 100 / 0.625);
    check_value(bench_value_lammps(&p, &sweep), 28 * 0.5 / 0.25, NAN, NAN);
    check_value(bench_value_immersed(&p, &(struct bench_subject){"forcing", "128x64x64", 2, 0}), 5, 3, 9);
    check_value(bench_value_cracks(&p, &(struct bench_subject){"crack_pressures", "1000000", 1, 0}), 21, NAN, NAN);
    check_value(bench_value_contact(&p, &run), 7, NAN, NAN);
    check_value(bench_value_minutes(&p, &run), 2.0 / 60, NAN, NAN);
    check_value(bench_value_output(&p, &run), 100 * (0.05 + 0.02 + 0.01) / 2, NAN, NAN);
    check_close(bench_whole_sweeps(&p.run[0]), 90, 1e-10);
    check_close(bench_value_substeps(&p), 3, 1e-12);
    check_close(bench_value_sweeps(&p), 6, 1e-12);
    /* 30 (8 + 3) + 20 (1 + 2) + 10 0.5 + 10 1.5 + 90 6/3 + 60 0.25 ms of 2 s */
    const double ms = 330 + 60 + 5 + 15 + 180 + 15;
    check_close(bench_value_parts(&p, &run).median, 100 * 1e-3 * ms / 2, 1e-9);
    /* without 30 (1 + 1) and 20 1 ms; with 30 (2 + 1) and 20 3 ms more */
    check_close(bench_value_parts(&p, &run).low, 100 * 1e-3 * (ms - 80) / 2, 1e-9);
    check_close(bench_value_parts(&p, &run).high, 100 * 1e-3 * (ms + 150) / 2, 1e-9);
    check_close(bench_value_peers(&p, &run).median, (30 * 40e-3 + 14e-9 * 90 * 1000 / 2) / 60, 1e-12);
    assert_true(isnan(bench_value_minutes(&p, &rk3).median));
    bench_page_free(&p);
}

/* The table's line whose number is this of this part. */
static struct bench_target line(bench_value_of *ours, const char *part) {
    int k = 0;
    while (k < bench_targets_count && (bench_targets[k].ours != ours || strcmp(bench_targets[k].of.part, part))) k++;
    assert_true(k < bench_targets_count);
    return bench_targets[k];
}

static enum bench_verdict verdict_of(const struct bench_page_files *p, struct bench_target t) {
    struct bench_value ours;
    double reach;
    return bench_targets_verdict(p, &t, &ours, &reach);
}

static void verdicts(void **state) {
    (void)state;
    struct bench_page_files p = measured();
    struct bench_target most = line(bench_value_ms, "fluid_step"), least = line(bench_value_core_speed, "sweep_full");
    most.reach = 8; /* ours is 8, and 80 */
    least.reach = 80 - 1e-9;
    assert_int_equal(verdict_of(&p, most), BENCH_REACHED);
    assert_int_equal(verdict_of(&p, least), BENCH_REACHED);
    most.reach = 7.99;
    least.reach = 80.01;
    assert_int_equal(verdict_of(&p, most), BENCH_NOT_REACHED);
    assert_int_equal(verdict_of(&p, least), BENCH_NOT_REACHED);
    assert_int_equal(verdict_of(&p, line(bench_value_ms, "channel_step")), BENCH_NOT_MEASURED);
    assert_int_equal(verdict_of(&p, line(bench_value_bytes, "memory_fluid")), BENCH_NOT_REACHED);
    assert_int_equal(verdict_of(&p, line(bench_value_bytes, "memory_run")), BENCH_REACHED);
    assert_int_equal(verdict_of(&p, line(bench_value_bytes, "memory_list_bond")), BENCH_NOT_MEASURED);
    /* a run that was resumed can only miss the time of a whole one */
    struct bench_target whole = line(bench_value_minutes, "");
    assert_int_equal(verdict_of(&p, whole), BENCH_REACHED);
    p.run[0].from = 10;
    assert_int_equal(verdict_of(&p, whole), BENCH_NOT_MEASURED);
    p.run[0].wall_seconds = 6000;
    assert_int_equal(verdict_of(&p, whole), BENCH_NOT_REACHED);
    bench_page_free(&p);
}

static char *written(const struct bench_page_files *p, const char *sentence) {
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    if (sentence)
        bench_sentence_write(to, p, sentence);
    else
        bench_targets_write(to, p);
    fclose(to);
    return text;
}

static void check_said(const struct bench_page_files *p, const char *sentence, const char *expected) {
    char *text = written(p, sentence);
    assert_string_equal(text, expected);
    free(text);
}

static void sentences(void **state) {
    (void)state;
    struct bench_page_files p = measured();
    check_said(&p, "no number", "no number");
    check_said(&p, "{ms fluid_step 128x64x64 2} of {least fluid_step - 2} ms: {roofline fluid_step - 2} %.",
               "8 of 4 ms: 50 %.");
    check_said(&p, "{bytes memory_fluid 128x64x64 2} and {before memory_fluid 128x64x64 2} B", "84 and 83.5 B");
    check_said(&p, "{cans fluid_step -}{cans fluid_step 128x64x64}, {cans_best fluid_step 128x64x64}", "–70, 40");
    check_said(&p, "{lammps} ns, {lammps_ratio}", "14 ns, 28");
    check_said(&p, "{sweeps} {substeps_alone} {substeps 0} {substeps 1}", "6 3 7 –");
    check_said(&p, "{stage fracture contact} ms, {share solid} %, {share solid 2} %", "700 ms, 45 %, – %");
    bench_page_free(&p);
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
    char folder[256], path[2][300];
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

/* The files of the repository: no sentence lacks a number, and the headline counts the lines that say so. */
static void repository(void **state) {
    (void)state;
    struct bench_page_files p = {0};
    glob_t found;
    assert_int_equal(glob(FRANA_SOURCE_DIR "/bench/results/*.csv", 0, NULL, &found), 0);
    assert_int_equal(glob(FRANA_SOURCE_DIR "/bench/results/*/run.json", GLOB_APPEND, NULL, &found), 0);
    assert_int_equal(glob(FRANA_SOURCE_DIR "/bench/reference/*.csv", GLOB_APPEND, NULL, &found), 0);
    for (size_t k = 0; k < found.gl_pathc; k++) bench_page_read(&p, found.gl_pathv[k]);
    globfree(&found);
    for (int k = 0; k < bench_targets_count; k++) {
        char *why = written(&p, bench_targets[k].why);
        if (strpbrk(why, "{}") || strstr(why, "–") || !*why) fail_msg("a number is missing: %s", why);
        free(why);
    }
    char *page = written(&p, NULL);
    int reached, all, said = 0;
    assert_int_equal(sscanf(page, "**%d of %d reached", &reached, &all), 2);
    for (const char *at = page; (at = strstr(at, "| reached |")); at++) said++;
    assert_int_equal(reached, said);
    assert_int_equal(all, bench_targets_count);
    free(page);
    bench_page_free(&p);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(values), cmocka_unit_test(verdicts),
                                       cmocka_unit_test(sentences), cmocka_unit_test(kinds),
                                       cmocka_unit_test(repository)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
