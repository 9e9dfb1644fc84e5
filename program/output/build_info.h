/* What the program was built from. Not collective. */
#pragma once
#include "base/files/json.h"

/* One line for each of version, compiler, vectors, MPI, HDF5, FFTW. */
void build_info_text(char *text, int size);
/* Members of run.json: version, compiler, libraries, host. */
void build_info_write(struct json *j);
