/* The command line. */
#pragma once
#include "program/bench/bench.h"
#include "program/study/study.h"

enum command_verb {
    COMMAND_RUN,
    COMMAND_CHECK,
    COMMAND_POST,
    COMMAND_BENCH,
    COMMAND_STUDY,
    COMMAND_PERMEABILITY,
    COMMAND_CALIBRATE,
    COMMAND_INIT,
    COMMAND_SCHEMA,
    COMMAND_KEYS,
    COMMAND_VERSION,
    COMMAND_HELP
};

struct command {
    enum command_verb verb;
    enum command_verb about; /* of COMMAND_HELP: the command that is explained, COMMAND_HELP: all */
    int files;               /* scene; study; run folders for post; case and folder */
    const char *const *file; /* borrowed from argv */
    char out[512];           /* run: the run folder; post with several folders: the folder of the comparison; bench,
                              * study: the folder of the tables */
    int sets;
    const char **set;        /* owned: --set key.path=value */
    int resume;              /* --resume: 1 */
    const char *resume_file; /* --resume=FILE, or NULL: the run folder's latest */
    int resume_or_start;     /* --resume-or-start: 1 */
    int archives;            /* 1: the folder's unfinished run is moved out of the way first (program/run/resume.h) */
    double max_wall;         /* s; 0: no limit */
    int quiet;
    int measure;          /* check: --measure */
    int help;             /* --help */
    int is_missing;       /* the line is empty: the help is an answer to a mistake */
    enum study_task task; /* study: --list, --run NUMBER, --collect */
    int number;           /* study: --run NUMBER */
    const char *results;  /* study: --results DIR, or NULL */
    int fresh;            /* study, permeability, calibrate: --fresh */
    /* post */
    int film;
    const char *film_quantity; /* --film=QUANTITY, or NULL */
    double level, magnify;     /* 0: not given */
    const char *before;        /* --before RUNDIR, or NULL */
    int sliced[3];             /* --slice x=PLACE: 1 */
    double slice[3];           /* m */
    int quick;                 /* study, bench, calibrate, permeability: --quick */
    int stepped;               /* permeability: --stepped */
    int fields;                /* permeability: --fields */
    const char *only;          /* bench, calibrate: a comma-separated list of parts, or NULL: all */
    /* bench */
    int repeats;
    const char *sizes; /* a comma-separated list, or NULL: the standard ones */
};

/* Dies (exit 2) with one sentence on a command line with a mistake. Collective. */
struct command *command_new(int argc, char **argv);
void command_free(struct command *c);
