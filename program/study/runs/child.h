/* Programs that a study starts, one at a time, and the signals that stop the study. */
#pragma once

struct study_child {
    char *const *argv;           /* argv[0] is searched for in PATH if it contains no slash */
    const char *folder;          /* working folder of the program; NULL: this program's */
    const char *output, *errors; /* files for its output, overwritten; errors is appended to; absolute, or relative to
                                  * this program's folder */
};

/* From this call on SIGINT, SIGTERM, SIGHUP and SIGUSR1 are only noted (study_child_stopped), and passed on to the
 * running program: SIGUSR1 as it is, so that it stops with a checkpoint under mpiexec too, the others as SIGTERM. */
void study_child_begin(void);
/* 0: these signals end this program with exit code 75, as while it writes and draws, and files that are not finished
 * are removed; 1: they are noted again. */
void study_child_note(int on);
/* Runs the program. Returns its exit code; 128 + n if signal n has ended it; 127 if it could not be started (errno). A
 * first signal to this program other than SIGUSR1 is passed on as SIGTERM, a second one as SIGKILL. */
int study_child_run(const struct study_child *c);
int study_child_stopped(void); /* the signal that this program has received, or 0 */
