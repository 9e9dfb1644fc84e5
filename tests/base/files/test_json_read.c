/* A JSON file that the program wrote is read back by path. */
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/json.h"
#include "base/files/json_read.h"
#include "tests/check.h"

#include <stdio.h>

#define FOLDER FRANA_BINARY_DIR "/base/files/json_read"

static void what_is_written_is_read(void **state) {
    (void)state;
    const char *const quoted = "back\\slash \"quote\" \n\t\x01 \xc3\xa4";
    struct json *j = json_begin(FOLDER "/it.json");
    json_number(j, "third", 1. / 3);
    json_number(j, "none", NAN);
    json_long(j, "long", -12);
    json_bool(j, "yes", 1);
    json_text(j, "quoted", quoted);
    json_array(j, "list");
    json_long(j, NULL, 1);
    json_close(j);
    json_object(j, "inner");
    json_object(j, "most");
    json_number(j, "value", 2.5e-8);
    json_end(j);

    struct json_read *t = json_read_new(FOLDER "/it.json");
    assert_non_null(t);
    check_close(json_read_number(t, "third"), 1. / 3, 1e-15);
    assert_true(isnan(json_read_number(t, "none")));
    check_equal(json_read_number(t, "long"), -12);
    assert_string_equal(json_read_text(t, "yes"), "true");
    assert_string_equal(json_read_text(t, "quoted"), quoted);
    check_equal(json_read_number(t, "inner.most.value"), 2.5e-8);
    check_equal(json_read_number(t, "list.0"), 1);
    static const char *const none[] = {"other", "inner",  "inner.most", "inner.value", "long.value", "list",
                                       "thir",  "list.1", "list.-1",    "list.0.one",  "list.one",   "list.."};
    for (size_t k = 0; k < sizeof none / sizeof *none; k++) {
        if (json_read_text(t, none[k])) fail_msg("%s is found", none[k]);
        assert_true(isnan(json_read_number(t, none[k])));
    }
    assert_true(isnan(json_read_number(t, "quoted")));
    assert_string_equal(json_read_key(t, "", 0), "third");
    assert_string_equal(json_read_key(t, "", 6), "inner");
    assert_null(json_read_key(t, "", 7));
    assert_string_equal(json_read_key(t, "inner.most", 0), "value");
    assert_null(json_read_key(t, "long", 0));
    json_read_free(t);
}

static void a_file_that_cannot_be_read_is_no_tree(void **state) {
    (void)state;
    assert_null(json_read_new(FOLDER "/missing.json"));
    FILE *file = fopen(FOLDER "/broken.json", "w");
    assert_non_null(file);
    fputs("{\"a\": [1, 2", file);
    fclose(file);
    assert_null(json_read_new(FOLDER "/broken.json"));
    file = fopen(FOLDER "/empty.json", "w");
    fclose(file);
    assert_null(json_read_new(FOLDER "/empty.json"));
    assert_null(json_read_text(NULL, "a"));
    assert_true(isnan(json_read_number(NULL, "a")));
    json_read_free(NULL);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder_make(FOLDER);
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_is_written_is_read),
                                       cmocka_unit_test(a_file_that_cannot_be_read_is_no_tree)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
