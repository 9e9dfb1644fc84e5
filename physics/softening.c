/* The two stretches of the bilinear bond law, from the peak of the stress of a uniformly stretched body. */
#include "physics/softening.h"
#include "base/ensure.h"
#include "physics/bond.h"
#include "physics/dilatation.h"

#include <math.h>

enum { DIRECTIONS = 128, STEPS = 200, TURNS = 30 };

/* Directions of bonds, alike in all: cos^2 of the angle to the axis of the load, and the largest stretch so far. */
struct family {
    double axial[DIRECTIONS], most[DIRECTIONS];
    double s_c;    /* s_e = 1 */
    double beyond; /* k/k_b - 1 */
};

static struct family family_of(enum physics_model model, double s_c, double beyond) {
    struct family f = {.s_c = s_c, .beyond = beyond};
    for (int i = 0; i < DIRECTIONS; i++) {
        const double part = (i + 0.5) / DIRECTIONS;
        switch (model) {
        case PHYSICS_3D: /* uniform in the cosine */
            f.axial[i] = part * part;
            break;
        case PHYSICS_PLANE_STRESS:
        case PHYSICS_PLANE_STRAIN: /* uniform in the angle */
            f.axial[i] = cos(0.5 * M_PI * part) * cos(0.5 * M_PI * part);
            break;
        }
    }
    return f;
}

struct stress {
    double axial, lateral;
};

/* The mean over the directions, at these two strains; over n^2 k_b, n dimensions. With a for the cosine squared, f for
 * the share of its stiffness that a bond has kept, and means over the directions, the energy is
 *     1/2 n^2 [k_b <f s^2> + (k - k_b) <f s>^2/<f>],
 * the second term of the dilatation n <f s>/<f>, whose weight M/M_0 is <f> (solid/force/dilatation.h). */
static struct stress stress_of(const struct family *f, double axial, double lateral) {
    struct stress sum = {0, 0}, weight = {0, 0};
    double stretch[DIRECTIONS], share[DIRECTIONS];
    for (int i = 0; i < DIRECTIONS; i++) {
        const double a = f->axial[i], s = axial * a + lateral * (1 - a), most = s > f->most[i] ? s : f->most[i];
        const double left = (f->s_c - most) / ((f->s_c - 1) * most);
        stretch[i] = s;
        share[i] = most <= 1 ? 1 : most >= f->s_c ? 0 : left;
    }
    for (int i = 0; i < DIRECTIONS; i++) {
        const double a = f->axial[i];
        sum.axial += share[i] * stretch[i] * a / DIRECTIONS;
        sum.lateral += share[i] * stretch[i] * (1 - a) / DIRECTIONS;
        weight.axial += share[i] * a / DIRECTIONS;
        weight.lateral += share[i] * (1 - a) / DIRECTIONS;
    }
    if (f->beyond == 0) return sum;
    const double trace = sum.axial + sum.lateral, all = weight.axial + weight.lateral;
    const double pressure = all > 0 ? f->beyond * trace / all : 0;
    return (struct stress){sum.axial + pressure * weight.axial, sum.lateral + pressure * weight.lateral};
}

/* The lateral strain without a lateral stress; below Poisson's ratio 0 it may be above 0. */
static double lateral_of(const struct family *f, double axial) {
    double low = -axial, high = f->beyond < 0 ? axial : 0;
    for (int k = 0; k < TURNS; k++) {
        const double middle = 0.5 * (low + high);
        if (stress_of(f, axial, middle).lateral < 0)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

/* Strain is raised in steps from 1, where the first bonds begin to soften; behind the peak the stress falls. */
double physics_softening_peak(enum physics_model model, double ratio, double beyond) {
    if (!(ratio > 1)) return 1;
    struct family f = family_of(model, ratio, beyond);
    const double elastic = stress_of(&f, 1e-3, lateral_of(&f, 1e-3)).axial / 1e-3;
    double most = elastic;
    for (int k = 0; k <= STEPS; k++) {
        const double strain = pow(ratio, (double)k / STEPS), lateral = lateral_of(&f, strain);
        const double now = stress_of(&f, strain, lateral).axial;
        if (now < 0.9 * most) break;
        most = fmax(most, now);
        for (int i = 0; i < DIRECTIONS; i++)
            f.most[i] = fmax(f.most[i], strain * f.axial[i] + lateral * (1 - f.axial[i]));
    }
    return most / elastic;
}

/* Young's modulus of a bar that lies in the plane. */
static double modulus_of(enum physics_model model, double youngs_modulus, double ratio_excess) {
    const double nu = physics_model_poisson_ratio(PHYSICS_PLANE_STRAIN) + ratio_excess;
    switch (model) {
    case PHYSICS_3D:
    case PHYSICS_PLANE_STRESS:
        return youngs_modulus;
    case PHYSICS_PLANE_STRAIN:
        return youngs_modulus / (1 - nu * nu);
    }
    ENSURE(0, "model %d", (int)model);
}

/* peak(s0^2/s_e^2) s_e rises with s_e, and the peak is at least 1: s_e is found from above, where it is largest. */
static double beyond_of(enum physics_model model, double youngs_modulus, double ratio_excess) {
    if (ratio_excess == 0) return 0;
    const struct physics_dilatation k = physics_dilatation_of(model, youngs_modulus, ratio_excess);
    return k.bulk_modulus / physics_dilatation_of(model, k.bonds_modulus, 0).bulk_modulus - 1;
}

struct physics_softening physics_softening_of(enum physics_model model, double youngs_modulus, double ratio_excess,
                                              double tensile_strength, double s0) {
    const double strain = tensile_strength / modulus_of(model, youngs_modulus, ratio_excess),
                 beyond = beyond_of(model, youngs_modulus, ratio_excess);
    double s_e = strain;
    if (!(strain < s0)) return (struct physics_softening){0, 0};
    for (int k = 0; k < TURNS; k++) {
        const double last = s_e;
        s_e = strain / physics_softening_peak(model, s0 * s0 / (s_e * s_e), beyond);
        if (fabs(s_e - last) < 1e-9 * s_e) break;
    }
    return (struct physics_softening){s_e, s0 * s0 / s_e};
}

double physics_softening_brittle_energy(enum physics_model model, enum physics_micromodulus kind, double youngs_modulus,
                                        double ratio_excess, double tensile_strength, double delta) {
    const double s0 = tensile_strength / modulus_of(model, youngs_modulus, ratio_excess),
                 of_one = physics_bond_elastic(model, kind, 1, youngs_modulus, ratio_excess, 1, delta).s0;
    return (s0 / of_one) * (s0 / of_one); /* s0^2 is proportional to G0 */
}

double physics_softening_widest(enum physics_model model, double youngs_modulus, double ratio_excess,
                                double tensile_strength, double s0, double delta) {
    const double ratio = s0 * modulus_of(model, youngs_modulus, ratio_excess) / tensile_strength;
    return delta * ratio * ratio;
}
