/* Bond lists: the sweep against single bonds, both ends of a bond, memory. */
#include "base/par_ghost.h"
#include "tests/solid/make.h"

#include "base/memory.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/law/material.h"
#include "solid/solid.h"
#include "tests/check.h"

#include <stdlib.h>

enum { NX = 9, NY = 8, NZ = 10, POINTS = NX * NY * NZ };

/* A block of points moved from a lattice by up to a fifth of the spacing, of unequal volumes, periodic along z and,
 * where asked, far from the origin. */
static struct solid *cloud_new(double away) {
    static double x[3][POINTS], volume[POINTS];
    srand(11);
    for (int p = 0; p < POINTS; p++) {
        const int site[3] = {p % NX, p / NX % NY, p / NX / NY};
        for (int c = 0; c < 3; c++)
            x[c][p] = (site[c] + 0.5 + 0.2 * (2. * rand() / RAND_MAX - 1) + (c == 0 ? away : 0)) * SPACING;
        volume[p] = pow(SPACING, 3) * (1 + 0.2 * (2. * rand() / RAND_MAX - 1));
    }
    const struct solid_body body = {
        .name = "cloud", .shape = SOLID_POINTS, .points = POINTS, .point = {x[0], x[1], x[2]}, .point_volume = volume};
    const struct solid_material material = {YOUNG, DENSITY, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
    const struct solid_input in = {.spacing = SPACING,
                                   .bodies = 1,
                                   .body = &body,
                                   .materials = 1,
                                   .material = &material,
                                   .surface_correction = 1,
                                   .periodic = {0, 0, 1},
                                   .length = {(NX + away) * SPACING, NY * SPACING, NZ * SPACING}};
    return solid_new(&in);
}

static void shake(struct solid *s, double size) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            s->d[c][h] = size * SPACING * noise(s, h, c);
            s->v[c][h] = 0.1 * noise(s, h, 3 + c);
        }
    solid_ghosts_update(s);
}

/* The acceleration of particle h from its bonds, with square roots and divisions  (001: eqs 3.20, 3.39). */
static void by_hand(const struct solid *s, int h, double damping, double a[3], double *power) {
    static struct solid_family_view view;
    const double c0 = solid_material_micromodulus(s->in.material, s->in.spacing);
    solid_family_view(s, h, &view);
    a[0] = a[1] = a[2] = *power = 0;
    for (int b = 0; b < view.n; b++) {
        if (!view.intact[b]) continue;
        double zeta[3], xi2 = 0, zeta2 = 0, closing = 0;
        for (int c = 0; c < 3; c++) {
            zeta[c] = view.xi[b][c] + (s->d[c][view.l[b]] - s->d[c][h]);
            xi2 += view.xi[b][c] * view.xi[b][c];
            zeta2 += zeta[c] * zeta[c];
            closing += (s->v[c][view.l[b]] - s->v[c][h]) * zeta[c];
        }
        const double stretch = sqrt(zeta2 / xi2) - 1;
        const double f = c0 * view.alpha[b] * stretch / sqrt(zeta2) + damping * closing / zeta2;
        for (int c = 0; c < 3; c++) a[c] += f * view.weight[b] * zeta[c] / DENSITY;
        *power += damping * view.weight[b] * closing * closing / zeta2;
    }
}

/* Small and large stretches, with and without damping, with bonds broken here and there. zeta^2 by hand loses digits to
 * cancellation, 1e-16 of a bond's length in 1e-4 of it. */
static void test_by_hand(void **state) {
    (void)state;
    const double size[2] = {1e-4, 2e-2}, damping[2] = {0, 1e11}, tolerance[2] = {1e-11, 1e-12};
    struct solid *s = cloud_new(0);
    s->stage.breakage = 0;
    for (int cut = 0; cut < 2; cut++) {
        for (int h = 0; cut && h < s->n; h++)
            if (noise(s, h, 9) > 0)
                for (int b = 0; b < 20; b += 3) solid_family_break(s, h, b);
        for (int large = 0; large < 2; large++)
            for (int damped = 0; damped < 2; damped++) {
                s->stage.damping_relative = damping[damped];
                shake(s, size[large]);
                solid_force(s, 0);
                double most[2] = {0}, power = 0;
                for (int h = 0; h < s->n; h++) {
                    double a[3], w;
                    by_hand(s, h, damping[damped], a, &w);
                    power += 0.5 * w * s->volume[h];
                    for (int c = 0; c < 3; c++) {
                        most[0] = fmax(most[0], fabs(a[c]));
                        most[1] = check_worst(most[1], a[c] - s->a[c][h]);
                    }
                }
                par_max_array(most, 2);
                check_above(most[0], 100);
                check_close(most[1] / most[0], 0, tolerance[large]);
                check_close(s->power_damped, power, 1e-12 * power);
                assert_true((power > 0) == damped || s->n == 0);
            }
    }
    solid_free(s);
}

/* Each bond breaks from both its ends at once, across ranks and the periodic side, near the origin and far from it:
 * both ends count the same. */
static void test_both_ends(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int far = 0; far < 2; far++) {
        struct solid *s = cloud_new(far ? 1000 : 0);
        const size_t all = (size_t)(s->n + s->n_ghost) + 1;
        double *id = memory_new(MEMORY_SOLID, all, sizeof *id);
        for (int h = 0; h < s->n; h++) id[h] = (double)(s->first[par_rank()] + h);
        par_ghost_update(s->ghost, 1, &id, s->n);
        shake(s, 8e-4);
        solid_force(s, 1);
        solid_family_count(s);
        check_between(s->bonds_broken, 50, s->bonds_total / 2);
        long broken = 0, odd = 0;
        uint64_t turned = 0; /* sum of xi in its last digits; modulo 2^40 */
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                const long i = lrint(id[h]), l = lrint(id[view.l[b]]), low = i < l ? i : l, high = i + l - low;
                for (int c = 0; c < 3; c++) turned += (uint64_t)(c + 1) * (uint64_t)llrint(view.xi[b][c] * 0x1p58);
                if (view.intact[b]) continue;
                broken++;
                odd += (i < l ? 1 : -1) * ((low * 7919 + high * high * 31) % 10007);
            }
        }
        assert_int_equal(par_sum_long(broken), 2 * s->bonds_broken);
        assert_int_equal(par_sum_long(odd), 0);
        assert_int_equal(par_sum_long((long)(turned & 0xffffffffffu)) & 0xffffffffffu, 0);
        memory_free(id);
        solid_free(s);
    }
}

/* Memory that grows with the bonds: 24 bytes for each directed one, and families padded to multiples of eight. */
static void test_memory(void **state) {
    (void)state;
    const double before = (double)memory_bytes(MEMORY_SOLID);
    struct solid *s = make((struct make){.sites = {24, 24, 24}, .list = 1});
    const double bonds = (double)solid_family_directed(s);
    const double bytes = (double)memory_bytes(MEMORY_SOLID) - before;
    const double particles = (double)(s->n + s->n_ghost) * 45 * sizeof(double);
    check_above(bonds, 100. * s->n);
    check_below(bytes - particles, 24 * (bonds + 7. * s->n));
    if (par_size() == 1) check_below(bytes, 27 * bonds);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_by_hand),
        cmocka_unit_test(test_both_ends),
        cmocka_unit_test(test_memory),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
