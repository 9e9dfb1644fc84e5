/* Regular files alone are opened: not through links, and no pipe is waited for. */
#include "base/files/plain_file.h"
#include "tests/check.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

static void put(const char *path, const char *text) {
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    fputs(text, file);
    fclose(file);
}

static void holds(const char *path, const char *text) {
    char line[64] = "";
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    assert_true(fgets(line, sizeof line, file) || !*text);
    fclose(file);
    assert_string_equal(line, text);
}

static int enter(void **state) {
    char *folder = strdup("/tmp/frana_plain_file_XXXXXX");
    *state = folder;
    return !mkdtemp(folder) || chdir(folder) || mkfifo("pipe", 0600) || mkdir("folder", 0700) ||
           symlink("file", "link") || symlink("nowhere", "dangling");
}

static int leave(void **state) {
    static const char *const name[] = {"pipe", "file", "link", "dangling"};
    for (int k = 0; k < 4; k++) unlink(name[k]);
    rmdir("folder");
    const int left = chdir("/") || rmdir(*state);
    free(*state);
    return left;
}

static void a_file_is_written_and_read(void **state) {
    (void)state;
    put("file", "longer than before");
    FILE *file = plain_file_write("file", 0);
    assert_non_null(file);
    assert_true(fputs("one", file) >= 0 && fclose(file) == 0);
    holds("file", "one");
    file = plain_file_write("file", 1);
    assert_true(fputs(" two", file) >= 0 && fclose(file) == 0);
    holds("file", "one two");
    file = plain_file_read("link"); /* to read through a link does no harm */
    assert_non_null(file);
    fclose(file);
}

static void nothing_else_is(void **state) {
    (void)state;
    put("file", "kept");
    static const struct {
        const char *name;
        int reads, writes;
    } is[] = {{"pipe", ENODEV, ENODEV}, {"folder", EISDIR, EISDIR}, {"link", 0, ELOOP}, {"dangling", ENOENT, ELOOP}};
    for (size_t k = 0; k < sizeof is / sizeof *is; k++) {
        errno = 0;
        FILE *file = plain_file_read(is[k].name);
        assert_int_equal(file ? 0 : errno, is[k].reads);
        if (file) fclose(file);
        for (int append = 0; append < 2; append++) {
            assert_null(plain_file_write(is[k].name, append));
            assert_int_equal(errno, is[k].writes);
        }
    }
    holds("file", "kept");
    assert_int_equal(access("nowhere", F_OK), -1);
    assert_string_equal(plain_file_why(ENODEV), "it is not a regular file");
}

static void a_new_file_replaces_what_is_there(void **state) {
    (void)state;
    static const char *const name[] = {"link", "dangling", "pipe", "file"};
    put("file", "kept");
    for (int k = 0; k < 4; k++) {
        struct stat is;
        const int fd = plain_file_create(name[k]);
        assert_true(fd >= 0);
        close(fd);
        assert_true(lstat(name[k], &is) == 0 && S_ISREG(is.st_mode) && is.st_size == 0);
        if (k < 3) holds("file", "kept");
    }
    assert_int_equal(plain_file_create("folder"), -1);
    assert_int_equal(access("nowhere", F_OK), -1);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_file_is_written_and_read), cmocka_unit_test(nothing_else_is),
                                       cmocka_unit_test(a_new_file_replaces_what_is_there)};
    return cmocka_run_group_tests(tests, enter, leave);
}
