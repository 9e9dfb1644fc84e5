/* Low-storage third-order Runge-Kutta substep of the solid.  (001: eqs 3.47-3.48) */
#include "physics/rk3.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/drag.h"
#include "solid/force/force.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/indenter.h"
#include "solid/imposed/reactions.h"
#include "solid/imposed/walls.h"
#include "solid/step/rk3.h"
#include "solid/step/rk3_loss.h"

/* d += dt (alpha v + beta v_old), v += dt (alpha a + beta a_old); the rates of this stage become the old ones. [n] */
static void update(int n, double alpha_dt, double beta_dt, double *restrict d, double *restrict v,
                   const double *restrict a, double *restrict v_old, double *restrict a_old) {
    for (int h = 0; h < n; h++) {
        const double rate_d = v[h], rate_v = a[h];
        d[h] += alpha_dt * rate_d + beta_dt * v_old[h];
        v[h] += alpha_dt * rate_v + beta_dt * a_old[h];
        v_old[h] = rate_d;
        a_old[h] = rate_v;
    }
}

/* Of d and v, and of the energies; eqs 3.47-3.48 without the third term. */
void solid_rk3_step(struct solid *s, double dt) {
    double damped = 0, load = 0, constraint = 0, walls = 0, t = s->t;
    s->e_integrator += solid_walls_energy(s);
    for (int r = 0; r < 3; r++) {
        solid_ghosts_begin(s);
        solid_indenter_place(s, t);
        solid_force(s, r == 0);
        if (r == 0) solid_rk3_loss_begin(s);
        if (r == 2) solid_rk3_loss_end(s, dt);
        t += physics_rk3_gamma[r] * dt;
        s->e_damped += dt * (physics_rk3_alpha[r] * s->power_damped + physics_rk3_beta[r] * damped);
        s->work_load += dt * (physics_rk3_alpha[r] * s->power_load + physics_rk3_beta[r] * load);
        s->e_constraint += dt * (physics_rk3_alpha[r] * s->power_constraint + physics_rk3_beta[r] * constraint);
        s->e_integrator -= dt * (physics_rk3_alpha[r] * solid_walls_power(s) + physics_rk3_beta[r] * walls);
        solid_reactions_add(s, physics_rk3_alpha[r] * dt, physics_rk3_beta[r] * dt);
        damped = s->power_damped;
        load = s->power_load;
        constraint = s->power_constraint;
        walls = solid_walls_power(s);
        for (int c = 0; c < s->dim; c++)
            update(s->n, physics_rk3_alpha[r] * dt, physics_rk3_beta[r] * dt, s->d[c], s->v[c], s->a[c], s->v_old[c],
                   s->a_old[c]);
    }
    s->e_integrator -= solid_walls_energy(s);
    if (s->drag) solid_drag_kick(s, dt);
    solid_constraint_displacement(s, s->t + dt);
    s->a_holds = 0;
}
