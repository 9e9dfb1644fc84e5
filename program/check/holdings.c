/* frana check: what a run holds: cells, particles, bonds, cracks, bodies, the medium, files; what it leaves out. */
#include "program/check/parts.h"
#include "base/ensure.h"
#include "base/print.h"
#include "coupling/control/blocked.h"
#include "coupling/control/piston.h"
#include "coupling/control/contact_warning.h"
#include "coupling/control/unbonded.h"
#include "coupling/interface/crack_outlets.h"
#include "coupling/interface/deposit.h"
#include "coupling/interface/outside.h"
#include "cracks/measure.h"
#include "physics/consolidation.h"
#include "program/check/injection.h"
#include "program/output/amount.h"
#include "program/output/left_out.h"
#include "solid/bonds/family.h"
#include "solid/imposed/constraint.h"
#include "solid/law/material.h"

#include <math.h>

static const char *model_name(enum physics_model model) {
    switch (model) {
    case PHYSICS_3D:
        return "3D";
    case PHYSICS_PLANE_STRESS:
        return "plane stress";
    case PHYSICS_PLANE_STRAIN:
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

static void print_perturbed(const struct solid *s) {
    const struct solid_input *in = &s->in;
    for (int b = 0; b < in->bodies; b++) {
        const struct solid_body *body = &in->body[b];
        if (body->perturbation == 0) continue;
        print("  perturbed  the particles of %s by up to %g spacings in each direction, seed %d\n", body->name,
              body->perturbation, body->perturbation_seed);
    }
}

static void print_outside(const struct run *r) {
    char sentence[OUTSIDE_SENTENCE];
    for (int b = 0; b < r->solid->in.bodies; b++)
        if (outside_of(r->solid, b, r->fluid != NULL, sentence)) print("  warning: %s\n", sentence);
}

/* Cracks that cut particles off, bodies that burst or pass through one another. */
static void print_contact(struct run *r) {
    char loose[UNBONDED_SENTENCE], sentence[CONTACT_WARNING_MAX][CONTACT_WARNING_SENTENCE];
    if (unbonded_of(r, loose)) print("  warning: %s\n", loose);
    for (int k = 0, n = contact_warning_of(r, sentence); k < n; k++) print("  warning: %s\n", sentence[k]);
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
static void print_outlets(const struct run *r) {
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
    print("  crack fluid  in %.0f particles with broken bonds, %.4g m2 of cracks; least aperture %.3g m\n",
          v.wet_particles, v.area, c->least_aperture);
    if (c->in.porous) print_pores(c);
    if (r->crack_outlets) print_outlets(r);
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

/* The sides that particles do not pass. */
static void print_walls(const struct solid *s) {
    if (!s->walls) return;
    print("  walls     ");
    for (int c = 0; c < s->dim; c++)
        for (int high = 0; high < 2; high++)
            if (s->in.wall[c][high]) print(" %c_%s", "xyz"[c], high ? "high" : "low");
    print(" stop particles, without friction\n");
}

static void print_fields(const struct run *r) {
    if (r->scene->output.fields_every == 0) return;
    print("  fields     every %ld steps, %ld times, about %.3g MB each\n", r->scene->output.fields_every,
          amount_fields(r), 1e-6 * amount_fields_bytes(r));
}

void check_holdings_print(struct run *r) {
    char sentence[LEFT_OUT_MAX][LEFT_OUT_SENTENCE], blocked[BLOCKED_MAX][BLOCKED_SENTENCE], piston[PISTON_SENTENCE];
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
    if (r->solid) print_walls(r->solid);
    print_crack_fluid(r);
    check_injection_print(r);
    if (r->solid) print_on_surface(r->solid);
    if (r->solid) print_perturbed(r->solid);
    if (r->solid) print_outside(r);
    if (r->solid) print_contact(r);
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
    if (piston_of(r, piston)) print("  warning: %s\n", piston);
    print("\nleaves out\n");
    const int n = left_out_of(r->scene, sentence);
    for (int k = 0; k < n; k++) print("  %s\n", sentence[k]);
    if (n == 0) print("  nothing\n");
}
