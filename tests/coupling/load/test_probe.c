/* Loads by probes: the acceleration that they take for the surface's. */
#include "tests/coupling/ball.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/coupling/scene_of.h"
#include "tests/check.h"

#include <stdio.h>

static const char *const box = BALL_IN_A_BOX("3000");
static const char *const drift = "coupling: {load: probe}\n"
                                 "stages:\n"
                                 "  - {name: drift, steps: 6, time_step: 2.0e-3, breakage: false}\n"
                                 "  - {name: finer, steps: 6, time_step: 4.0e-4, breakage: false}\n";

/* Goes to the next stage where a stage's steps are done. */
static void next(struct run *r) {
    if (r->stage_step < r->scene->stage[r->stage].steps) return;
    r->stage++;
    r->stage_step = 0;
    step_begin_stage(r);
}

/* In the first step after a change of the step. Returns the largest error of the acceleration of probes' roots, over
 * the largest acceleration. */
static double acceleration_after_change(const char *load) {
    char set_load[64];
    snprintf(set_load, sizeof set_load, "coupling.load=%s", load);
    struct scene *scene = scene_of(box, drift, 1, (const char *const[]){set_load});
    struct run *r = run_new(scene);
    const struct solid *s = r->solid;
    const struct wall_probes *p = &r->probes;
    double off = 0, most = 0, *gained[3];
    step_begin_stage(r);
    for (int n = 0; n < 6; n++) step_advance(r);
    for (int c = 0; c < 3; c++) {
        gained[c] = calloc((size_t)s->n + 1, sizeof(double));
        for (int h = 0; h < s->n; h++) gained[c][h] = s->v[c][h] - r->v_last[c][h];
    }
    next(r);
    step_advance(r);
    for (int q = 0; q < p->n; q++) {
        double a_n = 0;
        for (int c = 0; c < 3; c++) a_n += gained[c][p->particle[q]] / 2e-3 * p->normal[c][q];
        off = check_worst(off, p->acceleration_n[q] - a_n);
        most = check_worst(most, a_n);
    }
    off = par_max(off);
    most = par_max(most);
    for (int c = 0; c < 3; c++) free(gained[c]);
    run_free(r);
    scene_free(scene);
    check_above(most, 0);
    return off / most;
}

static void acceleration_is_over_the_last_step(void **state) {
    (void)state;
    check_below(acceleration_after_change("probe"), 1e-12);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(acceleration_is_over_the_last_step)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
