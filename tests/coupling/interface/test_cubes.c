/* With coupling.surface: cubes a particle's centre is half a spacing inside the wetted face, wherever it is: with
 * r_d = 0.5 the markers are at the centres (001: sec. 3.5.2), with a smaller one as far outside them on a ball, whose
 * depths differ from particle to particle with lattice. */
#include "coupling/run.h"
#include "coupling/step.h"
#include "tests/check.h"
#include "tests/coupling/ball.h"
#include "tests/coupling/scene_of.h"

#include "base/par.h"
#include "solid/surface/surface.h"

#include <math.h>

static const char *const stages = "stages: [{name: flow, steps: 1, time_step: 1.0e-3, solid: rigid}]\n";

/* Least and largest distance of the markers from their particles, m. */
static void distances(const char *surface, const char *retraction, double range[2]) {
    const char *const set[] = {surface, retraction};
    struct scene *scene = scene_of(BALL_IN_A_BOX("1000") "coupling: {}\n", stages, 2, set);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    step_advance(r);
    double largest[2] = {-INFINITY, -INFINITY};
    for (int i = 0; i < r->markers.n; i++) {
        double x[3], apart = 0;
        solid_position(r->solid, r->surface->h[i], x);
        for (int c = 0; c < 3; c++) apart += pow(r->markers.x[c][i] - x[c], 2);
        largest[0] = fmax(largest[0], -sqrt(apart));
        largest[1] = fmax(largest[1], sqrt(apart));
    }
    range[0] = -par_max(largest[0]);
    range[1] = par_max(largest[1]);
    run_free(r);
    scene_free(scene);
}

static void markers_at_the_centres(void **state) {
    (void)state;
    const double dx = 0.01;
    double range[2];
    distances("coupling.surface=cubes", "coupling.retraction=0.5", range);
    check_close(range[1], 0, 1e-15);
    distances("coupling.surface=cubes", "coupling.retraction=0.2", range);
    check_close(range[0], 0.3 * dx, 1e-12);
    check_close(range[1], 0.3 * dx, 1e-12);
    distances("coupling.surface=lattice", "coupling.retraction=0.5", range);
    check_above(range[1] - range[0], 0.1 * dx);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(markers_at_the_centres)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
