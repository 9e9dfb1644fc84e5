/* FFTW's plans in the cache folder: read before planning, written after it, none without a folder. */
/* Without a folder nothing is read or written. */
#include "fluid/poisson/transform.h"
#include "fluid/poisson/wisdom.h"
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

#include <fftw3.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

static char folder[256], file[512];

/* A transform that FFTW does. */
static void plan(int n) {
    const struct fluid_transform_input in = {
        .n = n, .low = FLUID_END_NEUMANN, .high = FLUID_END_DIRICHLET, .lines = 8, .stride = 1, .distance = n};
    fluid_transform_free(fluid_transform_new(&in));
}

static long length_of(const char *path) {
    struct stat s;
    return stat(path, &s) == 0 ? (long)s.st_size : -1;
}

/* No entry within FFTW's outer brackets. */
static int knows_nothing(void) {
    char *all = fftw_export_wisdom_to_string();
    const int none = strchr(strchr(all, '(') + 1, '(') == NULL;
    free(all);
    return none;
}

static void kept_from_run_to_run(void **state) {
    (void)state;
    if (par_rank() == 0) {
        snprintf(folder, sizeof folder, "%s", FRANA_BINARY_DIR "/wisdom_XXXXXX");
        assert_non_null(mkdtemp(folder));
    }
    par_bcast(folder, sizeof folder, 0);
    snprintf(file, sizeof file, "%s/frana/fftw.wisdom", folder);
    setenv("XDG_CACHE_HOME", folder, 1);
    fftw_forget_wisdom();
    fluid_wisdom_load();
    assert_true(knows_nothing());
    plan(48);
    fluid_wisdom_store();
    par_barrier();
    const long first = length_of(file);
    check_above(first, 0);
    fftw_forget_wisdom();
    fluid_wisdom_load();
    assert_false(knows_nothing());
    par_barrier();
    if (par_rank() == 0) { /* nothing new: the file is not changed */
        assert_int_equal(truncate(file, 5), 0);
        fluid_wisdom_store();
        assert_int_equal(length_of(file), 5);
    }
    par_barrier();
    fftw_forget_wisdom(); /* a truncated file gives no plans, and does no harm */
    fluid_wisdom_load();
    assert_true(knows_nothing());
    plan(48);
    fluid_wisdom_store();
    par_barrier();
    check_above(length_of(file), 5);
}

static void without_a_folder(void **state) {
    (void)state;
    setenv("XDG_CACHE_HOME", "/proc/no_such_place", 1);
    fftw_forget_wisdom();
    fluid_wisdom_load();
    assert_true(knows_nothing());
    plan(40);
    fluid_wisdom_store();
    assert_int_equal(length_of("/proc/no_such_place/frana/fftw.wisdom"), -1);
    par_barrier();
    if (par_rank() == 0) {
        char path[300];
        unlink(file);
        snprintf(path, sizeof path, "%s/frana", folder);
        rmdir(path);
        rmdir(folder);
    }
}

FLUID_TEST_MAIN(cmocka_unit_test(kept_from_run_to_run), cmocka_unit_test(without_a_folder))
