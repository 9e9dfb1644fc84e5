/* Load by reaction: what the forcing takes from the fluid the solid is given; a driving gradient acts on both. */
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/check.h"
#include "tests/coupling/ball.h"
#include "tests/coupling/scene_of.h"

#include <stdio.h>

static const char *const heavy = BALL_IN_A_BOX("3000");
static const char *const neutral = BALL_IN_A_BOX("1000");
static const char *const drift = "coupling: {load: reaction}\n"
                                 "stages:\n"
                                 "  - {name: drift, steps: 12, time_step: 2.0e-3, breakage: false}\n";

/* Load = -forcing + V (rho I - rho b), with I the acceleration of the inner fluid, extrapolated from the two steps
 * before. The load is summed by the solid, the forcing by the fluid. */
static void load_with(const char *fluid_integrator) {
    struct scene *scene =
        scene_of(heavy, drift, 2, (const char *const[]){"fluid.body_force=[0, 2, -1]", fluid_integrator});
    struct run *r = run_new(scene);
    const double push[3] = {0, 2, -1};
    double before[3] = {0}; /* volume integral of rho dU/dt in the step before, this rank's */
    step_begin_stage(r);
    for (int n = 0; n < 12; n++) {
        double inner[3] = {0}, forcing[3];
        const double last = r->inner_time;
        for (int h = 0; h < r->solid->n; h++)
            for (int c = 0; c < 3; c++) inner[c] -= 1000 * r->solid->volume[h] * r->inner_velocity[c][h];
        step_advance(r);
        for (int h = 0; h < r->solid->n; h++)
            for (int c = 0; c < 3; c++) inner[c] += 1000 * r->solid->volume[h] * r->inner_velocity[c][h];
        for (int c = 0; c < 3; c++) {
            const double now = n > 0 ? inner[c] / (r->inner_time - last) : 0;
            inner[c] = 2 * now - before[c];
            before[c] = now;
            for (int h = 0; h < r->solid->n; h++) inner[c] -= 1000 * r->solid->volume[h] * push[c];
        }
        par_sum_array(inner, 3);
        ibm_forcing_total(r->ibm, forcing);
        check_above(fabs(r->load[0]), 1e-3); /* N */
        for (int c = 0; c < 3; c++) check_close(r->load[c], inner[c] - forcing[c], 1e-12 * fabs(r->load[0]));
    }
    run_free(r);
    scene_free(scene);
}

static void load_is_what_the_forcing_took(void **state) {
    (void)state;
    load_with("stages.drift.fluid_integrator=rk3");
    load_with("stages.drift.fluid_integrator=ab2");
}

/* A ball of the fluid's density, both at rest, under a driving gradient G: both are accelerated by G/rho. Without its
 * share of G the ball, with its added mass, gets a third of it. */
static double gained(const char *load) {
    char set_load[64];
    snprintf(set_load, sizeof set_load, "coupling.load=%s", load);
    struct scene *scene = scene_of(neutral, drift, 3,
                                   (const char *const[]){set_load, "fluid.initial.velocity=[0, 0, 0]",
                                                         "fluid.driving={type: pressure_gradient, value: 100}"});
    struct run *r = run_new(scene);
    double sum[2] = {0};
    step_begin_stage(r);
    for (int n = 0; n < 12; n++) step_advance(r);
    for (int h = 0; h < r->solid->n; h++) {
        sum[0] += r->solid->volume[h] * r->solid->v[0][h];
        sum[1] += r->solid->volume[h] * 0.1 * r->t;
    }
    par_sum_array(sum, 2);
    run_free(r);
    scene_free(scene);
    return sum[0] / sum[1];
}

static void driving_gradient_acts_on_the_body(void **state) {
    (void)state;
    static const char *const load[] = {"reaction", "balanced"};
    for (int k = 0; k < 2; k++) {
        const double share = gained(load[k]);
        print_message("%s: %.6f of the driving gradient's acceleration\n", load[k], share);
        check_close(share, 1, 0.05); /* reaction: the first step knows of no acceleration */
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(load_is_what_the_forcing_took),
                                       cmocka_unit_test(driving_gradient_acts_on_the_body)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
