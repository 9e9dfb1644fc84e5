/* Convective outflow: mass conserved at every step, vortices leave, all directions alike. */
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

/* A uniform stream, or a developing one between walls, along any direction, forwards or backwards. */
static struct fluid_input stream_in(int d, int reverse, int n, double viscosity) {
    struct fluid_input in = {.n = {n, n, n}, .length = {1, 1, 1}, .density = 1.5, .viscosity = viscosity};
    for (int c = 0; c < 3; c++) all_sides(&in, c, FLUID_SLIP);
    in.n[d] = 2 * n;
    in.length[d] = 2;
    in.side[d][reverse] = (struct fluid_side){.type = FLUID_INFLOW, .profile = FLUID_UNIFORM, .bulk_velocity = 1};
    in.side[d][!reverse].type = FLUID_OUTFLOW;
    in.initial_velocity[d] = reverse ? -1 : 1;
    return in;
}

/* Net volume that leaves through all six sides over what enters. */
static double imbalance(struct fluid *f) {
    const struct fluid_grid *g = fluid_grid_of(f);
    double net = 0, in = 0;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            const int at_end = side ? g->lo[d] + g->m[d] == g->n[d] : g->lo[d] == 0, a = d == 0, b = d == 2 ? 1 : 2;
            for (int l = 0; at_end && l < g->m[b]; l++)
                for (int j = 0; j < g->m[a]; j++) {
                    int at[3];
                    at[d] = side ? g->m[d] - 1 : -1;
                    at[a] = j;
                    at[b] = l;
                    const double q =
                        (side ? 1 : -1) * component(f, d)[fluid_grid_at(g, at[0], at[1], at[2])] * g->d[a] * g->d[b];
                    net += q;
                    in += fabs(q);
                }
        }
    return fabs(par_sum(net)) / par_sum(in);
}

/* Speed of the disturbance of the uniform stream, m/s, root mean square. */
static double disturbance(struct fluid *f, int d, double mean) {
    const struct fluid_grid *g = fluid_grid_of(f);
    double sum = 0;
    for (int c = 0; c < 3; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++)
                    sum += pow(component(f, c)[fluid_grid_at(g, i, j, k)] - (c == d ? mean : 0), 2);
    return sqrt(par_sum(sum) / (double)fluid_cells(f));
}

/* A vortex (stream function a exp(-r^2/s^2), axis along the third direction) is carried out of the box. */
static void vortex_leaves(void **state) {
    (void)state;
    for (int d = 0; d < 3; d++)
        for (int reverse = 0; reverse < 2; reverse++) {
            if (check_skips(2 * d + reverse, 3)) continue; /* all_directions_alike has the others */
            const int across = (d + 1) % 3;
            const double mean = reverse ? -1 : 1, s = 0.12;
            struct fluid_input in = stream_in(d, reverse, 32, 2e-3); /* resolved: a cell Peclet number of 16 */
            in.n[(d + 2) % 3] = 4;
            in.length[(d + 2) % 3] = 0.125;
            struct fluid *f = fluid_new(&in);
            const struct fluid_grid *g = fluid_grid_of(f);
            check_below(disturbance(f, d, mean), 1e-12);
            for (int c = 0; c < 3; c++)
                for (int k = 0; k < g->m[2]; k++)
                    for (int j = 0; j < g->m[1]; j++)
                        for (int i = 0; i < g->m[0]; i++) {
                            const int at[3] = {i, j, k};
                            double x[3];
                            for (int e = 0; e < 3; e++)
                                x[e] = (at[e] + g->lo[e] + (e == c ? 1.0 : 0.5)) * g->d[e] - (e == d ? 1.0 : 0.5);
                            const double psi = 0.05 * exp(-(x[d] * x[d] + x[across] * x[across]) / (s * s));
                            double *q = component(f, c) + fluid_grid_at(g, i, j, k);
                            const int end = at[c] + g->lo[c] == g->n[c] - 1;
                            if (c == d && !end) *q += -2 * x[across] / (s * s) * psi;
                            if (c == across && !end) *q += 2 * x[d] / (s * s) * psi;
                        }
            fluid_state_refresh(f);
            const double before = disturbance(f, d, mean);
            double at_exit = 0;
            for (int i = 0; i < 180; i++) {
                fluid_step(f, 0.01);
                if (i % 20 == 0) check_below(imbalance(f), 1e-14);
                if (i % 20 == 0) check_below(fluid_measures_of(f).divergence_max, 1e-11);
                if (i == 60) at_exit = disturbance(f, d, mean);
            }
            check_above(before, 0.05);
            check_above(at_exit, 0.6 * before); /* it is still there shortly before */
            check_below(disturbance(f, d, mean), 0.04 * before);
            fluid_free(f);
        }
}

/* The same developing flow along x, y, z, forwards and backwards: the same energy, force on the box, and pressures. */
static void all_directions_alike(void **state) {
    (void)state;
    double first[5] = {0};
    for (int d = 0; d < 3; d++)
        for (int reverse = 0; reverse < 2; reverse++) {
            struct fluid_input in = stream_in(d, reverse, 10, 0.02);
            const int across = (d + 1) % 3, span = (d + 2) % 3;
            all_sides(&in, across, FLUID_WALL);
            in.side[across][1].velocity[d] = reverse ? -0.3 : 0.3;
            in.side[across][1].velocity[span] = 0.2;
            in.n[span] = 8;
            in.length[span] = 0.8;
            struct fluid *f = fluid_new(&in);
            for (int i = 0; i < 40; i++) fluid_step(f, 0.02);
            double pressure[64], force[3], seen[5];
            fluid_measures_mean_pressure(f, d, pressure);
            fluid_box_force(f, force);
            seen[0] = fluid_measures_kinetic_energy(f);
            seen[1] = fabs(force[d]);
            seen[2] = force[across];
            seen[3] = force[span];
            seen[4] = reverse ? pressure[15] - pressure[4] : pressure[4] - pressure[15];
            if (d == 0 && !reverse) memcpy(first, seen, sizeof first);
            for (int i = 0; i < 5; i++) check_close(seen[i], first[i], 1e-11 * (fabs(first[i]) + 1));
            check_above(first[0], 0.1);
            check_above(first[4], 1e-3);
            check_below(fabs(pressure[reverse ? 0 : 19]), 1e-12 * first[4]); /* its level is the outlet's */
            fluid_free(f);
        }
}

FLUID_TEST_MAIN(cmocka_unit_test(vortex_leaves), cmocka_unit_test(all_directions_alike))
