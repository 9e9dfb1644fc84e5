/* The preconditioner of the pressures: symmetric, and near the inverse of P for what varies slowly and fast. */
#include "cracks/precondition.h"
#include "cracks/aperture.h"
#include "cracks/coarse.h"
#include "cracks/solve.h"
#include "cracks/struts.h"
#include "cracks/sums.h"
#include "tests/cracks/make.h"

#include <stdlib.h>

enum { LONG = 96 };
static const struct planes planes[] = {{{LONG, 16, 0}, {0, 1, 0}, 16}, {{LONG, 16, 9}, {0, 1, 0}, 16}};

/* y = P p, the flow in a substep and the diagonal of the elastic part; p [n + ghosts]. */
static void apply(const struct cracks *c, double dt, double *p, double *y) {
    const struct cracks_struts *t = &c->struts;
    cracks_struts_update(t, sizeof *p, p);
    for (int i = 0; i < t->n; i++) y[i] = (c->storage[i] + dt * dt * t->diagonal[i]) * p[i];
    cracks_sums_flow(c, dt, p, y);
}

static double dot(const struct cracks *c, const double *a, const double *b) {
    double sum = 0;
    for (int i = 0; i < c->struts.n; i++) sum += a[i] * b[i];
    return par_sum(sum);
}

static double *array_of(const struct cracks *c) {
    return calloc((size_t)(c->struts.n + c->struts.ghosts) + 1, sizeof(double));
}

/* z = about P^-1 y. Of a particle that is not full z is 0. */
static void precondition(const struct cracks *c, double dt, const double *y, double *z) {
    for (int i = 0; i < c->struts.n; i++) c->work->residual[i] = y[i];
    cracks_precondition(c, dt);
    for (int i = 0; i < c->struts.n; i++) z[i] = c->work->z[i];
}

/* A crack through a solid that opens by w, with a substep so short that the flow is `stiff` times the elastic
 * part. */
static struct cracks *crack_of(const struct planes *p, double stiff, double *dt) {
    struct solid *s = make((struct make){.sites = {p->sites[0], p->sites[1], p->sites[2]}});
    const double w = 1e-6;
    cut(s, p);
    for (int h = 0; h < s->n; h++) s->d[1][h] = side_of(p, number_of(s, p, h)) ? w : 0;
    struct cracks *c = cracks_new(&(struct cracks_input){.viscosity = 1e-3, .least_aperture = w}, s);
    double sum[2] = {0, 0};
    cracks_aperture_conductance(c);
    for (int i = 0; i < c->struts.n; i++) {
        sum[0] += c->work->outflow[c->struts.slot[i]];
        sum[1] += c->struts.diagonal[i];
        c->work->set[i] = CRACKS_FULL;
        c->work->ones_stiff[i] = c->work->of_ones[i] = 0; /* a flow to no one */
    }
    par_sum_array(sum, 2);
    *dt = sum[0] / (sum[1] * stiff);
    return c;
}

/* (z - p).P (z - p) over p.P p, with z from P p. */
static double error_of(const struct cracks *c, double dt, double *p) {
    double *y = array_of(c), *z = array_of(c);
    apply(c, dt, p, y);
    const double whole = dot(c, p, y);
    precondition(c, dt, y, z);
    for (int i = 0; i < c->struts.n; i++) z[i] -= p[i];
    apply(c, dt, z, y);
    const double left = dot(c, z, y);
    free(y);
    free(z);
    return left / whole;
}

/* With bricks one call leaves little of what varies over the whole crack and of what varies from particle to particle.
 * The polynomial alone leaves nearly all of the former. */
static void inverse(void **state) {
    (void)state;
    for (int q = 0; q < 2; q++) {
        double dt;
        struct cracks *c = crack_of(&planes[q], 1e4, &dt);
        double *slow = array_of(c), *fast = array_of(c);
        for (int i = 0; i < c->struts.n; i++) {
            const int h = c->struts.h[i];
            slow[i] = cos(2 * M_PI * c->solid->x0[0][h] / (LONG * SPACING));
            fast[i] = noise(c->solid, h, 0);
        }
        cracks_precondition_begin(c, dt);
        check_equal(c->work->bricks, 1);
        check_equal(c->work->coarse->side, 4);
        check_below(error_of(c, dt, slow), 0.02);
        check_below(error_of(c, dt, fast), 0.02);
        c->work->bricks = 0;
        check_above(error_of(c, dt, slow), 0.5);
        free(slow);
        free(fast);
        struct solid *s = c->solid;
        cracks_free(c);
        solid_free(s);
    }
}

/* a.M b is b.M a, and a.M a above 0, with bricks and without, also where particles are not full. */
static void symmetric(void **state) {
    (void)state;
    for (int q = 0; q < 4; q++) {
        double dt;
        struct cracks *c = crack_of(&planes[q % 2], q < 2 ? 1e4 : 10, &dt);
        double *a = array_of(c), *b = array_of(c), *of_a = array_of(c), *of_b = array_of(c);
        for (int i = 0; i < c->struts.n; i++) {
            const int h = c->struts.h[i];
            a[i] = noise(c->solid, h, 1);
            b[i] = noise(c->solid, h, 2);
            if (noise(c->solid, h, 3) > 0.8) c->work->set[i] = CRACKS_CAVITY;
        }
        cracks_precondition_begin(c, dt);
        check_equal(c->work->bricks, q < 2);
        precondition(c, dt, a, of_a);
        precondition(c, dt, b, of_b);
        check_relative(dot(c, b, of_a), dot(c, a, of_b), 1e-9);
        check_above(dot(c, a, of_a), 0);
        check_above(dot(c, b, of_b), 0);
        for (int i = 0; i < c->struts.n; i++)
            if (c->work->set[i] != CRACKS_FULL) check_equal(of_a[i], 0);
        free(a);
        free(b);
        free(of_a);
        free(of_b);
        struct solid *s = c->solid;
        cracks_free(c);
        solid_free(s);
    }
}

/* The flow between two bricks is that of the links across their border over the links between their middles, and the
 * bricks have the particles' mass. */
static void bricks(void **state) {
    (void)state;
    double dt;
    struct cracks *c = crack_of(&planes[0], 1e4, &dt);
    cracks_precondition_begin(c, dt);
    const struct cracks_coarse *b = c->work->coarse;
    double mass = 0, conductance = 0, sum[2] = {0, 0};
    for (int i = 0; i < c->struts.n; i++) mass += dt * dt * c->struts.diagonal[i];
    for (int k = 0; k < b->bricks; k++) {
        sum[0] += b->matrix[k];
        sum[1] += b->matrix[b->bricks + k];
    }
    const struct cracks_rows *r = &c->struts.rows;
    for (int i = 0; i < c->struts.n; i++) {
        const int x = (int)lrint(c->solid->x0[0][c->struts.h[i]] / SPACING - 0.5), slot = c->struts.slot[i];
        const int row = slot / CRACKS_LANES, lane = slot % CRACKS_LANES;
        for (long k = r->link_start[row]; k < r->link_start[row + 1]; k++)
            if (x % 4 == 3 && r->link[k].kind == 1) conductance += c->work->conductance[CRACKS_LANES * k + lane];
    }
    check_relative(sum[0], par_sum(mass), 1e-12);
    check_relative(sum[1], dt / 4 * par_sum(conductance), 1e-12);
    struct solid *s = c->solid;
    cracks_free(c);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(inverse), cmocka_unit_test(symmetric),
                                       cmocka_unit_test(bricks)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
