/* Ranges of the keys: the sentence says what is admitted. */
#include "scene/keys/key.h"
#include "tests/check.h"

#include <stdlib.h>

/* A key without a range admits everything; an open end is not admitted itself. */
static void ranges_and_their_sentences(void **state) {
    (void)state;
    static const struct {
        double low, high;
        int open;
        const char *sentence;
        int below, at_low, within, at_high, above; /* whether low - 1, low, ... are admitted */
    } table[] = {{0, 0, 0, NULL, 1, 1, 1, 1, 1},
                 {0, INFINITY, 1, "greater than 0", 0, 0, 1, 1, 1},
                 {0.5, INFINITY, 0, "at least 0.5", 0, 1, 1, 1, 1},
                 {-1, 1, 0, "between -1 and 1", 0, 1, 1, 1, 0},
                 {0, 1, 1, "greater than 0 and at most 1", 0, 0, 1, 1, 0},
                 {1, 6, 2, "at least 1 and less than 6", 0, 1, 1, 0, 0},
                 {0, 1, 3, "greater than 0 and less than 1", 0, 0, 1, 0, 0}};
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        const struct scene_key key = {.low = table[k].low, .high = table[k].high, .open = table[k].open};
        const double high = isinf(key.high) ? 1e300 : key.high;
        char *sentence = scene_key_range(&key);
        if (!table[k].sentence)
            assert_null(sentence);
        else
            assert_string_equal(sentence, table[k].sentence);
        free(sentence);
        assert_int_equal(scene_key_admits(&key, key.low - 1), table[k].below);
        assert_int_equal(scene_key_admits(&key, key.low), table[k].at_low);
        assert_int_equal(scene_key_admits(&key, 0.5 * (key.low + high)), table[k].within);
        assert_int_equal(scene_key_admits(&key, high), table[k].at_high);
        assert_int_equal(scene_key_admits(&key, high + fabs(high)), table[k].above);
    }
}

static void units_are_shown_where_there_are_some(void **state) {
    (void)state;
    static const char *const table[][2] = {{"fluid.density", " (kg/m3)"},
                                           {"solid.bodies[3].radius", " (m)"},
                                           {"fluid.sides.x_low.velocity", " (m/s)"},
                                           {"domain.cells", ""},
                                           {"fluid.diffusion", ""},
                                           {"stages", ""},
                                           {"no.such.key", ""}};
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        char *units = scene_key_in_units(scene_key_find(table[k][0], NULL));
        assert_string_equal(units, table[k][1]);
        free(units);
    }
}

/* Each default that is a number is within its own range. Returns how many are. */
static int check_defaults(const struct scene_value *v) {
    int numbers = 0;
    const struct scene_value *element = v->type == SCENE_LIST ? v->entry : v;
    for (const struct scene_key *key = element->type == SCENE_SECTION ? element->keys : NULL; key && key->name; key++) {
        char *end;
        numbers += check_defaults(&key->value);
        if (!key->fallback || key->low == key->high) continue;
        const double value = strtod(key->fallback, &end);
        if (*end || end == key->fallback) continue;
        if (!scene_key_admits(key, value)) fail_msg("%s: %s is not admitted", key->name, key->fallback);
        numbers++;
    }
    return numbers;
}

static void defaults_are_admitted(void **state) {
    (void)state;
    check_above(check_defaults(&scene_table_scene), 20);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(ranges_and_their_sentences),
                                       cmocka_unit_test(units_are_shown_where_there_are_some),
                                       cmocka_unit_test(defaults_are_admitted)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
