/* frana check: prints parts of the run, stable steps and their limits, memory, dimensionless groups, costs. Takes
 * no step, unless it is to measure some. */
#include "program/check/check.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/control/blocked.h"
#include "coupling/control/overstep.h"
#include "coupling/interface/crack_outlets.h"
#include "coupling/interface/deposit.h"
#include "coupling/interface/outside.h"
#include "coupling/march.h"
#include "coupling/run.h"
#include "coupling/setup/forecast.h"
#include "coupling/step.h"
#include "cracks/measure.h"
#include "fluid/scheme.h"
#include "physics/consolidation.h"
#include "physics/waves.h"
#include "program/check/injection.h"
#include "program/check/image.h"
#include "program/check/sizes.h"
#include "program/check/costs.h"
#include "program/output/amount.h"
#include "program/output/outputs.h"
#include "program/output/left_out.h"
#include "solid/bonds/family.h"
#include "solid/contact/contact.h"
#include "solid/contact/implicit.h"
#include "solid/imposed/constraint.h"
#include "solid/law/material.h"
#include "solid/refine/refine.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "solid/step/stable.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

/* Rank 0 prints. */
static void print(const char *format, ...) __attribute__((format(printf, 1, 2)));
static void print(const char *format, ...) {
    if (par_rank() != 0) return;
    va_list args;
    va_start(args, format);
    vprintf(format, args);
    va_end(args);
}

static const char *model_name(enum solid_model model) {
    switch (model) {
    case SOLID_3D:
        return "3D";
    case SOLID_PLANE_STRESS:
        return "plane stress";
    case SOLID_PLANE_STRAIN:
        return "plane strain";
    }
    ENSURE(0, "model %d", (int)model);
}

static void print_border(const struct solid *s, const char *key, int k, const double low[3], const double high[3],
                         const struct solid_turn *turn) {
    const long on = solid_constraint_on_border(s, low, high, turn);
    if (on > 0) print("  warning: %ld particles lie on the border of solid.%s[%d]; they count as inside\n", on, key, k);
}

/* Lattice points that a small change of a size would move in or out. */
static void print_on_surface(const struct solid *s) {
    const struct solid_input *in = &s->in;
    for (int b = 0; b < in->bodies; b++)
        if (in->body[b].on_surface > 0)
            print("  warning: %ld lattice points lie on the surface of %s; they count as inside. Sizes that move the "
                  "surface by %.3g m avoid this\n",
                  in->body[b].on_surface, in->body[b].name, 0.5 * in->body[b].surface_gap);
    for (int k = 0; k < in->constraints; k++)
        print_border(s, "constraints", k, in->constraint[k].low, in->constraint[k].high, &in->constraint[k].turn);
    for (int k = 0; k < in->unbreakables; k++)
        print_border(s, "unbreakable", k, in->unbreakable[k].low, in->unbreakable[k].high, &in->unbreakable[k].turn);
    for (int k = 0; k < in->loads; k++)
        if (in->load[k].kind == SOLID_LOAD_REGION)
            print_border(s, "loads", k, in->load[k].low, in->load[k].high, &in->load[k].turn);
}

/* Particles that are nearer to each other than contact's radius are pushed apart as soon as the bond between them
 * breaks. */
static void print_perturbed(const struct solid *s) {
    const struct solid_input *in = &s->in;
    for (int b = 0; b < in->bodies; b++) {
        const struct solid_body *body = &in->body[b];
        if (body->perturbation == 0) continue;
        const double least = 1 - 2 * body->perturbation;
        print("  perturbed  the particles of %s by up to %g spacings in each direction, seed %d\n", body->name,
              body->perturbation, body->perturbation_seed);
        if (in->contact && in->contact_radius > least && body->shape == SOLID_POLYGON)
            print("  warning: particles of %s may be %.3g spacings apart, and solid.contact.radius is %g; those nearer "
                  "than that push each other apart when their bond breaks. A radius of %.3g avoids this\n",
                  body->name, least, in->contact_radius, least);
    }
}

static void print_outside(const struct run *r) {
    char sentence[OUTSIDE_SENTENCE];
    for (int b = 0; b < r->solid->in.bodies; b++)
        if (outside_of(r->solid, b, r->fluid != NULL, sentence)) print("  warning: %s\n", sentence);
}

/* The first body whose shapes are not bonded to one another, or NULL. */
static const char *broken_contacts(const struct solid_input *in) {
    for (int b = 0; b < in->bodies; b++)
        if (in->body[b].contacts_broken) return in->body[b].name;
    return NULL;
}

/* Which bodies are swept in mixed precision, where the scene asks for it. */
static void print_precision(const struct solid *s) {
    if (s->in.precision == SOLID_DOUBLE || s->in.rigid) return;
    for (int b = 0; b < s->in.bodies; b++)
        print("  precision  the bonds of %s are swept in %s\n", s->in.body[b].name,
              solid_family_is_mixed(s, b) ? "mixed precision" : "double: they have lists, or several materials");
}

static void print_interfaces(const struct solid_input *in) {
    for (int k = 0; k < in->interfaces; k++)
        print("  interface  %s and %s are bonded to each other; a crack between them takes %g J/m2\n",
              in->body[in->interface[k].body[0]].name, in->body[in->interface[k].body[1]].name,
              in->interface[k].fracture_energy);
}

/* The pores, by the first body's material. */
static void print_pores(const struct cracks *c) {
    const struct solid *s = c->solid;
    const struct cracks_pores *p = &c->in.pores;
    const struct physics_consolidation rock = {s->in.material[s->in.body[0].material].youngs_modulus, 0.25, p->biot,
                                               p->modulus, p->permeability / c->in.viscosity};
    print("  pores      in all %ld particles; pressure spreads by %.4g m2/s\n", s->n_global,
          physics_consolidation_coefficient(&rock));
}

/* Where cracks are open to the flow; a warning where empty ones hold together by themselves. */
static void print_mouths(const struct run *r) {
    const struct solid *s = r->solid;
    double least = INFINITY;
    print("  mouths     at %ld of the interface's particles\n", crack_outlets_count(r));
    for (int m = 0; m < s->in.materials; m++) {
        const struct solid_material *k = &s->in.material[m];
        const double s0 =
            solid_material_constants(s->in.model, s->in.thickness, k, k->horizon_ratio * s->in.spacing).s0;
        least = fmin(least, k->youngs_modulus * s0);
    }
    if (-r->cracks->in.least_pressure > least)
        print("  crack_fluid.least_pressure: an empty crack holds together with %.3g times the strength E s0\n",
              -r->cracks->in.least_pressure / least);
}

/* The fluid in cracks, and the particles that each injection enters by. */
static void print_crack_fluid(const struct run *r) {
    const struct cracks *c = r->cracks;
    if (!c) return;
    const struct cracks_values v = cracks_measure(c);
    print("  crack fluid  in %ld particles with broken bonds, %.4g m2 of cracks; least aperture %.3g m\n",
          v.wet_particles, v.area, c->least_aperture);
    if (c->in.porous) print_pores(c);
    if (r->crack_outlets) print_mouths(r);
    for (int q = 0; q < c->in.injections; q++)
        print("  injection  %s %g %s by %ld of them\n", c->in.injection[q].is_pressure ? "at a pressure of" : "of",
              c->in.injection[q].value, c->in.injection[q].is_pressure ? "Pa" : "m3/s", c->particles[q]);
}

/* The bodies that move at the start. */
static void print_moving(const struct solid_input *in) {
    for (int b = 0; b < in->bodies; b++) {
        const double *v = in->body[b].velocity;
        if (v[0] == 0 && v[1] == 0 && v[2] == 0) continue;
        print("  moving     %s, at the start with (%g, %g", in->body[b].name, v[0], v[1]);
        if (solid_dim(in) == 3) print(", %g", v[2]);
        print(") m/s\n");
    }
}

static void print_fields(const struct run *r) {
    if (r->scene->output.fields_every == 0) return;
    print("  fields     every %ld steps, %ld times, about %.3g MB each\n", r->scene->output.fields_every,
          amount_fields(r), 1e-6 * amount_fields_bytes(r));
}

static void print_holdings(struct run *r) {
    char sentence[LEFT_OUT_MOST][LEFT_OUT_SENTENCE], blocked[BLOCKED_MAX][BLOCKED_SENTENCE];
    print("%s\n\nholds\n", r->scene->title);
    if (r->fluid) {
        const struct fluid_grid *g = fluid_grid_of(r->fluid);
        print("  fluid      %d x %d x %d cells of %.6g x %.6g x %.6g m on %d x %d ranks\n", g->n[0], g->n[1], g->n[2],
              g->d[0], g->d[1], g->d[2], g->ranks[1], g->ranks[2]);
    }
    if (r->solid) {
        const long directed = run_directed_bonds(r);
        print("  solid      %ld particles %.6g m apart, %ld bonds\n", r->solid->n_global, r->solid->in.spacing,
              directed / 2);
        if (r->solid->dim == 2)
            print("  plate      %s, %.6g m thick\n", model_name(r->solid->in.model), r->solid->in.thickness);
        const char *contacts = broken_contacts(&r->solid->in);
        if ((r->solid->in.cuts > 0 || contacts) && r->needs.bonds) {
            solid_family_count(r->solid);
            if (contacts)
                print("  broken     %ld bonds, by %d cracks and between the shapes of %s\n", r->solid->bonds_broken,
                      r->solid->in.cuts, contacts);
            else
                print("  cracks     %d, across %ld bonds\n", r->solid->in.cuts, r->solid->bonds_broken);
        }
    }
    if (r->solid) print_precision(r->solid);
    if (r->solid) print_interfaces(&r->solid->in);
    if (r->solid) print_moving(&r->solid->in);
    print_crack_fluid(r);
    check_injection_print(r);
    if (r->solid) print_on_surface(r->solid);
    if (r->solid) print_perturbed(r->solid);
    if (r->solid) print_outside(r);
    if (r->surface)
        print("  interface  %ld particles, immersed area %.6g m2, A_h %.6g m2\n", r->surface->total,
              r->surface->immersed_area, r->surface->initial_area);
    if (r->medium) {
        deposit_update(r);
        print("  medium     porosity %.5f, connected along %c %.5f, surface %.5g 1/m\n",
              medium_measure_porosity(r->medium), "xyz"[medium_axis(r->medium)], medium_connect_porosity(r->medium),
              medium_measure_specific_surface(r->medium, r->surface->immersed_area));
        if (r->measured.why[0])
            print("  no permeability: %s\n", r->measured.why);
        else
            print("  permeability along (%g, %g, %g)\n", r->measured.along[0], r->measured.along[1],
                  r->measured.along[2]);
    }
    print_fields(r);
    for (int k = 0, n = blocked_of(r, blocked); k < n; k++) print("  warning: %s\n", blocked[k]);
    print("\nleaves out\n");
    const int n = left_out_of(r->scene, sentence);
    for (int k = 0; k < n; k++) print("  %s\n", sentence[k]);
    if (n == 0) print("  nothing\n");
}

/* Number of substeps that a contact would need, if there is none yet and the number is automatic. */
static void print_touch(struct run *r, const struct scene_stage *stage) {
    if (stage->substeps > 0 || !(r->substeps > 0)) return;
    if (!r->needs.contact || solid_contact_implicit_is(r->solid) || !solid_contact_is_possible(r->solid)) return;
    const double limit =
        solid_stable_of(&r->solid_rates, r->solid->stage.integrator, solid_contact_rate_touch(r->solid), NULL);
    const double least = ceil(r->dt / (stage->safety * limit) * (1 - 1e-12));
    if (least > r->substeps)
        print("  %s: %.0f substeps once a broken bond has closed, more as particles press on one another\n",
              stage->name, least);
}

/* Stable steps of the levels that a refinement may add, inside a body of one level only. */
static void print_levels(struct run *r) {
    const int finest = solid_refine_finest(r->solid);
    struct solid_rates rates;
    solid_rates_of(r->solid, &rates);
    for (int level = finest + 1; level <= r->scene->solid->refinement->levels; level++) {
        struct solid_rates finer = rates;
        char name[64];
        finer.stiffness = fmax(rates.stiffness, solid_refine_rate_lattice(r->solid, level));
        for (int k = 0; k < SOLID_INTEGRATORS; k++) {
            const enum solid_integrator integrator = (enum solid_integrator)k;
            snprintf(name, sizeof name, "solid, bonds of level %d, %s", level, solid_integrate_kind(integrator)->name);
            print("  %-42s %.6g\n", name, solid_stable_of(&finer, integrator, 0, NULL));
        }
    }
}

/* The largest inflow velocity or driven velocity of the scene, m/s. */
static double velocity_of(const struct scene_fluid *f) {
    double u = f->driving == SCENE_DRIVING_BULK ? fabs(f->driving_value) : 0;
    if (f->has_taylor_green) u = fabs(f->taylor_green_velocity);
    for (int c = 0; c < 3; c++) {
        u = fmax(u, fabs(f->initial_velocity[c]));
        for (int e = 0; e < 2; e++)
            u = fmax(u, fmax(fabs(f->side[c][e].bulk_velocity), fabs(f->side[c][e].velocity[c])));
    }
    return u;
}

/* A stage whose given step is so short that its flow would take more steps than any run has. */
static void print_slow(const struct run *r, const struct scene_stage *stage) {
    const double most = 1e9;
    const struct scene_fluid *f = r->scene->fluid;
    if (!f || !(stage->time_step > 0)) return;
    const double *size = r->scene->domain.size, least = fmin(size[0], fmin(size[1], size[2]));
    const double crossing = least / velocity_of(f), viscous = least * least / f->viscosity;
    const double steps = fmin(crossing, viscous) / stage->time_step;
    if (steps > most)
        print("  warning: stage %s: the run is hopeless: with a step of %.3g s the flow needs %.3g steps to cross the "
              "domain, and viscosity %.3g\n",
              stage->name, stage->time_step, crossing / stage->time_step, viscous / stage->time_step);
}

/* Of stages whose fluid is stepped by Adams and Bashforth's scheme. */
static void print_limits_of_ab2(struct run *r) {
    if (!fluid_input_of(r->fluid)->keeps_rate) return;
    fluid_scheme_set(r->fluid, FLUID_AB2);
    const struct fluid_limits l = fluid_limits_foreseen(r->fluid);
    fluid_scheme_set(r->fluid, FLUID_RK3);
    print("  %-42s %.6g\n", "fluid, AB2, viscous", l.viscous);
    print("  %-42s %.6g\n", "fluid, AB2, convective", l.convective);
}

static void print_limits(struct run *r, struct costs *costs) {
    print("\nstable steps, s\n");
    if (r->fluid) {
        const struct fluid_limits l = fluid_limits_foreseen(r->fluid);
        if (fluid_input_of(r->fluid)->implicit) {
            print("  %-42s %s\n", "fluid, viscous", "none: implicit diffusion");
            print("  %-42s %.6g\n", "fluid, an automatic step at most", l.viscous);
        } else {
            print("  %-42s %.6g\n", "fluid, viscous", l.viscous);
        }
        print("  %-42s %.6g\n", "fluid, convective (velocity of the scene)", l.convective);
        print_limits_of_ab2(r);
    }
    if (r->needs.bonds) {
        const int touches = r->needs.contact;
        const char *const name[3] = {"solid, bonds, RK3", "solid, bonds, velocity Verlet",
                                     "solid, a broken bond closed, RK3"};
        struct solid_rates rates;
        r->solid->stage = (struct solid_stage){0};
        solid_rates_of(r->solid, &rates);
        for (int k = 0; k < 2 + touches; k++)
            print("  %-42s %.6g\n", name[k],
                  solid_stable_of(&rates, k == 1 ? SOLID_VERLET : SOLID_RK3,
                                  k == 2 ? solid_contact_rate_touch(r->solid) : 0, NULL));
    }
    if (r->needs.bonds && r->solid->refine) print_levels(r);
    print("\nstages\n");
    for (r->stage = 0; r->stage < r->scene->stages; r->stage++) {
        const struct scene_stage *stage = &r->scene->stage[r->stage];
        step_begin_stage(r);
        costs_add(costs, r);
        print("  %-10s %ld steps%s", stage->name, stage->steps,
              stage->has_until ? " at most, until the permeability is steady" : "");
        if (r->dt > 0)
            print(" of %.6g s", r->dt);
        else
            print(", automatic");
        if (r->substeps > 0 && !(r->dt > 0))
            print(", %d substep%s, stable up to %.6g s (%s)", r->substeps, r->substeps > 1 ? "s" : "", r->solid_stable,
                  solid_stable_bound_name[r->solid_bound]);
        else if (r->substeps > 0)
            print(", %d substep%s of %.6g s, stable up to %.6g s (%s)", r->substeps, r->substeps > 1 ? "s" : "",
                  r->dt / r->substeps, r->solid_stable, solid_stable_bound_name[r->solid_bound]);
        print(":");
        for (int k = 0; k < r->parts; k++) print("%s %s", k ? "," : "", r->part_name[k]);
        print("\n");
        char sentence[OVERSTEP_MAX][OVERSTEP_SENTENCE];
        for (int k = 0, n = overstep_of(r, sentence); k < n; k++) print("  warning: %s\n", sentence[k]);
        print_slow(r, stage);
        print_touch(r, stage);
    }
}

static void print_memory(void) {
    double most[MEMORY_PARTS + 1], sum = 0;
    for (int p = 0; p < MEMORY_PARTS; p++) sum += most[p] = (double)memory_bytes((enum memory_part)p);
    most[MEMORY_PARTS] = sum;
    par_max_array(most, MEMORY_PARTS + 1);
    print("\nmemory per rank, MB (largest of %d)\n", par_size());
    for (int p = 0; p < MEMORY_PARTS; p++) print("  %-10s %.1f\n", memory_name((enum memory_part)p), most[p] * 1e-6);
    const double share = par_min(forecast_share());
    print("  %-10s %.1f, and the libraries' own; of %.0f that a rank has here\n", "in all", most[MEMORY_PARTS] * 1e-6,
          share * 1e-6);
    if (most[MEMORY_PARTS] > share) print("  warning: the run needs more memory than there is: other ranks or nodes\n");
}

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
          physics_softening_widest((enum physics_model)in->model, s->youngs_modulus, s->tensile_strength, s0, delta));
}

/* A flow of which the cells hold nothing: central differences, and no model of turbulence. */
static void print_unresolved(const struct run *r, double u) {
    const double most = 1000;
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const double finest = fmin(g->d[0], fmin(g->d[1], g->d[2])), number = u * finest / r->scene->fluid->viscosity;
    if (number > most)
        print("  warning: the Reynolds number of a cell, U d/nu, is %.3g: the run is hopeless, because viscosity acts "
              "only on lengths far below a cell and there is no model of turbulence. Make it less than %g by smaller "
              "cells, a larger viscosity or a lower velocity\n",
              number, most);
}

static void print_groups(const struct run *r) {
    const struct scene *scene = r->scene;
    const struct scene_fluid *f = scene->fluid;
    const double u = f ? velocity_of(f) : 0, h = scene->domain.size[1];
    print("\ngroups\n");
    if (u > 0) print("  Re = U h/nu = %.5g (U = %.4g m/s, h = %.4g m)\n", u * h / f->viscosity, u, h);
    if (u > 0) print_unresolved(r, u);
    for (int m = 0; scene->solid && m < scene->solid->materials; m++) {
        const struct scene_material *s = &scene->solid->material[m];
        const struct solid_material *material = &r->solid->in.material[m];
        const struct solid_input *in = &r->solid->in;
        const enum physics_model model = (enum physics_model)in->model;
        const struct physics_waves c =
            physics_waves_of(model, s->youngs_modulus, physics_model_poisson_ratio(model), s->density);
        const double s0 =
            solid_material_constants(in->model, in->thickness, material, s->horizon_ratio * in->spacing).s0;
        if (f) print("  %s: rho_s/rho_f = %.5g\n", s->name, s->density / f->density);
        if (u > 0) print("  %s: E/(rho_f U2) = %.5g\n", s->name, s->youngs_modulus / (f->density * u * u));
        if (s->s00 > 0)
            print("  %s: s0 = %.6g - %.6g times the smallest stretch of a particle's bonds in the step before\n",
                  s->name, s->s00, s->alpha);
        else if (!isfinite(s0))
            print("  %s: no fracture_energy: its bonds do not break\n", s->name);
        else
            print("  %s: s0 = %.6g, sigma0 = E s0 = %.6g Pa\n", s->name, s0, s->youngs_modulus * s0);
        if (material->tensile_strength > 0) print_softening(in, material, s, s0);
        print("  %s: sqrt(E/rho_s) = %.6g m/s; waves: longitudinal %.6g, shear %.6g, Rayleigh's %.6g m/s\n", s->name,
              sqrt(s->youngs_modulus / s->density), c.longitudinal, c.shear, c.rayleigh);
    }
}

/* Memory of a run by its size, GB: 464 bytes a particle with its bonds, and 18 more where a body is of several
 * materials; 200 a particle at rest while it is made, measured with samples of rock; 260 a cell of the fluid, an
 * estimate. */
static double gigabytes_of(const struct scene *scene, double particles) {
    const int bonds = setup_needs_of(scene).bonds;
    double cells = scene->fluid ? 1 : 0, bytes = bonds ? 464 : 200;
    for (int c = 0; c < 3; c++) cells *= scene->domain.cells[c];
    for (int b = 0; scene->solid && b < scene->solid->bodies; b++)
        if (bonds && scene->solid->body[b].image.kinds > 1) bytes = 464 + 18;
    return 1e-9 * (bytes * particles + 260 * cells);
}

/* Whether a body of an image makes the run larger than this machine's memory for so many ranks; if so, says it. */
static int is_too_large(const struct scene *scene, double particles) {
    const double share = 1e-9 * par_min(forecast_share());
    const double needed = gigabytes_of(scene, particles) / par_size();
    if (particles == 0 || share >= needed) return 0;
    print(
        "\nThe run needs some %.3g GB a rank on %d ranks; this machine has %.3g GB a rank. Stable steps and what else "
        "needs the particles is left out: check the scene on more ranks, or a crop of the image.\n",
        needed, par_size(), share);
    return 1;
}

int check_scene(const struct command *c, const struct scene *scene) {
    const double particles = check_image(c, scene);
    if (is_too_large(scene, particles)) return EXIT_CODE_DONE;
    struct run *r = run_new(scene);
    struct costs costs = {0};
    struct outputs *outputs = outputs_new(r); /* dies on what does not fit; they take memory */
    struct march *march = march_new(r);       /* the kept state takes memory */
    print_holdings(r);
    print_limits(r, &costs);
    print_memory();
    march_free(march);
    print_groups(r);
    costs_print(&costs, r, outputs, c->out, c->measure);
    check_sizes_print(r);
    outputs_free(outputs);
    run_free(r);
    return EXIT_CODE_DONE;
}
