/* Names and versions of the MPI, HDF5 and FFTW libraries in use. */
#include "base/libraries.h"

#include <fftw3.h>
#include <hdf5.h>
#include <mpi.h>
#include <stdio.h>
#include <string.h>

void libraries_describe(char line[3][128]) {
    char mpi[MPI_MAX_LIBRARY_VERSION_STRING] = "";
    int length = 0;
    unsigned major = 0, minor = 0, release = 0;
    MPI_Get_library_version(mpi, &length);
    mpi[strcspn(mpi, ",\n")] = '\0';
    snprintf(line[0], 128, "%.127s", mpi);
    H5get_libversion(&major, &minor, &release);
    snprintf(line[1], 128, "%u.%u.%u", major, minor, release);
    snprintf(line[2], 128, "%.127s", fftw_version);
}
