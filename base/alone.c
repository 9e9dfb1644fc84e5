/* A process that no launcher started: Open MPI without its daemon, for a quicker start. */
/* Otherwise Open MPI 4 starts a daemon (orted) for it. That takes a quarter of a second and more, and the daemon waits
 * or spins for ever after some deaths of the process. All processes without it have the same job number, so they must
 * not make a folder for the job. Other libraries do not read these variables. */
#include "base/alone.h"

#include <stdlib.h>

static const char *const variable[][2] = {{"OMPI_MCA_ess_singleton_isolated", "1"},
                                          {"OMPI_MCA_pmix", "isolated"},
                                          {"OMPI_MCA_orte_create_session_dirs", "0"},
                                          {"OMPI_MCA_pml", "ob1"}, /* and no network */
                                          {"OMPI_MCA_btl", "self"},
                                          /* and no plugins and no look at devices that one process does without */
                                          {"OMPI_MCA_coll", "^adapt,han,inter,monitoring,sm,sync,tuned"},
                                          {"OMPI_MCA_osc", "^monitoring,rdma,ucx"},
                                          {"HWLOC_COMPONENTS", "-pci,-x86,-linuxio"}};
enum { VARIABLES = sizeof variable / sizeof *variable };

static int is_set[VARIABLES]; /* by alone_begin */

/* Of Open MPI's, MPICH's, PMIx' and Slurm's launchers. */
static int is_launched(void) {
    static const char *const by_launcher[] = {"OMPI_COMM_WORLD_SIZE", "PMI_RANK", "PMI_SIZE", "PMIX_RANK"};
    for (size_t k = 0; k < sizeof by_launcher / sizeof *by_launcher; k++)
        if (getenv(by_launcher[k])) return 1;
    return 0;
}

void alone_begin(void) {
    if (is_launched()) return;
    for (int k = 0; k < VARIABLES; k++)
        is_set[k] = !getenv(variable[k][0]) && setenv(variable[k][0], variable[k][1], 0) == 0;
}

/* A launcher that this process starts must not find them. */
void alone_end(void) {
    for (int k = 0; k < VARIABLES; k++)
        if (is_set[k]) unsetenv(variable[k][0]);
}
