/* The bonds' constants from their two ends: sums over lattices, pairs of different horizons, family volumes. */
#include "tests/solid/make.h"

#include "solid/law/pair.h"
#include "solid/law/stencil.h"
#include "solid/law/weight.h"
#include "tests/check.h"

#include <stdlib.h>

static double uniform(double low, double high) { return low + (high - low) * rand() / RAND_MAX; }

struct sums {
    int bonds;
    double c11, c12, nu, w, g; /* over the continuum's */
};

/* C_ijkl = (1/2) sum c xi_i xi_j xi_k xi_l/|xi|^3 Gamma V, and the energy of the bonds across a line x = const, in a
 * full family of one size and horizon.  (000: eqs 9, 16) */
static struct sums sums_of(enum physics_model model, enum solid_partial partial, enum physics_micromodulus kind,
                           double m) {
    const struct solid_material material = {YOUNG, DENSITY, 0.05, m, kind, 0, 0};
    const struct solid_input in = {.model = model, .thickness = 0.7, .spacing = 1, .partial = partial};
    const struct solid_bond_law law = solid_pair_law(&in, &material);
    const struct solid_end end = {1, m, 1};
    const int plate = model != PHYSICS_3D, reach = (int)m + 2;
    const double unit = plate ? 0.7 : 1;
    struct sums sums = {0};
    for (int k = plate ? 0 : -reach; k <= (plate ? 0 : reach); k++)
        for (int j = -reach; j <= reach; j++)
            for (int i = -reach; i <= reach; i++) {
                const double xi[3] = {i, j, k}, length = sqrt(i * i + j * j + k * k);
                if (length == 0 || !solid_pair_exists(&law, xi, &end, &end)) continue;
                const struct solid_pair pair = solid_pair_of(&law, xi, &end, &end);
                const double kv = pair.stiffness * unit, s2 = law.s0 * law.s0;
                sums.bonds++;
                sums.c11 += 0.5 * kv * pow(i, 4) / pow(length, 3);
                sums.c12 += 0.5 * kv * i * i * j * j / pow(length, 3);
                if (i > 0) sums.g += 0.5 * kv * s2 * length * i;
                check_close(pair.eps_limit, law.s0 * (2 + law.s0), 1e-15 * pair.eps_limit);
            }
    sums.nu = sums.c12 / sums.c11;
    const double c11 = YOUNG * (model == PHYSICS_PLANE_STRESS ? 9. / 8 : 1.2),
                 c12 = YOUNG * (model == PHYSICS_PLANE_STRESS ? 3. / 8 : 0.4);
    sums.w = (sums.c11 + sums.c12) / (c11 + c12);
    sums.c11 /= c11;
    sums.c12 /= c12;
    sums.g /= 0.05;
    return sums;
}

/* What correct sums over the square lattice return at m = 3. */
static void test_lattice_sums(void **state) {
    (void)state;
    static const struct sums exact = {44, 1.02200, 0.98967, 0.32279, 1.01392, 1.02801},
                             ramp = {36, 1.03268, 0.98249, 0.31713, 1.02013, 1.03424};
    for (int model = PHYSICS_PLANE_STRESS; model <= PHYSICS_PLANE_STRAIN; model++)
        for (int k = 0; k < 2; k++) {
            const struct sums expected = k ? ramp : exact;
            const struct sums is = sums_of(model, k ? SOLID_PARTIAL_RAMP : SOLID_PARTIAL_EXACT, PHYSICS_CONSTANT, 3);
            assert_int_equal(is.bonds, expected.bonds);
            check_close(is.c11, expected.c11, 1e-5);
            check_close(is.c12, expected.c12, 1e-5);
            if (model == PHYSICS_PLANE_STRESS) check_close(is.nu, expected.nu, 1e-5);
            check_close(is.w, expected.w, 1e-5);
            check_close(is.g, expected.g, 1e-5);
        }
}

/* With more particles in the horizon the constants converge to the continuum's, for each model and micromodulus; at m =
 * 3.5 and 4 they are within a few per cent. */
static void test_fine_sums(void **state) {
    (void)state;
    for (int model = PHYSICS_3D; model <= PHYSICS_PLANE_STRAIN; model++)
        for (int kind = 0; kind < PHYSICS_MICROMODULI; kind++) {
            if (model == PHYSICS_3D && kind == PHYSICS_CONSTANT) continue; /* tests/solid/bonds/test_lattice.c */
            const double m[3] = {3.5, 4, model == PHYSICS_3D ? 8 : 20}, within[3] = {0.08, 0.05, 0.015};
            for (int k = 0; k < 3; k++) {
                const struct sums is =
                    sums_of(model, model == PHYSICS_3D ? SOLID_PARTIAL_RAMP : SOLID_PARTIAL_EXACT, kind, m[k]);
                check_close(is.c11, 1, within[k]);
                check_close(is.w, 1, within[k]);
                check_close(is.g, 1, within[k]);
            }
        }
}

/* Different horizons: both ends get the same numbers to the bit; a half is 0 if its end does not reach the other; a
 * bond releases the energy of its halves. With equal horizons both couplings are the same. */
static void test_pairs(void **state) {
    (void)state;
    srand(17);
    int one_half = 0;
    for (int trial = 0; trial < 20000; trial++) {
        const struct solid_material m = {YOUNG, DENSITY, 0.05, 3, trial & 1 ? PHYSICS_CONICAL : PHYSICS_CONSTANT, 0, 0};
        struct solid_input in = {.model = trial & 2 ? PHYSICS_PLANE_STRESS : PHYSICS_PLANE_STRAIN,
                                 .thickness = 0.1,
                                 .spacing = 1e-3,
                                 .partial = trial & 4 ? SOLID_PARTIAL_RAMP : SOLID_PARTIAL_EXACT};
        const struct solid_bond_law dual = solid_pair_law(&in, &m);
        in.horizons = SOLID_ONE_SIDED;
        const struct solid_bond_law single = solid_pair_law(&in, &m);
        const struct solid_end a = {uniform(0.2, 1), uniform(1, 3.5), uniform(0.1, 1)},
                               b = {uniform(0.2, 1), uniform(1, 3.5), uniform(0.1, 1)};
        const double xi[3] = {uniform(-4, 4), uniform(-4, 4), 0}, back[3] = {-xi[0], -xi[1], 0};
        const int ab = solid_pair_exists(&single, xi, &a, &b), ba = solid_pair_exists(&single, back, &b, &a);
        assert_int_equal(solid_pair_exists(&dual, xi, &a, &b), ab || ba);
        assert_int_equal(solid_pair_exists(&dual, back, &b, &a), ab || ba);
        if (!ab && !ba) continue;
        const struct solid_pair there = solid_pair_of(&dual, xi, &a, &b), here = solid_pair_of(&dual, back, &b, &a);
        check_equal(there.stiffness, here.stiffness);
        check_equal(there.eps_limit, here.eps_limit);
        const struct solid_pair half[2] = {solid_pair_of(&single, xi, &a, &b), solid_pair_of(&single, back, &b, &a)};
        check_close(there.stiffness, 0.5 * (half[0].stiffness + half[1].stiffness), 1e-15 * there.stiffness);
        double energy = 0;
        for (int k = 0; k < 2; k++) energy += 0.5 * half[k].stiffness * pow(sqrt(1 + half[k].eps_limit) - 1, 2);
        check_close(there.stiffness * pow(sqrt(1 + there.eps_limit) - 1, 2) / energy, 1, 1e-10);
        one_half += ab != ba;
        const struct solid_end same = {b.size, a.horizon, b.volume};
        const struct solid_end like = {b.size, a.horizon, a.volume};
        if (!solid_pair_exists(&single, xi, &like, &same)) continue;
        check_equal(solid_pair_of(&dual, xi, &like, &same).stiffness,
                    solid_pair_of(&single, xi, &like, &same).stiffness);
        check_close(solid_pair_of(&dual, xi, &like, &same).eps_limit /
                        solid_pair_of(&single, xi, &like, &same).eps_limit,
                    1, 0);
    }
    check_above(one_half, 1000);
}

/* Work of a bond on its ends, which are moved along it from one place to the next and back to the first: u[k] are the
 * displacements of a and b, k[0] and k[1] the stiffness with which a and b feel the bond. The forces are linear, so the
 * trapezium rule is exact. */
static double work_round(const double (*u)[2], int places, const double k[2]) {
    double work = 0;
    for (int p = 0; p < places; p++) {
        const double *from = u[p], *to = u[(p + 1) % places];
        const double stretch = 0.5 * ((from[1] - from[0]) + (to[1] - to[0]));
        work += k[0] * stretch * (to[0] - from[0]) - k[1] * stretch * (to[1] - from[1]);
    }
    return work;
}

/* A bond of different horizons, one-sided, has no energy: round a closed path of its ends it does work, (k_a - k_b)
 * e^2, and takes as much on the way back. The dual horizon's bond does none. */
static void test_one_sided_bonds_have_no_energy(void **state) {
    (void)state;
    static const double there[4][2] = {{0, 0}, {0, 1}, {1, 1}, {1, 0}}, back[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const struct solid_material m = {YOUNG, DENSITY, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
    struct solid_input in = {.model = PHYSICS_PLANE_STRESS, .thickness = 1, .spacing = 1};
    const struct solid_end coarse = {1, 3, 1}, fine = {0.5, 1.5, 0.25};
    for (int length = 1; length <= 2; length++) { /* both ends reach the other; the coarse one alone */
        const double xi[3] = {length, 0, 0}, other[3] = {-length, 0, 0};
        for (int kind = SOLID_DUAL_HORIZON; kind <= SOLID_ONE_SIDED; kind++) {
            in.horizons = (enum solid_horizons)kind;
            const struct solid_bond_law law = solid_pair_law(&in, &m);
            double k[2] = {0, 0};
            if (solid_pair_exists(&law, xi, &coarse, &fine)) k[0] = solid_pair_of(&law, xi, &coarse, &fine).stiffness;
            if (solid_pair_exists(&law, other, &fine, &coarse))
                k[1] = solid_pair_of(&law, other, &fine, &coarse).stiffness;
            const double work = work_round(there, 4, k), largest = fmax(k[0], k[1]);
            check_close(work, k[0] - k[1], 1e-12 * largest);
            check_close(work_round(back, 4, k), -work, 1e-12 * largest);
            if (kind == SOLID_ONE_SIDED)
                check_above(fabs(work), 0.5 * largest);
            else
                check_close(work, 0, 1e-12 * largest);
        }
    }
}

/* V0 scales with the size of things, and is that of the lattice's stencil. */
static void test_full_volume(void **state) {
    (void)state;
    const struct solid_material m = {YOUNG, DENSITY, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
    const struct solid_input plate = {.model = PHYSICS_PLANE_STRESS, .thickness = 1, .spacing = 1},
                             space = {.spacing = 1};
    const struct solid_bond_law law = solid_pair_law(&plate, &m);
    struct solid_bond_law solid = solid_pair_law(&space, &m);
    solid.columns = 400;
    const double full = solid_pair_full_volume(&law, 3, 1);
    check_close(full, M_PI * 9 - 1, 1e-13);
    check_close(solid_pair_full_volume(&law, 1.5, 0.5) * 4 / full, 1, 1e-14);
    check_close(solid_pair_full_volume(&law, 3, 0.97) / full, 1, 0);
    solid.table = solid_weight_table_new();
    struct solid_stencil *stencil = solid_stencil_new(1, 3);
    check_close(solid_pair_full_volume(&solid, 3, 1) / stencil->full_volume, 1, 1e-13); /* rounded weights */
    solid_stencil_free(stencil);
    solid_weight_table_free(solid.table);
}

/* Who belongs to a family of horizon 3, just inside and just outside of each limit; and the ramp's values. */
static void test_members(void **state) {
    (void)state;
    const double tiny = 1e-6;
    struct solid_material m = {YOUNG, DENSITY, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
    struct solid_input in = {.spacing = 1, .thickness = 1};
    struct solid_bond_law law = solid_pair_law(&in, &m);
    check_equal(solid_pair_holds(&law, (double[]){0, 2.8, 2.1 - tiny}, 3, 1), 1);
    check_equal(solid_pair_holds(&law, (double[]){0, 2.8, 2.1}, 3, 1), 0);
    check_equal(solid_pair_holds(&law, (double[]){0, 2.8, 2.1}, 3, 1.1), 1);
    in.model = PHYSICS_PLANE_STRESS; /* the cell's nearest corner at (1.8, 2.4) */
    law = solid_pair_law(&in, &m);
    check_equal(solid_pair_holds(&law, (double[]){-2.3, 2.9 - tiny}, 3, 1), 1);
    check_equal(solid_pair_holds(&law, (double[]){-2.3, 2.9}, 3, 1), 0);
    check_equal(solid_pair_holds(&law, (double[]){3.5, 0}, 3, 1), 0);
    m.micromodulus = PHYSICS_CONICAL;
    law = solid_pair_law(&in, &m);
    check_equal(solid_pair_holds(&law, (double[]){1.8, 2.4 - tiny}, 3, 1), 1);
    check_equal(solid_pair_holds(&law, (double[]){1.8, 2.4}, 3, 1), 0);
    in.partial = SOLID_PARTIAL_RAMP;
    law = solid_pair_law(&in, &m);
    const double length[4] = {2.4, 3, 3.4, 3.6}, gamma[4] = {1, 0.5, 0.1, 0};
    for (int k = 0; k < 4; k++) check_close(solid_pair_gamma(&law, (double[]){length[k], 0}, 3, 1), gamma[k], 1e-14);
}

/* A bond between horizons 3 and 1.5: c goes as delta^-(dim + 1), s0^2 as 1/delta; K is the mean of the halves, one half
 * where only one end reaches; the micromodulus is the mean of those that exist. */
static void test_horizons_by_hand(void **state) {
    (void)state;
    for (int plate = 0; plate < 2; plate++) {
        const struct solid_material m = {YOUNG, DENSITY, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
        const struct solid_input in = {
            .model = plate ? PHYSICS_PLANE_STRAIN : PHYSICS_3D, .thickness = 1, .spacing = 1};
        const struct solid_bond_law law = solid_pair_law(&in, &m);
        const struct solid_end coarse = {1, 3, 1}, fine = {0.5, 1.5, plate ? 0.25 : 0.125};
        const double near[3] = {0.75, 0, 0}, far[3] = {2.25, 0, 0}, times = plate ? 8 : 16;
        const struct solid_pair both = solid_pair_of(&law, near, &coarse, &fine),
                                one = solid_pair_of(&law, far, &coarse, &fine),
                                back = solid_pair_of(&law, far, &fine, &coarse);
        /* near: all of either cell is in the other's horizon, Gamma = 1 */
        check_relative(both.stiffness, 0.5 * (1 + times) * law.c, 1e-14);
        check_relative(solid_pair_micromodulus(&law, near, &coarse, &fine), 0.5 * (1 + times) * law.c, 1e-14);
        const double s2 = (1 + times * 2) / (1 + times) * law.s0 * law.s0, s0 = sqrt(s2);
        check_relative(both.eps_limit, s0 * (2 + s0), 1e-13);
        check_equal(solid_pair_limit(&law, near, &coarse, &fine), both.eps_limit);
        /* far: the coarse cell begins at 1.75, beyond the fine horizon */
        check_relative(one.stiffness, 0.5 * law.c, 1e-14);
        check_equal(one.gamma, 1);
        check_equal(back.gamma, 0);
        check_equal(back.stiffness, one.stiffness);
        check_relative(one.eps_limit, law.s0 * (2 + law.s0), 1e-13);
        check_relative(solid_pair_micromodulus(&law, far, &fine, &coarse), law.c, 1e-14);
    }
}

/* Rounded volumes add up to the same bits in any order. */
static void test_rounded(void **state) {
    (void)state;
    enum { N = 400 };
    double part[N], up = 0, down = 0;
    const struct solid_bond_law law = {.dim = 2};
    srand(8);
    for (int i = 0; i < N; i++) {
        const double volume = uniform(0, 1);
        part[i] = solid_pair_rounded(&law, 3, volume);
        check_close(part[i], volume, 0x1p-44);
    }
    for (int i = 0; i < N; i++) {
        up += part[i];
        down += part[N - 1 - i];
    }
    check_equal(up, down);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_lattice_sums),
                                       cmocka_unit_test(test_fine_sums),
                                       cmocka_unit_test(test_pairs),
                                       cmocka_unit_test(test_one_sided_bonds_have_no_energy),
                                       cmocka_unit_test(test_full_volume),
                                       cmocka_unit_test(test_members),
                                       cmocka_unit_test(test_horizons_by_hand),
                                       cmocka_unit_test(test_rounded)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
