/* Bodies of several materials against known answers: layers in series, a crack in the weak layer, uniform strain. */
#include "tests/solid/bonds/mix.h"

/* Segments of one kind are those whose bonds join one kind only; both sorts occur. */
static void segments_of_a_kind(void **state) {
    (void)state;
    const struct mix m = {
        .sites = {64, 16, 12}, .pattern = HALVES, .at = 29, .material = {quartz, clay, ore}, .kinds = 2};
    struct solid *s = mixed(&m);
    const struct solid_lattice *t = s->family->lattice[0];
    int count[3] = {0};
    for (int g = 0; g < t->segments->n; g++) {
        const int kind = t->materials->segment[g];
        int low = 64, high = -1;
        for (int k = 0; k < SOLID_ROW; k++)
            if (t->segments->owned[g] >> k & 1) {
                const int h = t->local[t->segments->cell[g] + k], x = (int)floor(s->x0[0][h] / SPACING);
                low = x < low ? x : low;
                high = x > high ? x : high;
            }
        check_equal(kind, high + 3 < 29 ? 0 : low - 3 >= 29 ? 1 : SOLID_MATERIALS_SEVERAL);
        count[kind == SOLID_MATERIALS_SEVERAL ? 2 : kind]++;
    }
    for (int k = 0; k < 3; k++) check_above(par_sum_long(count[k]), 100);
    solid_free(s);
}

/* Mean strain of a bar between the sites from and to, held at one end and pulled at the other, and without contraction;
 * stress 1 kPa. */
static double strain_of_bar(enum pattern pattern, double stiffer, int sites, int from, int to) {
    const struct solid_constraint clamp = {.low = {-1, -1, -1}, .high = {3 * SPACING, 1, 1}, .direction = {1, 1, 1}};
    struct mix m = {.sites = {sites, 4, 4},
                    .periodic = {0, 1, 1},
                    .pattern = pattern,
                    .at = sites / 2,
                    .material = {quartz, quartz, ore},
                    .kinds = 2,
                    .constraints = 1,
                    .constraint = &clamp};
    m.material[1].youngs_modulus = stiffer * YOUNG;
    m.material[1].density = 2 * DENSITY;
    struct solid *s = mixed(&m);
    for (int h = 0; h < s->n; h++)
        if (s->x0[0][h] > (sites - 1) * SPACING) s->load[0][h] = 1e3 / SPACING;
    check_above(solid_relax(s, 1e-7, 40000), 10);
    double d[2] = {0};
    for (int h = 0; h < s->n; h++)
        for (int e = 0; e < 2; e++)
            if (fabs(s->x0[0][h] / SPACING - 0.5 - (e ? to : from)) < 0.1) d[e] += s->d[0][h] / 16;
    par_sum_array(d, 2);
    double(*stress)[6] = calloc((size_t)s->n + 1, sizeof *stress), far = 0, near = 0;
    solid_ghosts_update(s);
    solid_stress_measure(s, stress);
    for (int h = 0; h < s->n; h++) {
        const double x = s->x0[0][h] / SPACING, off = stress[h][0] / 1e3 - 1;
        if (x < 7 || x > sites - 7) continue;
        if (fabs(x - sites / 2) > 7)
            far = check_worst(far, off);
        else
            near = check_worst(near, off);
    }
    check_below(far, 0.01);
    check_below(near, 0.25); /* a mean over the family */
    print_message("stress: off by at most %.4f far from the border, %.4f near to it\n", far, near);
    free(stress);
    solid_free(s);
    return (d[1] - d[0]) / ((to - from) * SPACING);
}

/* Two layers in series: the strain is the mean of both layers'. What differs belongs to the border, some tenths of a
 * spacing of the softer layer whatever the length: with the length the stiffness converges to the analytic one. */
static void layers_in_series(void **state) {
    (void)state;
    const double stiffer[] = {3, 0.25};
    for (int k = 0; k < 2; k++) {
        double border[2];
        for (int q = 0; q < 2; q++) {
            const int sites = q ? 48 : 24, from = sites / 4, to = sites - 1 - from;
            const double one = strain_of_bar(ONE, 1, sites, from, to),
                         two = strain_of_bar(HALVES, stiffer[k], sites, from, to);
            border[q] = (two / one - 0.5 * (1 + 1 / stiffer[k])) * (to - from) * fmin(stiffer[k], 1);
            print_message("two layers of %d spacings, %.2f times as stiff: %.5f of the analytic strain, the border "
                          "%.4f spacings\n",
                          sites, stiffer[k], two / one / (0.5 * (1 + 1 / stiffer[k])), border[q]);
        }
        check_close(border[0], 0, 0.6);
        check_close(border[1], border[0], 1e-3);
    }
}

/* A plate with a layer of a weaker material is pulled across the layer: it breaks there and nowhere else. */
static void crack_in_the_layer(void **state) {
    (void)state;
    static struct solid_family_view view;
    const struct solid_constraint end[] = {
        {.low = {-1, -1, -1}, .high = {1, 3 * SPACING, 1}, .direction = {1, 1, 1}, .velocity = {0, -0.008, 0}},
        {.low = {-1, 21 * SPACING, -1}, .high = {1, 1, 1}, .direction = {1, 1, 1}, .velocity = {0, 0.008, 0}}};
    struct mix m = {.sites = {16, 24, 4},
                    .periodic = {0, 0, 1},
                    .pattern = LAYER,
                    .at = 13,
                    .material = {quartz, quartz, ore},
                    .kinds = 2,
                    .constraints = 2,
                    .constraint = end};
    m.material[1].fracture_energy = 0.3 * G0;
    struct solid *s = mixed(&m);
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .breakage = 1};
    for (int h = 0; h < s->n; h++) s->v[1][h] = 0.016 * (s->x0[1][h] / (24 * SPACING) - 0.5);
    solid_ghosts_update(s);
    const double dt = 0.5 * solid_rates_stable_step(s, SOLID_VERLET);
    long outside = 0;
    for (int k = 0; k < 2000 && s->bonds_broken < 2000; k += 10) {
        solid_integrate(s, dt, 10);
        solid_family_count(s);
    }
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++)
            outside += !view.intact[b] && kind_of(&m, s, h) == 0 && kind_of(&m, s, view.l[b]) == 0 &&
                       (s->x0[1][h] - 15 * SPACING) * (s->x0[1][h] + view.xi[b][1] - 15 * SPACING) > 0;
    }
    check_at_least(s->bonds_broken, 2000);
    check_equal(par_sum_long(outside), 0);
    solid_free(s);
}

/* Materials of several Poisson's ratios: the forces are the derivative of the energy, and equal and opposite, whichever
 * materials the ends of a bond have. One of the three has the ratio of bonds alone. */
static void test_ratios(void **state) {
    (void)state;
    const double excess[3] = {0.15, -0.3, 0};
    for (enum pattern pattern = HALVES; pattern <= LAYER; pattern++) {
        struct mix m = {.sites = {19, 10, 11},
                        .periodic = {0, 0, 1},
                        .pattern = pattern,
                        .at = pattern == HALVES ? 9 : 3,
                        .material = {QUARTZ, CLAY, ORE},
                        .kinds = pattern == HALVES || pattern == LAYER ? 2 : 3};
        double total[4] = {0};
        for (int k = 0; k < 3; k++) m.material[k].ratio_excess = excess[k];
        struct solid *s = mixed(&m);
        shake(s, 1e-3);
        check_derivative(s, 1e-5, noise);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) {
                const double force = solid_density(s, h) * s->volume[h] * s->a[c][h];
                total[c] += force;
                total[3] += fabs(force);
            }
        par_sum_array(total, 4);
        for (int c = 0; c < 3; c++) check_close(total[c] / total[3], 0, 1e-14);
        solid_free(s);
    }
}

/* Two halves of the same shear modulus and nu = 0.4 and 0.1, in a uniform shear: no dilatation, the same stress in
 * both, so no force anywhere inside, at the joint neither. With another shear modulus there is one at the joint. */
static void test_patch(void **state) {
    (void)state;
    for (int same = 0; same < 2; same++) {
        struct mix m = {
            .sites = {30, 22, 22}, .pattern = HALVES, .at = 15, .kinds = 2, .material = {QUARTZ, QUARTZ, ORE}};
        m.material[0].ratio_excess = 0.15;
        m.material[1].ratio_excess = -0.15;
        m.material[1].youngs_modulus *= same ? 1.1 / 1.4 : 1;
        struct solid *s = mixed(&m);
        double largest = 0;
        for (int h = 0; h < s->n; h++) s->d[1][h] = 1e-8 * s->x0[0][h];
        solid_ghosts_update(s);
        solid_force(s, 0);
        for (int h = 0; h < s->n; h++) {
            double depth = 1e300;
            for (int c = 0; c < 3; c++)
                depth = fmin(depth, fmin(s->x0[c][h], m.sites[c] * SPACING - s->x0[c][h]) / SPACING);
            if (depth < 10) continue; /* the surface correction reaches three horizons */
            for (int c = 0; c < 3; c++) largest = fmax(largest, fabs(s->a[c][h]));
        }
        largest = par_max(largest) * DENSITY * SPACING / (1e-8 * YOUNG);
        if (same)
            check_below(largest, 1e-7); /* the square of the strain */
        else
            check_above(largest, 1e-3);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(segments_of_a_kind), cmocka_unit_test(layers_in_series),
                                       cmocka_unit_test(crack_in_the_layer), cmocka_unit_test(test_ratios),
                                       cmocka_unit_test(test_patch)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
