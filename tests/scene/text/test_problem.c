/* Sentences of mistakes: file, line, key and value; their order by line; and the nearest word. */
#include "scene/text/problem.h"
#include "scene/text/yaml.h"
#include "tests/check.h"

static const char *const text = "a: 1\n"
                                "b: \"two\"\n"
                                "c: {d: [1, 2, x]}\n"
                                "long: abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz0123456789\n"
                                "e: abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz0123\xc3\xa4zzzzz\n";

static void sentences_have_line_key_and_value(void **state) {
    (void)state;
    struct scene_problems p = {.file = "it.yaml"};
    struct scene_node *root = scene_yaml_parse(text, strlen(text), &p);
    assert_non_null(root);
    int n = 0;
    scene_problem_at(&p, root, "a", "must be %d", 3);
    assert_string_equal(p.text[n++], "it.yaml:1: a = 1: must be 3");
    scene_problem_at(&p, root, "b", "no");
    assert_string_equal(p.text[n++], "it.yaml:2: b = \"two\": no");
    scene_problem_at(&p, root, "c.d", "no");
    assert_string_equal(p.text[n++], "it.yaml:3: c.d = [1, 2, x]: no");
    scene_problem_at(&p, root, "c.f", "is missing"); /* on the line of its parent */
    assert_string_equal(p.text[n++], "it.yaml:3: c.f: is missing");
    scene_problem_key(&p, root->child[0], "a", "no");
    assert_string_equal(p.text[n++], "it.yaml:1: a: no");
    scene_problem_line(&p, 7, "no %s", "colon");
    assert_string_equal(p.text[n++], "it.yaml:7: no colon");
    scene_problem_line(&p, 0, "empty");
    assert_string_equal(p.text[n++], "it.yaml: empty");
    assert_int_equal(p.n, n);
    scene_problem_free(&p);
    scene_node_free(root);
}

/* Long values are cut, and not within a character of several bytes. */
static void long_values_are_cut(void **state) {
    (void)state;
    struct scene_problems p = {.file = "it.yaml"};
    struct scene_node *root = scene_yaml_parse(text, strlen(text), &p);
    scene_problem_at(&p, root, "long", "no");
    assert_string_equal(p.text[0],
                        "it.yaml:4: long = abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz01234...: no");
    scene_problem_at(&p, root, "e", "no");
    assert_string_equal(p.text[1], "it.yaml:5: e = abcdefghijklmnopqrstuvwxyzabcdefghijklmnopqrstuvwxyz0123...: no");
    scene_problem_free(&p);
    scene_node_free(root);
}

static void a_setting_is_named_by_its_path(void **state) {
    (void)state;
    struct scene_problems p = {.file = "it.yaml"};
    struct scene_node node = {.kind = SCENE_NODE_SCALAR, .value = (char[]){"5"}, .line = 3, .set = (char[]){"x.y"}};
    scene_problem_value(&p, &node, "x.y", "no");
    assert_string_equal(p.text[0], "--set x.y = 5: no");
    assert_int_equal(p.line[0], 0);
    node.set_inner = 1;
    scene_problem_value(&p, &node, "x.y.z", "no");
    assert_string_equal(p.text[1], "--set x.y: x.y.z = 5: no");
    scene_problem_free(&p);
}

/* Those of one line stay in the order in which they were found. */
static void problems_are_sorted_by_line(void **state) {
    (void)state;
    static const int line[] = {5, 2, 9, 2, 0, 5, 2, 1, 9, 3};
    struct scene_problems p = {.file = "f"};
    for (int i = 0; i < 10; i++) scene_problem_line(&p, line[i], "%d", i);
    scene_problem_sort(&p);
    char order[11] = "";
    for (int i = 0; i < 10; i++) strcat(order, strrchr(p.text[i], ' ') + 1);
    assert_string_equal(order, "4713690528");
    for (int i = 1; i < 10; i++) check_at_least(p.line[i], p.line[i - 1]);
    scene_problem_free(&p);
}

static void the_nearest_word_is_found(void **state) {
    (void)state;
    const char *const word[] = {"steps", "solid", "safety", "cfl"};
    assert_string_equal(scene_problem_nearest("stepz", 4, word), "steps");
    assert_string_equal(scene_problem_nearest("setps", 4, word), "steps"); /* a swap is one edit */
    assert_string_equal(scene_problem_nearest("clf", 4, word), "cfl");
    assert_string_equal(scene_problem_nearest("safty", 4, word), "safety");
    assert_null(scene_problem_nearest("temperature", 4, word));
    assert_null(scene_problem_nearest("abc", 4, word));
    assert_null(scene_problem_nearest("", 4, word));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sentences_have_line_key_and_value), cmocka_unit_test(long_values_are_cut),
        cmocka_unit_test(a_setting_is_named_by_its_path), cmocka_unit_test(problems_are_sorted_by_line),
        cmocka_unit_test(the_nearest_word_is_found)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
