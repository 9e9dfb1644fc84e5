/* The nonlocal boundary-value problem: exact discrete errors of lattices, condition numbers, a matrix by brute force.
 */
#include "meshless/nonlocal/nonlocal.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "meshless/nonlocal/condition.h"
#include "tests/check.h"

#include <stdio.h>

static jmp_buf back;
static char said[512];

/* Instead of die (see CMakeLists.txt): keeps the sentence. */
_Noreturn void __wrap_die(enum exit_code code, const char *format, ...);
_Noreturn void __wrap_die(enum exit_code code, const char *format, ...) {
    va_list args;
    va_start(args, format);
    vsnprintf(said, sizeof said, format, args);
    va_end(args);
    longjmp(back, (int)code);
}

/* A lattice of delta / m, R = r + delta, r = 1. */
static struct meshless_nonlocal *solved(int dimension, double exponent, double horizon, int m) {
    struct meshless_nonlocal *n =
        meshless_nonlocal_new(&(struct meshless_nonlocal_input){.dimension = dimension,
                                                                .exponent = exponent,
                                                                .horizon = horizon,
                                                                .inner = 1,
                                                                .outer = 1 + horizon,
                                                                .points.spacing = horizon / m});
    meshless_nonlocal_assemble(n);
    meshless_nonlocal_solve(n);
    meshless_nonlocal_measure(n);
    return n;
}

/* On a line the operator's error is (3m + 1)/(2 m^2), 1/m and 0 for P = 0, 1, 2. The errors of the solution and the
 * condition numbers were computed by an independent program; they are given to six digits. */
static void test_line(void **state) {
    static const struct {
        int m;
        double linf[3], l2[3], condition[3];
    } row[] = {{2, {.541709, .382164, 0}, {.359222, .252615, 0}, {58.5265, 69.7006, 92.2834}},
               {4, {.329928, .224206, 0}, {.217508, .147104, 0}, {67.7672, 103.267, 198.151}},
               {8, {.185157, .123247, 0}, {.121770, .0806111, 0}, {74.3355, 138.308, 410.475}},
               {16, {.0986007, .0649274, 0}, {.0647762, .0424087, 0}, {78.2846, 172.986, 834.785}}};
    (void)state;
    for (size_t k = 0; k < sizeof row / sizeof *row; k++)
        for (int P = 0; P < 3; P++) {
            const double m = row[k].m, exact[3] = {(3 * m + 1) / (2 * m * m), 1 / m, 0};
            struct meshless_nonlocal *n = solved(1, P, 0.2, row[k].m);
            check_equal(n->points->n, 12 * row[k].m);
            check_close(n->operator_mean, exact[P], 1e-12);
            check_close(fabs(n->operator_max), exact[P], 1e-11); /* round-off of differences of u over |xi|^2 */
            check_close(n->error_linf, row[k].linf[P], P == 2 ? 1e-14 * m : 6e-7);
            check_close(n->error_l2, row[k].l2[P], P == 2 ? 1e-14 * m : 6e-7);
            check_relative(meshless_condition(n->matrix), row[k].condition[P], 6e-6);
            meshless_nonlocal_free(n);
        }
}

/* Kernels of fractional Laplacians, P = 1 + 2 s, and others between the whole numbers: on a line the operator's error
 * is (3 - P) sum k^(2 - P) / m^(3 - P) - 1, k = 1 ... m. */
static void test_any_exponent(void **state) {
    static const double exponent[] = {0.5, 1.2, 1.5, 2.2, 2.5, 2.8};
    (void)state;
    for (size_t k = 0; k < sizeof exponent / sizeof *exponent; k++) {
        const double P = exponent[k];
        const int m = 5;
        double exact = 0;
        for (int j = 1; j <= m; j++) exact += (3 - P) * pow(j, 2 - P) / pow(m, 3 - P);
        struct meshless_nonlocal *n = solved(1, P, 0.2, m);
        check_close(n->operator_mean, exact - 1, 1e-11);
        check_close(fabs(n->operator_max), fabs(exact - 1), 1e-10);
        meshless_nonlocal_free(n);
    }
}

/* Errors on tensor grids in a disc and a sphere, by an independent program: operator, largest, relative root mean
 * square (0: not given). They do not fall with every m. */
static void test_grids(void **state) {
    static const struct {
        int dimension, exponent, m, points;
        double operator_error, linf, l2;
    } row[] = {{2, 0, 2, 316, .107595, .115194, .066152},
               {2, 0, 3, 716, .0552452, .0593088, .0333191},
               {2, 0, 4, 1264, -.0506329, .0613484, .0345659},
               {2, 1, 2, 316, .0476773, .0534738, .0305654},
               {2, 1, 3, 716, .0275682, .0300623, .0167932},
               {2, 1, 4, 1264, -.0432031, .0513685, .0287768},
               {2, 2, 2, 316, -.0506329, .0620992, .0353327},
               {2, 2, 3, 716, -.0223464, .0252697, .0140193},
               {2, 2, 4, 1264, -.0506329, .0597785, .0332336},
               {3, 0, 2, 912, -.0378289, .0500615, 0},
               {3, 0, 3, 3112, .137532, .154801, 0},
               {3, 0, 4, 7208, -.0682228, 0, 0},
               {3, 1, 2, 912, -.0363098, .0474635, 0},
               {3, 1, 3, 3112, .0998258, .114663, 0},
               {3, 1, 4, 7208, -.0528515, 0, 0},
               {3, 2, 2, 912, -.0526316, .0691492, 0},
               {3, 2, 3, 3112, .0584833, .0685686, 0},
               {3, 2, 4, 7208, -.0410655, 0, 0}};
    (void)state;
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        struct meshless_nonlocal *n =
            solved(row[k].dimension, row[k].exponent, row[k].dimension == 2 ? 0.25 : 0.5, row[k].m);
        check_equal(n->points->n, row[k].points);
        check_close(n->operator_mean, row[k].operator_error, 6e-7);
        if (row[k].linf > 0) check_close(n->error_linf, row[k].linf, 6e-7);
        if (row[k].l2 > 0) check_close(n->error_l2, row[k].l2, 6e-7);
        meshless_nonlocal_free(n);
    }
}

/* On centroidal points with cells' volumes: the rows against a double loop, and symmetry. */
static void test_matrix(void **state) {
    (void)state;
    const struct meshless_nonlocal_input in = {
        .dimension = 2,
        .exponent = 1,
        .horizon = 0.5,
        .inner = 1,
        .outer = 1.5,
        .points = {.kind = MESHLESS_CENTROIDAL, .volume = MESHLESS_CELL, .spacing = 0.2, .seed = 5}};
    struct meshless_nonlocal *n = meshless_nonlocal_new(&in);
    meshless_nonlocal_assemble(n);
    const struct meshless_points *p = n->points;
    struct meshless_matrix *a = n->matrix;
    double *x = memory_new(MEMORY_SOLID, (size_t)(a->rows + a->ghosts) + 1, sizeof *x),
           *y = memory_new(MEMORY_SOLID, (size_t)a->rows + 1, sizeof *y), worst = 0;
    for (int i = 0; i < a->rows; i++) x[i] = sin(3 * p->x[0][a->point[i]]) + p->x[1][a->point[i]];
    meshless_matrix_times(a, x, y);
    for (int r = 0; r < a->rows; r++) {
        const long i = a->point[r];
        double sum = 0, given = 0;
        for (long j = 0; j < p->n; j++) {
            const double d = hypot(p->x[0][j] - p->x[0][i], p->x[1][j] - p->x[1][i]);
            if (j == i || d > in.horizon) continue;
            const double k = p->volume[i] * p->volume[j] / d;
            sum += k * x[r];
            if (n->free[j])
                sum -= k * (sin(3 * p->x[0][j]) + p->x[1][j]);
            else
                given += k;
        }
        double ours = 0;
        for (long k = a->given_start[r]; k < a->given_start[r + 1]; k++) ours += a->given_value[k];
        worst = check_worst(worst, sum - y[r]);
        worst = check_worst(worst, given - ours);
    }
    check_at_most(worst, 1e-15); /* sums of some 20 numbers of 1e-3 */
    meshless_nonlocal_solve(n);
    meshless_nonlocal_measure(n);
    check_between(n->error_l2, 1e-4, 0.1);
    check_below(n->solved.residual, 1e-13);
    memory_free(y);
    memory_free(x);
    meshless_nonlocal_free(n);
}

static void test_condition(void **state) {
    (void)state;
    for (int P = 0; P < 3; P += 2) {
        struct meshless_nonlocal *n = solved(2, P, 0.25, 3);
        const double dense = meshless_condition_dense(n->matrix);
        check_above(dense, 10);
        check_relative(meshless_condition_lanczos(n->matrix), dense, 1e-8);
        meshless_nonlocal_free(n);
    }
}

/* Three points on a line: two of them at one place, or one beyond the horizon. One rank: die ends all of them. */
static void test_badly_posed(void **state) {
    double place[2][3] = {{0, 0.1, 0.1}, {0, 0.1, 0.4}}, volume[] = {0.1, 0.1, 0.1};
    const char all[] = {1, 1, 1}, *const sentence[] = {"coincide at (0.1, 0, 0)",
                                                       "has no neighbour within the horizon 0.25 m"};
    (void)state;
    for (int k = 0; k < 2 && par_size() == 1; k++) {
        const struct meshless_points p = {.dim = 1, .n = 3, .spacing = 0.1, .x = {place[k]}, .volume = volume};
        said[0] = '\0';
        const int code = setjmp(back);
        if (code == 0)
            meshless_matrix_new(
                &(struct meshless_matrix_input){.points = &p, .exponent = 1, .horizon = 0.25, .free = all});
        check_equal(code, EXIT_CODE_SCENE);
        if (!strstr(said, sentence[k])) fail_msg("not \"%s\": %s", sentence[k], said);
    }
}

/* b is the operator's integral: by the midpoint rule over the radius. */
static void test_load(void **state) {
    (void)state;
    for (int d = 1; d < 4; d++)
        for (int P = 0; P < 3; P++) {
            const double horizon = 0.7, area = d == 1 ? 2 : d == 2 ? 2 * M_PI : 4 * M_PI;
            double sum = 0;
            for (int k = 0; k < 10000; k++) {
                const double s = (k + 0.5) * horizon / 10000;
                sum += area * pow(s, d - 1) * s * s / pow(s, P) * horizon / 10000; /* the linear part cancels */
            }
            check_relative(meshless_nonlocal_load(d, P, horizon), sum, 1e-7);
        }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_line),        cmocka_unit_test(test_grids),
                                       cmocka_unit_test(test_matrix),      cmocka_unit_test(test_condition),
                                       cmocka_unit_test(test_load),        cmocka_unit_test(test_badly_posed),
                                       cmocka_unit_test(test_any_exponent)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
