/* Only one run at a time holds a folder, with the system's file locks and without them. */
/* With the system's locks and without them. The linker redirects die_all and fcntl to this file: a refusal returns to
 * the test, and locks can be made to be missing. */
#include "base/die.h"
#include "tests/base/files/files.h"

#include <errno.h>
#include <fcntl.h>
#include <setjmp.h>
#include <signal.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static const char *folder;
static char lock_file[FOLDER_PATH];
static jmp_buf back;
static char sentence[1024];
static int no_locks;

_Noreturn void __wrap_die_all(enum exit_code code, const char *format, ...);
int __wrap_fcntl(int fd, int command, struct flock *lock);
int __real_fcntl(int fd, int command, ...);

void __wrap_die_all(enum exit_code code, const char *format, ...) {
    va_list args;
    va_start(args, format);
    vsnprintf(sentence, sizeof sentence, format, args);
    va_end(args);
    longjmp(back, code);
}

int __wrap_fcntl(int fd, int command, struct flock *lock) {
    if (no_locks) {
        errno = ENOLCK;
        return -1;
    }
    return __real_fcntl(fd, command, lock);
}

/* 0, or the exit code with which the run would have ended. */
static int hold(void) {
    const int code = setjmp(back);
    if (!code) folder_hold(folder);
    par_barrier();
    return code;
}

static void release(void) {
    par_barrier();
    folder_hold_release();
    par_barrier();
}

/* Another process, which locks a byte of the file and waits. */
static pid_t other_begin(off_t byte) {
    int ready[2];
    char c;
    assert_int_equal(pipe(ready), 0);
    const pid_t child = fork();
    if (child == 0) {
        struct flock l = {.l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = byte, .l_len = 1};
        const int fd = open(lock_file, O_RDWR | O_CREAT, 0666);
        if (__real_fcntl(fd, F_SETLK, &l) != 0 || write(ready[1], "", 1) != 1) _exit(1);
        for (;;) pause();
    }
    assert_int_equal(read(ready[0], &c, 1), 1);
    close(ready[0]);
    close(ready[1]);
    return child;
}

static void other_end(pid_t child) {
    int status;
    kill(child, SIGKILL);
    waitpid(child, &status, 0);
}

static void write_lock(const char *text) {
    if (par_rank() == 0) {
        FILE *f = fopen(lock_file, "w");
        fputs(text, f);
        fclose(f);
    }
    par_barrier();
}

/* Which of the first bytes are locked, from the view of a process without locks. */
static int locked_bytes(int n) {
    int status, mask = 0;
    const pid_t child = fork();
    if (child == 0) {
        const int fd = open(lock_file, O_RDWR);
        for (int k = 0; k < n; k++) {
            struct flock l = {.l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = k, .l_len = 1};
            if (__real_fcntl(fd, F_GETLK, &l) != 0 || l.l_type != F_UNLCK) mask |= 1 << k;
        }
        _exit(mask);
    }
    waitpid(child, &status, 0);
    return WEXITSTATUS(status);
}

static void each_rank_locks_a_byte(void **state) {
    (void)state;
    assert_int_equal(hold(), 0);
    assert_int_equal(hold(), 0); /* a second call is not a fault */
    assert_int_equal(locked_bytes(par_size() + 1), (1 << par_size()) - 1);
    release();
    assert_false(files_exists(lock_file));
    par_barrier(); /* the next test writes the file again */
}

static void a_run_at_work_is_named(void **state) {
    (void)state;
    char text[300];
    pid_t child = 0;
    snprintf(text, sizeof text, "there 4711\n");
    write_lock(text);
    const int bytes[] = {0, 5}; /* its first rank; one that is left of it */
    for (int k = 0; k < 2; k++) {
        if (par_rank() == 0) child = other_begin(bytes[k]);
        assert_int_equal(hold(), EXIT_CODE_FILE);
        snprintf(text, sizeof text, "run folder %s: another run is at work there (process 4711 on there)", folder);
        assert_string_equal(sentence, text);
        if (par_rank() == 0) other_end(child);
        par_barrier();
    }
    assert_int_equal(hold(), 0); /* a killed process holds nothing */
    release();
}

static void without_locks_the_words_count(void **state) {
    (void)state;
    char host[256] = "", text[600];
    gethostname(host, sizeof host - 1);
    pid_t child = par_rank() == 0 ? fork() : 0;
    if (par_rank() == 0 && child == 0)
        for (;;) pause();
    no_locks = 1;
    snprintf(text, sizeof text, "%s %ld\n", host, (long)child);
    write_lock(text);
    assert_int_equal(hold(), EXIT_CODE_FILE);
    assert_non_null(strstr(sentence, "; should it be gone, delete "));
    write_lock("another.host 1\n"); /* processes of another host cannot be seen from here */
    assert_int_equal(hold(), EXIT_CODE_FILE);
    if (par_rank() == 0) other_end(child);
    write_lock(text);
    assert_int_equal(hold(), 0);
    release();
    write_lock("rubbish");
    assert_int_equal(hold(), 0);
    release();
    no_locks = 0;
}

static void unfinished_files_are_forgotten(void **state) {
    (void)state;
    const char *const name[] = {"fields/fluid_00000001.hdf.part", "checkpoint/latest.part", "run.json.part",
                                "checkpoint/step_1.h5.part",      "fields/notes.part.txt",  "mine.part"};
    char path[FOLDER_PATH];
    for (int k = 0; k < 6 && par_rank() == 0; k++) fclose(fopen(folder_path(path, folder, name[k]), "w"));
    par_barrier();
    assert_int_equal(hold(), 0);
    for (int k = 0; k < 6; k++) assert_int_equal(files_exists(folder_path(path, folder, name[k])), k >= 4);
    release();
    for (int k = 4; k < 6 && par_rank() == 0; k++) remove(folder_path(path, folder, name[k]));
}

static void a_folder_that_is_missing_is_no_ones(void **state) {
    (void)state;
    char path[FOLDER_PATH];
    const char *was = folder;
    folder = folder_path(path, was, "nowhere");
    assert_int_equal(hold(), 0);
    assert_false(files_exists(path));
    folder = was;
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("hold");
    folder_path(lock_file, folder, "run.lock");
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_rank_locks_a_byte), cmocka_unit_test(a_run_at_work_is_named),
        cmocka_unit_test(without_locks_the_words_count), cmocka_unit_test(unfinished_files_are_forgotten),
        cmocka_unit_test(a_folder_that_is_missing_is_no_ones)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
