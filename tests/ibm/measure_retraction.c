/* Measures the tables of docs/retraction.md: the depth of a marker inside the wetted face that gives the exact
 * result. */
/* measure_retraction [largest mesh, default 32 [smallest, default 16]]: the tables of docs/retraction.md, as Markdown.
 * Minutes on one core. */
#include "tests/ibm/flows.h"

#include <stdio.h>
#include <stdlib.h>

static int largest = 32, smallest = 16;

#define SAY(...)                                                                                                       \
    do {                                                                                                               \
        if (par_rank() == 0) {                                                                                         \
            printf(__VA_ARGS__);                                                                                       \
            fflush(stdout);                                                                                            \
        }                                                                                                              \
    } while (0)

static const struct flow_forcing feedback = {2, 1, 0.03}, multidirect = {2, 1, 0};

static void say_forcing(const struct flow_forcing *forcing) {
    if (forcing->slip_time > 0)
        SAY("| feedback, s = %g | %g |", forcing->slip_time, forcing->fraction);
    else
        SAY("| N_s = %d | %g |", forcing->iterations, forcing->fraction);
}

static void planes(void) {
    static const struct flow_forcing how[] = {{2, 1, 0},    {2, 0.1, 0},     {5, 1, 0},  {2, 1, 0.01},
                                              {2, 1, 0.03}, {2, 0.25, 0.03}, {2, 1, 0.1}};
    static const double area[3] = {1, 0.8, 1.2};
    SAY("## Planes\n\nHow far out of the markers the wall stands, e / dx.\n\n"
        "| forcing | dt / limit | A_h / dx^2 | offset: 0 | 0.1 | 0.2 | 0.3 | 0.4 | 0.5 | spread | thin sheet 0 | "
        "0.5 | slip |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (size_t n = 0; n < sizeof how / sizeof *how; n++)
        for (int a = 0; a < (n == 0 || n == 4 ? 3 : 1); a++) {
            double e[6], spread = 0;
            struct flow_result result = {0};
            say_forcing(&how[n]);
            SAY(" %g |", area[a]);
            for (int o = 0; o <= 5; o++) {
                e[o] = walls_shift(0.1 * o, area[a], &how[n]);
                for (int q = 0; q <= o; q++) spread = fmax(spread, fabs(e[o] - e[q]));
                SAY(" %.3f |", e[o]);
            }
            SAY(" %.3f |", spread);
            for (int o = 0; o <= 5; o += 5) SAY(" %.3f |", sheets_shift(16, 0.1 * o, area[a], &how[n], &result));
            SAY(" %.1e |\n", result.slip);
        }
}

/* k's error at three retractions, and the retraction at which a parabola through them is zero. */
static void array_row(struct array_case c, const char *name) {
    static const double retraction[2][3] = {{0.3, 0.6, 0.8}, {0.2, 0.28, 0.36}};
    const double *at = retraction[c.even || c.depth != BODY_HALF];
    double error[3];
    struct flow_result result[3];
    for (int n = 0; n < 3; n++) {
        c.retraction = at[n];
        error[n] = array_error(&c, &result[n]);
    }
    double a = -0.5, b = 1.5; /* bisection; the error grows with the retraction */
    for (int n = 0; n < 60; n++) {
        const double r = 0.5 * (a + b);
        double value = 0;
        for (int i = 0; i < 3; i++) {
            double w = error[i];
            for (int j = 0; j < 3; j++)
                if (j != i) w *= (r - at[j]) / (at[i] - at[j]);
            value += w;
        }
        *(value < 0 ? &a : &b) = r;
    }
    SAY("| %g | %d | %s ", c.solid_fraction, c.n, name);
    say_forcing(&c.forcing);
    SAY(" %ld | %+.2f | %+.2f | %+.2f | %.3f | %.1e | %ld | %.0f |\n", result[1].markers, 100 * error[0],
        100 * error[1], 100 * error[2], 0.5 * (a + b), result[1].slip, result[1].steps,
        result[0].seconds + result[1].seconds + result[2].seconds);
}

static const struct {
    const char *name;
    double sphere[3], lattice[3];
} cut[] = {{"site at the centre", {0, 0, 0}, {0, 0, 0}},
           {"the same, moved (.3, .1, .7) on the grid", {0.3, 0.1, 0.7}, {0.3, 0.1, 0.7}},
           {"corner at the centre", {0, 0, 0}, {0.5, 0.5, 0.5}},
           {"centre at (.25, .6, .4)", {0.25, 0.6, 0.4}, {0, 0, 0}},
           {"centre at (.35, .85, .15)", {0.35, 0.85, 0.15}, {0, 0, 0}},
           {"centre at (.1, .45, .8)", {0.1, 0.45, 0.8}, {0, 0, 0}}};
enum { CUTS = sizeof cut / sizeof *cut };

static void cuts(struct array_case c, int most) {
    for (int n = 0; n < most; n++) {
        char name[96];
        for (int d = 0; d < 3; d++) c.sphere[d] = cut[n].sphere[d], c.lattice[d] = cut[n].lattice[d];
        snprintf(name, sizeof name, "%s: %s", c.depth == BODY_COUNTED ? "counted" : "half", cut[n].name);
        array_row(c, name);
    }
    struct array_case even = c;
    even.even = 1;
    for (int d = 0; d < 3; d++) even.sphere[d] = 0;
    if (c.depth == BODY_COUNTED) array_row(even, "even");
}

static void arrays(void) {
    static const int mesh[5] = {16, 24, 32, 48, 64};
    SAY("\n## Spheres\n\nk's error in %% at r_d = 0.2, 0.28, 0.36 (half: 0.3, 0.6, 0.8); r_d* without error; slip / "
        "mean velocity at the second.\n\n"
        "| c | cells | markers | forcing | dt / limit | number | 1 | 2 | 3 | r_d* | slip | steps | s |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (int n = 0; n < 5 && mesh[n] <= largest; n++) {
        if (mesh[n] < smallest) continue;
        struct array_case c = {.n = mesh[n], .solid_fraction = 0.125, .depth = BODY_COUNTED, .forcing = feedback};
        cuts(c, CUTS);
        c.forcing = multidirect;
        cuts(c, CUTS);
        c.depth = BODY_HALF;
        cuts(c, 4);
        c.depth = BODY_COUNTED;
        c.solid_fraction = 0.2;
        c.forcing = feedback;
        cuts(c, CUTS);
        c.forcing = multidirect;
        cuts(c, 1);
        if (mesh[n] != 32) continue;
        static const struct flow_forcing how[] = {{2, 1, 0.01},      {2, 1, 0.1}, {2, 0.25, 0.03}, {2, 0.0625, 0.03},
                                                  {2, 0.0625, 0.01}, {1, 1, 0},   {5, 1, 0},       {2, 0.1, 0}};
        for (size_t h = 0; h < sizeof how / sizeof *how; h++) {
            c.forcing = how[h];
            array_row(c, "counted: site at the centre");
        }
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
