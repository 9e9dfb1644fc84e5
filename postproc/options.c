/* Names of the quantities that can be drawn. */
#include "postproc/options.h"

#include <string.h>

static const char *const name[POSTPROC_QUANTITIES] = {"damage",         "stretch",       "energy", "displacement_x",
                                                      "displacement_y", "flow",          "speed",  "pressure",
                                                      "aperture",       "crack_pressure"};

int postproc_options_quantity(const char *word) {
    for (int k = 0; k < POSTPROC_QUANTITIES; k++)
        if (strcmp(word, name[k]) == 0) return k;
    return -1;
}

const char *postproc_options_name(enum postproc_quantity quantity) { return name[quantity]; }
