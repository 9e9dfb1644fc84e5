/* The libraries this program runs with. */
#pragma once

/* One line each of MPI, HDF5 and FFTW as found at run time. Not collective. */
void libraries_describe(char line[3][128]);
