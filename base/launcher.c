/* Recognises a launcher of another MPI than the library's. */
#include "base/launcher.h"
#include "base/die.h"
#include "base/libraries.h"
#include "base/par.h"

#include <stdlib.h>

void launcher_check(void) {
    static const char *const set[][2] = {{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"}, {"PMI_SIZE", "PMI_RANK"}};
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
