/* The user's mistake: one sentence, and the program ends with its exit code. */
#pragma once

enum exit_code {
    EXIT_CODE_DONE = 0,
    EXIT_CODE_SCENE = 2,      /* the scene or the command line */
    EXIT_CODE_UNSTABLE = 3,   /* unstable or NaN */
    EXIT_CODE_FILE = 4,       /* a file */
    EXIT_CODE_CHECKPOINT = 5, /* a checkpoint that does not fit the scene */
    EXIT_CODE_REQUEUE = 75    /* stopped early with a checkpoint */
};

/* A mistake that every rank has met alike: rank 0 says one sentence, all ranks leave with the code. Collective. */
_Noreturn void die_all(enum exit_code code, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A fault that one rank has met: it says the sentence and takes the others with it. Not collective. */
_Noreturn void die(enum exit_code code, const char *format, ...) __attribute__((format(printf, 2, 3)));
