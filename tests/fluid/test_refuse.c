/* Refused grids and contradictory sides: the program exits with the scene's code and a sentence. */
/* Run with the name of a case, this program must exit with the scene's exit code and its message. */
#include "base/par.h"
#include "fluid/fluid.h"

#include <string.h>

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const char *what = argc > 1 ? argv[1] : "";
    struct fluid_input in = {.n = {8, 8, 8}, .length = {1, 1, 1}, .density = 1, .viscosity = 1};
    for (int d = 0; d < 3; d++) in.side[d][0].type = in.side[d][1].type = FLUID_WALL;
    if (!strcmp(what, "cells")) in.n[1] = in.n[2] = 1;
    if (!strcmp(what, "periodic")) in.side[1][0].type = FLUID_PERIODIC;
    if (!strcmp(what, "flux")) in.side[0][0] = (struct fluid_side){.type = FLUID_INFLOW, .bulk_velocity = 1};
    if (!strcmp(what, "plane")) in.side[2][1].velocity[2] = 1;
    if (!strcmp(what, "file")) {
        in.side[0][0] =
            (struct fluid_side){.type = FLUID_INFLOW, .profile = FLUID_PROFILE_FILE, .file = "no/such/file"};
        in.side[0][1].type = FLUID_OUTFLOW;
    }
    fluid_free(fluid_new(&in));
    par_end();
    return 0;
}
