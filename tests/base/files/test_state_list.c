/* The order of several tables' items, which of them a scene has, and bytes that no item covers. */
#include "base/files/state_list.h"
#include "tests/check.h"

struct thing {
    double a, b;
    int c;
    int spare;
    double *v[3];
};

static int never(const void *owner) {
    (void)owner;
    return 0;
}

#define ONE(its_name, ...)                                                                                             \
    { .name = (its_name), .shape = STATE_ONE, STATE_MEMBER(struct thing, a), ##__VA_ARGS__ }

static void the_list_is(const struct state_list *list, const char *expected) {
    char names[200] = "";
    for (int k = 0; k < list->n; k++) {
        strcat(names, list->at[k].item->name);
        if (k + 1 < list->n) strcat(names, " ");
    }
    assert_string_equal(names, expected);
}

/* An item with `after` takes those below it along; the name that d follows is in no table. */
static void items_follow_those_that_they_name(void **state) {
    (void)state;
    struct thing thing = {0};
    static const struct state_item one[] = {ONE("a"), ONE("b"), ONE("c")};
    static const struct state_item other[] = {ONE("p"), ONE("q", .after = "a"), ONE("r"), ONE("s", .after = "b"),
                                              ONE("d", .after = "nothing")};
    const struct state_part part[] = {{.item = one, .items = 3, .base = &thing},
                                      {.item = other, .items = 5, .base = &thing}};
    struct state_list list;
    state_list_make(&list, part, 2);
    the_list_is(&list, "a q r b s c p d");
    for (int k = 0; k < list.n; k++)
        assert_ptr_equal(list.at[k].part, strchr("abc", list.at[k].item->name[0]) ? &part[0] : &part[1]);
    state_list_make(&list, part, 1);
    the_list_is(&list, "a b c");
}

/* An item keeps its place for others, also if the scene does not have it. */
static void items_that_a_scene_lacks_are_left_out(void **state) {
    (void)state;
    double value = 0;
    struct thing with = {.v = {&value, &value, NULL}}, without = {0};
    static const struct state_item item[] = {ONE("a"),
                                             ONE("none", .is_part = never),
                                             ONE("z"),
                                             {.name = "v", .shape = STATE_PARTICLE, STATE_MEMBER(struct thing, v)}};
    static const struct state_item more[] = {ONE("x"), ONE("b", .after = "none")};
    struct state_part part[] = {{.item = item, .items = 4, .base = &with}, {.item = more, .items = 2, .base = &with}};
    struct state_list list;
    state_list_make(&list, part, 2);
    the_list_is(&list, "a b z v x");
    assert_int_equal(state_item_comps(&item[3], &part[0]), 2); /* a plate's third is NULL */
    assert_ptr_equal(state_item_array(&item[3], &part[0], 1), &value);
    assert_int_equal(state_item_comps(&item[0], &part[0]), 1);
    part[0].base = &without;
    state_list_make(&list, part, 2);
    the_list_is(&list, "a b z x");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(items_follow_those_that_they_name),
                                       cmocka_unit_test(items_that_a_scene_lacks_are_left_out)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
