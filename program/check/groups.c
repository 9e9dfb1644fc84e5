/* frana check: dimensionless groups, critical stretches and wave speeds. */
#include "program/check/groups.h"
#include "base/print.h"
#include "coupling/control/unresolved.h"
#include "physics/dilatation.h"
#include "physics/waves.h"
#include "solid/law/material.h"

#include <math.h>
#include <stdio.h>

/* Dynamic viscosity of water at 20 degrees C, Pa s. */
#define WATER 1.0e-3

/* The bilinear law's stretches, and how well the lattice resolves the zone in which bonds soften. */
static void print_softening(const struct solid_input *in, const struct solid_material *material,
                            const struct scene_material *s, double s0) {
    const double delta = s->horizon_ratio * in->spacing;
    const struct physics_softening k = solid_material_softening(in->model, in->thickness, material, delta);
    const double length = s->youngs_modulus * s->fracture_energy / (s->tensile_strength * s->tensile_strength);
    print("  %s: bilinear law: softens from s_e = %.6g, breaks at s_c = %.6g = %.4g s_e\n", s->name, k.s_e, k.s_c,
          k.s_c / k.s_e);
    print("  %s: characteristic length E G0/sigma_t2 = %.6g m: %.4g spacings, %.4g horizons; the horizon must be below "
          "%.6g m\n",
          s->name, length, length / in->spacing, length / delta,
          physics_softening_widest((enum physics_model)in->model, s->youngs_modulus, material->ratio_excess,
                                   s->tensile_strength, s0, delta));
}

/* No solid that a liquid or a gas flows past is so light: a thousandth is g/cm3 given for kg/m3. */
int check_groups_light(const struct scene *scene, int material, char sentence[CHECK_GROUPS_SENTENCE]) {
    const double least = 0.0099;
    if (!scene->fluid || !scene->solid) return 0;
    const struct scene_material *m = &scene->solid->material[material];
    const double ratio = m->density / scene->fluid->density;
    if (!(ratio < least)) return 0;
    snprintf(
        sentence, CHECK_GROUPS_SENTENCE,
        "solid.materials.%s.density = %g kg/m3 is %.3g of the fluid's %g kg/m3: no material is so light. Both are in "
        "kg/m3; 1 g/cm3 is 1000 kg/m3",
        m->name, m->density, ratio, scene->fluid->density);
    return 1;
}

/* Largest pressure of the sides, Pa. */
static double level_of(const struct scene_fluid *f) {
    double most = 0;
    for (int c = 0; c < 3; c++)
        for (int end = 0; end < 2; end++)
            if (f->side[c][end].type == FLUID_PRESSURE) most = fmax(most, fabs(f->side[c][end].pressure));
    return most;
}

/* The load by reaction is the difference of the pressures outside a body and of the fluid inside it (docs/theory.md).
 */
static void print_level(const struct run *r, const struct scene_material *s) {
    const double least = 1e-4; /* change of volume that is worth a line */
    if (!r->fluid || !r->reaction || !r->needs.bonds || r->cracks) return;
    const double level = level_of(r->scene->fluid),
                 strain = level * (1 - 2 * s->poisson_ratio) / s->youngs_modulus; /* along each axis */
    if (3 * strain < least) return;
    print("  %s: bodies feel differences of pressure, not its level: one of %.4g Pa all around would shrink them by "
          "%.2g %% in volume\n",
          s->name, level, 300 * strain);
}

void check_groups_print(const struct run *r) {
    const struct scene *scene = r->scene;
    const struct scene_fluid *f = scene->fluid;
    const double u = f ? unresolved_velocity(f) : 0, h = scene->domain.size[1];
    print("\ngroups\n");
    if (u > 0) print("  Re = U h/nu = %.5g (U = %.4g m/s, h = %.4g m)\n", u * h / f->viscosity, u, h);
    if (f)
        print("  nu = %.5g m2/s, mu = rho_f nu = %.5g Pa s: %.3g times water\n", f->viscosity,
              f->density * f->viscosity, f->density * f->viscosity / WATER);
    char sentence[CHECK_GROUPS_SENTENCE];
    if (unresolved_of(r, u, sentence)) print("  warning: %s\n", sentence);
    for (int m = 0; scene->solid && m < scene->solid->materials; m++) {
        const struct scene_material *s = &scene->solid->material[m];
        const struct solid_material *material = &r->solid->in.material[m];
        const struct solid_input *in = &r->solid->in;
        const enum physics_model model = (enum physics_model)in->model;
        const struct physics_waves c =
            physics_waves_of(model, s->youngs_modulus, physics_dilatation_ratio(model, s->poisson_ratio), s->density);
        const double s0 =
            solid_material_constants(in->model, in->thickness, material, s->horizon_ratio * in->spacing).s0;
        if (f) print("  %s: rho_s/rho_f = %.5g\n", s->name, s->density / f->density);
        if (check_groups_light(scene, m, sentence)) print("  warning: %s\n", sentence);
        print_level(r, s);
        if (u > 0) print("  %s: E/(rho_f U2) = %.5g\n", s->name, s->youngs_modulus / (f->density * u * u));
        if (s->s00 > 0)
            print("  %s: s0 = %.6g - %.6g times the smallest stretch of a particle's bonds in the step before\n",
                  s->name, s->s00, s->alpha);
        else if (!isfinite(s0))
            print("  %s: no fracture_energy: its bonds do not break\n", s->name);
        else
            print("  %s: s0 = %.6g, sigma0 = E s0 = %.6g Pa\n", s->name, s0, s->youngs_modulus * s0);
        if (s->toughness > 0)
            print("  %s: G0 = %.6g J/m2 by its toughness of %.6g Pa m^(1/2)\n", s->name, s->fracture_energy,
                  s->toughness);
        if (s->strength > 0 && s->breakage == SCENE_BRITTLE)
            print("  %s: G0 = %.6g J/m2 by its tensile_strength of %.6g Pa at the horizon %.6g m\n", s->name,
                  s->fracture_energy, s->strength, s->horizon_ratio * in->spacing);
        if (material->tensile_strength > 0) print_softening(in, material, s, s0);
        print("  %s: sqrt(E/rho_s) = %.6g m/s; waves: longitudinal %.6g, shear %.6g, Rayleigh's %.6g m/s\n", s->name,
              sqrt(s->youngs_modulus / s->density), c.longitudinal, c.shear, c.rayleigh);
    }
}
