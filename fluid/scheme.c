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
        s.keeps[r] = r + 1 < s.stages;
    }
    return s;
}

static struct fluid_scheme ab2(void) {
    return (struct fluid_scheme){.stages = 1, .alpha = {1}, .gamma = {1}, .most = 1, .keeps = {1}, .is_multistep = 1};
}

void fluid_scheme_set(struct fluid *f, enum fluid_integrator integrator) {
    switch (integrator) {
    case FLUID_RK3:
        f->scheme = rk3();
        f->state.rate_dt = 0;
        return;
    case FLUID_AB2:
        ENSURE(f->in.keeps_rate && !f->in.implicit, "a fluid without R of the last step, or with implicit diffusion");
        f->scheme = ab2();
        return;
    }
    ENSURE(0, "integrator %d of the fluid", (int)integrator);
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

double fluid_scheme_gamma_most(const struct fluid *f) { return f->scheme.most; }
