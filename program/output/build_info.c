/* What the program was built from: for frana --version and run.json. */
#include "program/output/build_info.h"
#include "base/libraries.h"
#include "base/vec_type.h"
#include "base/version.h"

#include <stdio.h>
#include <unistd.h>

void build_info_text(char *text, int size) {
    char libraries[3][128];
    libraries_describe(libraries);
    snprintf(text, (size_t)size, "frana %s (%s)\ncompiler: %s, %s\nvectors: %s\nMPI: %s\nHDF5: %s\nFFTW: %s\n",
             FRANA_VERSION, FRANA_REVISION, FRANA_COMPILER, FRANA_FLAGS, VEC_NAME, libraries[0], libraries[1],
             libraries[2]);
}

void build_info_write(struct json *j) {
    char libraries[3][128], host[128] = "";
    libraries_describe(libraries);
    gethostname(host, sizeof host - 1);
    json_text(j, "version", FRANA_VERSION);
    json_text(j, "revision", FRANA_REVISION);
    json_text(j, "compiler", FRANA_COMPILER);
    json_text(j, "flags", FRANA_FLAGS);
    json_text(j, "vectors", VEC_NAME);
    json_text(j, "mpi", libraries[0]);
    json_text(j, "hdf5", libraries[1]);
    json_text(j, "fftw", libraries[2]);
    json_text(j, "host", host);
}
