/* Mixed precision against double: forces of a strained block wherever it has moved and however it has turned, momentum,
 * breakage, and that a snapshot comes back to the bit. */
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/force/segment_single.h"
#include "solid/snapshot.h"
#include "solid/step/integrate.h"
#include "tests/solid/make.h"
#include "tests/check.h"

#include <stdlib.h>
#include <string.h>

static const double HALF_DIGIT = 0x1p-24; /* the largest relative error of rounding to single */

enum { SIDE = 12 };

static struct solid *block(int mixed, double fracture_energy) {
    struct solid *s = make((struct make){
        .sites = {SIDE, SIDE, SIDE}, .mixed = mixed, .fracture_energy = fracture_energy > 0 ? fracture_energy : 0});
    s->stage.integrator = SOLID_VERLET;
    s->stage.breakage = fracture_energy > 0;
    return s;
}

/* X = R (X0 + u) + shift: strained at random, turned about the diagonal as a whole, and moved. Lengths in spacings. */
static void place(struct solid *s, double strain, double angle, double shift) {
    const double third = 1.0 / 3, c = cos(angle), si = sin(angle) / sqrt(3);
    const double diagonal = c + (1 - c) * third, next = (1 - c) * third - si, last = (1 - c) * third + si;
    const double turn[3][3] = {{diagonal, next, last}, {last, diagonal, next}, {next, last, diagonal}};
    for (int h = 0; h < s->n; h++) {
        double x[3];
        for (int k = 0; k < 3; k++) x[k] = s->x0[k][h] + strain * SPACING * noise(s, h, k);
        for (int k = 0; k < 3; k++) {
            s->d[k][h] = turn[k][0] * x[0] + turn[k][1] * x[1] + turn[k][2] * x[2] - s->x0[k][h] + shift * SPACING;
            s->v[k][h] = 100 * strain * noise(s, h, k + 3);
        }
    }
    s->a_holds = 0;
    solid_ghosts_update(s);
}

/* Sums over the bonds of h: of their forces' magnitudes over the density, and of what an error of eps would do, and one
 * of the relative displacement, m. */
static void scale_of(const struct solid *s, int h, double *force, double *of_eps, double *of_eta) {
    static struct solid_family_view view;
    solid_family_view(s, h, &view);
    *force = *of_eps = *of_eta = 0;
    for (int b = 0; b < view.n; b++) {
        double xi2 = 0, zeta2 = 0;
        for (int c = 0; c < 3; c++) {
            const double zeta = view.xi[b][c] + s->d[c][view.l[b]] - s->d[c][h];
            xi2 += view.xi[b][c] * view.xi[b][c];
            zeta2 += zeta * zeta;
        }
        const double k = view.intact[b] * view.alpha[b] * view.micro[b] * view.weight[b] / DENSITY;
        *force += k * fabs(sqrt(zeta2 / xi2) - 1);
        *of_eps += k * 0.5 * SOLID_SINGLE_EPS_ERROR;
        *of_eta += k / sqrt(xi2);
    }
}

/* What the two precisions of one state differ by. */
struct differences {
    double worst;   /* of a component of a, over what rounding may add: 105 half digits of the sum of the magnitudes of
                     * the particle's bond forces, and one of each end's displacement where that is rounded */
    double of_eps;  /* the same over what an error SOLID_SINGLE_EPS_ERROR of each eps may add, the rest being 1e-5 */
    double mean;    /* rms of a's error over the rms of that sum */
    double total;   /* total force in mixed precision, over the sum of those sums */
    double damping; /* relative, of its power */
};

static struct differences compare(double strain, double angle, double shift, double damping) {
    struct solid *s[2];
    struct differences difference = {0};
    double sums[5] = {0}, far = 0;
    for (int k = 0; k < 2; k++) {
        s[k] = block(k, 0);
        assert_int_equal(solid_family_is_mixed(s[k], 0), k);
        s[k]->stage.damping_relative = damping;
        place(s[k], strain, angle, shift);
        solid_force(s[k], 0);
        solid_force(s[k], 0); /* no segment is known to be large or near a limit any more */
    }
    for (int h = 0; h < s[0]->n; h++)
        for (int c = 0; c < 3; c++) far = fmax(far, fabs(s[0]->d[c][h]));
    par_max_array(&far, 1);
    const double rounded = far > SOLID_SINGLE_NEAR * SPACING ? 0 : 2 * sqrt(3) * HALF_DIGIT * far;
    for (int h = 0; h < s[0]->n; h++) {
        double force, of_eps, of_eta;
        scale_of(s[0], h, &force, &of_eps, &of_eta);
        for (int c = 0; c < 3; c++) {
            const double error = s[1]->a[c][h] - s[0]->a[c][h];
            difference.worst = check_worst(difference.worst, error / (105 * HALF_DIGIT * force + rounded * of_eta));
            difference.of_eps = check_worst(difference.of_eps, error / (of_eps + 1e-5 * force));
            sums[0] += error * error;
            sums[1 + c] += s[1]->a[c][h];
        }
        sums[4] += force * force;
    }
    par_sum_array(sums, 5);
    double power[2] = {s[0]->power_damped, s[1]->power_damped};
    par_sum_array(power, 2);
    double most[2] = {difference.worst, difference.of_eps};
    par_max_array(most, 2);
    difference.worst = most[0];
    difference.of_eps = most[1];
    difference.mean = sqrt(sums[0] / sums[4]);
    difference.total =
        sqrt(sums[1] * sums[1] + sums[2] * sums[2] + sums[3] * sums[3]) / sqrt(sums[4] * (double)s[0]->n_global);
    difference.damping = damping > 0 ? fabs(power[1] / power[0] - 1) : 0;
    for (int k = 0; k < 2; k++) solid_free(s[k]);
    return difference;
}

/* A bond's force takes some 16 roundings, and a sum over half a family at most 89 more: 105 half digits of the sum of
 * magnitudes at most. By chance they nearly cancel: rms some 2 half digits. That holds for any strain however far the
 * block has moved, but for the last ones: they have moved by a thousandth of a spacing, which is rounded. */
static void forces(void **state) {
    (void)state;
    for (double strain = 1e-4; strain > 1e-7; strain *= 1e-2)
        for (int moved = 0; moved < 2; moved++) {
            const struct differences difference = compare(strain, 0, moved ? 1000 * strain : 0, 1e13);
            print_message("strain %g: worst %.2g of the bound, rms %.2g half digits, total force %.2g\n", strain,
                          difference.worst, difference.mean / HALF_DIGIT, difference.total);
            check_at_most(difference.worst, 1);
            if (!moved || 1000 * strain > SOLID_SINGLE_NEAR) check_at_most(difference.mean, 2 * HALF_DIGIT);
            check_at_most(difference.total, 0.1 * HALF_DIGIT);
            check_at_most(difference.damping, 1e-6);
        }
}

/* A sweep copies displacements in double only if the last one, or a ghost in this one, could not be rounded. Whatever
 * the sweeps before were of, the forces are those of a solid that was never swept before, to the bit. */
static void near_and_far(void **state) {
    (void)state;
    static const double far[][2] = {{0, 0}, {0.5, 0.5}, {0, 0}, {0, 0.5}, {0.5, 0}, {0, 0}}; /* first rank, others */
    struct solid *s = block(1, 0);
    for (size_t k = 0; k < sizeof far / sizeof far[0]; k++) {
        struct solid *fresh = block(1, 0);
        struct solid *const both[2] = {s, fresh};
        for (int i = 0; i < 2; i++) {
            place(both[i], 1e-4 * (1 + (double)k), 0, far[k][par_rank() > 0]);
            solid_force(both[i], 0);
        }
        solid_force_reset(s); /* which segments are large */
        for (int c = 0; c < 3; c++) check_equal(memcmp(s->a[c], fresh->a[c], (size_t)s->n * sizeof *s->a[c]), 0);
        solid_free(fresh);
    }
    solid_free(s);
}

/* In turned pieces eta is long and eps the small difference of large numbers: its error is below the bound that
 * breakage relies on. Turned by 120 degrees about the diagonal the lattice covers itself. */
static void turned(void **state) {
    (void)state;
    for (int k = 1; k <= 6; k++) {
        const struct differences difference = compare(1e-4, k * acos(-1) / 6, 1e4, 0);
        print_message("%d degrees: rms %.2g, of the bound %.2g, total force %.2g\n", 30 * k, difference.mean,
                      difference.of_eps, difference.total);
        check_at_most(difference.of_eps, 0.05); /* by chance the errors of many bonds nearly cancel */
        check_at_most(difference.total, 0.1 * HALF_DIGIT);
    }
}

/* Bonds break by stretches in double: in one state the same ones break in either precision, wherever the block is. */
static void breaks(void **state) {
    (void)state;
    for (int where = 0; where < 3; where++) {
        struct solid *s[2];
        uint8_t bits[2][SOLID_FAMILY_MAX / 8];
        for (int k = 0; k < 2; k++) {
            s[k] = block(k, 0.05);
            place(s[k], 3e-4, where ? 1.0 : 0, where == 2 ? 1e3 : 0);
            solid_force(s[k], 1);
            solid_family_count(s[k]);
        }
        check_between(s[0]->bonds_broken, 100, s[0]->bonds_total / 4);
        check_equal(s[1]->bonds_broken, s[0]->bonds_broken);
        check_relative(s[1]->e_fracture, s[0]->e_fracture, 1e-13);
        for (int h = 0; h < s[0]->n; h++) {
            for (int k = 0; k < 2; k++) solid_family_save(s[k], h, bits[k]);
            assert_memory_equal(bits[0], bits[1], (size_t)solid_family_bytes(s[0]));
        }
        for (int k = 0; k < 2; k++) solid_free(s[k]);
    }
}

/* 200 steps of a free body: momentum stays to less than a half digit of the momentum that its waves carry, and energy
 * as in double. */
static void free_body(void **state) {
    (void)state;
    double energy[2][2], momentum[2][3] = {{0}}, carried = 0;
    for (int k = 0; k < 2; k++) {
        struct solid *s = block(k, 0);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) s->d[c][h] = 1e-4 * SPACING * sin(2 * s->x0[c][h] / SPACING);
        solid_ghosts_update(s);
        energy[k][0] = energy_of(s, NULL);
        solid_integrate(s, step_of(0.4), 200);
        solid_ghosts_update(s);
        energy[k][1] = energy_of(s, NULL);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) {
                momentum[k][c] += DENSITY * s->volume[h] * s->v[c][h];
                carried += k ? DENSITY * s->volume[h] * fabs(s->v[c][h]) : 0;
            }
        solid_free(s);
    }
    par_sum_array(&momentum[0][0], 6);
    par_sum_array(&carried, 1);
    const double drift =
        sqrt(momentum[1][0] * momentum[1][0] + momentum[1][1] * momentum[1][1] + momentum[1][2] * momentum[1][2]) /
        carried;
    print_message("momentum %.2g of what the waves carry, energy %.3g in mixed and %.3g in double\n", drift,
                  energy[1][1] / energy[1][0] - 1, energy[0][1] / energy[0][0] - 1);
    check_at_most(drift, HALF_DIGIT);
    check_close(energy[1][1] / energy[1][0], energy[0][1] / energy[0][0], 1e-6);
}

static double *places_of(const struct solid *s) {
    double *all = malloc(6 * (size_t)s->n * sizeof *all);
    for (int c = 0; c < 3; c++) {
        memcpy(all + (size_t)c * (size_t)s->n, s->d[c], (size_t)s->n * sizeof *all);
        memcpy(all + (size_t)(3 + c) * (size_t)s->n, s->v[c], (size_t)s->n * sizeof *all);
    }
    return all;
}

/* The same steps from a snapshot give the same bits, in a body that breaks. */
static void kept(void **state) {
    (void)state;
    struct solid *s = block(1, 0.05);
    s->stage.damping_relative = 1e13;
    place(s, 2.3e-4, 0, 0);
    solid_integrate(s, step_of(0.4), 3);
    struct solid_snapshot *keep = solid_snapshot_new(s, NULL, 1);
    solid_snapshot_take(keep, s, NULL);
    solid_integrate(s, step_of(0.4), 5);
    double *once = places_of(s);
    solid_family_count(s);
    check_at_least(s->bonds_broken, 50);
    solid_snapshot_restore(keep, s, NULL);
    solid_integrate(s, step_of(0.4), 5);
    double *again = places_of(s);
    assert_memory_equal(once, again, 6 * (size_t)s->n * sizeof *once);
    free(once);
    free(again);
    solid_snapshot_free(keep);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(forces),    cmocka_unit_test(near_and_far),
                                       cmocka_unit_test(turned),    cmocka_unit_test(breaks),
                                       cmocka_unit_test(free_body), cmocka_unit_test(kept)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
