/* Limits of the stretch that follow the other bonds: small clusters against brute force over all pairs. */
#include "base/par.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/measure/events.h"
#include "solid/solid.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

static const double SPACING = 1e-3, YOUNG = 1e9, DENSITY = 2000;
static const struct solid_limit LIMIT = {2e-3, 0.25, 7.5};
enum { SITES = 6, KINDS = 4, SWEEPS = 5, MOST = SITES * SITES * SITES };

/* Block in the lattice store, in lists, with the ramp that is cut, and a plate. */
static struct solid *make(int kind) {
    const double size = SITES * SPACING;
    const double corner[4][2] = {{0, 0}, {size, 0}, {size, size}, {0, size}};
    const signed char turn[4] = {0};
    const struct solid_outline outline = {0, 4, corner, corner, turn};
    const struct solid_material material = {YOUNG, DENSITY, INFINITY, 2.2, PHYSICS_CONSTANT, 0, 0};
    struct solid_body body = {.name = "block", .shape = SOLID_BOX, .high = {size, size, size}};
    if (kind == 3)
        body = (struct solid_body){.name = "plate", .shape = SOLID_POLYGON, .outlines = 1, .outline = &outline};
    const struct solid_input in = {.model = kind == 3 ? PHYSICS_PLANE_STRESS : PHYSICS_3D,
                                   .thickness = SPACING,
                                   .spacing = SPACING,
                                   .partial = kind == 2 ? SOLID_PARTIAL_RAMP_CUT : SOLID_PARTIAL_EXACT,
                                   .general_bonds = kind == 1,
                                   .bodies = 1,
                                   .body = &body,
                                   .materials = 1,
                                   .material = &material,
                                   .limit = &LIMIT};
    return solid_new(&in);
}

/* In [-1, 1), by the global number of the particle. */
static double noise(long id, int c, int sweep) {
    uint64_t z = (uint64_t)(id * 3 + c) * 0x9e3779b97f4a7c15u + (uint64_t)(sweep + 1) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    z ^= z >> 31;
    return (double)(z >> 11) * 0x1p-52 - 1;
}

/* The same cluster without any code of solid/: its bonds as matrix, positions and displacements of all particles. */
struct brute {
    long n;
    int dim;
    double x0[MOST][3], d[MOST][3], limit[MOST];
    uint8_t bond[MOST][MOST];
};

/* Values by global number on every rank: sums of arrays that are 0 elsewhere. */
static struct brute *brute_new(const struct solid *s) {
    struct brute *b = calloc(1, sizeof *b);
    struct solid_family_view view;
    double *row = calloc(MOST, sizeof *row);
    assert_non_null(b);
    assert_non_null(row);
    b->n = s->n_global;
    b->dim = s->dim;
    const long first = s->first[par_rank()];
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < s->dim; c++) b->x0[first + h][c] = s->x0[c][h];
    par_sum_array(&b->x0[0][0], 3 * MOST);
    for (long k = 0; k < b->n; k++) {
        memset(row, 0, MOST * sizeof *row);
        if (k >= first && k < first + s->n) {
            solid_family_view(s, (int)(k - first), &view);
            for (int i = 0; i < view.n; i++)
                for (long l = 0; l < b->n; l++) {
                    double far = 0;
                    for (int c = 0; c < s->dim; c++) far = fmax(far, fabs(b->x0[l][c] - b->x0[k][c] - view.xi[i][c]));
                    if (far < 1e-6 * SPACING) row[l] = 1;
                }
        }
        par_sum_array(row, MOST);
        for (long l = 0; l < b->n; l++) b->bond[k][l] = row[l] > 0;
        b->limit[k] = INFINITY;
    }
    free(row);
    return b;
}

/* Returns how many bonds break. */
static long brute_sweep(struct brute *b) {
    double *next = calloc(MOST, sizeof *next);
    long broken = 0;
    assert_non_null(next);
    for (long k = 0; k < b->n; k++) {
        double least = INFINITY;
        for (long l = 0; l < b->n; l++) {
            if (!b->bond[k][l]) continue;
            double r2 = 0, r02 = 0;
            for (int c = 0; c < b->dim; c++) {
                const double xi = b->x0[l][c] - b->x0[k][c], now = xi + b->d[l][c] - b->d[k][c];
                r02 += xi * xi;
                r2 += now * now;
            }
            const double stretch = (sqrt(r2) - sqrt(r02)) / sqrt(r02);
            least = fmin(least, stretch);
            if (stretch > fmin(b->limit[k], b->limit[l])) b->bond[k][l] = 2;
        }
        next[k] = least < INFINITY ? LIMIT.s00 - LIMIT.alpha * least : INFINITY;
    }
    for (long k = 0; k < b->n; k++) {
        b->limit[k] = next[k];
        for (long l = 0; l < b->n; l++)
            if (b->bond[k][l] == 2) {
                assert_true(b->bond[l][k] != 1); /* both ends agree */
                b->bond[k][l] = 0;
                b->bond[l][k] = 0;
                broken++;
            }
    }
    free(next);
    return broken;
}

static long intact_of(const struct brute *b, long k) {
    long n = 0;
    for (long l = 0; l < b->n; l++) n += b->bond[k][l];
    return n;
}

/* Strains grow from sweep to sweep, so that some bonds break in each but the first, whose limits are infinite. The
 * forces of a sweep contain the bonds that break in it. */
static void test_cluster(void **state) {
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        struct solid *s = make(kind);
        struct brute *b = brute_new(s);
        const long first = s->first[par_rank()];
        long broken = 0;
        for (int sweep = 0; sweep < SWEEPS; sweep++) {
            for (long k = 0; k < b->n; k++)
                for (int c = 0; c < s->dim; c++) b->d[k][c] = 1.5e-3 * SPACING * (1 + 0.3 * sweep) * noise(k, c, sweep);
            for (int h = 0; h < s->n; h++)
                for (int c = 0; c < s->dim; c++) s->d[c][h] = b->d[first + h][c];
            solid_ghosts_update(s);
            const long before = s->bonds_broken;
            double *a = calloc((size_t)s->n + 1, sizeof *a);
            assert_non_null(a);
            solid_force_bonds(s, 0, 0);
            memcpy(a, s->a[0], (size_t)s->n * sizeof *a);
            solid_force_bonds(s, 1, 0);
            for (int h = 0; h < s->n; h++) assert_true(a[h] == s->a[0][h]);
            free(a);
            const long more = brute_sweep(b);
            broken += more;
            solid_family_count(s);
            assert_int_equal(s->bonds_broken - before, more);
            if (sweep == 0) assert_int_equal(more, 0);
            for (int h = 0; h < s->n; h++) {
                struct solid_family_view view;
                long intact = 0;
                solid_family_view(s, h, &view);
                for (int i = 0; i < view.n; i++) intact += view.intact[i];
                assert_int_equal(intact, intact_of(b, first + h));
                if (intact > 0) check_close(s->stretch_limit[h], b->limit[first + h], 1e-12);
            }
        }
        check_above((double)broken, 20);
        assert_true(s->bonds_broken < s->bonds_total);
        free(b);
        solid_free(s);
    }
}

/* Without alpha the limit is constant. A pair at rest, then pulled beyond it: the first sweep sets the limits, and
 * its break adds the bond's energy to e_fracture and, at s00, the area by the fracture energy to crack_area. */
static void test_energy_and_area(void **state) {
    (void)state;
    if (par_size() > 1) skip();
    const struct solid_limit constant = {2e-3, 0, 7.5};
    const struct solid_material material = {YOUNG, DENSITY, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};
    const struct solid_body body = {.shape = SOLID_BOX, .high = {2 * SPACING, SPACING, SPACING}};
    for (int list = 0; list < 2; list++) {
        const struct solid_input in = {.spacing = SPACING,
                                       .bodies = 1,
                                       .body = &body,
                                       .materials = 1,
                                       .material = &material,
                                       .general_bonds = list,
                                       .limit = &constant};
        struct solid *s = solid_new(&in);
        solid_breaks_begin(s);
        solid_force(s, 1);
        s->d[0][1] = 1.9e-3 * SPACING;
        solid_force(s, 1);
        solid_family_count(s);
        assert_int_equal(s->bonds_broken, 0);
        s->d[0][1] = 2.2e-3 * SPACING;
        solid_force(s, 1);
        solid_family_count(s);
        assert_int_equal(s->bonds_broken, 1);
        const double force = DENSITY * s->volume[0] * s->a[0][0], energy = 0.5 * force * 2.2e-3 * SPACING;
        assert_true(force > 0);
        check_relative(s->e_fracture, energy, 1e-9);
        check_relative(s->crack_area, energy / (1.1 * 1.1) / constant.fracture_energy, 1e-9);
        struct solid_break *bond;
        assert_int_equal(solid_events_take(s, &bond), 1);
        check_relative(bond->energy, s->e_fracture, 1e-14);
        check_relative(bond->area, s->crack_area, 1e-14);
        check_relative(bond->xi[0], SPACING, 1e-14);
        check_close(bond->x[0], 0.5 * SPACING, 1e-12 * SPACING);
        free(bond);
        solid_force(s, 1);
        check_equal(s->a[0][0], 0);
        assert_true(isinf(s->stretch_limit[0]));
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_cluster), cmocka_unit_test(test_energy_and_area)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
