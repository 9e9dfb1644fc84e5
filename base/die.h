/* A mistake of the user: the program prints one sentence and ends with an exit code. */
#pragma once

enum exit_code {
    EXIT_CODE_DONE = 0,
    EXIT_CODE_SCENE = 2,      /* the scene or the command line */
    EXIT_CODE_UNSTABLE = 3,   /* unstable or NaN */
    EXIT_CODE_FILE = 4,       /* a file */
    EXIT_CODE_CHECKPOINT = 5, /* a checkpoint that does not fit the scene */
    EXIT_CODE_REQUEUE = 75    /* stopped early with a checkpoint */
};

/* For a fault that all ranks have found: rank 0 prints one sentence, and all ranks exit with the code. Collective. */
_Noreturn void die_all(enum exit_code code, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* For a fault that only this rank has found: it prints the sentence and aborts all ranks. Not collective. */
_Noreturn void die(enum exit_code code, const char *format, ...) __attribute__((format(printf, 2, 3)));
