/* The bilinear law's stretches: limits, energy, strength, and the peak of the stress against sums by another method. */
#include "physics/bond.h"
#include "physics/dilatation.h"
#include "physics/softening.h"
#include "tests/check.h"

/* The peaks by a separate computation: 1000 directions, 400 equal steps of strain, the lateral strain by bisection; its
 * steps resolve a peak to 0.4 %. */
static void peaks(void **state) {
    (void)state;
    static const struct {
        double ratio, space, plate;
    } row[] = {{1.2, 1.038, 1.003}, {1.5, 1.084, 1.014}, {2, 1.143, 1.035}, {3, 1.225, 1.070},
               {6, 1.356, 1.135},   {10, 1.445, 1.183},  {20, 1.552, 1.242}};
    double last[2] = {1, 1};
    for (size_t k = 0; k < sizeof row / sizeof row[0]; k++) {
        const double space = physics_softening_peak(PHYSICS_3D, row[k].ratio, 0),
                     plate = physics_softening_peak(PHYSICS_PLANE_STRESS, row[k].ratio, 0);
        check_relative(space, row[k].space, 4e-3);
        check_relative(plate, row[k].plate, 4e-3);
        check_equal(physics_softening_peak(PHYSICS_PLANE_STRAIN, row[k].ratio, 0), plate);
        check_above(space, last[0]);
        check_above(plate, last[1]);
        last[0] = space;
        last[1] = plate;
    }
    check_equal(physics_softening_peak(PHYSICS_3D, 1, 0), 1);
    check_close(physics_softening_peak(PHYSICS_3D, 1.0001, 0), 1, 1e-3);
}

/* With a dilatation, by another method: the lateral strain that makes the largest axial strain's energy least, found by
 * golden section of the energy itself, and the stress as its derivative at fixed shares. */
enum { MANY = 200 };

struct body {
    int space;
    double s_c, beyond, most[MANY];
};

static double cosine2(const struct body *b, int i) {
    const double part = (i + 0.5) / MANY;
    return b->space ? part * part : cos(0.5 * M_PI * part) * cos(0.5 * M_PI * part);
}

/* Of shares f at the strains: n^2 k_b is 1. */
static double energy_at(const struct body *b, const double f[MANY], double axial, double lateral) {
    double bonds = 0, trace = 0, weight = 0;
    for (int i = 0; i < MANY; i++) {
        const double a = cosine2(b, i), s = axial * a + lateral * (1 - a);
        bonds += f[i] * s * s / MANY;
        trace += f[i] * s / MANY;
        weight += f[i] / MANY;
    }
    return 0.5 * (bonds + b->beyond * trace * trace / weight);
}

static void shares_at(const struct body *b, double axial, double lateral, double f[MANY]) {
    for (int i = 0; i < MANY; i++) {
        const double a = cosine2(b, i), most = fmax(b->most[i], axial * a + lateral * (1 - a));
        f[i] = most <= 1 ? 1 : most >= b->s_c ? 0 : (b->s_c - most) / ((b->s_c - 1) * most);
    }
}

static double peak_of(struct body *b) {
    double f[MANY], most = 0, elastic = 0;
    memset(b->most, 0, sizeof b->most);
    for (double axial = 0.5; axial < b->s_c; axial *= 1.015) {
        double low = -axial, high = axial;
        for (int k = 0; k < 40; k++) { /* the lateral stress is 0 */
            const double middle = 0.5 * (low + high), d = 1e-4;
            shares_at(b, axial, middle, f);
            if (energy_at(b, f, axial, middle + d) > energy_at(b, f, axial, middle - d))
                high = middle;
            else
                low = middle;
        }
        shares_at(b, axial, low, f);
        const double stress = (energy_at(b, f, axial + 1e-4, low) - energy_at(b, f, axial - 1e-4, low)) / 2e-4;
        if (axial < 0.51) elastic = stress / axial;
        most = fmax(most, stress);
        for (int i = 0; i < MANY; i++) b->most[i] = fmax(b->most[i], axial * cosine2(b, i) + low * (1 - cosine2(b, i)));
    }
    return most / elastic;
}

static void peaks_beyond(void **state) {
    (void)state;
    static const double ratios[] = {-0.5, 0, 0.1, 0.4, 0.45};
    struct body body;
    for (int space = 0; space < 2; space++)
        for (int k = 0; k < 5; k++)
            for (double ratio = 1.5; ratio < 10; ratio *= 2) {
                const enum physics_model model = space ? PHYSICS_3D : PHYSICS_PLANE_STRESS;
                const double excess = ratios[k] - physics_model_poisson_ratio(model);
                const struct physics_dilatation d = physics_dilatation_of(model, 1, excess);
                body.space = space;
                body.s_c = ratio;
                body.beyond = d.bulk_modulus / physics_dilatation_of(model, d.bonds_modulus, 0).bulk_modulus - 1;
                check_relative(physics_softening_peak(model, ratio, body.beyond), peak_of(&body), 5e-3);
            }
}

/* A brittle material of this fracture energy has the strength: in a bar's E', with any Poisson's ratio. */
static void brittle_energy(void **state) {
    (void)state;
    for (enum physics_model model = PHYSICS_3D; model <= PHYSICS_PLANE_STRAIN; model++)
        for (int k = 0; k < 3; k++) {
            const double excess = 0.1 * (k - 1), nu = physics_model_poisson_ratio(model) + excess, young = 3e10,
                         modulus = model == PHYSICS_PLANE_STRAIN ? young / (1 - nu * nu) : young;
            const double energy = physics_softening_brittle_energy(model, PHYSICS_CONSTANT, young, excess, 4e6, 0.01);
            check_relative(modulus * physics_bond_elastic(model, PHYSICS_CONSTANT, 1, young, excess, energy, 0.01).s0,
                           4e6, 1e-12);
            check_relative(physics_softening_widest(model, young, excess, 4e6, 4e6 / modulus, 0.01), 0.01, 1e-12);
        }
}

/* The two conditions, at horizons up to the widest one, where the two stretches meet; none beyond. */
static void stretches(void **state) {
    (void)state;
    const double young = 3e10, energy = 70, strength = 4e6;
    for (enum physics_model model = PHYSICS_3D; model <= PHYSICS_PLANE_STRAIN; model++) {
        const double modulus = model == PHYSICS_PLANE_STRAIN ? young * 16 / 15 : young;
        const double first = physics_bond_of(model, PHYSICS_CONSTANT, 1, young, energy, 1).s0;
        const double widest = physics_softening_widest(model, young, 0, strength, first, 1);
        double last = 0;
        for (int k = -1; k < 6; k++) {
            const double delta = widest * (k < 0 ? 1.001 : ldexp(0.999, -k));
            const double s0 = physics_bond_of(model, PHYSICS_CONSTANT, 1, young, energy, delta).s0;
            const struct physics_softening soft = physics_softening_of(model, young, 0, strength, s0);
            check_relative(physics_softening_widest(model, young, 0, strength, s0, delta), widest, 1e-12);
            if (k < 0) {
                check_equal(soft.s_e, 0);
                check_equal(soft.s_c, 0);
                continue;
            }
            check_relative(soft.s_e * soft.s_c, s0 * s0, 1e-12);
            check_relative(modulus * soft.s_e * physics_softening_peak(model, soft.s_c / soft.s_e, 0), strength, 1e-3);
            check_above(soft.s_c / soft.s_e, last); /* the narrower the horizon, the more ductile a bond */
            last = soft.s_c / soft.s_e;
            if (k == 0) check_close(last, 1, 0.03);
        }
    }
    /* in plane stress the limit is 4 pi/9 of the characteristic length, in 3D 5/6 */
    const double length = young * energy / (strength * strength);
    const double plate = physics_bond_of(PHYSICS_PLANE_STRESS, PHYSICS_CONSTANT, 1, young, energy, 1).s0,
                 space = physics_bond_of(PHYSICS_3D, PHYSICS_CONSTANT, 1, young, energy, 1).s0;
    check_relative(physics_softening_widest(PHYSICS_PLANE_STRESS, young, 0, strength, plate, 1), 4 * M_PI / 9 * length,
                   1e-12);
    check_relative(physics_softening_widest(PHYSICS_3D, young, 0, strength, space, 1), 5. / 6 * length, 1e-12);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(peaks), cmocka_unit_test(peaks_beyond),
                                       cmocka_unit_test(brittle_energy), cmocka_unit_test(stretches)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
