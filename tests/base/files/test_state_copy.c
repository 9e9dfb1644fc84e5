/* A copy of a table's state restores what was changed since, and nothing that it does not keep. */
#include "base/files/state_copy.h"
#include "tests/check.h"

enum { OWNED = 3, GHOSTS = 2, ALL = OWNED + GHOSTS, CELLS = 4 };

struct thing {
    double t;
    int step;
    double *v[3], *damage, *p;
    double other;
};

static char calls[40]; /* the own functions of items, in their order */

static void sizes(const void *owner, struct state_size *size) {
    (void)owner;
    *size = (struct state_size){.n = OWNED, .n_ghost = GHOSTS, .cells = CELLS};
}

static void made(void *snapshot, void *owner) {
    (void)owner;
    *(int *)snapshot = 1;
    strcat(calls, "m");
}
static void taken(void *snapshot, void *owner) {
    *(int *)snapshot = ((struct thing *)owner)->step;
    strcat(calls, "t");
}
static void restored(void *snapshot, void *owner) {
    ((struct thing *)owner)->other =
        100 * *(int *)snapshot + ((struct thing *)owner)->step; /* step: already restored? */
    strcat(calls, "r");
}
static void dropped(void *snapshot) {
    *(int *)snapshot = 0;
    strcat(calls, "d");
}
static const struct state_snapshot own = {made, taken, restored, dropped};

static const struct state_item item[] = {
    {.name = "own", .shape = STATE_ONE, .in = STATE_SNAPSHOT, .last = 1, .snapshot = &own},
    {.name = "t", .shape = STATE_ONE, STATE_MEMBER(struct thing, t), .in = STATE_BOTH},
    {.name = "step", .kind = STATE_INT, .shape = STATE_ONE, STATE_MEMBER(struct thing, step), .in = STATE_BOTH},
    {.name = "v", .shape = STATE_PARTICLE, STATE_MEMBER(struct thing, v), .ghosts = 1, .in = STATE_BOTH},
    {.name = "damage", .shape = STATE_PARTICLE, STATE_MEMBER(struct thing, damage), .in = STATE_BOTH},
    {.name = "p", .shape = STATE_CELL, STATE_MEMBER(struct thing, p), .in = STATE_BOTH},
    {.name = "other", .shape = STATE_ONE, STATE_MEMBER(struct thing, other), .in = STATE_CHECKPOINT}};
enum { ITEMS = sizeof item / sizeof *item };

static void the_state_is_restored(void **state) {
    (void)state;
    double array[2][ALL], damage[ALL], p[CELLS];
    struct thing thing = {.t = 1.5, .step = 7, .v = {array[0], array[1], NULL}, .damage = damage, .p = p};
    const struct state_part part = {.item = item, .items = ITEMS, .base = &thing, .owner = &thing, .size = sizes};
    int snapshot = 0;
    for (int i = 0; i < ALL; i++) array[0][i] = i, array[1][i] = 10 + i, damage[i] = 20 + i;
    for (int i = 0; i < CELLS; i++) p[i] = 30 + i;

    struct state_copy *copy = state_copy_new(&part, &snapshot);
    state_copy_take(copy, &part, &snapshot);
    for (int turn = 0; turn < 2; turn++) { /* a copy can be restored again */
        thing.t = thing.step = -1;
        thing.other = 9;
        for (int i = 0; i < ALL; i++) array[0][i] = array[1][i] = damage[i] = -1;
        for (int i = 0; i < CELLS; i++) p[i] = -1;
        state_copy_restore(copy, &part, &snapshot);
        check_equal(thing.t, 1.5);
        assert_int_equal(thing.step, 7);
        check_equal(thing.other, 707); /* by the item's function, after all others */
        for (int i = 0; i < ALL; i++) {
            check_equal(array[0][i], i);
            check_equal(array[1][i], 10 + i);
            check_equal(damage[i], i < OWNED ? 20 + i : -1); /* its ghosts are not kept */
        }
        for (int i = 0; i < CELLS; i++) check_equal(p[i], 30 + i);
    }
    check_equal(((const double *)state_copy_of(copy, "damage"))[2], 22);
    check_equal(*(const double *)state_copy_of(copy, "t"), 1.5);
    state_copy_free(copy, &snapshot);
    assert_string_equal(calls, "mtrrd");
    assert_int_equal(snapshot, 0);
    state_copy_free(NULL, NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_state_is_restored)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
