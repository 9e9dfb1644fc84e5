/* Schema, rules and docs/scene.md name the same keys, units, defaults and ranges. */
#include "base/par.h"
#include "base/text.h"
#include "scene/rules/rule.h"
#include "scene/rules/schema.h"
#include "tests/scene/scene_sample.h"
#include "tests/check.h"

struct keys {
    int n;
    char *path[512];
    int optional[512];
};

static void collect(struct keys *keys, const cyaml_schema_value_t *v, const char *path) {
    if (v->type == CYAML_SEQUENCE) {
        char *inner = text_new("%s[]", path);
        collect(keys, v->sequence.entry, inner);
        free(inner);
    }
    if (v->type != CYAML_MAPPING) return;
    for (const cyaml_schema_field_t *f = v->mapping.fields; f->key; f++) {
        const int is_side = !strcmp(path, "fluid.sides");
        char *inner = is_side ? text_new("fluid.sides.SIDE") : text_new("%s%s%s", path, *path ? "." : "", f->key);
        if (!is_side || !strcmp(f->key, "x_low")) {
            check_below(keys->n, 512);
            keys->path[keys->n] = text_new("%s", inner);
            keys->optional[keys->n++] = (f->value.flags & CYAML_FLAG_OPTIONAL) != 0;
            collect(keys, &f->value, inner);
        }
        free(inner);
    }
}

static void free_keys(struct keys *keys) {
    for (int i = 0; i < keys->n; i++) free(keys->path[i]);
}

static void test_every_key_has_a_rule(void **state) {
    (void)state;
    struct keys keys = {0};
    collect(&keys, &scene_schema, "");
    check_above(keys.n, 160);
    int rules = 0;
    while (scene_rule_table[rules].path) rules++;
    for (int i = 0; i < keys.n && i < rules; i++)
        assert_string_equal(keys.path[i], scene_rule_table[i].path); /* and in the same order */
    assert_int_equal(keys.n, rules);
    free_keys(&keys);
}

static void test_paths_find_their_rule(void **state) {
    (void)state;
    assert_string_equal(scene_rule_find("solid.bodies[12].cavities.radius")->path, "solid.bodies[].cavities.radius");
    assert_string_equal(scene_rule_find("fluid.sides.z_high")->path, "fluid.sides.SIDE");
    assert_string_equal(scene_rule_find("fluid.sides.y_low.u")->path, "fluid.sides.SIDE.u");
    assert_null(scene_rule_find("fluid.sides.y_low.q"));
    assert_null(scene_rule_find("fluid.densit"));
    assert_null(scene_rule_find("fluid.density2"));
    assert_null(scene_rule_find("solid.bodies.radius"));
}

/* | `path` | unit | default | range | ...: default is `none` for an optional key, `needed` for a required one, or a
 * text in brackets for a default that depends on other keys. */
static void test_the_reference_has_every_key(void **state) {
    (void)state;
    struct keys keys = {0};
    char *text = sample_text(FRANA_SOURCE_DIR "/docs/scene.md");
    collect(&keys, &scene_schema, "");
    for (int i = 0; i < keys.n; i++) {
        const struct scene_rule *rule = &scene_rule_table[i];
        char *row = text_new("| `%s` | %s | ", rule->path, rule->unit);
        const char *at = strstr(text, row);
        if (!at) fail_msg("docs/scene.md lacks \"%s\"", row);
        at += strlen(row);
        const char *given = rule->fallback ? rule->fallback : !keys.optional[i] || rule->needed ? "needed" : "";
        if (strncmp(at, given, strlen(given)) != 0 || (*given && strncmp(at + strlen(given), " |", 2) != 0))
            fail_msg("docs/scene.md: the default of %s is %s", rule->path, given);
        char *range = scene_rule_range(rule), *cell = text_new(" | %s%s%s |", range ? range : "",
                                                               rule->word ? ", or " : "", rule->word ? rule->word : "");
        const size_t end = strcspn(at, "\n"), found = range ? (size_t)(strstr(at, cell) - at) : 0;
        if (range && (!strstr(at, cell) || found > end))
            fail_msg("docs/scene.md: the range of %s is%s", rule->path, cell);
        free(cell);
        free(range);
        free(row);
    }
    free_keys(&keys);
    free(text);
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
        cmocka_unit_test(test_every_key_has_a_rule), cmocka_unit_test(test_paths_find_their_rule),
        cmocka_unit_test(test_the_reference_has_every_key), cmocka_unit_test(test_largest_horizon_fits_a_family),
        cmocka_unit_test(test_largest_horizon_of_a_plate)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
