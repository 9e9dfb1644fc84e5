/* Memory that is kept until all of it is freed. */
#include "base/arena.h"
#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

static void texts_are_printed(void **state) {
    (void)state;
    char *first = arena_text("%s = %d", "cells", -12), *second = arena_text("%100000d;", 7);
    assert_string_equal(first, "cells = -12");
    assert_int_equal(strlen(second), 100001);
    arena_free();
}

static void arrays_begin_with_zeros_and_grow(void **state) {
    (void)state;
    long *a = NULL;
    for (long n = 0; n < 100; n++) {
        a = arena_grown(a, (size_t)n, sizeof *a);
        assert_int_equal(a[n], 0);
        a[n] = n * n;
    }
    for (long n = 0; n < 100; n++) assert_int_equal(a[n], n * n);
    arena_free();
}

/* With ASan a leak or a second free fails. */
static void what_malloc_gave_is_kept_too(void **state) {
    (void)state;
    char *text = arena_keep(strdup("abc"));
    assert_string_equal(text, "abc");
    assert_null(arena_keep(NULL));
    arena_free();
    arena_free();
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(texts_are_printed),
                                       cmocka_unit_test(arrays_begin_with_zeros_and_grow),
                                       cmocka_unit_test(what_malloc_gave_is_kept_too)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
