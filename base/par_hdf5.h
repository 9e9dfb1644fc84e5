/* HDF5 files that all ranks open together: HDF5 takes a communicator, which only base/ knows. */
#pragma once
#include <hdf5.h>

void par_hdf5_access(hid_t list); /* a file is opened by all ranks. Not collective; opening is. */
/* Whether all ranks can open a new file of this name together; it is removed. ROMIO, for one, takes what stands before
 * a colon for the name of a file system. Collective. */
int par_hdf5_opens(const char *path);
void par_hdf5_transfer(hid_t list); /* all ranks take part in a transfer. Not collective; the transfer is. */
