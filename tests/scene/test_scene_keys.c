/* The tables of keys and docs/scene.md name the same keys, units, defaults and ranges. */
#include "base/par.h"
#include "base/text.h"
#include "scene/keys/key.h"
#include "tests/scene/scene_sample.h"
#include "tests/check.h"

/* Calls check with each key and its path in docs/scene.md; returns their number. */
static int each_key(const struct scene_value *v, const char *path, void check(const struct scene_key *, const char *)) {
    int n = 0;
    const struct scene_value *element = v->type == SCENE_LIST ? v->entry : v;
    for (const struct scene_key *key = element->type == SCENE_SECTION ? element->keys : NULL; key && key->name; key++) {
        char *section = text_new("%s%s", path, v->type == SCENE_LIST ? "[]" : ""),
             *inner = scene_key_path(section, key);
        check(key, inner);
        n += 1 + each_key(&key->value, inner, check);
        free(section);
        free(inner);
        if (key->described) break; /* the sides are alike */
    }
    return n;
}

/* A key is found at its path, and its table is consistent: the keys that it names stand beside it, and its values are
 * words of its sibling. */
static void check_found(const struct scene_key *key, const char *path) {
    char *described, *at = strstr(path, "SIDE") ? sample_with(path, "SIDE", "y_low") : text_new("%s", path);
    const struct scene_key *found = scene_key_find(at, &described);
    assert_non_null(found);
    assert_string_equal(found->name, strstr(path, "SIDE") && !strcmp(key->name, "x_low") ? "y_low" : key->name);
    assert_string_equal(described, path);
    free(described);
    free(at);
}

static void check_beside(const struct scene_value *v) {
    const struct scene_value *element = v->type == SCENE_LIST ? v->entry : v;
    for (const struct scene_key *key = element->type == SCENE_SECTION ? element->keys : NULL; key && key->name; key++) {
        const char *const beside[] = {key->sibling, key->with, key->not_with};
        for (int k = 0; k < 3; k++)
            if (beside[k] && !scene_key_beside(element->keys, beside[k]))
                fail_msg("%s: no %s beside", key->name, beside[k]);
        if (key->sibling) {
            char *values = scene_key_values(element->keys, key);
            const struct scene_value *sibling = &scene_key_beside(element->keys, key->sibling)->value;
            check_above(strlen(values), 0);
            for (char *at = strtok(values, " "); at; at = strtok(NULL, " ")) {
                int known = 0;
                for (int i = 0; i < sibling->most; i++) known |= !strcmp(sibling->words[i].word, at);
                if (!known) fail_msg("%s: %s is not a word of %s", key->name, at, key->sibling);
            }
            free(values);
        }
        check_beside(&key->value);
    }
}

static void test_every_key_is_found(void **state) {
    (void)state;
    check_above(each_key(&scene_table_scene, "", check_found), 350);
    check_beside(&scene_table_scene);
}

static void test_paths_find_their_key(void **state) {
    (void)state;
    static const char *const table[][2] = {{"solid.bodies[12].cavities.radius", "solid.bodies[].cavities.radius"},
                                           {"fluid.sides.z_high", "fluid.sides.SIDE"},
                                           {"fluid.sides.y_low.u", "fluid.sides.SIDE.u"},
                                           {"fluid.sides.y_low.q", NULL},
                                           {"fluid.densit", NULL},
                                           {"fluid.density2", NULL},
                                           {"fluid.density.value", NULL},
                                           {"solid.bodies[2]", NULL},
                                           {"solid.bodies[2", NULL},
                                           {"solid.bodies.radius", NULL}};
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        char *described;
        const struct scene_key *key = scene_key_find(table[k][0], &described);
        assert_int_equal(key != NULL, table[k][1] != NULL);
        if (key) assert_string_equal(described, table[k][1]);
        free(described);
    }
}

static char *reference;

/* | `path` | unit | default | range | ...: default is `none` for an optional key, `needed` for a required one, or a
 * text in brackets for a default that depends on other keys. */
static void check_row(const struct scene_key *key, const char *path) {
    char *row = text_new("| `%s` | %s | ", path, key->unit);
    const char *at = strstr(reference, row);
    if (!at) fail_msg("docs/scene.md lacks \"%s\"", row);
    at += strlen(row);
    const char *given = key->fallback ? key->fallback : key->needed ? "needed" : "";
    if (strncmp(at, given, strlen(given)) != 0 || (*given && strncmp(at + strlen(given), " |", 2) != 0))
        fail_msg("docs/scene.md: the default of %s is %s", path, given);
    char *range = scene_key_range(key),
         *cell = text_new(" | %s%s%s |", range ? range : "", key->word ? ", or " : "", key->word ? key->word : "");
    const size_t end = strcspn(at, "\n"), found = range ? (size_t)(strstr(at, cell) - at) : 0;
    if (range && (!strstr(at, cell) || found > end)) fail_msg("docs/scene.md: the range of %s is%s", path, cell);
    free(cell);
    free(range);
    free(row);
}

static void test_the_reference_has_every_key(void **state) {
    (void)state;
    reference = sample_text(FRANA_SOURCE_DIR "/docs/scene.md");
    each_key(&scene_table_scene, "", check_row);
    free(reference);
}

/* The largest horizon ratio is the one at which a family on the cubic lattice, |xi| < m + 1/2 spacings, would exceed
 * 512 bonds. */
static void test_largest_horizon_fits_a_family(void **state) {
    (void)state;
    const double r2 = (SCENE_HORIZON_MAX + 0.5) * (SCENE_HORIZON_MAX + 0.5);
    int within = -1, on = 0; /* not its own neighbour */
    for (int i = -9; i <= 9; i++)
        for (int j = -9; j <= 9; j++)
            for (int k = -9; k <= 9; k++) {
                within += i * i + j * j + k * k < r2;
                on += i * i + j * j + k * k == r2;
            }
    assert_int_equal(within, 484);
    assert_int_equal(within + on, 514);
}

/* In a plate the largest is the last whole number with which a family, |xi| < m + 1/2 spacings, has at most 512 bonds.
 */
static void test_largest_horizon_of_a_plate(void **state) {
    (void)state;
    int bonds[2] = {-1, -1};
    for (int more = 0; more < 2; more++) {
        const double r = SCENE_HORIZON_MAX_PLATE + more + 0.5;
        for (int i = -14; i <= 14; i++)
            for (int j = -14; j <= 14; j++) bonds[more] += i * i + j * j < r * r;
    }
    assert_int_equal(bonds[0], 488);
    check_above(bonds[1], 512);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_every_key_is_found), cmocka_unit_test(test_paths_find_their_key),
        cmocka_unit_test(test_the_reference_has_every_key), cmocka_unit_test(test_largest_horizon_fits_a_family),
        cmocka_unit_test(test_largest_horizon_of_a_plate)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
