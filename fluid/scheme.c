/* The schemes of the fluid's time step: RK3 and AB2. */
#include "fluid/scheme.h"
#include "base/ensure.h"
#include "fluid/internal.h"
#include "physics/rk3.h"

static struct fluid_scheme rk3(void) {
    struct fluid_scheme s = {.stages = 3, .most = physics_rk3_gamma[0]};
    for (int r = 0; r < s.stages; r++) {
        s.alpha[r] = physics_rk3_alpha[r];
        s.beta[r] = physics_rk3_beta[r];
        s.gamma[r] = physics_rk3_gamma[r];
    }
    return s;
}

static struct fluid_scheme ab2(void) {
    return (struct fluid_scheme){.stages = 1, .alpha = {1}, .gamma = {1}, .most = 1, .is_multistep = 1};
}

static struct fluid_scheme scheme_of(enum fluid_integrator integrator) {
    switch (integrator) {
    case FLUID_RK3:
        return rk3();
    case FLUID_AB2:
        return ab2();
    }
    ENSURE(0, "integrator %d of the fluid", (int)integrator);
}

int fluid_scheme_is_multistep(enum fluid_integrator integrator) { return scheme_of(integrator).is_multistep; }

void fluid_scheme_set(struct fluid *f, enum fluid_integrator integrator) {
    f->scheme = scheme_of(integrator);
    ENSURE(!f->scheme.is_multistep || (f->in.keeps_rate && !f->in.implicit),
           "a fluid without R of the last step, or with implicit diffusion");
    if (!f->scheme.is_multistep) f->state.rate_dt = 0;
}

void fluid_scheme_begin(struct fluid *f, double dt) {
    if (!f->scheme.is_multistep) return;
    const double half = f->state.rate_dt > 0 ? 0.5 * dt / f->state.rate_dt : 0;
    f->scheme.alpha[0] = 1 + half;
    f->scheme.beta[0] = -half;
    f->state.rate_dt = dt;
}

int fluid_scheme_stages(const struct fluid *f) { return f->scheme.stages; }

double fluid_scheme_gamma(const struct fluid *f, int r) { return f->scheme.gamma[r]; }

double fluid_scheme_gamma_max(const struct fluid *f) { return f->scheme.most; }
