/* Ghost cells by the sides' conditions: each kind of condition on each component, at a centre's place and on the
 * side's own face. */
#include "fluid/grid/boundary.h"
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

#include <stdlib.h>

/* Fields of the global place; a side's own faces too. */
static double field(int c, const long at[3]) { return random_at(c, at[0], at[1], at[2]); }

static void fill(const struct fluid_grid *g, double *q[3]) {
    for (int c = 0; c < 3; c++) {
        q[c] = malloc(g->size * sizeof(double));
        for (size_t n = 0; n < g->size; n++) q[c][n] = NAN;
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++)
                    q[c][fluid_grid_at(g, i, j, k)] =
                        field(c, (const long[]){i + g->lo[0], j + g->lo[1], k + g->lo[2]});
    }
}

/* Of a side of x: what stands l cells beyond it or within it, as an index along x. Faces are mirrored about the
 * side's own face, -1 or m-1. */
static int beyond(const struct fluid_grid *g, int side, int on_face, int l) {
    return side ? g->m[0] - 1 + l : on_face ? -1 - l : -l;
}
static int within(const struct fluid_grid *g, int side, int on_face, int l) {
    return side ? g->m[0] - (on_face ? 1 + l : l) : l - 1;
}

/* The sides of x have the type and numbers; y, z are periodic. Looks at three layers. */
static void check_sides(const struct fluid_side *kind, const enum fluid_condition condition[3], const double value[3]) {
    struct fluid_input in = {.n = {8, 8, 12}, .length = {0.8, 1.6, 1.2}, .density = 1, .viscosity = 1};
    const int periodic[3] = {0, 1, 1};
    double *q[3];
    in.side[0][0] = in.side[0][1] = *kind;
    struct fluid_grid *g = fluid_grid_new(in.n, in.length, periodic, 3, NULL);
    struct fluid_boundary *b = fluid_boundary_new(g, &in);
    fill(g, q);
    fluid_boundary_velocity(b, g, q, 3);
    for (int side = 0; side < 2; side++)
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < g->m[2]; k++)
                for (int j = 0; j < g->m[1]; j++) {
                    if (c == 0) check_equal(q[0][fluid_grid_at(g, side ? g->m[0] - 1 : -1, j, k)], value[0]);
                    for (int l = 1; l <= (c == 0 && !side ? 2 : 3); l++) { /* the face itself is one */
                        const double out = q[c][fluid_grid_at(g, beyond(g, side, c == 0, l), j, k)],
                                     in_ = q[c][fluid_grid_at(g, within(g, side, c == 0, l), j, k)];
                        const double expected = condition[c] == FLUID_DIRICHLET
                                                    ? 2 * value[c] - in_
                                                    : in_ + (2 * l - 1) * g->d[0] * value[c];
                        check_close(out, expected, 1e-14);
                    }
                }
    for (int c = 0; c < 3; c++) free(q[c]);
    fluid_boundary_free(b);
    fluid_grid_free(g);
}

static void by_type_of_side(void **state) {
    (void)state;
    const enum fluid_condition D = FLUID_DIRICHLET, N = FLUID_NEUMANN;
    check_sides(&(struct fluid_side){.type = FLUID_WALL, .velocity = {0, 0.5, -2}}, (enum fluid_condition[]){D, D, D},
                (double[]){0, 0.5, -2});
    check_sides(&(struct fluid_side){.type = FLUID_SLIP}, (enum fluid_condition[]){D, N, N}, (double[]){0, 0, 0});
    check_sides(&(struct fluid_side){.type = FLUID_GENERAL, .velocity = {0, 3, 0.25}, .condition = {D, N, D, N}},
                (enum fluid_condition[]){D, N, D}, (double[]){0, 3, 0.25});
    check_sides(&(struct fluid_side){.type = FLUID_GENERAL, .velocity = {0, -1, 4}, .condition = {D, D, N, N}},
                (enum fluid_condition[]){D, D, N}, (double[]){0, -1, 4});
}

/* Across periodic sides, and between ranks, ghosts are the other end's cells, to the bit. */
static void across_periodic_sides(void **state) {
    (void)state;
    struct fluid_input in = {.n = {8, 8, 12}, .length = {1, 1, 1}, .density = 1, .viscosity = 1};
    const int periodic[3] = {1, 1, 1};
    double *q[3];
    struct fluid_grid *g = fluid_grid_new(in.n, in.length, periodic, 3, NULL);
    struct fluid_boundary *b = fluid_boundary_new(g, &in);
    fill(g, q);
    fluid_boundary_velocity(b, g, q, 3);
    for (int c = 0; c < 3; c++)
        for (int k = -3; k < g->m[2] + 3; k++)
            for (int j = -3; j < g->m[1] + 3; j++)
                for (int i = -3; i < g->m[0] + 3; i++) {
                    const int at[3] = {i, j, k};
                    long wrapped[3];
                    for (int d = 0; d < 3; d++) wrapped[d] = (at[d] + g->lo[d] + g->n[d]) % g->n[d];
                    check_equal(q[c][fluid_grid_at(g, i, j, k)], field(c, wrapped));
                }
    for (int c = 0; c < 3; c++) free(q[c]);
    fluid_boundary_free(b);
    fluid_grid_free(g);
}

/* What flows in through the planes: the mean velocities by the sides' areas; what is left open has an area. */
static void flow_through_the_sides(void **state) {
    (void)state;
    struct fluid_input in = {.n = {8, 8, 12}, .length = {0.8, 1.6, 1.2}, .density = 1, .viscosity = 1};
    in.side[0][0] = (struct fluid_side){.type = FLUID_INFLOW, .bulk_velocity = 0.5};
    in.side[0][1] = (struct fluid_side){.type = FLUID_OUTFLOW};
    struct fluid_grid *g = fluid_grid_new(in.n, in.length, (const int[]){0, 1, 1}, 1, NULL);
    struct fluid_boundary *b = fluid_boundary_new(g, &in);
    check_relative(b->inflow, 0.5 * 1.6 * 1.2, 1e-13);
    check_relative(b->outlet, 1.6 * 1.2, 1e-13);
    assert_false(b->open);
    fluid_boundary_free(b);
    fluid_grid_free(g);
}

FLUID_TEST_MAIN(cmocka_unit_test(by_type_of_side), cmocka_unit_test(across_periodic_sides),
                cmocka_unit_test(flow_through_the_sides))
