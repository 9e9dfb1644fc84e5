/* The libraries this program runs with. */
#pragma once

/* One line for each of MPI, HDF5 and FFTW, with the version found at run time. Not collective. */
void libraries_describe(char line[3][128]);
