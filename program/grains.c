/* Makes a small synthetic rock of overlapping grains. */
#include "program/grains.h"

#include <math.h>
#include <stdint.h>

enum { EDGE = 32, GRAINS = 60 };

/* The next random number between 0 and 1; the same on every machine. */
static double next(uint32_t *state) {
    *state = (uint32_t)(16807ULL * *state % 2147483647U);
    return *state / 2147483647.0;
}

/* The square of the distance between two places on a line that is periodic. */
static double apart(double a, double b) {
    const double d = fabs(a - b);
    return d < EDGE - d ? d * d : (EDGE - d) * (EDGE - d);
}

void grains_write(FILE *to) {
    double centre[GRAINS][3], radius[GRAINS];
    uint32_t state = 79190;
    for (int g = 0; g < GRAINS; g++) {
        for (int c = 0; c < 3; c++) centre[g][c] = EDGE * next(&state);
        radius[g] = 4 + 3 * next(&state);
    }
    for (int q = 0; q < EDGE * EDGE * EDGE; q++) {
        const double x[3] = {q % EDGE + 0.5, q / EDGE % EDGE + 0.5, q / EDGE / EDGE + 0.5};
        int is_grain = 0;
        for (int g = 0; g < GRAINS; g++) {
            double sum = 0;
            for (int c = 0; c < 3; c++) sum += apart(x[c], centre[g][c]);
            is_grain |= sum < radius[g] * radius[g];
        }
        putc(is_grain, to);
    }
}
