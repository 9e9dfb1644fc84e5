/* Low-storage third-order Runge-Kutta substep of the solid.  (001: eqs 3.47-3.48) */
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/imposed/constraint.h"
#include "solid/step/rk3.h"

/* The fluid's low-storage Runge-Kutta scheme, for d and v and for the energies.  (001: eqs 3.47, 3.48, mended) */
static const double ALPHA[3] = {8. / 15, 5. / 12, 3. / 4};
static const double BETA[3] = {0, -17. / 60, -5. / 12};

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

void solid_rk3_step(struct solid *s, double dt) {
    double damped = 0, load = 0, constraint = 0;
    for (int r = 0; r < 3; r++) {
        solid_ghosts_begin(s);
        solid_force(s, r == 0);
        s->e_damped += dt * (ALPHA[r] * s->power_damped + BETA[r] * damped);
        s->work_load += dt * (ALPHA[r] * s->power_load + BETA[r] * load);
        s->e_constraint += dt * (ALPHA[r] * s->power_constraint + BETA[r] * constraint);
        damped = s->power_damped;
        load = s->power_load;
        constraint = s->power_constraint;
        for (int c = 0; c < s->dim; c++)
            update(s->n, ALPHA[r] * dt, BETA[r] * dt, s->d[c], s->v[c], s->a[c], s->v_old[c], s->a_old[c]);
    }
    solid_constraint_displacement(s, s->t + dt);
    s->a_holds = 0;
}
