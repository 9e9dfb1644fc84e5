/* What regions impose: flags, velocities, displacements, and the work that it takes. */
#include "tests/solid/make.h"
#include "solid/imposed/constraint.h"

#include "tests/check.h"
#include "solid/solid.h"

static const double moment[2] = {0, 2}, factor[2] = {0, 1};

/* Of a bar of 8 x 2 x 2 sites the first two layers are driven along x, with a factor of time; the last three held
 * along x and z, and of these the very last is lifted along z. The regions end between sites. */
static struct solid *bar(void) {
    static struct solid_constraint k[3];
    for (int q = 0; q < 3; q++) k[q] = (struct solid_constraint){.low = {-1, -1, -1}, .high = {1, 1, 1}};
    k[0].high[0] = 2 * SPACING;
    k[0].direction[0] = 1;
    k[0].velocity[0] = 3;
    k[0].time = (struct solid_time){2, moment, factor, 0};
    k[1].low[0] = 5 * SPACING;
    k[1].direction[0] = k[1].direction[2] = 1;
    k[2].low[0] = 7 * SPACING;
    k[2].direction[2] = 1;
    k[2].has_displacement = 1;
    k[2].displacement[2] = 4e-4;
    k[2].time = k[0].time;
    return make((struct make){.sites = {8, 2, 2}, .constraints = 3, .constraint = k});
}

static int layer_of(const struct solid *s, int h) { return (int)(s->x0[0][h] / SPACING); }

static void flags_by_layer(void **state) {
    (void)state;
    struct solid *s = bar();
    long held[3] = {0};
    assert_true(solid_constraint_varies(s));
    for (int h = 0; h < s->n; h++) {
        const int layer = layer_of(s, h);
        const int expected = layer < 2 ? SOLID_HELD_X : layer < 5 ? 0 : SOLID_HELD_X | SOLID_HELD_Z;
        assert_int_equal(s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z), expected);
        for (int c = 0; c < 3; c++) held[c] += (s->flag[h] & SOLID_HELD_X << c) != 0;
    }
    assert_int_equal(par_sum_long(held[0]), 4 * 5);
    assert_int_equal(par_sum_long(held[1]), 0);
    assert_int_equal(par_sum_long(held[2]), 4 * 3);
    solid_free(s);
}

/* Of a ring of 9 layers a region that reaches beyond a side, turned or not, holds what comes in at the opposite one,
 * and one beyond the side alone holds the layer that is there. */
static void beyond_a_periodic_side(void **state) {
    (void)state;
    static const struct {
        double low, high;
        int is_turned;
        const char *held; /* by layer */
    } table[] = {{-2, 1, 0, "100000011"}, {8, 11, 0, "110000001"}, {9, 10, 0, "100000000"},  {-1, 10, 0, "111111111"},
                 {2, 4, 0, "001100000"},  {-1, 2, 1, "100000011"}, {-11, -8, 1, "110000001"}};
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        struct solid_constraint k = {.low = {table[i].low * SPACING, -1, -1}, .high = {table[i].high * SPACING, 1, 1}};
        k.direction[0] = 1;
        if (table[i].is_turned) /* by half a turn about z */
            k.turn = (struct solid_turn){.is_turned = 1, .edge = {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}}};
        struct solid *s =
            make((struct make){.sites = {9, 2, 2}, .periodic = {1, 0, 0}, .constraints = 1, .constraint = &k});
        for (int h = 0; h < s->n; h++)
            assert_int_equal(s->flag[h] & SOLID_HELD_X, table[i].held[layer_of(s, h)] == '1' ? SOLID_HELD_X : 0);
        solid_free(s);
    }
}

/* Velocities: the mean of what is given over the step; of a displacement what leads there; where two regions overlap
 * the later one's. What is not held keeps its own. The kinetic energy that this takes is the constraint's. */
static void velocities_and_their_energy(void **state) {
    (void)state;
    struct solid *s = bar();
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < s->n; h++) s->v[c][h] = 0.5;
    s->e_constraint = 0;
    solid_constraint_velocity(s, 0.5, 0.5); /* the factor goes from 1/4 to 1/2 */
    for (int h = 0; h < s->n; h++) {
        const int layer = layer_of(s, h);
        check_close(s->v[0][h], layer < 2 ? 3 * 0.375 : layer < 5 ? 0.5 : 0, 1e-14);
        check_equal(s->v[1][h], 0.5);
        check_close(s->v[2][h], layer < 5 ? 0.5 : layer < 7 ? 0 : 4e-4 * 0.25 / 0.5, 1e-16);
    }
    const double mass = 4 * DENSITY * SPACING * SPACING * SPACING, before = 0.25, after = 1.125 * 1.125;
    /* two layers driven, three stopped along x; three stopped along z and then one of them lifted */
    const double energy = 0.5 * mass * (2 * (after - before) - 3 * before - 3 * before + 2e-4 * 2e-4);
    check_relative(par_sum(s->e_constraint), energy, 1e-13);
    solid_constraint_displacement(s, 1);
    for (int h = 0; h < s->n; h++) check_equal(s->d[2][h], layer_of(s, h) < 7 ? 0 : 2e-4);
    solid_free(s);
}

/* Where a region that is moved to a displacement overlaps a later one that is held, the later one's particles stay. */
static void later_regions_overrule(void **state) {
    (void)state;
    struct solid_constraint k[2];
    for (int q = 0; q < 2; q++)
        k[q] = (struct solid_constraint){.low = {-1, -1, -1}, .high = {1, 1, 1}, .direction = {1}};
    k[0].has_displacement = 1;
    k[0].displacement[0] = 4e-4;
    k[0].time = (struct solid_time){2, moment, factor, 0};
    k[1].low[0] = 5 * SPACING;
    struct solid *s = make((struct make){.sites = {8, 2, 2}, .constraints = 2, .constraint = k});
    solid_constraint_velocity(s, 0.5, 0.5);
    solid_constraint_displacement(s, 1);
    for (int h = 0; h < s->n; h++) {
        check_close(s->v[0][h], layer_of(s, h) < 5 ? 2e-4 : 0, 1e-18);
        check_equal(s->d[0][h], layer_of(s, h) < 5 ? 2e-4 : 0);
    }
    solid_free(s);
}

/* What holds a particle takes its acceleration away: the power is that of minus mass times it. */
static void reactions(void **state) {
    (void)state;
    struct solid *s = bar();
    const double mass = DENSITY * SPACING * SPACING * SPACING;
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < s->n; h++) s->a[c][h] = 2 + c, s->v[c][h] = 10 * (c + 1);
    const double reaction2 = par_sum(solid_constraint_apply(s));
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) check_equal(s->a[c][h], s->flag[h] & SOLID_HELD_X << c ? 0 : 2 + c);
    check_relative(reaction2, mass * mass * (20 * 4 + 12 * 16), 1e-13);
    check_relative(par_sum(s->power_constraint), -mass * (20 * 2 * 10 + 12 * 4 * 30), 1e-13);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(flags_by_layer), cmocka_unit_test(beyond_a_periodic_side),
                                       cmocka_unit_test(velocities_and_their_energy),
                                       cmocka_unit_test(later_regions_overrule), cmocka_unit_test(reactions)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
