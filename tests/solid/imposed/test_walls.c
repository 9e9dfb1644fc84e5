/* Walls: what they push and what not, the balances of a body that is thrown at one, the stable step of loose particles.
 */
#include "base/par.h"
#include "solid/force/force.h"
#include "solid/imposed/reactions.h"
#include "solid/imposed/walls.h"
#include "solid/measure/energy.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

static const double SPACING = 1e-3, YOUNG = 1e7, DENSITY = 2000, HORIZON_RATIO = 2;

struct box {
    double low[3], high[3]; /* spacings */
};

/* Boxes of one material each in a domain of 16 spacings, whose sides are walls in the given directions. The lattice
 * lies half a spacing above y = 0, and `offset` spacings more. Bodies that reach below y = -1 spacing are held below 0.
 */
static struct solid *make(enum physics_model model, int bodies, const struct box *box, const int walls[3],
                          const double v[3], double offset) {
    const struct solid_material material = {YOUNG, DENSITY, INFINITY, HORIZON_RATIO, PHYSICS_CONSTANT, 0, 0};
    const double far = 100 * SPACING;
    const struct solid_constraint held = {.low = {-far, -far, -far}, .high = {far, 0, far}, .direction = {1, 1, 1}};
    const signed char turn[4] = {0};
    struct solid_body body[2] = {{.name = "first", .shape = SOLID_BOX}, {.name = "second", .shape = SOLID_BOX}};
    double corner[2][4][2];
    struct solid_outline outline[2];
    struct solid_input in = {.model = model,
                             .thickness = 2e-3,
                             .spacing = SPACING,
                             .origin = {0, offset * SPACING, 0},
                             .bodies = bodies,
                             .body = body,
                             .materials = 1,
                             .material = &material,
                             .constraints = box[0].low[1] < -1,
                             .constraint = &held};
    for (int b = 0; b < bodies; b++) {
        for (int c = 0; c < 3; c++) {
            body[b].low[c] = SPACING * box[b].low[c];
            body[b].high[c] = SPACING * box[b].high[c];
            body[b].velocity[c] = v[c];
        }
        if (model == PHYSICS_3D) continue;
        for (int i = 0; i < 4; i++) {
            corner[b][i][0] = i == 0 || i == 3 ? body[b].low[0] : body[b].high[0];
            corner[b][i][1] = i < 2 ? body[b].low[1] : body[b].high[1];
        }
        outline[b] = (struct solid_outline){0, 4, (const double(*)[2])corner[b], (const double(*)[2])corner[b], turn};
        body[b].shape = SOLID_POLYGON;
        body[b].outlines = 1;
        body[b].outline = &outline[b];
    }
    for (int c = 0; c < 3; c++) {
        in.length[c] = 16 * SPACING;
        in.wall[c][0] = in.wall[c][1] = walls[c];
    }
    return solid_new(&in);
}

static const int all[3] = {1, 1, 1}, floor_only[3] = {0, 1, 0};
static const double rest[3] = {0};

static double energy_of(struct solid *s) {
    solid_walls_list(s);
    return par_sum(solid_walls_energy(s));
}

/* The force along y of all particles after they have moved down, N. */
static double lift(struct solid *s, double down) {
    double sum = 0;
    for (int h = 0; h < s->n; h++)
        if (!(s->flag[h] & SOLID_HELD_Y)) s->d[1][h] = -down;
    solid_walls_list(s);
    for (int h = 0; h < s->n; h++) s->a[1][h] = 0;
    solid_walls_push(s);
    for (int h = 0; h < s->n; h++) sum += DENSITY * s->volume[h] * s->a[1][h];
    return par_sum(sum);
}

static double stiffness_per_area(void) {
    return 4 * YOUNG / (HORIZON_RATIO * HORIZON_RATIO * SPACING); /* Pa/m, of a layer of particles */
}

/* A body that stands on a wall, or begins nearer than half a spacing, or with its particles on it, is not pushed; then
 * each particle of its lowest layer is, by k times the volume times the way, which is the derivative of the energy. */
static void stands(void **state) {
    (void)state;
    for (int kind = 0; kind < 6; kind++) {
        const double offset = (const double[]){0, -0.3, -0.5}[kind % 3];
        const int is_plate = kind >= 3;
        const struct box box = {{4, offset, 4}, {8, offset + 3, 8}};
        struct solid *s = make(is_plate ? PHYSICS_PLANE_STRESS : PHYSICS_3D, 1, &box, all, rest, offset);
        const double area = is_plate ? 4 * SPACING * 2e-3 : 16 * SPACING * SPACING, e = 1e-3 * SPACING;
        check_close(lift(s, 0), 0, 1e-12 * stiffness_per_area() * area * SPACING);
        check_close(lift(s, -0.1 * SPACING), 0, 0);
        check_relative(lift(s, 0.1 * SPACING), stiffness_per_area() * area * 0.1 * SPACING, 1e-9);
        const double least = energy_of(s), force = lift(s, 0.1 * SPACING + 0.5 * e);
        lift(s, 0.1 * SPACING + e);
        check_relative((energy_of(s) - least) / e, force, 1e-9);
        solid_free(s);
    }
}

/* A body that stands in the wall, and is held there, is what its neighbours and other bodies above it meet; beside it
 * the side is a wall. */
static void is_solid_where_solid_stands(void **state) {
    (void)state;
    const struct box box[2] = {{{4, -3, 4}, {8, 4, 8}}, {{9, 0, 4}, {11, 2, 6}}};
    struct solid *s = make(PHYSICS_3D, 2, box, floor_only, rest, 0);
    const double one = stiffness_per_area() * SPACING * SPACING * 0.1 * SPACING;
    check_relative(lift(s, 0.1 * SPACING), 4 * one, 1e-9);
    for (int h = 0; h < s->n; h++) /* the second body moves over the first one's foot, two spacings too far */
        if (s->body[h] == 1) s->d[0][h] = -6 * SPACING;
    check_close(lift(s, 0.1 * SPACING), 2 * one, 1e-9 * one);
    for (int h = 0; h < s->n; h++) /* and out of the domain, where the wall goes on */
        if (s->body[h] == 1) s->d[0][h] = -30 * SPACING;
    check_relative(lift(s, 0.1 * SPACING), 4 * one, 1e-9);
    solid_free(s);
}

static double balance_of(struct solid *s) {
    const struct solid_energy e = solid_energy_measure(s);
    return e.kinetic + e.strain + e.contact + par_sum(s->e_integrator);
}

/* Thrown into a corner, it comes back with the velocity turned round in each direction. Momentum is what the walls
 * gave, to round-off, and so is energy by velocity Verlet. A single particle has no waves to leave energy in: it comes
 * back as fast as it came, whatever the step. */
static void comes_back(void **state) {
    (void)state;
    const double v[3] = {-0.5, -0.4, -0.3};
    const struct box one = {{3, 2, 2}, {4, 3, 3}}, cube = {{3, 2, 2}, {6, 5, 5}};
    for (int kind = 0; kind < 8; kind++) {
        const int is_one = !(kind & 1), is_long = kind & 4;
        if (is_long && !is_one) continue;
        struct solid *s = make(kind & 2 ? PHYSICS_PLANE_STRESS : PHYSICS_3D, 1, is_one ? &one : &cube, all, v, 0);
        s->stage = (struct solid_stage){.integrator = SOLID_VERLET};
        const double dt = (is_long ? 0.9 : 0.5) * solid_rates_stable_step(s, SOLID_VERLET), first = balance_of(s);
        double impulse[3] = {0}, before[3] = {0}, after[3] = {0}, largest = 0;
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < s->dim; c++) before[c] += DENSITY * s->volume[h] * s->v[c][h];
        while (s->t < 0.016) {
            solid_reactions_begin(s);
            solid_integrate(s, dt, is_long ? 1 : 5);
            solid_reactions_impulse(s, impulse);
            largest = fmax(largest, solid_energy_measure(s).contact);
        }
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < s->dim; c++) after[c] += DENSITY * s->volume[h] * s->v[c][h];
        par_sum_array(impulse, 3);
        par_sum_array(before, 3);
        par_sum_array(after, 3);
        for (int c = 0; c < s->dim; c++) {
            check_relative(after[c] - before[c], impulse[c], 1e-12);
            check_between(-after[c] / before[c], is_one ? 1 - 1e-12 : 0.5, is_one ? 1 + 1e-12 : 1.03);
        }
        check_above(largest, 0.01 * first);
        check_relative(balance_of(s), first, is_one ? 1e-12 : 2e-3);
        if (is_one) check_close(par_sum(s->e_integrator), 0, 1e-12 * first);
        solid_free(s);
    }
}

/* A particle that was squeezed into the foot of a body that is held in a wall moves from there towards the wall beside
 * the foot. If it is slow, it comes back. If it has more energy than the place under the wall, it comes
 * out there. It keeps its energy. (Where a wall began at once, it left with that of the place under the wall as well.)
 */
static void comes_from_under_a_body(void **state) {
    (void)state;
    const struct box box[2] = {{{4, -3, 4}, {8, 1, 8}}, {{9, 0, 5}, {10, 1, 6}}};
    const double deep = 0.9 * SPACING, whole = deep * sqrt(4 * YOUNG / DENSITY) / (HORIZON_RATIO * SPACING);
    for (int fast = 0; fast < 2; fast++) {
        struct solid *s = make(PHYSICS_3D, 2, box, floor_only, rest, 0);
        const double v = fast ? 1.2 * whole : 0.4 * whole;
        int mine = -1;
        for (int h = 0; h < s->n; h++)
            if (s->body[h] == 1) mine = h;
        if (mine >= 0) {
            s->d[1][mine] = -deep;
            s->d[0][mine] = -3 * SPACING;
            s->v[0][mine] = v;
        }
        s->stage = (struct solid_stage){.integrator = SOLID_VERLET};
        const double dt = 0.02 * solid_rates_stable_step(s, SOLID_VERLET), first = balance_of(s);
        check_relative(first, 0.5 * DENSITY * pow(SPACING, 3) * v * v, 1e-12);
        while (s->t < 6 * SPACING / v) solid_integrate(s, dt, 1);
        check_relative(balance_of(s), first, 1e-12);
        check_relative(solid_energy_measure(s).kinetic, first, 0.02);
        const double towards = par_sum(mine >= 0 ? s->v[0][mine] : 0), up = par_sum(mine >= 0 ? s->v[1][mine] : 0);
        print_message("%s: %.3f v along the wall, %.3f v off it\n", fast ? "fast" : "slow", towards / v, up / v);
        check_between(towards / v, fast ? 0 : -1, fast ? 1 : -0.5);
        check_between(up / v, 0, 1);
        solid_free(s);
    }
}

/* The walls' energy with the second body's only particle at x and `deep` below the place where it touches, J. */
static double energy_at(struct solid *s, double x, double deep) {
    for (int h = 0; h < s->n; h++) {
        if (s->body[h] != 1) continue;
        s->d[0][h] = x - s->x0[0][h];
        s->d[1][h] = -deep;
    }
    return energy_of(s);
}

/* A loose particle deep in a wall, beside the foot of a body that is held there: the walls' rate is at least the
 * curvature of their potential, which is steeper than bonds. (Where all that stands in walls is held it was 0. A
 * fragment in such a place ended a long run: it got the energy of all others from nothing.) */
static void rate_beside_a_held_body(void **state) {
    (void)state;
    const struct box box[2] = {{{4, -3, 4}, {8, 1, 8}}, {{9, 0, 5}, {10, 1, 6}}};
    struct solid *s = make(PHYSICS_3D, 2, box, floor_only, rest, 0);
    const double mass = DENSITY * pow(SPACING, 3), e = 1e-3 * SPACING,
                 plain = 4 * YOUNG / (DENSITY * pow(HORIZON_RATIO * SPACING, 2));
    double steepest = 0;
    for (int k = 0; k < 9; k++) {
        const double x = (7.6 + 0.1 * k) * SPACING, deep = 1.5 * SPACING, middle = energy_at(s, x, deep),
                     along = energy_at(s, x + e, deep) + energy_at(s, x - e, deep) - 2 * middle,
                     across = energy_at(s, x, deep + e) + energy_at(s, x, deep - e) - 2 * middle,
                     curvature = fmax(along, across) / (mass * e * e);
        steepest = fmax(steepest, curvature);
        energy_at(s, x, deep);
        check_at_least(solid_walls_rate_deep(s, 0), curvature);
    }
    check_above(steepest, 4 * plain);
    energy_at(s, 8 * SPACING, 0.4 * SPACING); /* not deep */
    check_equal(solid_walls_rate_deep(s, 0), 0);
    energy_at(s, 10 * SPACING, 1.5 * SPACING); /* not beside the foot */
    check_equal(solid_walls_rate_deep(s, 0), 0);
    solid_free(s);
}

/* A body that stands in a wall from the start leaves through its own hole, outwards and inwards, also if it swings
 * across: nothing pushes it. */
static void leaves_through_its_hole(void **state) {
    (void)state;
    const struct box box = {{4, -1, 4}, {8, 3, 8}};
    for (int in = 0; in < 2; in++) {
        const double v[3] = {0, in ? 0.5 : -0.5, 0};
        struct solid *s = make(PHYSICS_3D, 1, &box, floor_only, v, 0);
        for (int h = 0; h < s->n; h++) s->d[0][h] = 0.01 * SPACING * sin(s->x0[0][h] / SPACING);
        s->stage = (struct solid_stage){.integrator = SOLID_VERLET};
        const double dt = 0.9 * solid_rates_stable_step(s, SOLID_VERLET), first = balance_of(s);
        while (s->t < 4 * SPACING / 0.5) solid_integrate(s, dt, 1);
        double sum[2] = {0};
        for (int h = 0; h < s->n; h++) sum[0] += s->v[0][h], sum[1] += s->v[1][h] - v[1];
        check_close(par_sum(sum[0]), 0, 1e-9);
        check_close(par_sum(sum[1]), 0, 1e-9);
        check_relative(balance_of(s), first, 1e-3); /* bonds turn and stretch */
        check_close(solid_walls_given(s), 0, 1e-12 * first);
        solid_free(s);
    }
}

/* What RK3 gains at a wall is in RK3's sums alone: a stage of velocity Verlet after it, in free flight, takes nothing.
 */
static void one_integrator_after_another(void **state) {
    (void)state;
    const double v[3] = {-0.5, 0, 0};
    const struct box one = {{2, 6, 6}, {3, 7, 7}};
    struct solid *s = make(PHYSICS_3D, 1, &one, all, v, 0);
    const double dt = 0.3 * solid_rates_stable_step(s, SOLID_RK3), first = balance_of(s);
    while (s->t < 0.006) solid_integrate(s, dt, 5);
    const double taken = par_sum(s->e_integrator);
    double back = 0;
    for (int h = 0; h < s->n; h++) back = s->v[0][h];
    check_above(par_max(back), 0.4);
    check_above(fabs(taken), 1e-9 * first);
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET};
    solid_integrate(s, dt, 5);
    check_close(par_sum(s->e_integrator), taken, 1e-14 * first);
    solid_free(s);
}

/* A loose particle has no bonds: the walls alone limit its step. A body's stable step is that of its bonds, since a
 * particle at a face has half of them. */
static void steps(void **state) {
    (void)state;
    const struct box one = {{3, 2, 2}, {4, 3, 3}}, cube = {{3, 2, 2}, {8, 7, 7}};
    const int none[3] = {0};
    struct solid *s = make(PHYSICS_3D, 1, &one, all, rest, 0);
    const double rate = 4 * YOUNG / (DENSITY * pow(HORIZON_RATIO * SPACING, 2));
    check_relative(solid_rates_stable_step(s, SOLID_VERLET), 2 / sqrt(rate), 1e-12);
    solid_free(s);
    s = make(PHYSICS_3D, 1, &cube, all, rest, 0);
    struct solid *const free = make(PHYSICS_3D, 1, &cube, none, rest, 0);
    assert_null(free->walls);
    check_relative(solid_rates_stable_step(s, SOLID_RK3), solid_rates_stable_step(free, SOLID_RK3), 0);
    solid_free(s);
    solid_free(free);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(stands),
                                       cmocka_unit_test(is_solid_where_solid_stands),
                                       cmocka_unit_test(comes_back),
                                       cmocka_unit_test(comes_from_under_a_body),
                                       cmocka_unit_test(rate_beside_a_held_body),
                                       cmocka_unit_test(leaves_through_its_hole),
                                       cmocka_unit_test(one_integrator_after_another),
                                       cmocka_unit_test(steps)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
