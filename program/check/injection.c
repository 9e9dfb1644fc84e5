/* frana check: the regime of an injection into cracks, and what it cannot compute. */
#include "program/check/parts.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/print.h"
#include "physics/dilatation.h"
#include "scene/notch.h"
#include "solid/measure/damage.h"

#include <math.h>
#include <stdio.h>

/* A tip that is faster than this part of sqrt(E/rho) runs with inertia. */
#define SLOW 0.05

/* Particles on an initial crack: all their bonds are cut, on either side. */
static void print_floating(const struct solid *s) {
    double *damage = memory_new(MEMORY_OUTPUT, (size_t)s->n + 1, sizeof *damage);
    long loose = 0;
    solid_damage_measure(s, damage);
    for (int h = 0; h < s->n; h++) loose += damage[h] > 1 - 1e-9;
    memory_free(damage);
    loose = par_sum_long(loose);
    if (loose > 0)
        print(
            "  warning: crack_fluid: %ld particles have lost all their bonds, because an initial crack goes through "
            "their centres: a loose layer between two cracks. Move the crack by half a spacing, to between two rows\n",
            loose);
}

static void print_regime(const struct scene_notch *n, double spacing) {
    const int kgd = n->in.shape == PHYSICS_KGD;
    print("  regime     %s = %.3g: %s (below %g viscosity rules, above %g toughness)\n",
          kgd ? "K'/(mu' E'^3 Q0)^(1/4)" : "K'(t^2/(mu'^5 Q0^3 E'^13))^(1/18) as it begins to grow", n->number,
          scene_notch_regime(n), n->over[0], n->over[1]);
    print("  growth     from %s of %.4g m, %.3g spacings: tip at %.3g m/s, %.3g sqrt(E/rho_s); net pressure %.3g Pa, "
          "%.3g "
          "E s0; without leak-off and inertia\n",
          kgd ? "a half length" : "a radius", n->length, n->length / spacing, n->speed, n->speed / n->wave, n->pressure,
          n->pressure / n->limit);
    if (n->speed > SLOW * n->wave)
        print(
            "  warning: crack_fluid: the tip runs at %.3g sqrt(E/rho_s) at first, and above %g inertia counts: with "
            "time "
            "stretched by %.3g, so a lower rate and a viscosity that is higher by as much, it is the same slow crack\n",
            n->speed / n->wave, SLOW, n->speed / (SLOW * n->wave));
    if (n->pressure > n->limit)
        print(
            "  warning: crack_fluid: the notch begins to grow at a net pressure of %.3g Pa, above E s0 = %.3g Pa, and "
            "there its faces break everywhere: a spacing finer by %.3g raises E s0 to it\n",
            n->pressure, n->limit, pow(n->pressure / n->limit, 2));
}

/* Pressures that are given are net pressures too. */
static void print_given(const struct scene_crack_fluid *f, double limit) {
    for (int q = 0; q < f->injections; q++) {
        const struct scene_injection *in = &f->injection[q];
        double most = in->time.n ? in->time.factor[0] : 1;
        for (int k = 1; k < in->time.n; k++) most = fmax(most, in->time.factor[k]);
        if (in->is_pressure && in->pressure * most > limit)
            print("  warning: crack_fluid.injections[%d]: a pressure of %.3g Pa is above E s0 = %.3g Pa, at which the "
                  "notch's faces break everywhere\n",
                  q, in->pressure * most, limit);
    }
}

/* The largest stress that a load can press on the body with, Pa. */
static double load_stress(const struct scene *s) {
    double most = 0;
    for (int k = 0; k < s->solid->loads; k++) {
        const struct scene_load *l = &s->solid->load[k];
        double factor = l->time.n ? 0 : 1;
        for (int i = 0; i < l->time.n; i++) factor = fmax(factor, fabs(l->time.factor[i]));
        for (int c = 0; c < s->dimension; c++) {
            const double deep = fmax(fmin(l->high[c], s->domain.size[c]) - fmax(l->low[c], 0), 0);
            const double stress = l->kind == SOLID_LOAD_EDGE ? fabs(l->traction[c]) : fabs(l->force[c]) * deep;
            most = fmax(most, factor * stress);
        }
    }
    return most;
}

/* A lattice under the compression sigma0 from all sides takes G0 (1 + k sigma0/(E s0))^2 from a crack: a bond has to be
 * stretched from its compressed length, by k sigma0/E, up to s0. k = 1 - 2 nu in space, (1 + nu)(1 - 2 nu) in plane
 * strain, 1 - nu in plane stress (cases/verification/borehole). */
static void print_confined(const struct scene *s, double limit) {
    const double least = s->crack_fluid->least_pressure, load = load_stress(s);
    const enum physics_model model = s->dimension == 2 ? (enum physics_model)s->solid->model : PHYSICS_3D;
    const double nu = physics_dilatation_ratio(model,
                                               s->solid->material[s->solid->body[0].material_index].poisson_ratio),
                 k = model == PHYSICS_PLANE_STRESS ? 1 - nu : (1 - 2 * nu) * (model == PHYSICS_3D ? 1 : 1 + nu);
    if (least < 0)
        print(
            "  confined   least_pressure stands for a confining stress of %.3g Pa: pressures are net of it. As a load "
            "on "
            "the lattice it would raise the fracture energy to %.3g G0\n",
            -least, pow(1 - k * least / limit, 2));
    if (least < -1.001 * limit)
        print("  warning: crack_fluid.least_pressure: suction of %.3g Pa is above E s0 = %.3g Pa, and breaks bonds "
              "beside "
              "the crack: this spacing cannot have so high a confining stress\n",
              -least, limit);
    if (load > 0.01 * limit)
        print(
            "  warning: crack_fluid: the loads reach %.3g Pa. Where they press across the crack its fracture energy is "
            "%.3g G0: leave such a load out, and set least_pressure: -%.3g, with pressures net of it\n",
            load, pow(1 + k * load / limit, 2), load);
}

/* In the toughness regime the fluid reaches the tip. Elsewhere the lag is at most that of a solid without toughness at
 * the speed at which the notch begins to grow. */
static void print_lag(const struct scene *s, const struct scene_notch *n) {
    const double stress = -s->crack_fluid->least_pressure, spacing = s->solid->spacing,
                 horizon = s->solid->material[s->solid->body[0].material_index].horizon_ratio * spacing;
    if (n->number >= n->over[1]) return;
    const double least = physics_hydraulic_fracture_lag(&n->in, n->speed, n->limit);
    if (!(stress > 0)) {
        print("  warning: crack_fluid: without a confining stress the fluid's front stays far behind the tip. The "
              "shortest "
              "lag that this spacing can have is up to %.3g m, %.3g spacings, with least_pressure: -%.3g, which is "
              "-E s0\n",
              least, least / spacing, n->limit);
        return;
    }
    const double lag = physics_hydraulic_fracture_lag(&n->in, n->speed, stress);
    print("  lag        the fluid's front is up to %.3g m, %.3g spacings, behind the tip\n", lag, lag / spacing);
    if (lag < horizon)
        print(
            "  warning: crack_fluid: the lag is shorter than the horizon of %.3g m: it and the pressure beside the tip "
            "are not resolved\n",
            horizon);
    if (lag > n->length)
        print(
            "  warning: crack_fluid: the lag is longer than the notch, so the crack is not that of a solution without "
            "lag; "
            "with least_pressure: -%.3g, which is -E s0, it is up to %.3g m, the shortest that this spacing can have\n",
            n->limit, least);
}

void check_injection_print(const struct run *r) {
    const struct scene *s = r->scene;
    struct scene_notch notch;
    if (!r->cracks) return;
    print_floating(r->solid);
    const double limit = scene_notch_limit(s);
    const int injects = scene_notch_of(s, &notch);
    if (injects) print_regime(&notch, s->solid->spacing);
    if (!isfinite(limit)) return;
    print_given(s->crack_fluid, limit);
    print_confined(s, limit);
    if (injects) print_lag(s, &notch);
}
