/* Fields of a creeping flow through a slit: the velocity's parabola, the pressure's gradient, and the solid. */
#include "program/permeability/fields.h"
#include "base/files/folder.h"
#include "base/files/vtkhdf.h"
#include "stokes/solve.h"
#include "tests/check.h"
#include "tests/stokes/make.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

enum { WIDE = 5, LOW = 1 };
static int in_slit(const int at[3], const void *with) {
    (void)with;
    return at[1] >= LOW && at[1] < LOW + WIDE;
}

/* Twice the velocity at the middle of cell j of the slit for the gradient and the viscosity 1: that of walls half a
 * cell from the outermost velocities, f d^2 (q (n - q) + 1/4) with q = j + 1/2. */
static double twice_velocity(int j, double d) {
    const double q = j + 0.5;
    return d * d * (q * (WIDE - q) + 0.25);
}

/* Along one axis, with the sides along it. */
static void check_slit(int axis, enum stokes_side ends) {
    char out[] = "/tmp/frana_test_fieldsXXXXXX", path[FOLDER_PATH], name[32];
    const int n[3] = {6, 8, 7};
    struct stokes_input in = {.d = {0.5, 0.25, 0.5}, .tolerance = 1e-13};
    for (int c = 0; c < 3; c++) in.side[c][0] = in.side[c][1] = c == axis ? ends : STOKES_SIDE_PERIODIC;
    struct stokes *s = make_stokes(n, in_slit, NULL, &in);
    struct scene_fluid fluid = {.density = 1000, .viscosity = 1e-6};
    const struct scene scene = {.fluid = &fluid};
    const double gradient = 20, mu = 1e-3;
    if (par_rank() == 0) assert_non_null(mkdtemp(out));
    par_bcast(out, sizeof out, 0);
    stokes_solve(s, axis);
    permeability_fields_begin(out);
    permeability_fields_write(out, &scene, s, axis, gradient);
    stokes_free(s);
    snprintf(name, sizeof name, "fields/flow_%c.hdf", "xyz"[axis]);
    struct vtkhdf_source *f = vtkhdf_read_open(folder_path(path, out, name), NULL);
    assert_non_null(f);
    double *u = vtkhdf_read_double(f, "velocity"), *p = vtkhdf_read_double(f, "pressure"),
           *solid = vtkhdf_read_double(f, "solid_fraction");
    for (int c = 0; c < 3; c++) {
        check_equal(f->n[c], n[c]);
        check_close(f->origin[c], 0.5 * in.d[c], 1e-15);
        check_close(f->spacing[c], in.d[c], 1e-15);
    }
    /* between periodic sides the pressure's level is free */
    const int first = LOW * n[0], place[3] = {0, LOW, 0};
    const double level = ends == STOKES_SIDE_PERIODIC ? p[first] + gradient * (place[axis] + 0.5) * in.d[axis] : 0;
    check_close(level, 0, 1e-3 * gradient);
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++) {
                const int at[3] = {i, j, k}, cell = (k * n[1] + j) * n[0] + i, is_pore = in_slit(at, NULL);
                const double speed = is_pore ? 0.5 * twice_velocity(j - LOW, in.d[1]) * gradient / mu : 0;
                check_equal(solid[cell], !is_pore);
                for (int c = 0; c < 3; c++) check_close(u[3 * cell + c], c == axis ? speed : 0, 1e-6 * gradient / mu);
                if (is_pore) check_close(p[cell], level - gradient * (at[axis] + 0.5) * in.d[axis], 1e-5 * gradient);
                if (!is_pore) check_equal(isnan(p[cell]), 1);
            }
    free(u);
    free(p);
    free(solid);
    vtkhdf_read_close(f);
    par_barrier();
    par_barrier();
    if (par_rank() != 0) return;
    unlink(path);
    rmdir(folder_path(path, out, "fields"));
    rmdir(folder_path(path, out, "pictures"));
    check_equal(rmdir(out), 0);
}

static void test_between_periodic_sides(void **state) {
    (void)state;
    check_slit(0, STOKES_SIDE_PERIODIC);
    check_slit(2, STOKES_SIDE_PERIODIC);
}

static void test_between_pressures(void **state) {
    (void)state;
    check_slit(0, STOKES_SIDE_PRESSURE);
    check_slit(2, STOKES_SIDE_PRESSURE);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_between_periodic_sides),
                                       cmocka_unit_test(test_between_pressures)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
