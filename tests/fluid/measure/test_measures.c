/* Sums over the velocity against plain loops over the definitions. */
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"
#include "tests/fluid/fluid_case.h"

static struct fluid *fluid_of(enum fluid_side_type low, enum fluid_side_type high, int across) {
    struct fluid_input in = {.n = {13, 9, 11}, .length = {1, 2, 1.5}, .density = 3, .viscosity = 0.02};
    for (int d = 0; d < 3; d++) all_sides(&in, d, d == across ? low : FLUID_WALL);
    in.side[across][1].type = high;
    in.side[across][0].bulk_velocity = low == FLUID_INFLOW ? 0.2 : 0;
    struct fluid *f = fluid_new(&in);
    stir(f);
    return f;
}

/* By the definitions: a pair or face counts on the rank that has it. */
static struct fluid_measures plain(struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    const ptrdiff_t stride[3] = {1, g->row, g->plane};
    const double volume = g->d[0] * g->d[1] * g->d[2];
    struct fluid_measures v = {0};
    double sum[9] = {0};
    for (int k = -1; k <= g->m[2]; k++)
        for (int j = -1; j <= g->m[1]; j++)
            for (int i = -1; i <= g->m[0]; i++) {
                const int at[3] = {i, j, k};
                const size_t n = fluid_grid_at(g, i, j, k);
                double divergence = 0, rate = 0;
                int in_cells = 1;
                for (int c = 0; c < 3; c++) in_cells &= at[c] >= 0 && at[c] < g->m[c];
                for (int c = 0; c < 3; c++) {
                    const double *q = component(f, c) + n;
                    int low[3], high[3], advanced = 1;
                    fluid_boundary_advanced(f->boundary, g, c, low, high);
                    for (int d = 0; d < 3; d++) advanced &= at[d] >= low[d] && at[d] < high[d];
                    if (advanced) {
                        double x[3];
                        for (int d = 0; d < 3; d++)
                            x[d] = (g->lo[d] + at[d] + (c == d ? 1 : 0.5)) * g->d[d] - 0.5 * g->length[d];
                        sum[3 + c] += 3 * volume * q[0];
                        sum[6 + (c + 1) % 3] += 3 * volume * x[(c + 2) % 3] * q[0];
                        sum[6 + (c + 2) % 3] -= 3 * volume * x[(c + 1) % 3] * q[0];
                    }
                    for (int d = 0; d < 3; d++) {
                        const struct fluid_boundary_side *side = f->boundary->side[d];
                        const int end = g->m[d] + (c != d && side[1].here);
                        const int across =
                            c != d && ((at[d] == 0 && side[0].here) || (at[d] == g->m[d] && side[1].here));
                        int counts = at[d] >= 0 && at[d] < end;
                        for (int e = 0; e < 3; e++) counts &= e == d || (at[e] >= low[e] && at[e] < high[e]);
                        if (counts)
                            sum[2] += (across ? 0.5 : 1) * 3 * 0.02 * volume * pow((q[0] - q[-stride[d]]) / g->d[d], 2);
                    }
                    if (!in_cells) continue;
                    divergence += (q[0] - q[-stride[c]]) / g->d[c];
                    rate += fmax(fabs(q[0]), fabs(q[-stride[c]])) / g->d[c];
                    sum[1] += 0.25 * 3 * volume * (q[0] * q[0] + q[-stride[c]] * q[-stride[c]]);
                    if (c == 0) sum[0] += 0.5 * (q[0] + q[-1]) / (13 * 9 * 11);
                }
                v.divergence_max = fmax(v.divergence_max, fabs(divergence));
                v.convection_rate = fmax(v.convection_rate, rate);
            }
    par_sum_array(sum, 9);
    v.divergence_max = par_max(v.divergence_max);
    v.convection_rate = par_max(v.convection_rate);
    v.bulk_velocity = sum[0], v.kinetic_energy = sum[1], v.dissipation = sum[2];
    memcpy(v.momentum, sum + 3, sizeof v.momentum);
    memcpy(v.angular, sum + 6, sizeof v.angular);
    return v;
}

static void with_sides(enum fluid_side_type low, enum fluid_side_type high) {
    for (int across = 0; across < 3; across++) {
        struct fluid *f = fluid_of(low, high, across);
        const struct fluid_measures want = plain(f), all = fluid_measures_of(f);
        double momentum[3], angular[3];
        fluid_measures_momentum(f, momentum, angular);
        check_above(want.divergence_max, 0.1);
        check_relative(all.divergence_max, want.divergence_max, 1e-13);
        check_relative(all.convection_rate, want.convection_rate, 1e-13);
        check_close(all.bulk_velocity, want.bulk_velocity, 1e-14);
        check_relative(all.kinetic_energy, want.kinetic_energy, 1e-13);
        check_relative(all.dissipation, want.dissipation, 1e-13);
        check_close(bulk_velocity_along(f, 0), want.bulk_velocity, 1e-14);
        check_relative(fluid_measures_kinetic_energy(f), want.kinetic_energy, 1e-13);
        for (int c = 0; c < 3; c++) {
            check_close(all.momentum[c], want.momentum[c], 1e-13);
            check_close(momentum[c], want.momentum[c], 1e-13);
            check_close(all.angular[c], want.angular[c], 1e-13);
            check_close(angular[c], want.angular[c], 1e-13);
        }
        fluid_free(f);
    }
}

static void between_periodic_sides(void **state) {
    (void)state;
    with_sides(FLUID_PERIODIC, FLUID_PERIODIC);
}
static void between_walls(void **state) {
    (void)state;
    with_sides(FLUID_WALL, FLUID_SLIP);
}
static void from_an_inflow_to_an_outflow(void **state) {
    (void)state;
    with_sides(FLUID_INFLOW, FLUID_OUTFLOW);
}
/* The faces on a low open side are advanced too. */
static void between_open_sides(void **state) {
    (void)state;
    with_sides(FLUID_PRESSURE, FLUID_PRESSURE);
}

/* A value that is not a number is in none of the largest values, so it is told apart. */
static void what_is_no_number(void **state) {
    (void)state;
    const double bad[] = {NAN, INFINITY};
    for (int b = 0; b < 2; b++)
        for (int c = 0; c < 3; c++) {
            struct fluid *f = fluid_of(FLUID_PERIODIC, FLUID_PERIODIC, 0);
            if (par_rank() == 0) component(f, c)[fluid_grid_at(f->grid, 12, 1, 0)] = bad[b];
            const struct fluid_measures all = fluid_measures_of(f);
            check_equal(all.divergence_max, INFINITY);
            check_equal(all.convection_rate, INFINITY);
            fluid_free(f);
        }
}

FLUID_TEST_MAIN(cmocka_unit_test(between_periodic_sides), cmocka_unit_test(between_walls),
                cmocka_unit_test(from_an_inflow_to_an_outflow), cmocka_unit_test(between_open_sides),
                cmocka_unit_test(what_is_no_number))
