/* HDF5 files that all ranks open together: HDF5 takes a communicator, which only base/ knows. */
#include "base/par_hdf5.h"

#include <mpi.h>

void par_hdf5_access(hid_t list) { H5Pset_fapl_mpio(list, MPI_COMM_WORLD, MPI_INFO_NULL); }

void par_hdf5_transfer(hid_t list) { H5Pset_dxpl_mpio(list, H5FD_MPIO_COLLECTIVE); }
