/* The command line.  (SPEC 9) */
#pragma once

enum command_verb { COMMAND_RUN, COMMAND_CHECK, COMMAND_POST, COMMAND_VERSION, COMMAND_HELP };

struct command {
    enum command_verb verb;
    int files;               /* scene, or run folders for post */
    const char *const *file; /* borrowed from argv */
    char out[512];           /* run: the run folder; post with several folders: where the comparison goes */
    int sets;
    const char **set;        /* owned: --set key.path=value */
    int resume;              /* --resume: 1 */
    const char *resume_file; /* --resume=FILE, or NULL: the run folder's latest */
    double max_wall;         /* s; 0: no limit */
    int quiet;
};

/* Dies (exit 2) in one sentence on a line it does not understand. Collective. */
struct command *command_new(int argc, char **argv);
void command_free(struct command *c);
const char *command_usage(void);
