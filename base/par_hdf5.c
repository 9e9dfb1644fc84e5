/* HDF5 files that all ranks open together: HDF5 takes a communicator, which only base/ knows. */
#include "base/par_hdf5.h"

#include <mpi.h>

void par_hdf5_access(hid_t list) { H5Pset_fapl_mpio(list, MPI_COMM_WORLD, MPI_INFO_NULL); }

int par_hdf5_opens(const char *path) {
    MPI_File file;
    if (MPI_File_open(MPI_COMM_WORLD, path, MPI_MODE_CREATE | MPI_MODE_RDWR | MPI_MODE_DELETE_ON_CLOSE, MPI_INFO_NULL,
                      &file) != MPI_SUCCESS)
        return 0;
    MPI_File_close(&file);
    return 1;
}

void par_hdf5_transfer(hid_t list) { H5Pset_dxpl_mpio(list, H5FD_MPIO_COLLECTIVE); }
