/* The text of a JSON file: indents, commas, quotes, and null for numbers that JSON lacks. */
#include "base/files/json.h"
#include "tests/check.h"
#include "tests/base/files/files.h"

#include <math.h>

static char path[FOLDER_PATH + 20];

static void the_file_is(const char *expected) {
    char text[1000];
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    assert_string_equal(text, expected);
}

static void values_of_every_kind(void **state) {
    (void)state;
    struct json *j = json_begin(path);
    json_text(j, "a", "b");
    json_number(j, "third", 1. / 3);
    json_number(j, "large", -1e300);
    json_long(j, "long", -9007199254740993L); /* no double holds it */
    json_bool(j, "yes", 2);
    json_bool(j, "no", 0);
    json_end(j);
    the_file_is("{\n  \"a\": \"b\",\n  \"third\": 0.333333333333333,\n  \"large\": -1e+300,\n"
                "  \"long\": -9007199254740993,\n  \"yes\": true,\n  \"no\": false\n}\n");
}

static void no_number_is_null(void **state) {
    (void)state;
    struct json *j = json_begin(path);
    json_array(j, "none");
    json_number(j, NULL, NAN);
    json_number(j, NULL, INFINITY);
    json_number(j, NULL, -INFINITY);
    json_end(j);
    the_file_is("{\n  \"none\": [\n    null,\n    null,\n    null\n  ]\n}\n");
}

static void quotes_and_controls_are_escaped(void **state) {
    (void)state;
    struct json *j = json_begin(path);
    json_text(j, "a \"key\"", "back\\slash\nline\ttab\x01 \xc3\xa4");
    json_end(j);
    the_file_is("{\n  \"a \\\"key\\\"\": \"back\\\\slash\\nline\\ttab\\u0001 \xc3\xa4\"\n}\n");
}

/* What is still open is closed at the end; an empty array has no lines. */
static void objects_and_arrays_nest(void **state) {
    (void)state;
    struct json *j = json_begin(path);
    json_array(j, "empty");
    json_close(j);
    json_array(j, "list");
    json_object(j, NULL);
    json_long(j, "k", 1);
    json_close(j);
    json_long(j, NULL, 2);
    json_close(j);
    json_object(j, "open");
    json_array(j, "inner");
    json_long(j, NULL, 3);
    json_end(j);
    the_file_is("{\n  \"empty\": [],\n  \"list\": [\n    {\n      \"k\": 1\n    },\n    2\n  ],\n"
                "  \"open\": {\n    \"inner\": [\n      3\n    ]\n  }\n}\n");
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    snprintf(path, sizeof path, "%s/it.json", files_folder("json"));
    const struct CMUnitTest tests[] = {cmocka_unit_test(values_of_every_kind), cmocka_unit_test(no_number_is_null),
                                       cmocka_unit_test(quotes_and_controls_are_escaped),
                                       cmocka_unit_test(objects_and_arrays_nest)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
