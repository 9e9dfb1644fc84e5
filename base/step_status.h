/* A fault of the numerics: a value that all ranks agree on and the caller answers. */
#pragma once

/* What a step found, the same on every rank once agreed (step_status_agree). */
struct step_status {
    int failed;     /* 0: fine */
    int rank;       /* the rank that saw it first */
    double x[3];    /* where, m */
    char field[16]; /* which field: "u", "p", "velocity", ... */
    double value;
};

/* Makes the lowest failing rank's status everybody's. Returns whether any failed. Collective. */
int step_status_agree(struct step_status *status);
