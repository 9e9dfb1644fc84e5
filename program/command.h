/* The command line.  (SPEC 9) */
#pragma once
#include "bench/bench.h"

enum command_verb {
    COMMAND_RUN,
    COMMAND_CHECK,
    COMMAND_POST,
    COMMAND_BENCH,
    COMMAND_STUDY,
    COMMAND_VERSION,
    COMMAND_HELP
};

struct command {
    enum command_verb verb;
    int files;               /* scene; study; run folders for post; tables and run.json for bench --table */
    const char *const *file; /* borrowed from argv */
    char out[512];           /* run: the run folder; post with several folders: where the comparison goes;
                              bench, study: where the tables go */
    int sets;
    const char **set;        /* owned: --set key.path=value */
    int resume;              /* --resume: 1 */
    const char *resume_file; /* --resume=FILE, or NULL: the run folder's latest */
    double max_wall;         /* s; 0: no limit */
    int quiet;
    int fresh; /* study: --fresh */
    /* post, of plates */
    int film;
    const char *film_quantity; /* --film=QUANTITY, or NULL */
    double level, magnify;     /* 0: not given */
    /* bench */
    int quick, repeats;
    enum bench_page table;    /* of tables measured before, nothing is measured */
    const char *only, *sizes; /* lists of words with commas, or NULL: all, the standard ones */
};

/* Dies (exit 2) in one sentence on a line it does not understand. Collective. */
struct command *command_new(int argc, char **argv);
void command_free(struct command *c);
const char *command_usage(void);
