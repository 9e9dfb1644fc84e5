/* A file of the user's cache folder is written beside the old one and replaces it at once; two writers do not meet. */
#include "base/files/cache.h"
#include "base/files/read_file.h"
#include "tests/check.h"

#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static char folder[] = FRANA_BINARY_DIR "/cache_XXXXXX";

static void holds(const char *path, const char *wanted) {
    char *text = read_file(path);
    assert_non_null(text);
    assert_string_equal(text, wanted);
    free(text);
}

static int files_in(const char *path) {
    int n = 0;
    DIR *dir = opendir(path);
    assert_non_null(dir);
    for (const struct dirent *entry; (entry = readdir(dir));) n += entry->d_name[0] != '.';
    closedir(dir);
    return n;
}

/* Two writers of one process: their names differ although host and process are the same. */
static void two_writers(void **state) {
    (void)state;
    struct cache_file a, b;
    char path[CACHE_PATH], own[300];
    assert_non_null(mkdtemp(folder));
    setenv("XDG_CACHE_HOME", folder, 1);
    snprintf(own, sizeof own, "%s/frana", folder);
    assert_true(cache_begin(&a, "rates.txt"));
    fputs("first", a.file);
    assert_true(cache_path(path, "rates.txt", 0));
    assert_int_equal(access(path, F_OK), -1); /* not visible half-written */
    assert_true(cache_begin(&b, "rates.txt"));
    assert_string_not_equal(a.fresh, b.fresh);
    fputs("second", b.file);
    assert_true(cache_end(&a));
    holds(path, "first");
    assert_true(cache_end(&b));
    holds(path, "second");
    assert_int_equal(files_in(own), 1);
    assert_true(cache_begin(&a, "rates.txt"));
    assert_int_equal(unlink(a.fresh), 0); /* as if the folder was emptied meanwhile */
    assert_false(cache_end(&a));
    holds(path, "second");
    assert_int_equal(unlink(path), 0);
    assert_int_equal(rmdir(own), 0);
    assert_int_equal(rmdir(folder), 0);
}

static void no_folder(void **state) {
    (void)state;
    struct cache_file file;
    setenv("XDG_CACHE_HOME", "/proc/no_such_place", 1);
    assert_false(cache_begin(&file, "rates.txt"));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(two_writers), cmocka_unit_test(no_folder)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
