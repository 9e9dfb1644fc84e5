/* A file is read whole, whatever its length; what cannot be read gives NULL. */
#include "base/files/read_file.h"
#include "tests/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void every_length_is_read(void **state) {
    (void)state;
    static const int length[] = {0, 1, (1 << 14) - 2, (1 << 14) - 1, 1 << 14, (1 << 14) + 1, 100000};
    char path[] = "/tmp/frana_whole_XXXXXX";
    const int file = mkstemp(path);
    assert_true(file >= 0);
    close(file);
    for (size_t k = 0; k < sizeof length / sizeof *length; k++) {
        FILE *out = fopen(path, "w");
        assert_non_null(out);
        for (int i = 0; i < length[k]; i++) fputc('a' + i % 23, out);
        assert_int_equal(fclose(out), 0);
        char *text = read_file(path);
        assert_non_null(text);
        assert_int_equal(strlen(text), length[k]);
        for (int i = 0; i < length[k]; i++) assert_int_equal(text[i], 'a' + i % 23);
        free(text);
    }
    unlink(path);
}

static void what_cannot_be_read_is_null(void **state) {
    (void)state;
    assert_null(read_file("/tmp/frana_whole_there_is_no_such_file"));
    assert_null(read_file("/tmp")); /* a folder opens, but does not read */
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_length_is_read),
                                       cmocka_unit_test(what_cannot_be_read_is_null)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
