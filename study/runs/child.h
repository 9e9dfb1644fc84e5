/* Programs that a study starts, one at a time, and the signals that end them and it. */
#pragma once

struct study_child {
    char *const *argv;  /* argv[0]: looked for in PATH where it has no slash */
    const char *folder; /* it starts in; NULL: this one */
    const char *said,
        *errs; /* files for what it prints, written anew; errs is added to; absolute or from the folder here */
};

/* From now on SIGINT, SIGTERM and SIGHUP wait to be asked for; SIGTERM is then handed on to the program that runs. */
void study_child_begin(void);
/* Its exit code; 128 + n where signal n has ended it; 127 where it could not be started (errno). A first signal to this
 * program is handed on as SIGTERM, a second as SIGKILL. */
int study_child_run(const struct study_child *c);
int study_child_stopped(void); /* the signal that this program has had so far, or 0 */
