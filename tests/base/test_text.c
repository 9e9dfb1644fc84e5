/* Texts by printf, of any length. */
#include "base/text.h"
#include "tests/check.h"

#include <stdlib.h>

static void values_are_printed(void **state) {
    (void)state;
    char *text = text_new("%s = %d, %.3g%%", "cells", -12, 0.25);
    assert_string_equal(text, "cells = -12, 0.25%");
    free(text);
    char *empty = text_new("%s", "");
    assert_string_equal(empty, "");
    free(empty);
}

static void a_long_text_is_whole(void **state) {
    (void)state;
    char *text = text_new("%100000d;", 7);
    assert_int_equal(strlen(text), 100001);
    assert_string_equal(text + 99998, " 7;");
    free(text);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(values_are_printed), cmocka_unit_test(a_long_text_is_whole)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
