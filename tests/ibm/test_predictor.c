/* The predictor pressure of a forced flow: no stage creates energy. */
#include "physics/rk3.h"
#include "tests/check.h"
#include "tests/ibm/bodies.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

enum { N = 16, CELLS = N * N * N };
static const double density = 3;

/* What the next stage's momentum equation reads: pi, or this stage's pressure as without pi. */
enum hand_over { WEIGHTED, UNWEIGHTED };

/* A sphere that is held in a periodic box of length 1. */
struct flow {
    struct fluid *f;
    struct ibm *b;
    struct body body;
    enum hand_over hand_over;
};

static struct flow flow_new(enum hand_over hand_over, int iterations, enum fluid_projection projection) {
    struct fluid_input in = {.density = density, .viscosity = 1e-14, .immersed = 1, .projection = projection};
    for (int d = 0; d < 3; d++) in.n[d] = N, in.length[d] = 1;
    struct flow w = {.f = fluid_new(&in), .hand_over = hand_over};
    w.b = ibm_new(w.f, iterations);
    w.body = body_sphere_even((double[3]){0.51, 0.48, 0.53}, 0.3, 1.0 / N, 0.3 / N);
    body_send(w.b, &w.body);
    return w;
}

static void flow_free(struct flow *w) {
    body_free(&w->body);
    ibm_free(w->b);
    fluid_free(w->f);
}

/* While the force on the box is summed, p is set in every stage. */
static void stage(struct flow *w, int r, double dt) {
    struct fluid_state *s = fluid_state_of(w->f);
    fluid_box_force_begin(w->f);
    fluid_predict(w->f, r, dt);
    ibm_forcing_stage(w->b, r, dt);
    fluid_project(w->f, r, dt);
    if (w->hand_over == UNWEIGHTED) memcpy(s->pi, s->p, fluid_grid_of(w->f)->size * sizeof(double));
}

/* In [-1, 1). */
static double noise(unsigned n) {
    n = (n ^ 61) ^ (n >> 16);
    n *= 9;
    n ^= n >> 4;
    n *= 0x27d4eb2du;
    n ^= n >> 15;
    return (double)n / 2147483648.0 - 1;
}

/* A random velocity and pi, so small that neither convection nor diffusion counts. */
static void fill(const struct flow *w, double dt, unsigned seed) {
    const struct fluid_grid *g = fluid_grid_of(w->f);
    struct fluid_state *s = fluid_state_of(w->f);
    double *field[4] = {s->u, s->v, s->w, s->pi};
    const double small = 1e-12, unit[4] = {small, small, small, small * density * g->d[0] / dt};
    for (int c = 0; c < 4; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++) {
                    const int id = ((c * N + k + g->lo[2]) * N + j + g->lo[1]) * N + i + g->lo[0];
                    field[c][fluid_grid_at(g, i, j, k)] = unit[c] * noise((unsigned)id + seed * 4 * CELLS);
                }
    fluid_state_refresh(w->f);
}

/* Sum over the faces of |u|^2 + k |grad pi|^2, k = (length/rho)^2. */
static double energy(const struct flow *w, double length) {
    const struct fluid_grid *g = fluid_grid_of(w->f);
    const struct fluid_state *s = fluid_state_of(w->f);
    const double *q[3] = {s->u, s->v, s->w}, factor = length / density;
    const ptrdiff_t stride[3] = {1, g->row, g->plane};
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++)
                for (int c = 0; c < 3; c++) {
                    const ptrdiff_t n = (ptrdiff_t)fluid_grid_at(g, i, j, k);
                    const double gradient = factor * (s->pi[n + stride[c]] - s->pi[n]) / g->d[c];
                    sum += q[c][n] * q[c][n] + gradient * gradient;
                }
    return par_sum(sum);
}

/* The energy after a stage over that before it, from a random velocity without divergence and a random pi or, at_rest,
 * from pi = 0. */
static double growth_of(enum hand_over hand_over, int r, int iterations, int at_rest, unsigned seed) {
    const double dt = 0.1, length = physics_rk3_gamma[0] * dt;
    struct flow w = flow_new(hand_over, iterations, FLUID_EACH_STAGE);
    struct fluid_state *s = fluid_state_of(w.f);
    fill(&w, dt, seed);
    stage(&w, 0, dt); /* removes the divergence */
    if (at_rest) memset(s->pi, 0, fluid_grid_of(w.f)->size * sizeof(double));
    const double before = energy(&w, length);
    stage(&w, r, dt);
    const double growth = energy(&w, length) / before;
    flow_free(&w);
    return growth;
}

/* Markers that are held take energy. The pressure's part of it is handed on from stage to stage without a gain, which
 * it is not if pi is the last pressure. */
static void a_stage_creates_no_energy(void **state) {
    (void)state;
    double most[2] = {0, 0};
    for (int iterations = 1; iterations <= 8; iterations *= 2)
        for (int r = 0; r < 3; r++)
            for (int at_rest = 0; at_rest < 2; at_rest++)
                for (int h = 0; h < 2; h++) {
                    const double growth =
                        growth_of((enum hand_over)h, r, iterations, at_rest, (unsigned)(iterations + 16 * r));
                    most[h] = check_worst(most[h], growth);
                }
    print_message("energy after a stage over before, at most: %.6f, unweighted %.6f\n", most[WEIGHTED],
                  most[UNWEIGHTED]);
    check_below(most[WEIGHTED], 1);
    check_above(most[UNWEIGHTED], 1.01);
}

/* With one projection a step the markers are forced three times before it. All steps hand the pressure on alike. */
static void a_step_projected_once_creates_no_energy(void **state) {
    (void)state;
    const double dt = 0.1;
    double most = 0;
    for (int iterations = 1; iterations <= 8; iterations *= 2)
        for (unsigned seed = 0; seed < 4; seed++) {
            struct flow w = flow_new(WEIGHTED, iterations, FLUID_LAST_STAGE);
            fill(&w, dt, seed);
            stage(&w, 0, dt); /* from t = 0 each stage is projected: removes the divergence */
            fluid_state_of(w.f)->t = dt;
            for (int s = 0; s < 5; s++) {
                const double before = energy(&w, dt);
                for (int r = 0; r < 3; r++) stage(&w, r, dt);
                most = check_worst(most, energy(&w, dt) / before);
            }
            flow_free(&w);
        }
    print_message("energy after a step over before, at most: %.6f\n", most);
    check_below(most, 1);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(a_stage_creates_no_energy),
                                       cmocka_unit_test(a_step_projected_once_creates_no_energy)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
