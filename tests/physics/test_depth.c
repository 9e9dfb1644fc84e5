/* The depth by the number of neighbours: exact for faces along the lattice, and close to it for planes of any direction
 * and for spheres. */
#include "physics/depth.h"

#include <math.h>
#include <stdlib.h>
#include "tests/check.h"

/* Whether a site is in a body: of a plane dot(n, x) <= offset if curvature is 0, of a ball or a cavity of that mean
 * curvature that touches the plane. */
struct face {
    double n[3], depth, curvature;
};

static int is_in(const struct face *f, const double x[3]) {
    double along = 0, r2 = 0;
    for (int c = 0; c < 3; c++) along += f->n[c] * x[c], r2 += x[c] * x[c];
    const double t = f->depth - along; /* depth below the plane; across: r2 - along^2 */
    if (f->curvature == 0) return t >= -1e-9;
    const double a = 1 / f->curvature, from = a - t; /* along the normal, from the centre of the ball */
    const double distance = sqrt(from * from + r2 - along * along);
    return a > 0 ? distance <= a + 1e-9 : distance >= -a - 1e-9;
}

static double estimate(const struct face *f, int reach2) {
    int present = 0;
    for (int k = -3; k <= 3; k++)
        for (int j = -3; j <= 3; j++)
            for (int i = -3; i <= 3; i++) {
                const double x[3] = {i, j, k};
                if (is_in(f, x)) present += physics_depth_weight(i * i + j * j + k * k, reach2);
            }
    return physics_depth(present, reach2);
}

static void along_the_lattice(void **state) {
    (void)state;
    for (int axis = 0; axis < 6; axis++) {
        struct face f = {.depth = 0.5};
        f.n[axis / 2] = axis % 2 ? -1 : 1;
        for (int reach2 = 2; reach2 <= 4; reach2++) {
            f.depth = 0.5;
            check_close(estimate(&f, reach2), 0.5, 1e-12);
            f.depth = 0.1; /* the lattice holds no more than half a spacing */
            check_close(estimate(&f, reach2), 0.5, 1e-12);
        }
    }
}

static double uniform(void) { return rand() / (RAND_MAX + 1.0); }

/* Mean and standard deviation of the error at sites with one of six neighbours outside. */
static void study(double curvature, int reach2, double error[2]) {
    int n = 0;
    error[0] = error[1] = 0;
    srand(3);
    while (n < 5000) {
        struct face f = {.curvature = curvature, .depth = uniform()};
        double r2 = 0;
        for (int c = 0; c < 3; c++) f.n[c] = 2 * uniform() - 1, r2 += f.n[c] * f.n[c];
        if (r2 > 1 || r2 < 1e-2) continue;
        int inside = 0;
        for (int c = 0; c < 3; c++) f.n[c] /= sqrt(r2);
        for (int c = 0; c < 6; c++) {
            double x[3] = {0, 0, 0};
            x[c / 2] = c % 2 ? -1 : 1;
            inside += is_in(&f, x);
        }
        if (inside == 6) continue;
        const double e = estimate(&f, reach2) - f.depth;
        error[0] += e, error[1] += e * e;
        n++;
    }
    error[0] /= n;
    error[1] = sqrt(error[1] / n - error[0] * error[0]);
}

/* Half a spacing for all has a standard deviation of 0.25 to 0.27 there. */
static void any_direction(void **state) {
    (void)state;
    static const double radius[6] = {INFINITY, 20, 10, 6, -10, -6};
    for (int n = 0; n < 6; n++) {
        double error[2];
        study(1 / radius[n], 4, error);
        print_message("radius %4g: error %+.3f, standard deviation %.3f\n", radius[n], error[0], error[1]);
        check_below(error[1], 0.12);
        check_close(error[0], -0.017 - 0.6 / radius[n], 0.02);
        for (int reach2 = 2; reach2 < 4; reach2++) {
            study(1 / radius[n], reach2, error);
            print_message("             R^2 = %d: error %+.3f, standard deviation %.3f\n", reach2, error[0], error[1]);
            check_below(error[1], reach2 == 2 ? 0.145 : 0.12);
            check_close(error[0], reach2 == 2 ? -0.06 - 0.35 / radius[n] : -0.03 - 0.5 / radius[n], 0.02);
        }
    }
}

static void limits(void **state) {
    (void)state;
    check_close(physics_depth(25, 4), 0, 0);  /* a site alone */
    check_close(physics_depth(267, 4), 1, 0); /* all sites */
    check_close(physics_depth_weight(0, 4), 25, 0);
    check_close(physics_depth_weight(4, 4), 1, 0);
    check_close(physics_depth_weight(5, 4), 0, 0);
    check_close(physics_depth_weight(9, 4), 0, 0);
    int all = 0;
    for (int k = -2; k <= 2; k++)
        for (int j = -2; j <= 2; j++)
            for (int i = -2; i <= 2; i++) all += physics_depth_weight(i * i + j * j + k * k, 4);
    check_close(all, 267, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(along_the_lattice),
        cmocka_unit_test(any_direction),
        cmocka_unit_test(limits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
