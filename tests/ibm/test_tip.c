/* What a tip reads of fields that are polynomials: exact to the degree that its formulas have. */
#include "base/par.h"
#include "ibm/state.h"
#include "tests/check.h"

#include <stdlib.h>

static const int cells[3] = {8, 9, 10}, walls[3] = {0, 0, 0};
static const double length[3] = {0.8, 1.8, 1.5}; /* cells of 0.1, 0.2, 0.15 m */
static const double mu = 0.7;

/* Fills u, v, w, p, ghosts with them, from functions of place. */
static struct fluid_state state_of(const struct fluid_grid *g, double (*value_at)(int field, const double x[3])) {
    double *array[4];
    for (int f = 0; f < 4; f++) {
        array[f] = malloc(g->size * sizeof(double));
        for (size_t n = 0; n < g->size; n++) array[f][n] = NAN;
        for (int k = -3; k < g->m[2] + 3; k++)
            for (int j = -3; j < g->m[1] + 3; j++)
                for (int i = -3; i < g->m[0] + 3; i++) {
                    const int at[3] = {i, j, k};
                    double x[3];
                    for (int d = 0; d < 3; d++) x[d] = (at[d] + (d == f ? 1 : 0.5)) * g->d[d];
                    array[f][fluid_grid_at(g, i, j, k)] = value_at(f, x);
                }
    }
    return (struct fluid_state){.u = array[0], .v = array[1], .w = array[2], .p = array[3]};
}

static void state_free(struct fluid_state *s) {
    double *const array[4] = {s->u, s->v, s->w, s->p};
    for (int f = 0; f < 4; f++) free(array[f]);
}

static const double constant[4] = {1, -2, 0.5, 30};
static const double slope[4][3] = {{2, -1, 0.5}, {0.25, 3, 4}, {-2, 1, -5}, {10, 20, -40}};

static double linear(int field, const double x[3]) {
    return constant[field] + slope[field][0] * x[0] + slope[field][1] * x[1] + slope[field][2] * x[2];
}

/* Some tips and unit normals: more than a group, the last one not full. */
enum { TIPS = 19 };
static void items(const struct fluid_grid *g, double item[TIPS][IBM_TIP_SENT]) {
    for (int h = 0; h < TIPS; h++) {
        const double a = 0.3 + h, b = 1.1 * h;
        const double n[3] = {sin(a) * cos(b), sin(a) * sin(b), cos(a)};
        for (int d = 0; d < 3; d++) {
            item[h][d] = 1 + (g->n[d] - 2.0) * (h * (d + 3) * 7 % TIPS) / (TIPS - 1.0);
            item[h][IBM_TIP_NORMAL + d] = n[d];
            item[h][IBM_TIP_VELOCITY + d] = 0.1 * (d + 1) * h;
        }
    }
}

/* Linear fields: pressure, its slope along the normal, and mu (grad u + grad u^T) n; to the wall or not, as nothing
 * bends. */
static void linear_fields(void **state) {
    (void)state;
    struct fluid_grid *g = fluid_grid_new(cells, length, walls, 3, NULL);
    struct fluid_state f = state_of(g, linear);
    double item[TIPS][IBM_TIP_SENT], result[TIPS][IBM_TIP_RETURNED];
    items(g, item);
    const struct ibm_tip_form form = {.density = 1000, .mu = mu};
    ibm_tip_measure(g, &f, &form, TIPS, &item[0][0], &result[0][0]);
    for (int h = 0; h < TIPS; h++) {
        const double *n = &item[h][IBM_TIP_NORMAL],
                     x[3] = {item[h][0] * g->d[0], item[h][1] * g->d[1], item[h][2] * g->d[2]};
        double dp = 0;
        for (int d = 0; d < 3; d++) dp += slope[3][d] * n[d];
        check_close(result[h][0], linear(3, x), 1e-12);
        check_close(result[h][IBM_TIP_SLOPE], dp, 1e-11);
        for (int c = 0; c < 3; c++) {
            double stress = 0;
            for (int d = 0; d < 3; d++) stress += mu * (slope[c][d] + slope[d][c]) * n[d];
            check_close(result[h][IBM_TIP_STRESS + c], stress, 1e-11);
        }
    }
    state_free(&f);
    fluid_grid_free(g);
}

/* A flow along a plane wall y = 0.3 that moves with V: u - V = 2 s - 3 s^2 + 1.5 s^3 along x and -s + s^3 along z
 * with s = y - 0.3; p = 7 + 4 s + 5 s^2. */
static const double wall = 0.3, V[3] = {0.5, 0, -0.25};

static double sheared(int field, const double x[3]) {
    const double s = x[1] - wall;
    return field == 0   ? V[0] + s * (2 + s * (-3 + s * 1.5))
           : field == 1 ? 0
           : field == 2 ? V[2] - s + s * s * s
                        : 7 + s * (4 + s * 5);
}

/* Carried to the wall: its shear by cubics, the slope of a parabola of pressure, and the scale of what is carried.
 * */
static void carried_to_the_wall(void **state) {
    (void)state;
    struct fluid_grid *g = fluid_grid_new(cells, length, walls, 3, NULL);
    struct fluid_state f = state_of(g, sheared);
    for (int q = 0; q < 6; q++) {
        const double l = 0.21 + 0.1 * q, s = l, u = s * (2 + s * (-3 + s * 1.5)), w = -s + s * s * s;
        double result[IBM_TIP_RETURNED];
        const double item[IBM_TIP_SENT] = {
            3.1 + 0.17 * q, (wall + l) / g->d[1], 4.9 - 0.3 * q, 0, 1, 0, V[0], V[1], V[2]};
        const struct ibm_tip_form form = {.density = 1000, .mu = mu, .length = l};
        ibm_tip_measure(g, &f, &form, 1, item, result);
        check_close(result[0], 7 + 4 * s + 5 * s * s, 1e-12);
        check_close(result[IBM_TIP_SLOPE], 4 + 10 * s, 1e-11);
        check_close(result[IBM_TIP_WALL_SLOPE], 4, 1e-11);
        check_close(result[IBM_TIP_STRESS + 0], mu * 2, 1e-11);
        check_close(result[IBM_TIP_STRESS + 1], 0, 1e-11);
        check_close(result[IBM_TIP_STRESS + 2], -mu, 1e-11);
        check_close(result[IBM_TIP_SCALE], mu / (l * l) * sqrt(u * u + w * w), 1e-11);
    }
    state_free(&f);
    fluid_grid_free(g);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(linear_fields), cmocka_unit_test(carried_to_the_wall)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
