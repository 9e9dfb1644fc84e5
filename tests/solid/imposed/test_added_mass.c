/* Added mass of one face and of two opposite faces, and the energy that goes into it. */
#include "base/par.h"
#include "solid/imposed/added_mass.h"
#include "solid/force/force.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>

enum { DENSITY = 3000 };

/* One particle, of 1 mm, without bonds. */
static struct solid *particle_new(void) {
    const struct solid_material material = {1e8, DENSITY, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};
    const struct solid_body body = {.name = "one", .shape = SOLID_BOX, .high = {1e-3, 1e-3, 1e-3}};
    const struct solid_input in = {.spacing = 1e-3, .bodies = 1, .body = &body, .materials = 1, .material = &material};
    return solid_new(&in);
}

/* Along the faces' normal the acceleration is rho a/(rho + all the faces' m), across it as before. */
static void test_faces(void **state) {
    (void)state;
    const int particle[2] = {0, 0};
    const double s = 1 / sqrt(3.), opposite[2] = {s, -s}, density[2] = {700, 1500};
    for (int faces = 1; faces <= 2; faces++) {
        struct solid *one = particle_new();
        double lost[2] = {0}, before[2], from[2];
        const struct solid_added_mass added = {faces,  particle, {opposite, opposite, opposite}, density, lost,
                                               before, from};
        one->added = &added;
        for (int c = 0; c < 3; c++) one->load[c][0] = (c == 0) * 1e5;
        solid_force(one, 0);
        const double free_a = 1e5 / DENSITY, carried = density[0] + (faces == 2 ? density[1] : 0);
        const double along = free_a * s * DENSITY / (DENSITY + carried);
        double dot = 0;
        for (int c = 0; c < 3; c++) dot += one->a[c][0] * s;
        check_close(dot, along, 1e-14 * free_a);
        for (int c = 0; c < 3; c++) {
            const double across = (c == 0) * free_a - free_a * s * s;
            check_close(one->a[c][0] - dot * s - across, 0, 1e-14 * free_a);
        }
        solid_free(one);
    }
}

/* The work of the load, less that of the added mass, is the particle's own kinetic energy, with either integrator. */
static void test_energy(void **state) {
    (void)state;
    for (int verlet = 0; verlet < 2; verlet++) {
        const int particle = 0;
        const double one_way = 1, none = 0, density = 1200;
        struct solid *one = particle_new();
        double lost = 0, before, from;
        const struct solid_added_mass added = {1, &particle, {&one_way, &none, &none}, &density, &lost, &before, &from};
        one->added = &added;
        one->stage.integrator = verlet ? SOLID_VERLET : SOLID_RK3;
        for (int c = 0; c < 3; c++) one->load[c][0] = 2e4 * (c + 1);
        solid_integrate(one, 1e-3, 50);
        double kinetic = 0;
        for (int c = 0; c < 3; c++) kinetic += 0.5 * DENSITY * one->volume[0] * pow(one->v[c][0], 2);
        check_close(one->v[0][0], 0.05 * 2e4 / (DENSITY + density), 1e-12);
        check_close(one->v[1][0], 0.05 * 4e4 / DENSITY, 1e-12);
        check_relative(one->work_load, kinetic, 1e-12);
        solid_free(one);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_faces), cmocka_unit_test(test_energy)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
