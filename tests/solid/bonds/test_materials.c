/* Several materials in one lattice body: forces, energies, limits and densities of both ends of each bond; the same
 * bits as one material where the numbers are the same. */
#include "tests/solid/bonds/mix.h"

static const struct mix table[] = {
    {.sites = {17, 11, 10}, .pattern = GRAINS, .material = {QUARTZ, CLAY, ORE}, .kinds = 3},
    {.sites = {13, 8, 9}, .pattern = RANDOM, .periodic = {1, 1, 0}, .material = {CLAY, ORE, QUARTZ}, .kinds = 3},
    {.sites = {24, 7, 8}, .pattern = HALVES, .at = 11, .material = {QUARTZ, CLAY, ORE}, .kinds = 2}};
enum { TABLE = sizeof table / sizeof *table };

/* Accelerations, damping's power and strain energy by scalar sums over each family. */
static void sums_over_families(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int t = 0; t < TABLE; t++)
        for (int large = 0; large < 2; large++) {
            if (check_skips(t + large, 1)) continue; /* in a debug build half of them */
            const struct mix *m = &table[t];
            struct solid *s = mixed(m);
            const double damping = 1e9;
            s->stage.damping_relative = damping; /* so that the ghosts' velocities are current */
            shake(s, large ? 3e-2 : 1e-4);
            solid_force_bonds(s, 0, damping);
            double worst = 0, most = 0, strain = 0, power = 0, net[3] = {0}, all = 0;
            for (int h = 0; h < s->n; h++) {
                const int own = kind_of(m, s, h);
                double a[3] = {0};
                check_equal(solid_particle_material(s, h), own);
                check_close(solid_density(s, h), m->material[own].density, 0);
                solid_family_view(s, h, &view);
                for (int b = 0; b < view.n; b++) {
                    double c0, s0, zeta[3], closing = 0;
                    bond_of(m, own, kind_of(m, s, view.l[b]), &c0, &s0);
                    check_relative(view.micro[b], c0, 1e-14);
                    const double stretch = stretch_of(s, h, &view, b), length = length_of(view.xi[b]),
                                 now = length * (1 + stretch);
                    for (int c = 0; c < 3; c++) {
                        zeta[c] = view.xi[b][c] + s->d[c][view.l[b]] - s->d[c][h];
                        closing += (s->v[c][view.l[b]] - s->v[c][h]) * zeta[c] / now;
                    }
                    const double elastic = view.alpha[b] * c0 * stretch * view.weight[b],
                                 viscous = damping * closing * view.weight[b];
                    for (int c = 0; c < 3; c++) a[c] += (elastic + viscous) * zeta[c] / now / solid_density(s, h);
                    strain += 0.25 * view.alpha[b] * c0 * stretch * stretch * length * view.weight[b] * s->volume[h];
                    power += 0.5 * viscous * closing * s->volume[h];
                }
                for (int c = 0; c < 3; c++) {
                    const double force = solid_density(s, h) * s->volume[h] * s->a[c][h];
                    worst = check_worst(worst, a[c] - s->a[c][h]);
                    most = check_worst(most, a[c]);
                    net[c] += force;
                    all += fabs(force);
                }
            }
            check_at_most(par_max(worst), 1e-10 * par_max(most));
            check_relative(solid_energy_measure(s).strain, par_sum(strain), 1e-9);
            check_relative(par_sum(s->power_damped), par_sum(power), 1e-9);
            for (int c = 0; c < 3; c++) check_at_most(fabs(par_sum(net[c])), 1e-12 * par_sum(all));
            double *energy = malloc((size_t)(2 * s->n + 1) * sizeof *energy), sum = 0;
            solid_energy_bonds(s, energy, energy + s->n);
            for (int h = 0; h < s->n; h++) sum += energy[h] * s->volume[h];
            check_relative(par_sum(sum), par_sum(strain), 1e-9);
            free(energy);
            solid_free(s);
        }
}

/* What a body of one material has, and one of several whose numbers are the same: every bit. */
static void equal_numbers(void **state) {
    (void)state;
    for (int t = 0; t < TABLE; t++) {
        struct mix m = table[t];
        for (int k = 0; k < 3; k++) m.material[k] = quartz;
        struct solid *two = mixed(&m), *one;
        m.pattern = ONE;
        one = mixed(&m);
        check_equal(one->material == NULL, 1);
        check_equal(two->material != NULL, 1);
        check_equal(one->n, two->n);
        struct solid *const both[] = {one, two};
        double(*stress[2])[6];
        struct solid_energy energy[2];
        struct solid_rates rates[2];
        for (int k = 0; k < 2; k++) {
            both[k]->stage.damping_relative = 1e9;
            solid_rates_of(both[k], &rates[k]);
            both[k]->stage.breakage = 1;
            shake(both[k], 6e-4);
            solid_force(both[k], 1);
            solid_ghosts_update(both[k]);
            solid_family_count(both[k]);
            stress[k] = calloc((size_t)both[k]->n + 1, sizeof *stress[k]);
            solid_stress_measure(both[k], stress[k]);
            energy[k] = solid_energy_measure(both[k]);
        }
        check_above(one->bonds_broken, 100);
        check_equal(one->bonds_broken, two->bonds_broken);
        check_equal(memcmp(&rates[0], &rates[1], sizeof rates[0]), 0);
        check_equal(energy[0].strain == energy[1].strain && energy[0].kinetic == energy[1].kinetic, 1);
        check_equal(one->e_fracture == two->e_fracture && one->crack_area == two->crack_area, 1);
        for (int h = 0; h < one->n; h++) {
            for (int c = 0; c < 3; c++) check_equal(one->a[c][h] == two->a[c][h], 1);
            for (int c = 0; c < 6; c++) check_relative(stress[0][h][c], stress[1][h][c], 1e-12);
        }
        for (int k = 0; k < 2; k++) {
            free(stress[k]);
            solid_free(both[k]);
        }
    }
}

/* The body is stretched along x: bonds break beyond the limit of their two ends, and no others. */
static void limits(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int t = 0; t < TABLE; t++)
        for (int tough = 0; tough < 2; tough++) {
            if (check_skips(t + tough, 2)) continue;
            struct mix m = table[t];
            if (tough) m.material[0].fracture_energy = INFINITY;
            m.periodic[0] = 0;
            struct solid *s = mixed(&m);
            double low = INFINITY, high = 0;
            for (int k = 0; k < m.kinds; k++) {
                const double s0 = solid_material_critical_stretch(&m.material[k], SPACING);
                low = fmin(low, s0);
                high = fmax(high, isfinite(s0) ? s0 : 0);
            }
            double energy = 0, area = 0;
            long broken = 0;
            for (int turn = 0; turn < 5; turn++) {
                const double stretch = 0.87 * low + turn / 4. * (1.11 * high - 0.87 * low);
                for (int h = 0; h < s->n; h++) s->d[0][h] = stretch * s->x0[0][h];
                solid_ghosts_update(s);
                for (int h = 0; h < s->n; h++) {
                    solid_family_view(s, h, &view);
                    for (int b = 0; b < view.n; b++) {
                        const int own = kind_of(&m, s, h), other = kind_of(&m, s, view.l[b]);
                        double c0, s0, now = stretch_of(s, h, &view, b);
                        bond_of(&m, own, other, &c0, &s0);
                        if (!view.intact[b] || !(now > s0)) continue;
                        const double held =
                            0.25 * view.alpha[b] * c0 * length_of(view.xi[b]) * view.weight[b] * s->volume[h];
                        energy += held * now * now;
                        area +=
                            held * s0 * s0 * 2 / (m.material[own].fracture_energy + m.material[other].fracture_energy);
                        broken++;
                    }
                }
                solid_force(s, 1);
                solid_force(s, 1); /* bonds break before the forces are computed */
                solid_ghosts_update(s);
                for (int h = 0; h < s->n; h++) {
                    solid_family_view(s, h, &view);
                    for (int b = 0; b < view.n; b++) {
                        double c0, s0;
                        bond_of(&m, kind_of(&m, s, h), kind_of(&m, s, view.l[b]), &c0, &s0);
                        check_equal(!view.intact[b], !view.intact[b] || stretch_of(s, h, &view, b) > s0);
                    }
                }
                solid_family_count(s);
                check_equal(2 * s->bonds_broken, par_sum_long(broken));
            }
            check_above(s->bonds_broken, 1000);
            check_relative(par_sum(s->e_fracture), par_sum(energy), 1e-10);
            check_relative(par_sum(s->crack_area), par_sum(area), 1e-10);
            solid_free(s);
        }
}

/* Two halves are moved apart: crack_area is the border's area times the lattice's factor, as within one material. */
static void border(void **state) {
    (void)state;
    const struct mix m = {.sites = {20, 8, 8},
                          .periodic = {0, 1, 1},
                          .pattern = HALVES,
                          .at = 9,
                          .material = {quartz, clay, ore},
                          .kinds = 2};
    struct solid *s = mixed(&m);
    for (int h = 0; h < s->n; h++) s->d[0][h] = kind_of(&m, s, h) ? 0.1 * SPACING : 0;
    solid_ghosts_update(s);
    const double held = solid_energy_measure(s).strain;
    solid_force(s, 1);
    solid_family_count(s);
    check_close(par_sum(s->crack_area) / (64 * SPACING * SPACING), 1.0131175, 2e-5);
    check_relative(par_sum(s->e_fracture), held, 1e-12);
    check_close(solid_energy_measure(s).strain, 0, 0);
    solid_free(s);
}

/* Mass, momentum, kinetic energy, weight and fragments take each particle's density. */
static void densities(void **state) {
    (void)state;
    for (int t = 0; t < TABLE; t++) {
        struct mix m = table[t];
        m.body_force[1] = -9.81;
        struct solid *s = mixed(&m);
        struct solid_motion motion;
        struct solid_fragment *fragment;
        long *id = malloc(((size_t)s->n + 1) * sizeof *id);
        double mass = 0, momentum = 0, kinetic = 0;
        shake(s, 0);
        for (int h = 0; h < s->n; h++) {
            const double own = m.material[kind_of(&m, s, h)].density * s->volume[h];
            mass += own;
            momentum += own * s->v[0][h];
            for (int c = 0; c < 3; c++) kinetic += 0.5 * own * s->v[c][h] * s->v[c][h];
        }
        solid_motion_measure(s, &motion);
        check_relative(motion.mass, par_sum(mass), 1e-12);
        check_close(motion.momentum[0], par_sum(momentum), 1e-10 * par_sum(mass));
        check_relative(motion.kinetic, par_sum(kinetic), 1e-12);
        check_relative(motion.load[1], -9.81 * par_sum(mass), 1e-12);
        check_relative(solid_energy_measure(s).kinetic, par_sum(kinetic), 1e-12);
        check_equal(solid_fragments_measure(s, id, &fragment), 1);
        check_relative(fragment->mass, par_sum(mass), 1e-12);
        solid_force(s, 0);
        for (int h = 0; h < s->n; h++) check_close(s->a[1][h], -9.81, 1e-6);
        free(fragment);
        free(id);
        solid_free(s);
    }
}

/* A body that is shaken until it breaks: the energies add up as those of one material, and momentum is conserved
 * although separated particles of different density repel each other. */
static void balance(void **state) {
    (void)state;
    for (int verlet = 0; verlet < 2; verlet++) {
        struct mix m = table[0];
        m.contact = 1;
        struct solid *s = mixed(&m);
        double net[4] = {0};
        s->stage = (struct solid_stage){.integrator = verlet ? SOLID_VERLET : SOLID_RK3, .breakage = 1};
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) s->v[c][h] = 0.05 * noise(s, h, c);
        solid_ghosts_update(s);
        const double start = solid_energy_measure(s).kinetic,
                     dt = 0.05 * solid_rates_stable_step(s, s->stage.integrator);
        for (int k = 0; k < 60; k++) {
            solid_contact_update(s);
            solid_integrate(s, dt, 1);
        }
        const struct solid_energy e = solid_energy_measure(s);
        solid_family_count(s);
        const double now = e.kinetic + e.strain + e.contact + par_sum(s->e_fracture);
        print_message(
            "%s: %ld of %ld bonds broken, fracture %.3f, contact %.5f of the energy; the balance is off by %.2e\n",
            verlet ? "Verlet" : "RK3", s->bonds_broken, s->bonds_total, par_sum(s->e_fracture) / start,
            e.contact / start, now / start - 1);
        check_above(s->bonds_broken, 1000);
        check_close(now / start, 1, verlet ? 8e-3 : 5e-4); /* of one material 6e-3 and 3e-4 */
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) {
                net[c] += solid_density(s, h) * s->volume[h] * (s->v[c][h] - 0.05 * noise(s, h, c));
                net[3] += solid_density(s, h) * s->volume[h] * fabs(s->v[c][h]);
            }
        par_sum_array(net, 4);
        for (int c = 0; c < 3; c++) check_at_most(fabs(net[c]), 1e-11 * net[3]);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(sums_over_families),
                                       cmocka_unit_test(equal_numbers),
                                       cmocka_unit_test(limits),
                                       cmocka_unit_test(border),
                                       cmocka_unit_test(densities),
                                       cmocka_unit_test(balance)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
