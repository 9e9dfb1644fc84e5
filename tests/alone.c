/* Lets a test program that runs without mpiexec start without Open MPI's daemon: that takes a third of the time, and
 * the daemon waits for ever for children that the program forks and that die. Before main, so before MPI_Init. */
#include "base/launcher.h"

#include <stdlib.h>

/* All such processes have the same job number, so they must not make a folder for the job. */
__attribute__((constructor)) static void start_alone(void) {
    if (launcher_started() || getenv("PMIX_RANK")) return;
    setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
    setenv("OMPI_MCA_pmix", "isolated", 0);
    setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
}
