/* A signal on one rank, --max-wall and the batch limit stop all ranks. */
#include "base/batch.h"
#include "base/die.h"
#include "base/par.h"
#include "base/signals.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum { AGES = 1000000 }; /* s: no machine is so slow that a limit of so long passes during a test */

static void one_rank_stops_all(void **state) {
    (void)state;
    const int number[] = {SIGTERM, SIGUSR1, SIGINT};
    const char *const name[] = {"SIGTERM", "SIGUSR1", "SIGINT"};
    for (int k = 0; k < 3; k++) {
        signals_begin(0);
        assert_int_equal(signals_stop(1e9), SIGNALS_NONE);
        if (par_rank() == par_size() - 1) raise(number[k]);
        assert_int_equal(signals_stop(0), SIGNALS_SIGNAL);
        assert_int_equal(signals_stop(0), SIGNALS_SIGNAL); /* and the next call returns the same */
        if (par_rank() == par_size() - 1) assert_string_equal(signals_name(SIGNALS_SIGNAL), name[k]);
    }
}

static void a_second_interrupt_is_the_systems(void **state) {
    (void)state;
    struct sigaction action;
    signals_begin(0);
    raise(SIGINT);
    sigaction(SIGINT, NULL, &action);
    assert_true(action.sa_handler == SIG_DFL);
    raise(SIGTERM);
    sigaction(SIGTERM, NULL, &action);
    assert_true(action.sa_handler != SIG_DFL);
}

/* A write beyond the limit on files' sizes fails instead of ending the program, and so does one to a closed pipe. */
static void a_write_that_is_refused_only_fails(void **state) {
    (void)state;
    struct rlimit was;
    int pipes[2];
    signals_begin(0);
    assert_int_equal(getrlimit(RLIMIT_FSIZE, &was), 0);
    FILE *f = tmpfile();
    assert_non_null(f);
    const struct rlimit few = {100, was.rlim_max};
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &few), 0);
    assert_int_equal(pwrite(fileno(f), "x", 1, 100), -1);
    assert_int_equal(errno, EFBIG);
    assert_int_equal(setrlimit(RLIMIT_FSIZE, &was), 0);
    fclose(f);
    assert_int_equal(pipe(pipes), 0);
    close(pipes[0]);
    assert_int_equal(write(pipes[1], "x", 1), -1);
    assert_int_equal(errno, EPIPE);
    close(pipes[1]);
}

static void wall_time_ends_in_time(void **state) {
    (void)state;
    signals_begin(AGES);
    assert_int_equal(signals_stop(0), SIGNALS_NONE);
    assert_int_equal(signals_stop(AGES + 1), SIGNALS_MAX_WALL);
    signals_begin(par_rank() == 0 ? 1e-9 : AGES); /* clocks differ slightly; the first rank to be late decides */
    assert_int_equal(signals_stop(0.1), SIGNALS_MAX_WALL);
    assert_string_equal(signals_name(SIGNALS_MAX_WALL), "--max-wall");
    signals_begin(0);
    assert_int_equal(signals_stop(0), SIGNALS_NONE);
}

static void the_batch_systems_limit_counts(void **state) {
    (void)state;
    char end[32];
    snprintf(end, sizeof end, "%ld", (long)time(NULL) + AGES);
    setenv("SLURM_JOB_END_TIME", end, 1);
    batch_reset(); /* what the runs before have asked */
    signals_begin(0);
    assert_int_equal(signals_stop(0), SIGNALS_NONE);
    assert_int_equal(signals_stop(AGES + 2), SIGNALS_BATCH);
    assert_true(par_rank() == 0 ? signals_batch_left() <= AGES + 1 : isinf(signals_batch_left()));
    unsetenv("SLURM_JOB_END_TIME");
    batch_reset();
    signals_begin(0);
    assert_int_equal(signals_stop(AGES + 2), SIGNALS_NONE);
}

/* What a child process that the signal reaches returns. */
static int ends_with(int number, int at_once) {
    int status = 0;
    const pid_t child = fork();
    if (child == 0) {
        if (freopen("/dev/null", "w", stderr)) signals_at_once(at_once);
        raise(number);
        _exit(0);
    }
    assert_int_equal(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
}

/* A run's own option is not named where the command has none. */
static void it_says_what_goes_on(void **state) {
    (void)state;
    signals_begin(0);
    const char *const expected[] = {"--resume-or-start goes on", "nothing is kept", "the same command goes on"};
    if (par_rank() > 0) return; /* rank 0 speaks */
    for (int k = 1; k <= 3; k++) {
        char text[256] = "";
        int end[2], status;
        assert_int_equal(pipe(end), 0);
        const pid_t child = fork();
        if (child == 0) {
            dup2(end[1], STDERR_FILENO);
            signals_at_once(k);
            raise(SIGTERM);
            _exit(0);
        }
        close(end[1]);
        ssize_t got = 1;
        for (size_t n = 0; got > 0; n += (size_t)got) got = read(end[0], text + n, sizeof text - 1 - n);
        close(end[0]);
        assert_int_equal(waitpid(child, &status, 0), child);
        assert_non_null(strstr(text, expected[k - 1]));
    }
}

static void where_nothing_is_lost_it_ends_at_once(void **state) {
    (void)state;
    const int number[] = {SIGTERM, SIGUSR1, SIGINT, SIGALRM}; /* the last one when --max-wall is over */
    signals_begin(0);
    for (int k = 0; k < 4; k++) {
        assert_int_equal(ends_with(number[k], 1), EXIT_CODE_REQUEUE);
        assert_int_equal(ends_with(number[k], 0), 0);
    }
    raise(SIGTERM); /* before: heard when it may end at once */
    assert_int_equal(ends_with(SIGUSR1, 1), EXIT_CODE_REQUEUE);
    signals_begin(0);
}

/* A loop asks after the first turn, then about once a second, all ranks in the same turns. */
static void a_long_loop_hears(void **state) {
    (void)state;
    struct signals_poll_state poll = {0};
    signals_begin(0);
    for (int turn = 0; turn < 5000; turn++) assert_int_equal(signals_poll(&poll), SIGNALS_NONE);
    if (par_rank() == par_size() - 1) raise(SIGUSR1);
    int turns = 0;
    while (signals_poll(&poll) == SIGNALS_NONE) turns++;
    assert_true(turns < 2000);
    assert_true(par_max(turns) == turns && par_min(turns) == turns);
    poll = (struct signals_poll_state){0};
    assert_int_equal(signals_poll(&poll), SIGNALS_NONE); /* some of a turn is done in any case */
    assert_int_equal(signals_poll(&poll), SIGNALS_SIGNAL);
    poll = (struct signals_poll_state){0};
    signals_begin(1e-9);
    for (int turn = 0; turn < 3; turn++) assert_int_equal(signals_poll(&poll), SIGNALS_NONE); /* ten seconds more */
    signals_hold_back(11); /* which a checkpoint takes */
    assert_int_equal(signals_poll(&poll), SIGNALS_MAX_WALL);
    signals_begin(0);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_rank_stops_all),
                                       cmocka_unit_test(a_second_interrupt_is_the_systems),
                                       cmocka_unit_test(a_write_that_is_refused_only_fails),
                                       cmocka_unit_test(wall_time_ends_in_time),
                                       cmocka_unit_test(the_batch_systems_limit_counts),
                                       cmocka_unit_test(it_says_what_goes_on),
                                       cmocka_unit_test(where_nothing_is_lost_it_ends_at_once),
                                       cmocka_unit_test(a_long_loop_hears)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
