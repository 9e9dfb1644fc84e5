/* Perturbed particles of a plate: where they stand, on any number of ranks, and the moduli that they have. */
#include "tests/solid/make_plate.h"
#include "solid/body/perturb.h"
#include "tests/check.h"

/* Each particle is in its cell, at the place that seed and cell give, whatever rank it is on; moves are even. */
static void places(void **state) {
    (void)state;
    struct solid *s = make((struct make){.sites = {41, 37}, .perturbation = 0.3, .seed = 11});
    const struct solid_body body = {.perturbation = 0.3, .perturbation_seed = 11}, other = {.perturbation = 0.3};
    double sum[5] = {0}, same = 0;
    for (int h = 0; h < s->n; h++) {
        double move[2];
        long cell[2];
        for (int c = 0; c < 2; c++) cell[c] = (long)floor(s->x0[c][h] / SPACING);
        for (int c = 0; c < 2; c++) {
            move[c] = s->x0[c][h] / SPACING - (double)cell[c] - 0.5;
            check_close(move[c], solid_perturb(&body, cell[0], cell[1], c), 0x1p-20);
            same += fabs(move[c] - solid_perturb(&other, cell[0], cell[1], c)) < 1e-3;
            sum[c] += move[c];
            sum[2 + c] += move[c] * move[c];
        }
        sum[4] += move[0] * move[1];
        check_close(s->volume[h] / (SPACING * SPACING * THICKNESS), 1, 1e-12);
    }
    par_sum_array(sum, 5);
    const double n = 41 * 37, variance = 0.09 / 3;
    assert_int_equal(s->n_global, 41 * 37);
    for (int c = 0; c < 2; c++) { /* four standard errors of the mean, of the variance, of the covariance */
        check_close(sum[c] / n, 0, 4 * sqrt(variance / n));
        check_close(sum[2 + c] / n, variance, 4 * variance * sqrt(0.8 / n));
    }
    check_close(sum[4] / n, 0, 4 * variance / sqrt(n));
    check_below(par_sum(same), 0.02 * n); /* another seed moves them elsewhere */
    solid_free(s);
}

/* Strain energy of a homogeneous strain {xx, yy, xy}, J. */
static double energy_of(double perturbation, int seed, const double e[3]) {
    struct solid *s = make((struct make){.sites = {60, 60}, .perturbation = perturbation, .seed = seed});
    for (int h = 0; h < s->n; h++) {
        s->d[0][h] = e[0] * s->x0[0][h] + e[2] * s->x0[1][h];
        s->d[1][h] = e[1] * s->x0[1][h] + e[2] * s->x0[0][h];
    }
    solid_ghosts_update(s);
    const double strain = solid_energy_measure(s).strain;
    solid_free(s);
    return strain;
}

/* Moved by up to a fifth of a spacing, a plate keeps the modulus that no direction changes, that of equal stretches
 * along x and y. Tension along x and shear have C11 and C66, whose ratio is 3 in an isotropic plate of central forces:
 * the perturbed plate is nearer to that than the lattice, whose C11 is too large and C66 too small. */
static void moduli(void **state) {
    (void)state;
    static const double equal[3] = {1e-5, 1e-5, 0}, tension[3] = {1e-5, 0, 0}, shear[3] = {0, 0, 1e-5};
    const double lattice = energy_of(0, 1, equal);
    const double slant = 4. / 3 * energy_of(0, 1, tension) / energy_of(0, 1, shear) - 1;
    check_above(slant, 0.005);
    for (int seed = 1; seed <= 3; seed++) {
        check_close(energy_of(0.2, seed, equal) / lattice, 1, 3e-3);
        const double left = 4. / 3 * energy_of(0.2, seed, tension) / energy_of(0.2, seed, shear) - 1;
        check_below(fabs(left), slant);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(places), cmocka_unit_test(moduli)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
