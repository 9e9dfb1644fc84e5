/* The file of speeds: medians of the newest samples of such runs, and files that are broken, strange or not writable.
 */
#include "base/machine.h"
#include "base/files/cache.h"
#include "program/check/speed.h"
#include "tests/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[] = "/tmp/frana_speed_XXXXXX", path[CACHE_PATH];

static int begin(void **state) {
    (void)state;
    if (!mkdtemp(folder)) return 1;
    setenv("XDG_CACHE_HOME", folder, 1);
    return !cache_path(path, "speed.csv", 1);
}

static int fresh(void **state) {
    (void)state;
    remove(path);
    return 0;
}

static struct speed_sample sample(const char *kind, int ranks, double when, double cell) {
    struct speed_sample s = {.processor = "one",
                             .build = "0 1",
                             .cores = 2,
                             .ranks = ranks,
                             .when = when,
                             .part = {cell, 0, 2 * cell, 3, 4, 0.5}};
    snprintf(s.kind, sizeof s.kind, "%s", kind);
    return s;
}

static void keep(const char *kind, int ranks, double when, double cell) {
    const struct speed_sample s = sample(kind, ranks, when, cell);
    speed_append(&s);
}

static struct speed_estimate known_of(const char *kind, int ranks) {
    const struct speed_sample like = sample(kind, ranks, 0, 0);
    return speed_lookup(&like);
}

/* Of such runs on as many ranks, else of such runs, else of all; a number that no run had is not known. */
static void the_nearest_runs_are_taken(void **state) {
    (void)state;
    assert_int_equal(known_of("space fluid", 1).samples, 0);
    keep("space fluid", 1, 100, 10);
    keep("space fluid", 1, 200, 30);
    keep("space fluid", 1, 300, 20);
    keep("space fluid", 2, 400, 50);
    keep("plate bonds", 1, 500, 70);
    struct speed_estimate k = known_of("space fluid", 1);
    assert_true(k.samples == 3 && k.same_kind && k.same_ranks);
    check_equal(k.newest, 300);
    check_equal(k.part[SPEED_CELL], 20);
    check_equal(k.part[SPEED_IMMERSED], 0);
    check_equal(k.part[SPEED_BOND], 40);
    check_equal(k.part[SPEED_SAMPLE], 3);
    check_equal(k.part[SPEED_FILE], 4);
    check_equal(k.part[SPEED_REST], 0.5);
    k = known_of("space fluid", 4);
    assert_true(k.samples == 4 && k.same_kind && !k.same_ranks);
    check_equal(k.part[SPEED_CELL], 25);
    k = known_of("space", 1);
    assert_true(k.samples == 5 && !k.same_kind);
    struct speed_sample other = sample("space fluid", 1, 0, 0);
    other.cores = 3;
    assert_int_equal(speed_lookup(&other).samples, 0);
}

/* Of such runs those of about the size, on any number of ranks, before those of other sizes on as many ranks: a solid
 * of few particles takes long a particle. */
static void runs_of_the_size_are_taken(void **state) {
    (void)state;
    struct speed_sample large = sample("space bonds", 2, 100, 10), small = sample("space bonds", 1, 200, 500);
    large.size[SPEED_BONDS] = 3e6;
    small.size[SPEED_BONDS] = 100;
    speed_append(&small);
    struct speed_sample like = sample("space bonds", 1, 0, 0);
    like.size[SPEED_BONDS] = 1e6;
    struct speed_estimate k = speed_lookup(&like);
    assert_true(k.samples == 1 && k.same_kind && k.same_ranks);
    check_relative(k.apart, 1e4, 1e-14);
    check_equal(k.part[SPEED_CELL], 500);
    speed_append(&large);
    speed_append(&small);
    k = speed_lookup(&like);
    assert_true(k.samples == 1 && k.same_kind && !k.same_ranks);
    check_relative(k.apart, 3, 1e-14);
    check_equal(k.part[SPEED_CELL], 10);
    like.size[SPEED_BONDS] = 2e5; /* 15 times smaller, and 2000 times larger */
    k = speed_lookup(&like);
    assert_int_equal(k.samples, 1);
    check_relative(k.apart, 15, 1e-14);
    check_equal(k.part[SPEED_CELL], 10);
}

/* A bench tells no times of samples and files: those of other runs are taken. */
static void outputs_of_other_runs(void **state) {
    (void)state;
    struct speed_sample bench = sample("space fluid", 1, 200, 10);
    bench.part[SPEED_SAMPLE] = bench.part[SPEED_FILE] = 0;
    speed_append(&bench);
    struct speed_estimate k = known_of("space fluid", 1);
    check_equal(k.part[SPEED_SAMPLE], 0);
    keep("plate bonds", 2, 100, 70);
    k = known_of("space fluid", 1);
    assert_true(k.samples == 1 && k.same_kind && k.same_ranks);
    check_equal(k.newest, 200);
    check_equal(k.part[SPEED_CELL], 10);
    check_equal(k.part[SPEED_SAMPLE], 3);
    check_equal(k.part[SPEED_FILE], 4);
}

/* Old samples go first; nine are used. */
static void the_file_stays_small(void **state) {
    (void)state;
    for (int k = 0; k < 250; k++) keep("space fluid", 1, 1000 + k, 1 + k);
    struct stat is;
    assert_int_equal(stat(path, &is), 0);
    check_below(is.st_size, 200 * 100);
    const struct speed_estimate k = known_of("space fluid", 1);
    assert_int_equal(k.samples, 9);
    check_equal(k.newest, 1249);
    check_equal(k.part[SPEED_CELL], 246);
}

static void broken_files_are_as_good_as_none(void **state) {
    (void)state;
    FILE *file = fopen(path, "w");
    fputs("#a head\n\n,,,,,,,,,,,\none,2,0 1,space fluid,1,7,nan,1,1,1,1,1,8,0,0\none,2,0 1,space "
          "fluid,1,7,1e99,1,1,1,1,1,8,0,0\none,2,0 1,space fluid,1,7,5,0,6,2,3,0.25,8,inf,0\none,2,0 1,space "
          "fluid,1,7,5,0,6,2,3,0.25\n",
          file);
    for (int k = 0; k < 5000; k++) fputc(k % 256, file);
    fputs("\none,2,0 1,space fluid,1,7,5,0,6,2,3,0.25,0,0,0\none,2,0 1,space fluid,1,8,9",
          file); /* the last one is cut off */
    fclose(file);
    struct speed_estimate k = known_of("space fluid", 1);
    assert_int_equal(k.samples, 1);
    check_equal(k.part[SPEED_CELL], 5);
    keep("space fluid", 1, 9, 7);
    k = known_of("space fluid", 1);
    assert_int_equal(k.samples, 2);
    check_equal(k.part[SPEED_CELL], 6);
    remove(path);
    assert_int_equal(mkfifo(path, 0600), 0); /* one would wait for a writer */
    assert_int_equal(known_of("space fluid", 1).samples, 0);
    keep("space fluid", 1, 9, 7);
    assert_int_equal(known_of("space fluid", 1).samples, 1);
    remove(path);
    mkdir(path, 0700);
    keep("space fluid", 1, 9, 7);
    assert_int_equal(known_of("space fluid", 1).samples, 0);
    rmdir(path);
    setenv("XDG_CACHE_HOME", "/proc/no_such_place", 1);
    keep("space fluid", 1, 9, 7);
    unsetenv("XDG_CACHE_HOME");
    unsetenv("HOME");
    keep("space fluid", 1, 9, 7);
    assert_int_equal(known_of("space fluid", 1).samples, 0);
    setenv("XDG_CACHE_HOME", folder, 1);
}

/* Times the number of ranks, over the amount of work; what the run had none of is 0. */
static void a_sample_of_some_work(void **state) {
    (void)state;
    const struct speed_work work = {.seconds = 12, .amount = {1e9, 0, 4e9, 1e6, 1e8}, .seconds_of = {8, 3, 12, 0, 2}};
    struct speed_sample s = {.ranks = 2};
    assert_true(speed_sample_set(&work, &s));
    check_relative(s.part[SPEED_CELL], 8, 1e-15);
    check_equal(s.part[SPEED_IMMERSED], 0);
    check_relative(s.part[SPEED_BOND], 3, 1e-15);
    check_equal(s.part[SPEED_SAMPLE], 0);
    check_relative(s.part[SPEED_FILE], 20, 1e-15);
    check_relative(s.part[SPEED_REST], 1. / 11, 1e-14); /* 12 s of wall, of which 4 + 6 + 1 s */
    const struct speed_work none = {.seconds = 12};
    assert_false(speed_sample_set(&none, &s));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test_setup(the_nearest_runs_are_taken, fresh),
                                       cmocka_unit_test_setup(runs_of_the_size_are_taken, fresh),
                                       cmocka_unit_test_setup(outputs_of_other_runs, fresh),
                                       cmocka_unit_test_setup(the_file_stays_small, fresh),
                                       cmocka_unit_test_setup(broken_files_are_as_good_as_none, fresh),
                                       cmocka_unit_test(a_sample_of_some_work)};
    return cmocka_run_group_tests(tests, begin, NULL);
}
