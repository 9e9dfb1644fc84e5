/* Log lines and progress bar, with and without a terminal. */
#include "base/files/log.h"
#include "tests/check.h"
#include "tests/base/files/files.h"

#include <pty.h>
#include <fcntl.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *folder;
static char path[FOLDER_PATH], screen[1 << 16], file[1 << 16];

static void take(int fd, char *text, size_t bytes) {
    size_t n = 0;
    for (ssize_t got; n < bytes - 1 && (got = read(fd, text + n, bytes - 1 - n)) > 0;) n += (size_t)got;
    text[n] = '\0';
}

static int window_columns = 100;
static double now = 1000; /* s */

double __wrap_par_seconds(void);
double __wrap_par_seconds(void) { return now; }

/* Records the output of a run's calls on the screen (a terminal or a file) and in run.log. */
static void record(int terminal, int quiet, int resume, void (*calls)(void)) {
    int mine = -1, other = -1;
    char on_screen[FOLDER_PATH];
    fflush(stdout);
    const int before = dup(STDOUT_FILENO);
    if (terminal)
        assert_int_equal(openpty(&mine, &other, NULL, NULL,
                                 &(struct winsize){.ws_row = 24, .ws_col = (unsigned short)window_columns}),
                         0);
    else {
        snprintf(on_screen, sizeof on_screen, "%s/screen_%d", folder, par_rank());
        mine = other = open(on_screen, O_RDWR | O_CREAT | O_TRUNC, 0666);
    }
    dup2(other, STDOUT_FILENO);
    log_begin(folder, quiet, resume);
    calls();
    log_end();
    fflush(stdout);
    dup2(before, STDOUT_FILENO);
    close(before);
    if (terminal) {
        close(other); /* then reading ends after what is there */
    } else {
        lseek(mine, 0, SEEK_SET);
    }
    take(mine, screen, sizeof screen);
    close(mine);
    par_barrier();
    const int log = open(folder_path(path, folder, "run.log"), O_RDONLY);
    check_at_least(log, 0);
    take(log, file, sizeof file);
    close(log);
    par_barrier();
}

static int count(const char *text, const char *what) {
    int n = 0;
    for (const char *at = strstr(text, what); at; at = strstr(at + 1, what)) n++;
    return n;
}

static void steps(void) {
    log_line("frana %d", 1);
    for (long step = 1; step <= 250; step++) {
        now += 1e-3;
        log_progress("flow", step, 250, 100, "dp %ld", step);
    }
    log_line("done");
}

static void lines_in_a_log(void **state) {
    (void)state;
    record(0, 0, 0, steps);
    if (par_rank() == 0) {
        assert_string_equal(screen, file);
        assert_int_equal(strncmp(screen, "frana 1\nflow  100/250  ", 23), 0);
        assert_int_equal(count(screen, "\n"), 5); /* the two lines, 100, 200 and the last */
        assert_non_null(strstr(screen, "  dp 200\n"));
        assert_non_null(strstr(screen, "flow  250/250  "));
        assert_non_null(strstr(screen, " 0:00 left  dp 250\ndone\n"));
        assert_null(strchr(screen, '\r'));
    } else {
        assert_string_equal(screen, "");
    }
    assert_int_equal(count(file, "\n"), 5);
}

static void quiet_keeps_the_log(void **state) {
    (void)state;
    record(0, 1, 0, steps);
    assert_string_equal(screen, "");
    assert_int_equal(count(file, "\n"), 5);
}

static void a_resumed_run_appends(void **state) {
    (void)state;
    record(0, 1, 0, steps);
    record(0, 1, 1, steps);
    assert_int_equal(count(file, "\n"), 10);
    assert_int_equal(count(file, "frana 1\n"), 2);
}

static void slow_steps(void) {
    for (long step = 1; step <= 4; step++) {
        now += 0.12;
        log_progress("settle", step, 4, 3, "dp %ld", step);
    }
}

static void a_bar_on_a_terminal(void **state) {
    (void)state;
    record(1, 0, 0, slow_steps);
    if (par_rank() == 0) {
        assert_int_equal(count(screen, "\r"), 6); /* drawn at each of the four steps, wiped, and the line's end */
        assert_non_null(strstr(screen, "settle [=="));
        assert_non_null(strstr(screen, "2/4  "));
        assert_non_null(strstr(screen, "2/4  8.33 steps/s  0:00 left  ")); /* one step in 0.12 s */
        assert_int_equal(count(screen, "\n"), 1);                          /* only the stage's last line stays */
    }
    assert_int_equal(count(file, "\n"), 2);
    assert_null(strchr(file, '\r'));
    assert_non_null(strstr(file, "settle  3/4  "));
}

static void no_bar_where_the_launcher_has_no_terminal(void **state) {
    (void)state;
    snprintf(path, sizeof path, "/proc/%ld/fd/1", (long)getppid());
    const int launcher = open(path, O_WRONLY | O_NONBLOCK);
    const int watched = isatty(launcher);
    close(launcher);
    par_barrier();
    if (watched) skip(); /* started by hand from a terminal */
    window_columns = 0;  /* as mpiexec's own pseudo-terminals */
    record(1, 0, 0, slow_steps);
    window_columns = 100;
    assert_null(strstr(screen, "["));
    assert_int_equal(count(screen, "\n"), par_rank() == 0 ? 2 : 0);
}

/* 1.95 s: the terminal's own buffer holds what is drawn of it. */
static void fast_steps(void) {
    for (long step = 1; step <= 2000; step++) {
        now += 0.975e-3;
        log_progress("flow", step, 2000, 0, "%ld", step);
    }
}

static void fast_steps_are_not_all_drawn(void **state) {
    (void)state;
    record(1, 0, 0, fast_steps);
    /* drawn at the first step, at each 103rd after it, as 102 take less than 0.1 s, and at the last; wiped; and the
     * line's end */
    if (par_rank() == 0) assert_int_equal(count(screen, "\r"), 1 + 1999 / 103 + 1 + 2);
    assert_int_equal(count(file, "\n"), 1);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("log");
    const struct CMUnitTest tests[] = {cmocka_unit_test(lines_in_a_log),
                                       cmocka_unit_test(quiet_keeps_the_log),
                                       cmocka_unit_test(a_resumed_run_appends),
                                       cmocka_unit_test(a_bar_on_a_terminal),
                                       cmocka_unit_test(no_bar_where_the_launcher_has_no_terminal),
                                       cmocka_unit_test(fast_steps_are_not_all_drawn)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
