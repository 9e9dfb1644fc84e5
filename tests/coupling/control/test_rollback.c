/* Steps repeated from a state kept in memory are the same to the bit. */
#include "coupling/interface/marker_force.h"
#include "coupling/control/rollback.h"
#include "coupling/run.h"
#include "coupling/step.h"
#include "program/output/checkpoint.h"
#include "tests/coupling/scene_of.h"
#include "solid/bonds/family.h"
#include "solid/contact/contact.h"
#include "solid/refine/refine.h"
#include "tests/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A weak block in a channel's flow, so that it breaks at once. */
static const char *const channel =
    "title: test\n"
    "domain: {size: [0.16, 0.08, 0.08], cells: [32, 16, 16]}\n"
    "fluid:\n"
    "  density: 1000\n"
    "  viscosity: 1.0e-3\n"
    "  initial: {velocity: [0.1, 0, 0]}\n"
    "  sides:\n"
    "    x_low: {type: inflow, profile: uniform, bulk_velocity: 0.1}\n    x_high: {type: outflow}\n"
    "    y_low: {type: wall}\n    y_high: {type: wall}\n"
    "    z_low: {type: periodic}\n    z_high: {type: periodic}\n"
    "solid:\n"
    "  materials:\n"
    "    - {name: soft, youngs_modulus: 1.0e6, density: 3000, fracture_energy: 1.0e-4}\n"
    "  bodies:\n"
    "    - {name: block, material: soft, shape: box, low: [0.06, 0.0, 0.02], high: [0.09, 0.055, 0.06]}\n"
    "  constraints:\n"
    "    - {low: [0, 0, 0], high: [0.16, 0.006, 0.08], directions: xyz}\n"
    "stages:\n"
    "  - {name: drift, steps: 100, time_step: 1.0e-3, integrator: verlet, damping_relative: 1.0e11}\n";

/* Two weak blocks that collide under a load that varies in time. */
static const char *const blocks =
    "title: test\n"
    "domain: {size: [0.2, 0.1, 0.1]}\n"
    "solid:\n"
    "  spacing: 0.005\n"
    "  materials:\n"
    "    - {name: soft, youngs_modulus: 1.0e7, density: 1000, fracture_energy: 0.05}\n"
    "  bodies:\n"
    "    - {name: left, material: soft, shape: box, low: [0.05, 0.03, 0.03], high: [0.09, 0.06, 0.06]}\n"
    "    - {name: right, material: soft, shape: box, low: [0.1, 0.04, 0.04], high: [0.13, 0.07, 0.07]}\n"
    "  constraints:\n"
    "    - {low: [0.12, 0.04, 0.04], high: [0.13, 0.07, 0.07], velocity: [-5, 0, 0], time: [[0, 1], [1.0e-2, "
    "2]]}\n"
    "  loads:\n"
    "    - {low: [0.05, 0.03, 0.03], high: [0.06, 0.06, 0.06], force: [1.0e7, 0, 0], time: [[0, 0], [1.0e-3, "
    "2], [2.0e-3, 0]]}\n"
    "stages:\n"
    "  - {name: meet, steps: 1000, time_step: 5.0e-5, integrator: verlet}\n";

/* A plate, of lists of bonds, that is torn. */
static const char *const plate =
    "title: test\n"
    "domain: {size: [0.06, 0.04]}\n"
    "solid:\n"
    "  spacing: 0.001\n"
    "  model: plane_stress\n"
    "  thickness: 0.002\n"
    "  materials:\n"
    "    - {name: glass, youngs_modulus: 7.2e10, density: 2235, fracture_energy: 20}\n"
    "  bodies:\n"
    "    - {name: plate, material: glass, shape: rectangle, low: [0, 0], high: [0.06, 0.04]}\n"
    "  cracks:\n"
    "    - {name: notch, points: [[0, 0.02], [0.02, 0.02]]}\n"
    "  loads:\n"
    "    - {edge: {from: [0, 0.04], to: [0.06, 0.04]}, traction: [0, 8.0e6], time: [[0, 1], [4.0e-6, 0.5]]}\n"
    "    - {edge: {from: [0, 0], to: [0.06, 0]}, traction: [0, -8.0e6], time: [[0, 1], [4.0e-6, 0.5]]}\n"
    "  refinement: {levels: 1, energy: 0.5, damage: 0.3, from: 1.0e-5, every: 5}\n"
    "stages:\n"
    "  - {name: pull, steps: 1000, time_step: 5.0e-8, integrator: verlet}\n";

/* All data that a later step depends on, as a list of numbers. */
struct snapshot {
    int n, capacity;
    double *value;
};

static void add(struct snapshot *p, double value) {
    if (p->n == p->capacity) {
        p->capacity = 2 * p->capacity + 1024;
        p->value = realloc(p->value, (size_t)p->capacity * sizeof *p->value);
        assert_non_null(p->value);
    }
    p->value[p->n++] = value;
}

static void add_fluid(struct snapshot *p, struct run *r) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const struct fluid_state *q = fluid_state_of(r->fluid);
    const double *const field[4] = {q->u, q->v, q->w, q->p};
    for (int f = 0; f < 4; f++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++) add(p, field[f][fluid_grid_at(g, i, j, k)]);
    add(p, q->driving);
}

static void add_solid(struct snapshot *p, struct run *r) {
    struct solid *s = r->solid;
    const int bytes = solid_family_bytes(s);
    uint8_t *bits = malloc((size_t)bytes + 1);
    assert_non_null(bits);
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) {
            add(p, s->d[c][h]);
            add(p, s->v[c][h]);
            add(p, s->load[c][h]);
            if (r->v_last[c]) add(p, r->v_last[c][h]);
        }
    for (int h = 0; h < s->n; h++) {
        add(p, s->flag[h]);
        solid_family_save(s, h, bits);
        for (int b = 0; b < bytes; b++) add(p, bits[b]);
    }
    free(bits);
    add(p, s->e_damped);
    add(p, s->e_fracture);
    add(p, s->e_constraint);
    add(p, s->work_load);
    add(p, solid_contact_force_energy(s));
    for (int i = 0; r->surface && i < r->surface->n; i++) {
        add(p, r->surface->h[i]);
        add(p, r->surface->area[i]);
        add(p, r->surface->two_sided[i]);
        for (int c = 0; c < 3; c++) add(p, r->surface->normal[c][i]);
    }
    if (r->surface) add(p, (double)r->surface->total + 1e-3 * (double)r->surface->isolated);
}

static void add_marker_force(struct snapshot *p, struct run *r) {
    double(*force)[3] = calloc((size_t)r->solid->n + 1, sizeof *force);
    assert_non_null(force);
    marker_force_by_particle(r, force);
    for (int h = 0; h < r->solid->n; h++)
        for (int c = 0; c < 3; c++) add(p, force[h][c]);
    free(force);
}

static struct snapshot snapshot_of(struct run *r) {
    struct snapshot p = {0};
    add(&p, (double)r->step);
    add(&p, r->t);
    add(&p, r->dt);
    add(&p, r->substeps);
    if (r->fluid) add_fluid(&p, r);
    if (r->solid) add_solid(&p, r);
    if (marker_force_is_kept(r)) add_marker_force(&p, r);
    return p;
}

static void assert_same(const struct snapshot *a, const struct snapshot *b) {
    assert_int_equal(a->n, b->n);
    int differ = 0, first = -1;
    for (int i = 0; i < a->n; i++)
        if (a->value[i] != b->value[i]) {
            if (first < 0) first = i;
            differ++;
        }
    if (differ)
        print_message("rank %d: %d of %d differ, first %d: %.17g %.17g\n", par_rank(), differ, a->n, first,
                      a->value[first], b->value[first]);
    check_equal(par_max(differ), 0);
}

static void steps(struct run *r, int n) {
    for (int k = 0; k < n; k++) step_advance(r);
}

static long broken(struct run *r) {
    solid_family_count(r->solid);
    return r->solid->bonds_broken;
}

/* The state of an unstable run: NaN everywhere. */
static void spoil(struct run *r) {
    if (r->fluid) {
        const struct fluid_state *q = fluid_state_of(r->fluid);
        double *const field[4] = {q->u, q->v, q->w, q->p};
        for (int f = 0; f < 4; f++)
            for (size_t i = 0; i < fluid_grid_of(r->fluid)->size; i++) field[f][i] = NAN;
    }
    for (int c = 0; r->solid && c < r->solid->dim; c++)
        for (int h = 0; h < r->solid->n; h++) r->solid->d[c][h] = r->solid->v[c][h] = NAN;
    if (r->solid) r->solid->a_holds = 0;
    steps(r, 1);
}

struct course {
    const char *scene;
    int settings;
    const char *set[4];
    int before, after; /* steps before the state is kept, and after it */
    int breaks, meets; /* events that must have happened */
};

/* Takes `before` steps; keeps the state; takes `after` steps: result A. Takes as many more; restores; takes `after`
 * steps: A again. Sets NaN; restores; takes `after` steps: A again. The same with a second state saved in between, and
 * the first restored over it. */
static void go(const struct course *q) {
    struct scene *scene = scene_of(q->scene, "", q->settings, q->set);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    steps(r, q->before);
    struct rollback *g = rollback_new(r), *other = rollback_new(r);
    const long start = r->solid ? broken(r) : 0;
    rollback_save(g, r);
    const long from = r->step;
    steps(r, q->after / 2);
    rollback_save(other, r);
    steps(r, q->after - q->after / 2);
    struct snapshot first = snapshot_of(r);
    if (q->breaks) check_above(broken(r), start);
    if (q->meets) assert_non_null(r->solid->contact);
    if (q->meets) check_above(solid_contact_force_energy(r->solid), 0);
    steps(r, q->after);
    for (int round = 0; round < 3; round++) {
        const int is_last = round == 2;
        if (round == 1) spoil(r);
        assert_int_equal(rollback_restore(g, r), from);
        if (is_last) steps(r, q->after / 2);
        if (is_last) rollback_save(other, r);
        if (is_last) steps(r, q->after);
        if (is_last) rollback_restore(other, r);
        steps(r, is_last ? q->after - q->after / 2 : q->after);
        struct snapshot again = snapshot_of(r);
        assert_same(&first, &again);
        free(again.value);
    }
    rollback_free(other);
    rollback_free(g);
    free(first.value);
    run_free(r);
    scene_free(scene);
}

static void test_coupled(void **state) {
    (void)state;
    go(&(struct course){channel, 0, {NULL}, 12, 10, 1, 0});
    go(&(struct course){channel, 0, {NULL}, 0, 6, 0, 0});
    go(&(struct course){channel, 2, {"stages.drift.time_step=auto", "stages.drift.cfl=0.1"}, 6, 8, 1, 0});
    go(&(struct course){channel, 1, {"stages.drift.integrator=rk3"}, 12, 6, 1, 0});
}

/* The guess of the implicit forcing is restored with the rest, with the solid elastic or at rest. */
static void test_implicit(void **state) {
    (void)state;
    const char *const lasting = "solid.materials.soft.fracture_energy=.inf";
    const char *const implicit = "fluid.diffusion=implicit";
    go(&(struct course){channel, 2, {implicit, lasting}, 8, 6, 0, 0});
    go(&(struct course){channel, 2, {implicit, lasting}, 0, 4, 0, 0}); /* kept before there are markers */
    go(&(struct course){
        channel, 4, {implicit, lasting, "stages.drift.time_step=auto", "stages.drift.cfl=0.1"}, 6, 6, 0, 0});
    const char *const rigid =
        "stages=[{name: drift, steps: 100, time_step: 1.0e-3, solid: rigid}, {name: later, steps: 1}]";
    go(&(struct course){channel, 3, {implicit, lasting, rigid}, 8, 6, 0, 0});
}

static void test_fluid_alone(void **state) {
    (void)state;
    const char *const bulk = "title: test\n"
                             "domain: {size: [0.1, 0.05, 0.05], cells: [16, 12, 8]}\n"
                             "fluid:\n"
                             "  density: 1000\n"
                             "  viscosity: 1.0e-4\n"
                             "  initial: {velocity: [0.1, 0.02, 0]}\n"
                             "  driving: {type: bulk_velocity, direction: x, value: 0.1}\n"
                             "  sides:\n"
                             "    x_low: {type: periodic}\n    x_high: {type: periodic}\n"
                             "    y_low: {type: wall}\n    y_high: {type: wall}\n"
                             "    z_low: {type: periodic}\n    z_high: {type: periodic}\n"
                             "stages:\n"
                             "  - {name: flow, steps: 100, time_step: auto}\n";
    go(&(struct course){bulk, 0, {NULL}, 3, 10, 0, 0});
}

static void test_contact(void **state) {
    (void)state;
    go(&(struct course){blocks, 0, {NULL}, 4, 40, 1, 1});  /* before anything can touch */
    go(&(struct course){blocks, 0, {NULL}, 30, 20, 1, 1}); /* in contact */
    go(&(struct course){blocks, 0, {NULL}, 60, 40, 1, 1}); /* lists made again in between */
    go(&(struct course){blocks, 1, {"stages.meet.integrator=rk3"}, 30, 20, 1, 1});
}

static void test_plate(void **state) {
    (void)state;
    go(&(struct course){plate, 1, {"solid.refinement.from=1"}, 150, 24, 1, 0});
    go(&(struct course){plate, 2, {"solid.refinement.from=1", "stages.pull.integrator=rk3"}, 150, 24, 1, 0});
}

/* A refinement makes other particles: a state kept before does not fit, which is reported. */
static void test_refined(void **state) {
    (void)state;
    const char *set[] = {"solid.refinement.from=0"};
    struct scene *scene = scene_of(plate, "", 1, set);
    struct run *r = run_new(scene);
    step_begin_stage(r);
    struct rollback *g = rollback_new(r);
    assert_int_equal(rollback_restore(g, r), -1); /* nothing kept */
    rollback_save(g, r);
    const long before = solid_refine_events(r->solid);
    while (solid_refine_events(r->solid) == before && r->step < 400) steps(r, 1);
    check_above(solid_refine_events(r->solid), before);
    assert_false(rollback_fits(g, r));
    assert_int_equal(rollback_restore(g, r), -1);
    rollback_free(g);
    g = rollback_new(r);
    rollback_save(g, r);
    const long events = solid_refine_events(r->solid);
    const int n = 4 - (int)(r->step % 5); /* up to the next look */
    steps(r, n);
    struct snapshot first = snapshot_of(r);
    assert_int_equal(solid_refine_events(r->solid), events);
    rollback_restore(g, r);
    steps(r, n);
    struct snapshot again = snapshot_of(r);
    assert_same(&first, &again);
    free(first.value);
    free(again.value);
    rollback_free(g);
    run_free(r);
    scene_free(scene);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_coupled),     cmocka_unit_test(test_implicit),
                                       cmocka_unit_test(test_fluid_alone), cmocka_unit_test(test_contact),
                                       cmocka_unit_test(test_plate),       cmocka_unit_test(test_refined)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
