/* The result and the costs of a run, from its run.json. */
#pragma once

enum study_state { STUDY_TODO, STUDY_DONE, STUDY_FAILED, STUDY_SKIPPED };

struct study_outcome {
    enum study_state state;
    int exit_code;
    double wall, setup; /* s: of the steps; before the first step; NAN: not known */
    double cell_step;   /* ns on one core; NAN: no fluid */
    double bond_sweep;  /* ns on one core for a directed bond; NAN: no bonds */
    double memory;      /* bytes, peak, all ranks */
    long steps;
    int ranks;
    int same_build; /* 1: run by the same revision, compiler and flags */
};

/* Reads the folder's run.json. TODO if there is none, or if the run has neither finished nor become unstable. */
struct study_outcome study_outcome_read(const char *folder);
