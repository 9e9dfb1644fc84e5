/* The result of a step: which numerical fault it found, a value that the caller answers. */
#pragma once

/* The part of the run that found a fault. */
enum step_status_place {
    STEP_STATUS_FLUID,      /* the fluid's fields */
    STEP_STATUS_SOLID,      /* the solid's particles */
    STEP_STATUS_COUPLING,   /* the limits of a step's length (coupling/control/time_step.c) */
    STEP_STATUS_BALANCE,    /* the solid's energy (coupling/control/watch.c) */
    STEP_STATUS_UNRESOLVED, /* a flow too fast for its cells (coupling/control/unresolved.c) */
    STEP_STATUS_PROBES,     /* the energy of solid and fluid (coupling/control/probe_energy.c) */
};

/* The result of a step; the same on every rank after step_status_agree. */
struct step_status {
    int failed;                     /* 0: no fault */
    enum step_status_place seen_in; /* of that rank */
    int rank;                       /* the rank that found it */
    double x[3];                    /* where, m */
    char field[16];                 /* which field: "u", "p", "velocity", ... */
    double value;
};

/* Gives all ranks the status of the lowest rank that failed. Returns whether any failed. Collective. */
int step_status_agree(struct step_status *status);
