/* The three doors of an error: our bug (ENSURE), the user's mistake (die_all, die), numerics (struct step_status). */
#pragma once

enum exit_code {
    EXIT_CODE_DONE = 0,
    EXIT_CODE_SCENE = 2,      /* the scene or the command line */
    EXIT_CODE_UNSTABLE = 3,   /* unstable or NaN */
    EXIT_CODE_FILE = 4,       /* a file */
    EXIT_CODE_CHECKPOINT = 5, /* a checkpoint that does not fit the scene */
    EXIT_CODE_REQUEUE = 75    /* stopped early with a checkpoint */
};

/* What a step found, the same on every rank once agreed (step_status_agree). */
struct step_status {
    int failed;     /* 0: fine */
    int rank;       /* the rank that saw it first */
    double x[3];    /* where, m */
    char field[16]; /* which field: "u", "p", "velocity", ... */
    double value;
};

/* Our own bug: aborts with rank, file, line. Not collective. */
#define ENSURE(cond, ...)                                                                                              \
    do {                                                                                                               \
        if (!(cond)) ensure_failed(__FILE__, __LINE__, #cond, __VA_ARGS__);                                            \
    } while (0)

_Noreturn void ensure_failed(const char *file, int line, const char *cond, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* A mistake that every rank has met alike: rank 0 says one sentence, all ranks leave with the code. Collective. */
_Noreturn void die_all(enum exit_code code, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A fault that one rank has met: it says the sentence and takes the others with it. Not collective. */
_Noreturn void die(enum exit_code code, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* Makes the lowest failing rank's status everybody's. Returns whether any failed. Collective. */
int step_status_agree(struct step_status *status);
