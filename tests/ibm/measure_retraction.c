/* Measures the tables of docs/retraction.md: the depth of a marker inside the wetted face that gives the exact
 * result. */
/* measure_retraction [largest mesh, default 32 [smallest, default 16]]: the tables of docs/retraction.md, as Markdown.
 * Minutes on one core. */
#include "physics/retraction.h"
#include "tests/ibm/flows.h"

#include <stdio.h>
#include <stdlib.h>

static int largest = 32, smallest = 16;

#define PROBLEM(...)                                                                                                   \
    do {                                                                                                               \
        if (par_rank() == 0) {                                                                                         \
            printf(__VA_ARGS__);                                                                                       \
            fflush(stdout);                                                                                            \
        }                                                                                                              \
    } while (0)

static const struct flow_forcing feedback = {2, 1, 0.03}, multidirect = {2, 1, 0};

static void print_forcing(const struct flow_forcing *forcing) {
    if (forcing->slip_time > 0)
        PROBLEM("| feedback, s = %g | %g |", forcing->slip_time, forcing->fraction);
    else
        PROBLEM("| N_s = %d | %g |", forcing->iterations, forcing->fraction);
}

static void planes(void) {
    static const struct flow_forcing how[] = {{2, 1, 0},    {2, 0.1, 0},     {5, 1, 0},  {2, 1, 0.01},
                                              {2, 1, 0.03}, {2, 0.25, 0.03}, {2, 1, 0.1}};
    static const double area[3] = {1, 0.8, 1.2};
    PROBLEM("## Planes\n\nHow far out of the markers the wall stands, e / dx.\n\n"
            "| forcing | dt / limit | A_h / dx^2 | offset: 0 | 0.1 | 0.2 | 0.3 | 0.4 | 0.5 | spread | thin sheet 0 | "
            "0.5 | slip |\n"
            "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (size_t n = 0; n < sizeof how / sizeof *how; n++)
        for (int a = 0; a < (n == 0 || n == 4 ? 3 : 1); a++) {
            double e[6], spread = 0;
            struct flow_result result = {0};
            print_forcing(&how[n]);
            PROBLEM(" %g |", area[a]);
            for (int o = 0; o <= 5; o++) {
                e[o] = walls_shift(0.1 * o, area[a], &how[n]);
                for (int q = 0; q <= o; q++) spread = fmax(spread, fabs(e[o] - e[q]));
                PROBLEM(" %.3f |", e[o]);
            }
            PROBLEM(" %.3f |", spread);
            for (int o = 0; o <= 5; o += 5) PROBLEM(" %.3f |", sheets_shift(16, 0.1 * o, area[a], &how[n], &result));
            PROBLEM(" %.1e |\n", result.slip);
        }
}

/* k's error at three retractions, and the retraction at which a parabola through them is zero. */
static void array_row(struct array_case c, const char *name) {
    static const double retraction[2][3] = {{0.3, 0.6, 0.8}, {0.2, PHYSICS_RETRACTION, 0.36}};
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
    PROBLEM("| %g | %d | %s ", c.solid_fraction, c.n, name);
    print_forcing(&c.forcing);
    PROBLEM(" %ld | %+.2f | %+.2f | %+.2f | %.3f | %.1e | %ld | %.0f |\n", result[1].markers, 100 * error[0],
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
    PROBLEM(
        "\n## Spheres\n\nk's error in %% at r_d = 0.2, 0.28, 0.36 (half: 0.3, 0.6, 0.8); r_d* without error; slip / "
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

/* Mean, and smallest and largest value of a shift over cuts of a body. */
static void print_spread(int n, const double *value, double unit) {
    double sum = 0, low = INFINITY, high = -INFINITY;
    for (int i = 0; i < n; i++) sum += value[i], low = fmin(low, value[i]), high = fmax(high, value[i]);
    PROBLEM(" %+.3f (%+.3f to %+.3f) |", unit * sum / n, unit * low, unit * high);
}

static const double hollow[4][3] = {{0, 0, 0}, {0.25, 0.6, 0.4}, {0.35, 0.85, 0.15}, {0.1, 0.45, 0.8}};
static const char *const depth_name[3] = {"half", "counted", "true"};

static void other_bodies(void) {
    static const struct {
        int across[3], period;
        double way[3];
    } slab[8] = {{{1, 0, 0}, 40, {0, 0, 1}},
                 {{1, 1, 0}, 56, {0, 0, 1}},
                 {{1, 1, 0}, 56, {M_SQRT1_2, -M_SQRT1_2, 0}},
                 {{1, 2, 0}, 88, {0, 0, 1}},
                 {{1, 2, 0}, 88, {0.894427190999916, -0.447213595499958, 0}},
                 {{1, 3, 0}, 120, {0, 0, 1}},
                 {{1, 3, 0}, 120, {0.948683298050514, -0.316227766016838, 0}},
                 {{1, 1, 1}, 64, {M_SQRT1_2, -M_SQRT1_2, 0}}};
    PROBLEM(
        "\n## Other bodies\n\nSlabs: the gap between a face and the next, found too wide, per face, cells; r_d = 0.28 "
        "(half: 0.6). A slab is a whole number of the lattice's planes thick.\n\n"
        "| normal | motion | depth | forcing | dt / limit | shift |\n|---|---|---|---|---|---|\n");
    for (int n = 0; n < 8; n++)
        for (int d = 0; d < 3; d++)
            for (int h = 0; h < (d == 1 ? 2 : 1); h++) {
                const struct flow_forcing *forcing = h ? &multidirect : &feedback;
                const double shift = slabs_shift(slab[n].across, slab[n].period, slab[n].way, n == 0 ? 0 : 0.05,
                                                 (enum body_depth)d, d == 0 ? 0.6 : PHYSICS_RETRACTION, forcing);
                PROBLEM("| %d %d %d | %.2f %.2f %.2f | %s ", slab[n].across[0], slab[n].across[1], slab[n].across[2],
                        slab[n].way[0], slab[n].way[1], slab[n].way[2], depth_name[d]);
                print_forcing(forcing);
                PROBLEM(" %+.3f |\n", shift);
            }
    PROBLEM(
        "\nCylinders, c = 0.2: k's error in %%, four places on the lattice; r_d = 0.28 (half: 0.6; true: 0.28 + 0.25 "
        "dx/a).\n\n| cells | radius | depth | forcing | dt / limit | error |\n|---|---|---|---|---|---|\n");
    for (int n = 16; n <= 48; n += n < 32 ? 8 : 16)
        for (int d = 0; d < 3; d++) {
            double error[4];
            const double a = sqrt(0.2 / M_PI) * n;
            struct flow_result result;
            for (int o = 0; o < 4; o++)
                error[o] =
                    cylinders_error(n, hollow[o], (enum body_depth)d,
                                    d == 0 ? 0.6 : PHYSICS_RETRACTION + (d == 2) * PHYSICS_RETRACTION_CURVED * 0.5 / a,
                                    &feedback, &result);
            PROBLEM("| %d | %.1f | %s ", n, a, depth_name[d]);
            print_forcing(&feedback);
            print_spread(4, error, 100);
            PROBLEM("\n");
        }
    PROBLEM(
        "\nHollows: error of the radius, cells; r_d = 0.28 (half: 0.6; true: 0.28 - 0.25 dx/a of a pipe, 0.28 - 0.5 "
        "dx/a of a cavity).\n\n| hollow | radius | depth | forcing | dt / limit | error "
        "|\n|---|---|---|---|---|---|\n");
    for (int pipe = 1; pipe >= 0; pipe--)
        for (int a = 0; a < 3; a++)
            for (int d = 0; d < 3; d++) {
                double shift[4];
                const double radius = (const double[3]){5.2, 8.1, 12.3}[a],
                             bend = PHYSICS_RETRACTION_CURVED * (pipe ? 0.5 : 1) / radius;
                for (int o = 0; o < 4; o++)
                    shift[o] = hollow_shift(pipe, radius, hollow[o], (enum body_depth)d,
                                            d == 0 ? 0.6 : PHYSICS_RETRACTION - (d == 2) * bend, &feedback);
                PROBLEM("| %s | %g | %s ", pipe ? "pipe" : "cavity", radius, depth_name[d]);
                print_forcing(&feedback);
                print_spread(4, shift, 1);
                PROBLEM("\n");
            }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    if (argc > 1) largest = atoi(argv[1]);
    if (argc > 2) smallest = atoi(argv[2]);
    planes();
    arrays();
    other_bodies();
    par_end();
    return 0;
}
