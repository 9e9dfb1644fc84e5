/* Arrays: aligned, zeroed, counted by part, and with their contents where an array grows. */
#include "base/memory.h"
#include "tests/check.h"

static void arrays_are_aligned_zeroed_and_counted(void **state) {
    (void)state;
    const size_t sizes[] = {0, 1, 7, 64, 1000, 1 << 20, 3 << 20, (3 << 20) + 5};
    enum { N = sizeof sizes / sizeof *sizes };
    char *array[N];
    size_t all = 0, lines[N];
    const size_t before = memory_bytes(MEMORY_IBM), fluid = memory_bytes(MEMORY_FLUID);
    for (int i = 0; i < N; i++) {
        array[i] = memory_new(MEMORY_IBM, sizes[i], 1);
        assert_int_equal((uintptr_t)array[i] % 64, 0);
        lines[i] = (uintptr_t)array[i] % (2 << 20) / 64;
        for (size_t k = 0; k < sizes[i]; k++)
            if (array[i][k]) fail_msg("byte %zu of %zu is not 0", k, sizes[i]);
        memset(array[i], 'x', sizes[i]);
        assert_int_equal(memory_bytes(MEMORY_IBM) - before, all += sizes[i]);
    }
    assert_true(lines[5] != lines[6] && lines[6] != lines[7]); /* large arrays start in different cache lines */
    assert_int_equal(memory_bytes(MEMORY_FLUID), fluid);
    for (int i = 0; i < N; i++) memory_free(array[i]);
    memory_free(NULL);
    assert_int_equal(memory_bytes(MEMORY_IBM), before);
}

/* The most that was held, and from then on the most since. */
static void the_most_is_counted(void **state) {
    (void)state;
    const size_t before = memory_bytes(MEMORY_IBM);
    memory_high_water(MEMORY_IBM);
    char *a = memory_new(MEMORY_IBM, 1000, 1), *b = memory_new(MEMORY_IBM, 500, 1);
    memory_free(b);
    assert_int_equal(memory_high_water(MEMORY_IBM), before + 1500);
    memory_free(a);
    assert_int_equal(memory_high_water(MEMORY_IBM), before + 1000);
    assert_int_equal(memory_high_water(MEMORY_IBM), before);
}

static void a_copy_has_room_for_one_more(void **state) {
    (void)state;
    const long from[3] = {5, -6, 7};
    const size_t before = memory_bytes(MEMORY_SOLID);
    long *copy = memory_copy(MEMORY_SOLID, from, 3, sizeof *from);
    assert_int_equal(memory_bytes(MEMORY_SOLID) - before, 4 * sizeof *from);
    for (int i = 0; i < 3; i++) assert_int_equal(copy[i], from[i]);
    assert_int_equal(copy[3], 0);
    memory_free(copy);
    copy = memory_copy(MEMORY_SOLID, NULL, 0, sizeof *from);
    assert_int_equal(copy[0], 0);
    memory_free(copy);
    assert_int_equal(memory_bytes(MEMORY_SOLID), before);
}

static void a_grown_array_keeps_its_items(void **state) {
    (void)state;
    const size_t before = memory_bytes(MEMORY_OUTPUT);
    int *a = memory_grown(MEMORY_OUTPUT, NULL, 0, 3, sizeof *a);
    for (int i = 0; i < 3; i++) a[i] = i + 1;
    a = memory_grown(MEMORY_OUTPUT, a, 2, 500, sizeof *a);
    assert_int_equal(memory_bytes(MEMORY_OUTPUT) - before, 500 * sizeof *a);
    for (int i = 0; i < 500; i++) assert_int_equal(a[i], i < 2 ? i + 1 : 0); /* item 2 was not said to be used */
    a = memory_renew(MEMORY_OUTPUT, a, 8, sizeof *a);
    assert_int_equal(memory_bytes(MEMORY_OUTPUT) - before, 8 * sizeof *a);
    for (int i = 0; i < 8; i++) assert_int_equal(a[i], 0);
    memory_free(a);
    assert_int_equal(memory_bytes(MEMORY_OUTPUT), before);
}

/* Scratch that is read before it is written must show in a debug build, and is 0 otherwise. */
static void scratch_is_marked_in_debug_builds(void **state) {
    (void)state;
    double *work = memory_new_work(MEMORY_COUPLING, 9);
    for (int i = 0; i < 9; i++) {
#ifdef FRANA_DEBUG
        assert_true(isnan(work[i]));
#else
        check_equal(work[i], 0);
#endif
    }
    memory_free(work);
}

/* 64 MB that are touched are resident. */
static void the_peak_counts_what_was_touched(void **state) {
    (void)state;
    const size_t bytes = 64 << 20;
    void *a = memory_new(MEMORY_FLUID, bytes, 1);
    check_at_least((double)memory_peak(), (double)bytes);
    memory_free(a);
    check_at_least((double)memory_peak(), (double)bytes); /* also after it is given back */
}

static void parts_have_names(void **state) {
    (void)state;
    assert_string_equal(memory_name(MEMORY_FLUID), "fluid");
    assert_string_equal(memory_name(MEMORY_SOLID), "solid");
    assert_string_equal(memory_name(MEMORY_IBM), "ibm");
    assert_string_equal(memory_name(MEMORY_COUPLING), "coupling");
    assert_string_equal(memory_name(MEMORY_OUTPUT), "output");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(arrays_are_aligned_zeroed_and_counted),
                                       cmocka_unit_test(the_most_is_counted),
                                       cmocka_unit_test(a_copy_has_room_for_one_more),
                                       cmocka_unit_test(a_grown_array_keeps_its_items),
                                       cmocka_unit_test(scratch_is_marked_in_debug_builds),
                                       cmocka_unit_test(the_peak_counts_what_was_touched),
                                       cmocka_unit_test(parts_have_names)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
