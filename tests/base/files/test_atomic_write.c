/* A file has its name only when it is complete; a fault of the disk leaves the old file. */
#include "base/die.h"
#include "base/files/atomic_write.h"
#include "tests/check.h"
#include "tests/base/files/files.h"

#include <errno.h>
#include <unistd.h>

static char path[FOLDER_PATH + 20], part[FOLDER_PATH + 30];
static jmp_buf back;

/* Instead of the end of the program. */
_Noreturn void __wrap_die(enum exit_code code, const char *format, ...);
void __wrap_die(enum exit_code code, const char *format, ...) {
    (void)format;
    longjmp(back, code);
}

static void the_file_is(const char *expected) {
    char text[100];
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    assert_string_equal(text, expected);
}

static void it_appears_when_it_is_complete(void **state) {
    (void)state;
    struct atomic_write a;
    atomic_write_begin(&a, path);
    fputs("first", a.file);
    fflush(a.file);
    assert_false(files_exists(path));
    assert_true(files_exists(part));
    atomic_write_end(&a);
    assert_false(files_exists(part));
    the_file_is("first");
    atomic_write_begin(&a, path);
    a.unsynced = 1;
    fputs("second", a.file);
    fflush(a.file);
    the_file_is("first");
    atomic_write_end(&a);
    the_file_is("second");
}

/* The stream is of a device that is always full. */
static void a_full_disk_leaves_the_old_file(void **state) {
    (void)state;
    static struct atomic_write a;
    atomic_write_begin(&a, path);
    fputs("third", a.file);
    a.file = freopen("/dev/full", "w", a.file);
    assert_non_null(a.file);
    fputs("third", a.file);
    const int code = setjmp(back);
    if (code == 0) {
        atomic_write_end(&a);
        fail_msg("a full disk goes unnoticed");
    }
    assert_int_equal(code, EXIT_CODE_FILE);
    assert_false(files_exists(part));
    the_file_is("second");
}

/* Without an end of the program: a fault leaves the old file and is told. */
static void a_fault_is_told(void **state) {
    (void)state;
    for (int full = 0; full < 2; full++) {
        FILE *file = atomic_write_open(path);
        assert_non_null(file);
        fputs("fourth", file);
        if (full) file = freopen("/dev/full", "w", file);
        fputs(" time", file);
        the_file_is("second");
        errno = 0;
        check_equal(atomic_write_close(file, path, !full), -1);
        assert_int_not_equal(errno, 0);
        assert_false(files_exists(part));
        the_file_is("second");
    }
    FILE *file = atomic_write_open(path);
    fputs("fifth", file);
    check_equal(atomic_write_close(file, path, 0), 0);
    the_file_is("fifth");
    assert_null(atomic_write_open("/nowhere/there.csv"));
    assert_int_equal(errno, ENOENT);
}

static void a_folder_that_does_not_exist(void **state) {
    (void)state;
    static struct atomic_write a;
    const int code = setjmp(back);
    if (code == 0) {
        atomic_write_begin(&a, "/no/such/folder/file");
        fail_msg("a missing folder goes unnoticed");
    }
    assert_int_equal(code, EXIT_CODE_FILE);
    assert_int_equal(atomic_write_publish("/no/such/file", "/no/such/other", 0), ENOENT);
    assert_int_equal(atomic_write_publish("/no/such/file", "/no/such/other", 1), ENOENT);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    snprintf(path, sizeof path, "%s/it", files_folder("aside"));
    remove(path); /* of a run before this one */
    snprintf(part, sizeof part, "%s.part", path);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_appears_when_it_is_complete), cmocka_unit_test(a_full_disk_leaves_the_old_file),
        cmocka_unit_test(a_fault_is_told), cmocka_unit_test(a_folder_that_does_not_exist)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
