/* Measures the tables of docs/retraction.md: the depth of a marker inside the wetted face that gives the exact
 * result. */
/* measure_retraction [largest mesh, default 48 [smallest, default 24]]: the tables of docs/retraction.md, as Markdown.
 * Minutes on one core. */
#include "tests/ibm/flows.h"

#include <stdio.h>
#include <stdlib.h>

static int largest = 48, smallest = 24;

#define SAY(...)                                                                                                       \
    do {                                                                                                               \
        if (par_rank() == 0) {                                                                                         \
            printf(__VA_ARGS__);                                                                                       \
            fflush(stdout);                                                                                            \
        }                                                                                                              \
    } while (0)

static void planes(void) {
    static const struct {
        int iterations;
        double fraction, area;
    } how[5] = {{2, 1, 1}, {2, 0.1, 1}, {5, 1, 1}, {2, 1, 0.8}, {2, 1, 1.2}};
    SAY("## Planes\n\nHow far out of the markers the wall stands, e / dx.\n\n"
        "| N_s | dt / limit | A_h / dx^2 | offset: 0 | 0.1 | 0.2 | 0.3 | 0.4 | 0.5 | spread | thin sheet 0 | "
        "0.5 | slip |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (int n = 0; n < 5; n++) {
        double e[6], spread = 0;
        struct flow_result result = {0};
        SAY("| %d | %g | %g |", how[n].iterations, how[n].fraction, how[n].area);
        for (int o = 0; o <= 5; o++) {
            e[o] = walls_shift(0.1 * o, how[n].area, how[n].iterations, how[n].fraction);
            for (int q = 0; q <= o; q++) spread = fmax(spread, fabs(e[o] - e[q]));
            SAY(" %.3f |", e[o]);
        }
        SAY(" %.3f |", spread);
        for (int o = 0; o <= 5; o += 5)
            SAY(" %.3f |", sheets_shift(16, 0.1 * o, how[n].area, how[n].iterations, how[n].fraction, &result));
        SAY(" %.1e |\n", result.slip);
    }
}

/* k's error at three retractions, and the retraction at which a parabola through them is zero. */
static void array_row(struct array_case c, const char *name) {
    static const double retraction[3] = {0.3, 0.6, 0.8};
    double error[3];
    struct flow_result result[3];
    for (int n = 0; n < 3; n++) {
        c.retraction = retraction[n];
        error[n] = array_permeability(&c, &result[n]) / ARRAY_PERMEABILITY - 1;
    }
    double a = 0, b = retraction[2] + 0.4; /* bisection; the error grows with the retraction */
    for (int n = 0; n < 60; n++) {
        const double r = 0.5 * (a + b);
        double value = 0;
        for (int i = 0; i < 3; i++) {
            double w = error[i];
            for (int j = 0; j < 3; j++)
                if (j != i) w *= (r - retraction[j]) / (retraction[i] - retraction[j]);
            value += w;
        }
        *(value < 0 ? &a : &b) = r;
    }
    SAY("| %d | %s | %d | %g | %ld | %+.2f | %+.2f | %+.2f | %.3f | %.1e | %ld | %.0f |\n", c.n, name, c.iterations,
        c.fraction, result[1].markers, 100 * error[0], 100 * error[1], 100 * error[2], 0.5 * (a + b), result[1].slip,
        result[1].steps, result[0].seconds + result[1].seconds + result[2].seconds);
}

static void arrays(void) {
    static const int mesh[4] = {24, 32, 48, 64};
    SAY("\n## Spheres, c = 1/8\n\nk's error in %% at r_d = 0.3, 0.6, 0.8; r_d* without error; slip / mean "
        "velocity at 0.6.\n\n"
        "| cells | markers | N_s | dt / limit | number | 0.3 | 0.6 | 0.8 | r_d* | slip | steps | s |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (int n = 0; n < 4 && mesh[n] <= largest; n++) {
        if (mesh[n] < smallest) continue;
        const struct array_case plain = {.n = mesh[n], .iterations = 2, .fraction = 1};
        struct array_case c = plain;
        array_row(c, "outer layer");
        for (int d = 0; d < 3; d++) c.sphere[d] = c.lattice[d] = 0.5;
        array_row(c, "moved (.5, .5, .5) on the grid");
        c = plain;
        for (int d = 0; d < 3; d++) c.sphere[d] = c.lattice[d] = (const double[3]){0.3, 0.1, 0.7}[d];
        array_row(c, "moved (.3, .1, .7) on the grid");
        c = plain;
        for (int d = 0; d < 3; d++) c.lattice[d] = 0.5;
        array_row(c, "lattice moved by (.5, .5, .5)");
        c = plain;
        for (int d = 0; d < 3; d++) c.sphere[d] = (const double[3]){0.25, 0.6, 0.4}[d];
        array_row(c, "sphere moved by (.25, .6, .4)");
        c = plain;
        c.even = 1;
        array_row(c, "even");
        if (mesh[n] != 32) continue;
        c = plain;
        for (int s = 1; s <= 5; s += 4) {
            c.iterations = s;
            array_row(c, "outer layer");
        }
        c = plain;
        c.fraction = 0.1;
        array_row(c, "outer layer");
        c.even = 1;
        array_row(c, "even");
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    if (argc > 1) largest = atoi(argv[1]);
    if (argc > 2) smallest = atoi(argv[2]);
    planes();
    arrays();
    par_end();
    return 0;
}
