/* Rates in the cache folder: those of a solid that is known are taken to the bit, after a few sweeps. */
#include "solid/step/rates_cache.h"
#include "solid/step/rates.h"
#include "tests/check.h"
#include "tests/solid/make.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static char folder[256], file[512];
static long sweeps;

void __real_solid_force_bonds(struct solid *s, int may_break, double damping);
void __wrap_solid_force_bonds(struct solid *s, int may_break, double damping);
void __wrap_solid_force_bonds(struct solid *s, int may_break, double damping) {
    sweeps++;
    __real_solid_force_bonds(s, may_break, damping);
}

static void use_folder(void) {
    if (par_rank() == 0) {
        snprintf(folder, sizeof folder, "%s", FRANA_BINARY_DIR "/rates_XXXXXX");
        assert_non_null(mkdtemp(folder));
    }
    par_bcast(folder, sizeof folder, 0);
    setenv("XDG_CACHE_HOME", folder, 1);
    snprintf(file, sizeof file, "%s/frana/rates.txt", folder);
}

static void remove_folder(void) {
    char path[300];
    par_barrier();
    if (par_rank() != 0) return;
    unlink(file);
    snprintf(path, sizeof path, "%s/frana", folder);
    rmdir(path);
    rmdir(folder);
}

static void lines(void **state) {
    (void)state;
    use_folder();
    struct solid_rates_mark mark = {.stiffness = {1. / 3, 2}, .damping = {3, 4}, .particles = 1, .ranks = 1};
    const struct solid_rates rates = {.stiffness = 1. / 7, .damping = 5, .sum = 1.5, .difference = 0.5};
    struct solid_rates found = {.absolute = 9};
    assert_false(solid_rates_cache_find(&mark, &found));
    solid_rates_cache_add(&mark, &rates);
    par_barrier();
    assert_true(solid_rates_cache_find(&mark, &found));
    check_equal(found.stiffness, rates.stiffness);
    check_equal(found.damping, 5);
    check_equal(found.sum, 1.5);
    check_equal(found.difference, 0.5);
    check_equal(found.absolute, 9);
    mark.damping[0] = nextafter(3, 4);
    assert_true(solid_rates_cache_like(&mark));
    assert_false(solid_rates_cache_find(&mark, &found));
    mark.damping[0] = 3;
    mark.stiffness[0] = nextafter(1. / 3, 1);
    assert_false(solid_rates_cache_like(&mark));
    for (int k = 0; k < 99; k++) { /* with the first one a hundred; one more, and the first is dropped */
        mark.stiffness[0] = k;
        solid_rates_cache_add(&mark, &rates);
    }
    par_barrier();
    mark.stiffness[0] = 1. / 3;
    assert_true(solid_rates_cache_find(&mark, &found));
    mark.stiffness[0] = -1;
    solid_rates_cache_add(&mark, &rates);
    par_barrier();
    mark.stiffness[0] = 1. / 3;
    assert_false(solid_rates_cache_find(&mark, &found));
    mark.stiffness[0] = 0;
    assert_true(solid_rates_cache_find(&mark, &found));
    mark.stiffness[0] = 1000; /* rates that no iteration gives are not taken */
    solid_rates_cache_add(&mark, &(struct solid_rates){.stiffness = NAN});
    par_barrier();
    assert_false(solid_rates_cache_find(&mark, &found));
    mark.stiffness[0] = 0;
    par_barrier();
    if (par_rank() == 0) assert_int_equal(truncate(file, 100), 0); /* within the first line */
    par_barrier();
    assert_false(solid_rates_cache_find(&mark, &found));
    solid_rates_cache_add(&mark, &rates);
    par_barrier();
    assert_true(solid_rates_cache_find(&mark, &found));
    remove_folder();
}

/* A block, its twin, the twin with other damping, and the block with one layer held. */
static void solids(void **state) {
    (void)state;
    use_folder();
    const struct solid_constraint hold = {
        .low = {0, 0, 0}, .high = {30 * SPACING, 30 * SPACING, SPACING}, .direction = {1, 1, 1}};
    struct solid_rates rates[4];
    long taken[4];
    for (int k = 0; k < 4; k++) {
        struct solid *s = make((struct make){.sites = {28, 28, 28}, .constraints = k == 3, .constraint = &hold});
        s->stage.damping_relative = k == 2 ? 2e12 : 1e12;
        sweeps = 0;
        solid_rates_of(s, &rates[k]);
        taken[k] = sweeps;
        solid_free(s);
    }
    assert_true(taken[0] > 40);
    assert_int_equal(taken[1], 4);
    assert_true(taken[2] > 40 && taken[3] > 40);
    assert_memory_equal(&rates[0], &rates[1], sizeof rates[0]);
    check_relative(rates[2].damping, 2 * rates[0].damping, 1e-9);
    assert_true(rates[3].stiffness != rates[0].stiffness);
    remove_folder();
}

/* Without a cache folder the rates are found as ever. */
static void no_folder(void **state) {
    (void)state;
    setenv("XDG_CACHE_HOME", "/proc/no_such_place", 1);
    struct solid_rates_mark mark = {.stiffness = {1}};
    struct solid_rates rates = {.stiffness = 1};
    solid_rates_cache_add(&mark, &rates);
    assert_false(solid_rates_cache_find(&mark, &rates));
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(lines), cmocka_unit_test(solids), cmocka_unit_test(no_folder)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
