/* Run folder and run.json: made, cleared, and written as JSON's grammar asks. */
#include "base/files/json.h"
#include "tests/base/files/files.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static const char *folder;

static void touch(const char *name) {
    char path[FOLDER_PATH];
    if (par_rank() == 0) fclose(fopen(folder_path(path, folder, name), "w"));
    par_barrier();
}

static void a_run_is_seen_and_cleared(void **state) {
    (void)state;
    char path[FOLDER_PATH];
    const char *const name[] = {"series.csv", "run.json", "fields/fluid_1.hdf", "checkpoint/step_1.h5"};
    touch("scene.yaml"); /* the user's own */
    touch("fields/notes.txt");
    for (int k = 0; k < 4; k++) {
        touch(name[k]);
        assert_int_equal(folder_has_run(folder), 1);
        par_barrier();
        folder_clear(folder);
        assert_false(files_exists(folder_path(path, folder, name[k])));
        par_barrier();
    }
    assert_true(files_exists(folder_path(path, folder, "scene.yaml")));
    assert_true(files_exists(folder_path(path, folder, "fields/notes.txt")));
    par_barrier(); /* all have seen them */
    if (par_rank() == 0) {
        remove(path);
        remove(folder_path(path, folder, "scene.yaml"));
    }
    par_barrier();
    assert_int_equal(folder_has_run(folder), 0);
}

/* Deletes what an earlier run of the test has left in a folder. */
static void wipe(const char *path) {
    char command[FOLDER_PATH + 16];
    snprintf(command, sizeof command, "rm -rf '%s'", path);
    if (par_rank() == 0) assert_int_equal(system(command), 0);
    par_barrier();
}

static void a_foreign_folder_is_known(void **state) {
    (void)state;
    char path[FOLDER_PATH];
    wipe(folder_path(path, folder, "other"));
    assert_false(folder_is_foreign(path)); /* there is none */
    if (par_rank() == 0) mkdir(path, 0777);
    assert_false(folder_is_foreign(path)); /* empty */
    touch("other/notes");
    assert_true(folder_is_foreign(path));
    touch("other/series.csv.bak");
    assert_true(folder_is_foreign(path));
    touch("other/series.csv.part");
    assert_false(folder_is_foreign(path));
}

/* The files of a run are moved with their folders, the user's stay, and no earlier folder is overwritten. */
static void an_unfinished_run_is_moved(void **state) {
    (void)state;
    char run[FOLDER_PATH], aside[FOLDER_PATH], path[FOLDER_PATH];
    wipe(folder_path(run, folder, "again"));
    for (int k = 1; k <= 2; k++) {
        folder_make(run);
        touch("again/series.csv");
        touch("again/run.json");
        touch("again/fields/fluid_1.hdf");
        touch("again/notes");
        folder_archive(run, aside);
        snprintf(path, sizeof path, "%.900s/unfinished_%d", run, k);
        assert_string_equal(aside, path);
        assert_true(files_exists(folder_path(path, aside, "series.csv")));
        assert_true(files_exists(folder_path(path, aside, "run.json")));
        assert_true(files_exists(folder_path(path, aside, "fields/fluid_1.hdf")));
        assert_true(files_exists(folder_path(path, run, "notes")));
        assert_int_equal(folder_has_run(run), 0);
    }
}

static void folders_are_made_on_the_way(void **state) {
    (void)state;
    char path[FOLDER_PATH], below[FOLDER_PATH];
    folder_make(folder_path(path, folder, "a/b//c/"));
    assert_true(files_exists(folder_path(below, folder, "a/b/c/checkpoint")));
    assert_true(files_exists(folder_path(below, folder, "a/b/c/fields")));
    folder_make(path); /* a second call is not a fault */
}

static void json_is_as_its_grammar_wants(void **state) {
    (void)state;
    char path[FOLDER_PATH], text[1024];
    folder_path(path, folder, "run.json");
    if (par_rank() == 0) {
        struct json *j = json_begin(path);
        json_text(j, "status", "a \"b\" \\ \n\x01 \xc3\xa9");
        json_long(j, "steps", 1L << 40);
        json_number(j, "wall", 0.1);
        json_number(j, "nothing", NAN);
        json_bool(j, "resumed", 1);
        json_array(j, "left_out");
        json_text(j, NULL, "contact");
        json_number(j, NULL, -1e-300);
        json_close(j);
        json_object(j, "empty");
        json_close(j);
        json_object(j, "seconds");
        json_number(j, "momentum", 2);
        json_end(j); /* closes the open objects */
        FILE *f = fopen(path, "r");
        text[fread(text, 1, sizeof text - 1, f)] = '\0';
        fclose(f);
        assert_string_equal(text, "{\n"
                                  "  \"status\": \"a \\\"b\\\" \\\\ \\n\\u0001 \xc3\xa9\",\n"
                                  "  \"steps\": 1099511627776,\n"
                                  "  \"wall\": 0.1,\n"
                                  "  \"nothing\": null,\n"
                                  "  \"resumed\": true,\n"
                                  "  \"left_out\": [\n    \"contact\",\n    -1e-300\n  ],\n"
                                  "  \"empty\": {},\n"
                                  "  \"seconds\": {\n    \"momentum\": 2\n  }\n"
                                  "}\n");
        strcat(path, ".part");
        assert_false(files_exists(path));
    }
    par_barrier();
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("folder");
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_run_is_seen_and_cleared), cmocka_unit_test(a_foreign_folder_is_known),
        cmocka_unit_test(an_unfinished_run_is_moved), cmocka_unit_test(folders_are_made_on_the_way),
        cmocka_unit_test(json_is_as_its_grammar_wants)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
