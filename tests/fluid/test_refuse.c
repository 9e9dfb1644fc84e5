/* Refused grids and contradictory sides: the program exits with the scene's code and a sentence. */
/* Run with the name of a case, this program must exit with the scene's exit code and its message. */
#include "base/par.h"
#include "fluid/fluid.h"

#include <stdio.h>
#include <string.h>

static void inflow_from(struct fluid_input *in, const char *path) {
    struct fluid_side *side = &in->side[0][0];
    *side = (struct fluid_side){.type = FLUID_INFLOW, .profile = FLUID_PROFILE_FILE};
    snprintf(side->file, sizeof side->file, "%s", path);
    in->side[0][1].type = FLUID_OUTFLOW;
}

/* A file of so many velocities, of which the fifth is a word; in the folder in which the test runs. */
static void inflow_of(struct fluid_input *in, int values, const char *fifth) {
    char path[64];
    snprintf(path, sizeof path, "refuse_%d_%s.txt", values, fifth);
    FILE *file = par_rank() == 0 ? fopen(path, "w") : NULL;
    for (int k = 1; file && k <= values; k++) fprintf(file, "%s\n", k == 5 ? fifth : "0.1");
    if (file) fclose(file);
    inflow_from(in, path);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const char *what = argc > 1 ? argv[1] : "";
    struct fluid_input in = {.n = {8, 8, 8}, .length = {1, 1, 1}, .density = 1, .viscosity = 1};
    for (int d = 0; d < 3; d++) in.side[d][0].type = in.side[d][1].type = FLUID_WALL;
    if (!strcmp(what, "cells")) in.n[1] = in.n[2] = 1;
    if (!strcmp(what, "periodic")) in.side[1][0].type = FLUID_PERIODIC;
    if (!strcmp(what, "flux")) in.side[0][0] = (struct fluid_side){.type = FLUID_INFLOW, .bulk_velocity = 1};
    if (!strcmp(what, "plane")) in.side[2][1].velocity[2] = 1;
    if (!strcmp(what, "file")) inflow_from(&in, "no/such/file");
    if (!strcmp(what, "word")) inflow_of(&in, 64, "0.1,");
    if (!strcmp(what, "nan")) inflow_of(&in, 64, "nan");
    if (!strcmp(what, "fast")) inflow_of(&in, 64, "-1e151");
    if (!strcmp(what, "few")) inflow_of(&in, 63, "0.1");
    if (!strcmp(what, "many")) inflow_of(&in, 65, "0.1");
    fluid_free(fluid_new(&in));
    par_end();
    return 0;
}
