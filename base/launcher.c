/* What the environment tells of the program that started the ranks, and tells the one that will start others. */
#include "base/launcher.h"
#include "base/die.h"
#include "base/libraries.h"
#include "base/par.h"

#include <stdlib.h>
#include <unistd.h>

/* Open MPI's launcher, and MPICH's and Slurm's: the number of ranks and the rank. */
static const char *const set[][2] = {{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"}, {"PMI_SIZE", "PMI_RANK"}};

void launcher_check(void) {
    char library[3][128];
    for (int k = 0; k < 2 && par_size() == 1; k++) {
        const char *ranks = getenv(set[k][0]), *rank = getenv(set[k][1]);
        if (!ranks || atoi(ranks) < 2) continue;
        if (rank && atoi(rank) != 0) { /* the first says it */
            par_end();
            exit(EXIT_CODE_SCENE);
        }
        libraries_describe(library);
        die_all(EXIT_CODE_SCENE,
                "%s ranks were started, and each runs alone: the launcher is of another MPI than the library, %s",
                ranks, library[0]);
    }
}

int launcher_started(void) { return getenv(set[0][0]) || getenv(set[1][0]); }

void launcher_allow(void) {
    if (geteuid() != 0) return;
    setenv("OMPI_ALLOW_RUN_AS_ROOT", "1", 1);
    setenv("OMPI_ALLOW_RUN_AS_ROOT_CONFIRM", "1", 1);
}
