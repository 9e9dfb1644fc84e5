/* Pressures of substeps: the balances of volume and momentum, and the ranks. */
#include "base/par.h"
#include "cracks/measure.h"
#include "cracks/project.h"
#include "cracks/aperture.h"
#include "cracks/solve.h"
#include "cracks/struts.h"
#include "cracks/sums.h"
#include "solid/force/force.h"
#include "solid/step/integrate.h"
#include "tests/cracks/make.h"
#include "tests/one_rank.h"

#include <stdio.h>
#include <stdlib.h>

/* A plate with a crack that fluid is pumped into. slow: the factor of all times, with the density times its square, the
 * viscosity times it and the rate over it. second: another injection; NULL: none. */
struct run {
    struct solid *s;
    struct cracks *c;
    double dt;
};

static struct run begin(int space, double fracture_energy, double viscosity, double compressibility, double pressure,
                        double slow, const struct cracks_injection *second) {
    const double half = 3 * SPACING, mid = 12 * SPACING;
    const double line[2][3] = {{mid - half, mid, 0}, {mid + half, mid, 0}};
    const double quad[4][3] = {{3e-3, 3e-3, 6e-3}, {8e-3, 3e-3, 6e-3}, {8e-3, 8e-3, 6e-3}, {3e-3, 8e-3, 6e-3}};
    const struct solid_cut flat = {2, line}, plane = {4, quad};
    const double t[2] = {0, slow * 1e-4}, factor[2] = {0, 1};
    struct cracks_injection in = {.low = {mid - SPACING, mid - 3 * SPACING, 0},
                                  .high = {mid + SPACING, mid + 3 * SPACING, 0},
                                  .value = 2e-4,
                                  .time = {2, t, factor, 0}};
    if (space) {
        in = (struct cracks_injection){.low = {4e-3, 4e-3, 5e-3}, .high = {6e-3, 6e-3, 7e-3}, .value = 5e-4};
        in.time = (struct solid_time){2, t, factor, 0};
    }
    in.value /= slow;
    if (pressure > 0) {
        in.is_pressure = 1;
        in.value = pressure;
    }
    struct run r = {.s = make((struct make){.sites = {space ? 11 : 24, space ? 11 : 24, space ? 12 : 0},
                                            .cuts = 1,
                                            .cut = space ? &plane : &flat,
                                            .fracture_energy = fracture_energy,
                                            .density = slow * slow * DENSITY})};
    struct cracks_injection both[2] = {in};
    if (second) both[1] = *second;
    const struct cracks_input input = {.viscosity = slow * viscosity,
                                       .compressibility = compressibility,
                                       .least_aperture = 1e-8,
                                       .injections = second ? 2 : 1,
                                       .injection = both};
    r.s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .breakage = fracture_energy > 0};
    r.c = cracks_new(&input, r.s);
    r.dt = slow * 0.3 * SPACING / sqrt(YOUNG / DENSITY);
    cracks_begin(r.c, 1);
    return r;
}

static void end(struct run *r) {
    cracks_free(r->c);
    solid_free(r->s);
}

/* The work of the pressures in a substep, p dV. */
static double work_of(const struct cracks *c, const double *before) {
    double sum = 0;
    for (int i = 0; i < c->struts.n; i++) sum += c->p[i] * (c->volume[i] - before[i]);
    return sum;
}

/* Pressures are least where there is void and nowhere below. */
static void check_void(const struct cracks *c) {
    for (int i = 0; i < c->struts.n; i++) {
        check_at_least(c->p[i], c->in.least_pressure);
        check_at_least(c->cavity[i], -1e-6 * fabs(c->volume[i]) - 1e-15);
        if (c->p[i] > c->in.least_pressure) check_equal(c->cavity[i], 0);
    }
}

/* The rows that were made again where bonds broke are those that are found from the bonds at once. */
static void check_rows(struct cracks *c) {
    const int n = c->struts.n;
    double *p = calloc((size_t)(n + c->struts.ghosts) + 1, sizeof *p), *v = malloc(((size_t)n + 1) * sizeof *v);
    cracks_vec *force = aligned_alloc(sizeof *force, ((size_t)n + 1) * sizeof *force);
    const long entries = c->struts.rows.struts - c->struts.rows.struts_dead;
    for (int i = 0; i < n; i++) p[i] = 1 + noise(c->solid, c->struts.h[i], 3);
    cracks_struts_update(&c->struts, sizeof *p, p);
    cracks_sums_force(c, p, force);
    cracks_aperture_volume(c, v);
    double *const diagonal = memcpy(malloc(((size_t)n + 1) * sizeof *v), c->struts.diagonal, (size_t)n * sizeof *v),
                  *const area = memcpy(malloc(((size_t)n + 1) * sizeof *v), c->struts.area_size, (size_t)n * sizeof *v);
    c->stale = 1;
    cracks_project_end(c);
    assert_int_equal(c->struts.n, n);
    assert_int_equal(c->struts.rows.struts_dead, 0);
    assert_int_equal(c->struts.rows.struts, entries);
    cracks_sums_force(c, p, c->work->force);
    cracks_aperture_volume(c, c->work->b);
    for (int i = 0; i < n; i++) {
        for (int k = 0; k < 3; k++) check_equal(c->work->force[i][k], force[i][k]);
        check_equal(c->work->b[i], v[i]);
        check_equal(c->struts.diagonal[i], diagonal[i]);
        check_equal(c->struts.area_size[i], area[i]);
    }
    free(p);
    free(v);
    free(force);
    free(diagonal);
    free(area);
}

enum { KINDS = 8, STEPS = 120, NUMBERS = 9, ROWS = 4 };

/* One of the kinds; value: numbers of some steps. */
static void pump(int kind, double (*value)[NUMBERS]) {
    const int space = kind % 2, breaks = kind / 2 == 1;
    struct run r = begin(space, breaks ? 20 : 0, kind == 4 ? 1e-1 : 1e-3, kind / 2 == 2 ? 1e-9 : 0,
                         kind / 2 == 3 ? 2e7 : 0, 1, NULL);
    double *before = malloc((size_t)r.s->n * sizeof *before), work = 0, momentum[4] = {0};
    for (int step = 0; step < STEPS; step++) {
        for (int i = 0; i < r.c->struts.n; i++) before[i] = r.c->volume[i];
        solid_integrate(r.s, r.dt, 1);
        assert_int_equal(r.c->status.failed, 0);
        if (!breaks) {
            work += work_of(r.c, before);
            check_void(r.c);
        }
        cracks_project_end(r.c);
        const struct cracks_values v = cracks_measure(r.c);
        check_close(v.residual / v.volume, 0, 1e-12);
        check_above(v.injected, 0);
        if (step % (STEPS / ROWS) < STEPS / ROWS - 1) continue;
        const double row[NUMBERS] = {v.injected,      v.volume, v.cavity,       v.injection_pressure, v.injection_rate,
                                     v.pressure_mean, v.area,   v.aperture_max, v.wet_particles};
        memcpy(value[step / (STEPS / ROWS)], row, sizeof row);
    }
    if (!breaks) check_relative(par_sum(r.s->work_load), par_sum(work), 1e-11);
    if (breaks) {
        solid_family_count(r.s);
        check_above(r.c->renewals, 5);
        check_rows(r.c);
    }
    for (int h = 0; h < r.s->n; h++)
        for (int k = 0; k < r.s->dim; k++) {
            const double mv = DENSITY * r.s->volume[h] * r.s->v[k][h];
            momentum[k] += mv;
            momentum[3] += fabs(mv);
        }
    par_sum_array(momentum, 4);
    for (int k = 0; k < 3; k++) check_close(momentum[k] / momentum[3], 0, 1e-12);
    free(before);
    end(&r);
}

/* Volumes add up to what was injected, the work is p dV, momentum stays 0: at a rate and at a pressure, compressible or
 * not, viscous or not, in cracks that grow or do not. The numbers are the same on any number of ranks: one rank writes
 * them to a file, more ranks compare. The last ones differ where the iteration stops elsewhere. */
static void balance(void **state) {
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        if (check_skips(kind + kind / 2, 1)) continue; /* in a debug build a plate or a block of each */
        double value[ROWS][NUMBERS], expected[ROWS][NUMBERS];
        char name[64];
        snprintf(name, sizeof name, "cracks_test_project_%d", kind);
        pump(kind, value);
        one_rank_expects(name, value, sizeof value, expected);
        for (int i = 0; i < ROWS; i++)
            for (int k = 0; k < NUMBERS; k++)
                check_close(value[i][k], expected[i][k],
                            1e-8 * fabs(expected[i][k]) + 1e-8 * (k == 2) * expected[i][1]);
    }
}

/* A density that is 16 times as high with steps four times as long is the same motion, if the viscosity is four times
 * as high and the rate a quarter: how a user scales the mass to compress time (docs/scene.md). */
static void similar(void **state) {
    (void)state;
    struct cracks_values v[2];
    for (int k = 0; k < 2; k++) {
        struct run r = begin(0, 20, 1e-3, 0, 0, k ? 4 : 1, NULL);
        for (int step = 0; step < STEPS; step++) solid_integrate(r.s, r.dt, 1);
        assert_int_equal(r.c->status.failed, 0);
        cracks_project_end(r.c);
        v[k] = cracks_measure(r.c);
        solid_family_count(r.s);
        check_above(r.c->renewals, 5);
        end(&r);
    }
    check_above(v[0].injection_pressure, 1e5);
    check_relative(v[1].injection_pressure, v[0].injection_pressure, 1e-10);
    check_relative(v[1].volume, v[0].volume, 1e-10);
    check_relative(v[1].injection_rate, 0.25 * v[0].injection_rate, 1e-12);
    check_equal(v[1].wet_particles, v[0].wet_particles);
}

/* Two boxes that overlap, the first of a given pressure. Of two pressures the later one holds where both do, and the
 * fluid enters there once; a rate enters the first box's particles and leaves by their pressure. */
static void boxes_that_overlap(void **state) {
    (void)state;
    const double half = 3 * SPACING, mid = 12 * SPACING, t[2] = {0, 1e-4}, factor[2] = {0, 1};
    for (int kind = 0; kind < 3; kind++) {
        const struct cracks_injection second = {.low = {mid - (kind ? 0.6 : 1) * half, mid - half, 0},
                                                .high = {mid + (kind ? 0.6 : 1) * half, mid + half, 0},
                                                .is_pressure = kind < 2,
                                                .value = kind < 2 ? 2e7 : 1e-4,
                                                .time = {2, t, factor, 0}};
        struct run r = begin(0, 0, 1e-3, 0, 2e7, 1, &second);
        for (int step = 0; step < STEPS / 2; step++) {
            solid_integrate(r.s, r.dt, 1);
            assert_int_equal(r.c->status.failed, 0);
            cracks_project_end(r.c);
            const struct cracks_values v = cracks_measure(r.c);
            check_close(v.residual / v.volume, 0, 1e-12);
            check_above(v.injected, 0);
        }
        end(&r);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(balance), cmocka_unit_test(similar),
                                       cmocka_unit_test(boxes_that_overlap)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
