/* How a run went, as its run.json says. */
#pragma once

enum study_state { STUDY_TODO, STUDY_DONE, STUDY_FAILED, STUDY_SKIPPED };

struct study_outcome {
    enum study_state state;
    int exit_code;
    double wall, setup; /* s: of the steps, and before the first; NAN: not known */
    double cell_step;   /* ns of one core, NAN: no fluid */
    double bond_sweep;  /* ns of one core for a directed bond, NAN: no bonds */
    double memory;      /* bytes, peak, all ranks */
    long steps;
    int ranks;
    int same_build; /* by this revision, compiler and flags */
};

/* Fills in what the folder's run.json says; TODO where there is none, or the run neither ended nor went unstable. */
struct study_outcome study_outcome_read(const char *folder);
