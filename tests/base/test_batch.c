/* When the batch system ends a job: what Slurm and PBS print, and asking without waiting. */
#include "base/batch.h"
#include "base/par.h"
#include "base/signals.h"
#include "tests/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

static void durations(void **state) {
    (void)state;
    check_equal(batch_duration("1-02:03:04\n"), 93784);
    check_equal(batch_duration("23:59:59\n"), 86399);
    check_equal(batch_duration("9:05\n"), 545);
    check_equal(batch_duration("0:00"), 0);
    check_equal(batch_duration("120:00:00\n"), 432000); /* PBS: hours beyond a day */
    check_equal(batch_duration("2:00:00:00"), 172800);
    check_equal(batch_duration(" 3600\n"), 3600);
    static const char *const none[] = {"UNLIMITED\n", "INVALID", "NOT_SET",   "N/A", "",
                                       "\n",          "1:",      "1:2:3:4:5", "12x", "-5"};
    for (size_t k = 0; k < sizeof none / sizeof *none; k++)
        if (batch_duration(none[k]) >= 0) fail_msg("\"%s\" is read as a duration", none[k]);
}

/* Parts of what qstat -f prints in Torque and in OpenPBS. */
static void what_qstat_prints(void **state) {
    (void)state;
    struct tm start = {
        .tm_year = 121, .tm_mon = 7, .tm_mday = 11, .tm_hour = 17, .tm_min = 13, .tm_sec = 12, .tm_isdst = -1};
    const double began = (double)mktime(&start);
    check_equal(batch_end_of_pbs("Job Id: 55.a\n    resources_used.walltime = 43:22:30\n    Resource_List.walltime = "
                                 "120:00:00\n    Variable_List = PBS_O_HOME=/,\n\tstime = 1\n"
                                 "    start_time = Wed Aug 11 17:13:12 2021\n    Walltime.Remaining = 275789\n",
                                 5),
                began + 432000);
    check_equal(batch_end_of_pbs("Job Id: 7.b\n    Resource_List.select = 1:ncpus=2\n    Resource_List.walltime = "
                                 "01:00:00\n    stime = Wed Aug 11 17:13:12 2021\n",
                                 5),
                began + 3600);
    check_equal(batch_end_of_pbs("    Walltime.Remaining = 100\n", 5), 105);
    check_equal(batch_end_of_pbs("    Resource_List.walltime = 1:00\n    resources_used.walltime = 00:00:20\n", 5), 45);
    check_equal(batch_end_of_pbs("    Resource_List.walltime = 1:00\n    resources_used.walltime = 00:02:20\n", 5), 5);
    check_equal(batch_end_of_pbs("    Resource_List.walltime = 1:00\n    comment = Job run at Wed Aug 11\n", 5), 0);
    check_equal(batch_end_of_pbs("", 5), 0);
}

/* Makes a command of this name that rank 0 finds first in PATH. */
static void command(const char *name, const char *body) {
    static char path[256], was[4096];
    char file[512], all[8192];
    if (!was[0]) snprintf(was, sizeof was, "%s", getenv("PATH"));
    snprintf(path, sizeof path, "%s/tests/base/batch_%d_%d", FRANA_BINARY_DIR, par_size(), par_rank());
    mkdir(path, 0777);
    snprintf(file, sizeof file, "%s/%s", path, name);
    FILE *f = fopen(file, "w");
    assert_non_null(f);
    fprintf(f, "#!/bin/sh\n%s\n", body);
    fclose(f);
    chmod(file, 0777);
    snprintf(all, sizeof all, "%s:%s", path, was);
    setenv("PATH", all, 1);
}

/* Waits for the answer; ctest ends a test that waits for ever. */
static double answer(void) {
    while (!(batch_end() > 0)) usleep(1000);
    return batch_end();
}

static double now(void) { return (double)time(NULL); }

static void slurm_is_asked_once(void **state) {
    (void)state;
    command("squeue", "[ \"$*\" = '-h -j 71 -o %L' ] || exit 1\necho 1-00:00:10");
    setenv("SLURM_JOB_ID", "71", 1);
    batch_reset();
    batch_query();
    const double end = answer();
    assert_true(fabs(end - now() - 86410) < 100);
    command("squeue", "echo 10");
    batch_query();
    usleep(20000);
    check_equal(batch_end(), end);
    /* all ranks stop by it, and no rank but the first has asked */
    batch_reset();
    command("squeue", par_rank() == 0 ? "echo 1:00:00" : "echo 1");
    signals_begin(0);
    while (signals_stop(4000) == SIGNALS_NONE) usleep(1000);
    assert_int_equal(signals_stop(4000), SIGNALS_BATCH);
    assert_int_equal(signals_stop(0), SIGNALS_NONE);
    unsetenv("SLURM_JOB_ID");
    batch_reset();
}

static void pbs_is_asked(void **state) {
    (void)state;
    command("qstat",
            "[ \"$*\" = '-f 12[3].server' ] || exit 1\necho 'Job Id: 12'\nyes '    Variable_List = a' | head -n 9000\n"
            "echo '    Walltime.Remaining = 7'");
    setenv("PBS_JOBID", "12[3].server", 1);
    batch_reset();
    batch_query();
    usleep(50000);
    check_equal(batch_end(), 0); /* what is beyond the first 64 kB is not read */
    command("qstat",
            "echo 'Job Id: 12'\necho '    Walltime.Remaining = 700'\nyes '    Variable_List = a' | head -n 9000");
    batch_reset();
    batch_query();
    assert_true(fabs(answer() - now() - 700) < 100);
    unsetenv("PBS_JOBID");
    batch_reset();
}

/* A command that answers never, fails, or is not there, does not stop anything and is not waited for. */
static void no_answer_is_no_error(void **state) {
    (void)state;
    setenv("SLURM_JOB_ID", "71", 1);
    command("squeue", "exec sleep 100000");
    batch_reset();
    batch_query();
    for (int k = 0; k < 3; k++) check_equal(batch_end(), 0);
    batch_reset(); /* ends it: waits for its end */
    command("squeue", "echo 5:00; exit 1");
    batch_query();
    assert_true(fabs(answer() - now() - 300) < 100); /* what it has printed counts */
    batch_reset();
    command("squeue", "echo slurm_load_jobs error: Invalid job id specified >&2; exit 1");
    batch_query();
    for (int k = 0; k < 50; k++, usleep(2000)) check_equal(batch_end(), 0);
    batch_reset();
    setenv("PATH", "/nowhere", 1);
    batch_query();
    check_equal(batch_end(), 0);
    assert_true(isinf(signals_batch_left()));
    unsetenv("SLURM_JOB_ID");
    batch_reset();
    batch_query();
    check_equal(batch_end(), 0);
}

int main(int argc, char **argv) {
    unsetenv("SLURM_JOB_ID"), unsetenv("PBS_JOBID"), unsetenv("SLURM_JOB_END_TIME");
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(durations), cmocka_unit_test(what_qstat_prints),
                                       cmocka_unit_test(slurm_is_asked_once), cmocka_unit_test(pbs_is_asked),
                                       cmocka_unit_test(no_answer_is_no_error)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
