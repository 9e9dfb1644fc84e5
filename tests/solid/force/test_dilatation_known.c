/* Bodies of any Poisson's ratio in states whose answer is known: a lone particle and a lone bond, a body that is
 * swollen or compressed to half, however it is damaged, a large rotation, and plane waves. */
#include "base/step_status.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/force/strain.h"
#include "tests/check.h"
#include "tests/solid/make.h"

static const double ratios[] = {-0.5, 0.05, 0.2, 0.3, 0.45};
enum { RATIOS = sizeof ratios / sizeof *ratios };

/* sum K |xi| V over the family, N/m2 */
static double weight_of(const struct solid *s, int h) {
    static struct solid_family_view view;
    double sum = 0;
    solid_family_view(s, h, &view);
    for (int b = 0; b < view.n; b++) {
        const double *x = view.xi[b];
        if (view.intact[b]) sum += view.micro[b] * view.weight[b] * sqrt((x[0] * x[0] + x[1] * x[1]) + x[2] * x[2]);
    }
    return sum;
}

/* The same of a complete family. */
static double full_of(double ratio_excess) {
    struct solid *s = make((struct make){.sites = {13, 13, 13}, .ratio_excess = ratio_excess});
    double most = 0;
    for (int h = 0; h < s->n; h++) most = fmax(most, weight_of(s, h));
    solid_free(s);
    return par_max(most);
}

static double bulk_of(double nu) { return YOUNG / (3 * (1 - 2 * nu)); }

/* d = F x - x about the origin, m. */
static void deform(struct solid *s, const double f[3][3]) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            s->d[c][h] = -s->x0[c][h];
            for (int k = 0; k < 3; k++) s->d[c][h] += f[c][k] * s->x0[k][h];
        }
    solid_ghosts_update(s);
}

/* Half of all bonds, in no order. */
static void damage(struct solid *s) {
    static struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            double hash = 0;
            for (int c = 0; c < 3; c++) hash += (1.7 + c) * rint((2 * s->x0[c][h] + view.xi[b][c]) / SPACING);
            if (sin(37 * hash) > 0 && view.intact[b]) solid_family_break(s, h, b);
        }
    }
}

/* A particle alone feels nothing. A bond alone has the dilatation n s at both ends, M = K |xi| V, and so the force
 * K V s (1 + 2 n^2 (k - k_b)/M_0) = K V s k/k_b, because k_b = M_0/(2 n^2). */
static void test_alone(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int k = 0; k < RATIOS; k++)
        for (int list = 0; list < 2; list++) {
            if (check_skips(k + list, 2)) continue;
            const double excess = ratios[k] - 0.25, full = full_of(excess), stretch = 0.01,
                         f[3][3] = {{1 + stretch, 0, 0}, {0, 1, 0}, {0, 0, 1}};
            for (int sites = 1; sites < 3; sites++) {
                struct solid *s =
                    make((struct make){.sites = {sites, 1, 1}, .list = list, .uncorrected = 1, .ratio_excess = excess});
                deform(s, f);
                solid_force(s, 0);
                for (int h = 0; h < s->n; h++) {
                    double force = 0;
                    solid_family_view(s, h, &view);
                    for (int b = 0; b < view.n; b++)
                        if (view.intact[b])
                            force += view.micro[b] * view.weight[b] * stretch * bulk_of(ratios[k]) / (full / 18) *
                                     (view.xi[b][0] > 0 ? 1 : -1);
                    if (sites == 1)
                        check_equal(s->a[0][h], 0);
                    else
                        check_relative(DENSITY * s->a[0][h], force, 1e-11);
                    check_close(DENSITY * s->a[1][h], 0, 1e-12 * YOUNG / SPACING);
                }
                solid_free(s);
            }
        }
}

/* The same stretch s of every bond, be it double or half the length: each family has theta = 3 s, whichever of its
 * bonds are left, so the energy is sum 1/2 k theta^2 V M/M_0, and a complete family has no force. A turned body has
 * neither. */
static void test_sizes(void **state) {
    (void)state;
    static const double sizes[] = {0.5, 0.999, 1.1, 2};
    for (int k = 0; k < RATIOS; k++)
        for (int kind = 0; kind < 4; kind++) {
            if (check_skips(4 * k + kind, 3)) continue;
            const double excess = ratios[k] - 0.25, full = full_of(excess), bulk = bulk_of(ratios[k]);
            struct solid *s =
                make((struct make){.sites = {9, 8, 10}, .list = kind & 1, .uncorrected = 1, .ratio_excess = excess});
            double volume = 0;
            if (kind & 2) damage(s);
            for (int h = 0; h < s->n; h++) volume += s->volume[h] * weight_of(s, h) / full;
            volume = par_sum(volume);
            for (int i = 0; i < 4; i++) {
                const double g = sizes[i], theta = 3 * (g - 1), f[3][3] = {{g, 0, 0}, {0, g, 0}, {0, 0, g}};
                deform(s, f);
                check_relative(par_sum(solid_strain_energy(s)), 0.5 * bulk * theta * theta * volume, 1e-9);
                solid_force(s, 0);
                for (int h = 0; h < s->n; h++)
                    for (int c = 0; c < 3; c++)
                        if (weight_of(s, h) > full * (1 - 1e-12) && !(kind & 2))
                            check_close(DENSITY * s->a[c][h], 0, 1e-9 * bulk * fabs(g - 1) / SPACING + 1e-6);
            }
            const double turn[3][3] = {{cos(2), -sin(2), 0}, {sin(2), cos(2), 0}, {0, 0, 1}};
            deform(s, turn);
            solid_force(s, 0);
            check_close(par_sum(solid_strain_energy(s)), 0, 1e-20 * bulk * volume);
            for (int h = 0; h < s->n; h++)
                for (int c = 0; c < 3; c++) check_close(DENSITY * s->a[c][h] * SPACING / bulk, 0, 1e-12);
            solid_free(s);
        }
}

/* Plane waves of twenty spacings, along x and across: the force is -rho omega^2 d with
 *     rho omega^2 = sum c Gamma V (xi.e)^2/|xi|^3 (1 - cos k xi_x) + (k - k_b) f^2,
 *     f = 3/M_0 sum c Gamma V xi.e/|xi| sin k xi_x        the dilatation's amplitude over that of d
 */
static void test_waves(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int k = 0; k < RATIOS; k++)
        for (int across = 0; across < 2; across++) {
            struct solid *s = make((struct make){
                .sites = {20, 8, 8}, .periodic = {1, 1, 1}, .uncorrected = 1, .ratio_excess = ratios[k] - 0.25});
            const double wave = 2 * acos(-1) / (20 * SPACING), size = 1e-6 * SPACING;
            double c11 = 0, c44 = 0, bonds = 0, f = 0;
            for (int h = 0; h < s->n; h++)
                for (int c = 0; c < 3; c++) s->d[c][h] = c == across ? size * sin(wave * s->x0[0][h]) : 0;
            solid_ghosts_update(s);
            solid_force(s, 0);
            solid_family_view(s, 0, &view);
            for (int b = 0; b < view.n; b++) {
                const double *x = view.xi[b], length = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]),
                             part = view.micro[b] * view.weight[b] / (length * length * length);
                c11 += 0.5 * part * x[0] * x[0] * x[0] * x[0];
                c44 += 0.5 * part * x[0] * x[0] * x[1] * x[1];
                bonds += part * x[across] * x[across] * (1 - cos(wave * x[0]));
                f += 3 / weight_of(s, 0) * part * length * length * x[across] * sin(wave * x[0]);
            }
            const double excess = bulk_of(ratios[k]) - (c11 + 2 * c44) / 3, modulus = across ? c44 : c11 + excess,
                         exact = bonds + excess * f * f;
            for (int h = 0; h < s->n; h++)
                check_close(-DENSITY * s->a[across][h] / (exact * size), s->d[across][h] / size, 1e-5);
            if (par_rank() == 0 && across == 0)
                print_message("nu = %g: longitudinal speed over the lattice's %.4f\n", ratios[k],
                              sqrt(exact / modulus) / wave);
            solid_free(s);
        }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_alone), cmocka_unit_test(test_sizes),
                                       cmocka_unit_test(test_waves)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
