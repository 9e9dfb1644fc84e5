/* frana check: the regime of an injection into cracks, and what it cannot compute. */
#include "program/check/injection.h"
#include "base/print.h"
#include "physics/dilatation.h"
#include "scene/notch.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>

/* A tip that is faster than this part of sqrt(E/rho) runs with inertia. */
#define SLOW 0.05

/* Passes a sentence on. */
__attribute__((format(printf, 2, 3))) static void warn(void (*report)(const char *sentence), const char *format, ...) {
    char sentence[512];
    va_list args;
    va_start(args, format);
    vsnprintf(sentence, sizeof sentence, format, args);
    va_end(args);
    report(sentence);
}

static void print_regime(const struct scene_notch *n, double spacing) {
    const int kgd = n->in.shape == PHYSICS_KGD;
    print("  regime     %s = %.3g: %s (viscosity dominates below %g, toughness above %g)\n",
          kgd ? "K'/(mu' E'^3 Q0)^(1/4)" : "K'(t^2/(mu'^5 Q0^3 E'^13))^(1/18) as it begins to grow", n->number,
          scene_notch_regime(n), n->over[0], n->over[1]);
    print("  growth     from %s of %.4g m, %.3g spacings: tip at %.3g m/s, %.3g sqrt(E/rho_s); net pressure %.3g Pa, "
          "%.3g E s0; without leak-off and inertia\n",
          kgd ? "a half length" : "a radius", n->length, n->length / spacing, n->speed, n->speed / n->wave, n->pressure,
          n->pressure / n->limit);
}

static void warn_regime(const struct scene_notch *n, void (*report)(const char *sentence)) {
    if (n->speed > SLOW * n->wave)
        warn(report,
             "crack_fluid: the tip runs at %.3g sqrt(E/rho_s) at first, and above %g inertia counts: a rate that is "
             "lower and a viscosity that is higher by the factor %.3g give the same crack, slower by this factor",
             n->speed / n->wave, SLOW, n->speed / (SLOW * n->wave));
    if (n->pressure > n->limit)
        warn(report,
             "crack_fluid: the notch begins to grow at a net pressure of %.3g Pa, above E s0 = %.3g Pa, at which its "
             "faces break everywhere: a spacing that is smaller by the factor %.3g raises E s0 to that pressure",
             n->pressure, n->limit, pow(n->pressure / n->limit, 2));
}

/* Pressures that are given are net pressures too. */
static void warn_given(const struct scene_crack_fluid *f, double limit, void (*report)(const char *sentence)) {
    for (int q = 0; q < f->injections; q++) {
        const struct scene_injection *in = &f->injection[q];
        double most = in->time.n ? in->time.factor[0] : 1;
        for (int k = 1; k < in->time.n; k++) most = fmax(most, in->time.factor[k]);
        if (in->is_pressure && in->pressure * most > limit)
            warn(report,
                 "crack_fluid.injections[%d]: a pressure of %.3g Pa is above E s0 = %.3g Pa, at which the notch's "
                 "faces break everywhere",
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
static double confined(const struct scene *s, double stress, double limit) {
    const enum physics_model model = s->dimension == 2 ? (enum physics_model)s->solid->model : PHYSICS_3D;
    const double nu = physics_dilatation_ratio(model,
                                               s->solid->material[s->solid->body[0].material_index].poisson_ratio),
                 k = model == PHYSICS_PLANE_STRESS ? 1 - nu : (1 - 2 * nu) * (model == PHYSICS_3D ? 1 : 1 + nu);
    return pow(1 + k * stress / limit, 2);
}

static void print_confined(const struct scene *s, double limit) {
    const double stress = -s->crack_fluid->least_pressure;
    if (stress > 0)
        print("  confined   least_pressure stands for a confining stress of %.3g Pa: pressures are net of it. As a "
              "load on the lattice it would raise the fracture energy to %.3g G0\n",
              stress, confined(s, stress, limit));
}

static void warn_confined(const struct scene *s, double limit, void (*report)(const char *sentence)) {
    const double least = s->crack_fluid->least_pressure, load = load_stress(s);
    if (least < -1.001 * limit)
        warn(report,
             "crack_fluid.least_pressure: suction of %.3g Pa is above E s0 = %.3g Pa, and breaks bonds beside the "
             "crack: this spacing allows no confining stress that high",
             -least, limit);
    if (load > 0.01 * limit)
        warn(report,
             "crack_fluid: the loads reach %.3g Pa. Where they compress the crack its fracture energy is %.3g G0: "
             "leave such a load out, set least_pressure: -%.3g, and "
             "give pressures less the confining stress",
             load, confined(s, load, limit), load);
}

/* In the toughness regime the fluid reaches the tip. Elsewhere the lag is at most that of a solid without toughness at
 * the speed at which the notch begins to grow. */
static double lag_of(const struct scene *s, const struct scene_notch *n) {
    return physics_hydraulic_fracture_lag(&n->in, n->speed, -s->crack_fluid->least_pressure);
}

static void print_lag(const struct scene *s, const struct scene_notch *n) {
    if (n->number >= n->over[1] || !(s->crack_fluid->least_pressure < 0)) return;
    const double lag = lag_of(s, n);
    print("  lag        the fluid's front is up to %.3g m, %.3g spacings, behind the tip\n", lag,
          lag / s->solid->spacing);
}

static void warn_lag(const struct scene *s, const struct scene_notch *n, void (*report)(const char *sentence)) {
    const double spacing = s->solid->spacing,
                 horizon = s->solid->material[s->solid->body[0].material_index].horizon_ratio * spacing;
    if (n->number >= n->over[1]) return;
    const double least = physics_hydraulic_fracture_lag(&n->in, n->speed, n->limit);
    if (!(s->crack_fluid->least_pressure < 0)) {
        warn(report,
             "crack_fluid: without a confining stress the fluid's front stays far behind the tip. The shortest lag "
             "that this spacing can have is up to %.3g m, %.3g spacings, with least_pressure: -%.3g, which is -E s0",
             least, least / spacing, n->limit);
        return;
    }
    const double lag = lag_of(s, n);
    if (lag < horizon)
        warn(report,
             "crack_fluid: the lag is shorter than the horizon of %.3g m: it and the pressure beside the tip are not "
             "resolved",
             horizon);
    if (lag > n->length)
        warn(report,
             "crack_fluid: the lag is longer than the notch, so the crack is not that of a solution without lag; with "
             "least_pressure: -%.3g, which is -E s0, it is up to %.3g m, the shortest that this spacing can have",
             n->limit, least);
}

void check_injection_warn(const struct run *r, void (*report)(const char *sentence)) {
    const struct scene *s = r->scene;
    struct scene_notch notch;
    const double limit = r->cracks ? scene_notch_limit(s) : INFINITY;
    if (!isfinite(limit)) return;
    const int injects = scene_notch_of(s, &notch);
    if (injects) warn_regime(&notch, report);
    warn_given(s->crack_fluid, limit, report);
    warn_confined(s, limit, report);
    if (injects) warn_lag(s, &notch, report);
}

static void print_warning(const char *sentence) { print("  warning: %s\n", sentence); }

void check_injection_print(const struct run *r) {
    const struct scene *s = r->scene;
    struct scene_notch notch;
    const double limit = r->cracks ? scene_notch_limit(s) : INFINITY;
    if (!isfinite(limit)) return;
    const int injects = scene_notch_of(s, &notch);
    if (injects) print_regime(&notch, s->solid->spacing);
    print_confined(s, limit);
    if (injects) print_lag(s, &notch);
    check_injection_warn(r, print_warning);
}
