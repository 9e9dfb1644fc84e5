/* frana check: stable steps, and the stages with their steps and substeps. */
#include "program/check/parts.h"
#include "base/print.h"
#include "coupling/control/overstep.h"
#include "coupling/control/ramp.h"
#include "coupling/control/timescale.h"
#include "coupling/control/braked.h"
#include "coupling/control/undamped.h"
#include "coupling/control/unresolved.h"
#include "coupling/step.h"
#include "fluid/scheme.h"
#include "program/check/costs.h"
#include "solid/contact/contact.h"
#include "solid/contact/implicit.h"
#include "solid/refine/refine.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "solid/step/stable.h"

#include <math.h>
#include <stdio.h>

/* Part of the stable step from which on the area of cracks depends on it (cases/verification/cost, the notched plate).
 */
#define NEAR_STABLE 0.8

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

/* A stage whose given step is so short that its flow would take more steps than any run has. */
static void print_slow(const struct run *r, const struct scene_stage *stage) {
    const double most = 1e9;
    const struct scene_fluid *f = r->scene->fluid;
    if (!f || !(stage->time_step > 0)) return;
    const double *size = r->scene->domain.size, least = fmin(size[0], fmin(size[1], size[2]));
    const double transit = least / unresolved_velocity(f), viscous = least * least / f->viscosity;
    const double steps = fmin(transit, viscous) / stage->time_step;
    if (steps > most)
        print("  warning: stage %s: the run is hopeless: with a step of %.3g s the flow needs %.3g steps to cross the "
              "domain, and viscosity %.3g\n",
              stage->name, stage->time_step, transit / stage->time_step, viscous / stage->time_step);
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

/* How the solid of a stage is stepped, and what its step costs where bonds may break. */
static void print_accuracy(struct run *r, const struct scene_stage *stage) {
    double step, excess, early, advised;
    if (!r->needs.bonds || stage->solid != SCENE_SOLID_ELASTIC || stage->relax) return;
    print("  %-10s solid by %s", "", stage->integrator == SOLID_VERLET ? "velocity Verlet" : "RK3");
    if (timescale_breaking(r, &step, &excess, &early, &advised)) {
        print(": with a step of %.3g s %s%.2g %% too many bonds break, the first per cent of them after a time that is "
              "%s%.2g %% too short",
              step, excess < 1 ? "less than " : "about ", fmax(excess, 1), early < 1 ? "less than " : "about ",
              fmax(early, 1));
        if (step > advised) print("; time_step: %.2g for 2 %%", advised);
        if (!(stage->time_step > 0))
            print(" (the fluid alone would allow %.3g s)", fluid_limits_foreseen(r->fluid).step);
    } else if (!r->fluid && stage->integrator == SOLID_VERLET && scene_stage_may_break(r->scene, r->stage) &&
               r->dt > NEAR_STABLE * r->substeps * r->solid_stable) {
        print(": so near to the stable step about 4 %% too much area of cracks; safety: 0.7 for 1.5 %%");
    }
    print("\n");
}

/* What is known of times before a run. */
struct foreseen {
    int is_known; /* 0: some step is found only while the run goes on */
    int is_exact; /* 0: some stage may end earlier */
};

/* Times of loads, motions and injections that begin before they act, or outlast their stage, which goes from the
 * present time to `end`. Returns whether some outlast it. */
static int print_ramps(struct run *r, struct foreseen *f, double end) {
    const struct scene_stage *stage = &r->scene->stage[r->stage];
    char ramp[RAMP_SENTENCE];
    const int starts = f->is_known && f->is_exact && ramp_of(r, 0, ramp);
    if (starts) print("  warning: %s\n", ramp);
    const int outlasts = r->dt > 0 && ramp_of_stage(r, r->t, end, ramp);
    if (outlasts) print("  warning: %s\n", ramp);
    f->is_known &= r->dt > 0 || stage->relax;
    f->is_exact &= !stage->has_until;
    if (stage->solid == SCENE_SOLID_ELASTIC) r->moved = 1;
    return outlasts;
}

static void print_end(struct run *r, double end) {
    char ramp[RAMP_SENTENCE];
    r->stage = r->scene->stages - 1;
    r->t = end;
    if (ramp_of(r, 1, ramp)) print("  warning: %s\n", ramp);
    r->stage = r->scene->stages;
}

/* The numbers are cases/verification/sphere_drag's. */
static void print_probes(const struct run *r) {
    if (!r->needs.immersed || !r->load_kind->has_probes) return;
    print("  coupling.load: probe reads the stress %.3g cells off the wall and misses a part of the load: of the drag "
          "of a sphere in a creeping flow, by probes of two cells, 30 %% at 16 cells a diameter, 18 %% at 32; the log "
          "says how much in a run; "
          "coupling.load: reaction misses none\n",
          r->scene->coupling->probe_length);
}

void check_limits_print(struct run *r, struct costs *costs) {
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
    struct foreseen foreseen = {1, 1};
    int outlasts = 0;
    for (r->stage = 0; r->stage < r->scene->stages; r->stage++) {
        const struct scene_stage *stage = &r->scene->stage[r->stage];
        r->t = isfinite(costs->seconds) ? costs->seconds : 0;
        step_begin_stage(r);
        costs_add(costs, r);
        print("  %-10s ", stage->name);
        if (stage->duration > 0) print("%.6g s, ", stage->duration);
        print("%ld steps%s", stage->steps,
              !stage->has_until          ? stage->duration > 0 ? " at most" : ""
              : scene_stage_rests(stage) ? " at most, until all is at rest"
                                         : " at most, until the permeability is steady");
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
        const double all = r->dt * (double)stage->steps;
        char sentence[OVERSTEP_MAX][OVERSTEP_SENTENCE], undamped[UNDAMPED_SENTENCE], braked[BRAKED_SENTENCE];
        for (int k = 0, n = overstep_of(r, sentence); k < n; k++) print("  warning: %s\n", sentence[k]);
        outlasts = print_ramps(r, &foreseen, costs->seconds);
        if (r->dt > 0 && all < stage->duration * (1 - 1e-9))
            print("  warning: stage %s: its %ld steps take %.6g s, %.3g of its duration: more steps\n", stage->name,
                  stage->steps, all, all / stage->duration);
        if (undamped_of(r, undamped)) print("  warning: %s\n", undamped);
        if (braked_of(r, braked)) print("  warning: %s\n", braked);
        print_accuracy(r, stage);
        print_slow(r, stage);
        print_touch(r, stage);
    }
    if (!outlasts && foreseen.is_known) print_end(r, costs->seconds);
    r->t = 0;
    r->moved = 0;
    print_probes(r);
}
