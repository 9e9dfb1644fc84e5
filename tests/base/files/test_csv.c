/* Cells of CSV files are in quotes where they must be. */
#include "base/files/csv.h"
#include "tests/check.h"

static void cells_are_quoted_where_needed(void **state) {
    (void)state;
    static const char *const table[][2] = {
        {"plain text", "plain text"},     {"", ""},          {"a,b", "\"a,b\""}, {"say \"x\"", "\"say \"\"x\"\"\""},
        {"two\nlines", "\"two\nlines\""}, {"\"", "\"\"\"\""}};
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        char text[100];
        FILE *file = tmpfile();
        assert_non_null(file);
        csv_put(file, table[k][0]);
        rewind(file);
        text[fread(text, 1, sizeof text - 1, file)] = '\0';
        fclose(file);
        assert_string_equal(text, table[k][1]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(cells_are_quoted_where_needed)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
