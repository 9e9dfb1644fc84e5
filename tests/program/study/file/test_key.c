/* Keys by type: a right one gives its value, a missing one the fallback, a wrong one the fallback and one sentence. */
#include "scene/text/yaml.h"
#include "program/study/file/key.h"
#include "tests/check.h"

#include <stdlib.h>

static const char *const text = "number: 2.5e1\n"
                                "none: 0\n"
                                "minus: -3\n"
                                "word: fast\n"
                                "quoted: \"7\"\n"
                                "hex: 0x10\n"
                                "yes: true\n"
                                "list: [1, 2]\n"
                                "empty: []\n"
                                "inner: {a: 1}\n";

static struct scene_problems problems;
static struct scene_node *root;
static struct study_key key;

static int begin(void **state) {
    (void)state;
    problems = (struct scene_problems){.file = "it.yaml"};
    root = scene_yaml_parse(text, strlen(text), &problems);
    key = (struct study_key){root, "", &problems};
    return root == NULL;
}

static int end(void **state) {
    (void)state;
    scene_node_free(root);
    scene_problem_free(&problems);
    return 0;
}

/* The only problem so far, which is then forgotten. */
static void says(const char *sentence) {
    assert_int_equal(problems.n, 1);
    assert_string_equal(problems.text[0], sentence);
    scene_problem_free(&problems);
}

static void right_keys_have_their_values(void **state) {
    (void)state;
    static const char *const words[] = {"slow", "fast"};
    check_equal(study_key_number(&key, "number", STUDY_KEY_POSITIVE, 1), 25);
    check_equal(study_key_number(&key, "none", STUDY_KEY_NOT_NEGATIVE, 1), 0);
    check_equal(study_key_number(&key, "minus", STUDY_KEY_ANY, 1), -3);
    assert_int_equal(study_key_whole(&key, "minus", -3, 5, 1), -3);
    assert_int_equal(study_key_choice(&key, "word", 2, words, 0), 1);
    assert_int_equal(study_key_true(&key, "yes"), 1);
    assert_int_equal(study_key_list(&key, "list", 1)->n, 2);
    char *word = study_key_text(&key, "word", NULL);
    assert_string_equal(word, "fast");
    assert_int_equal(problems.n, 0);
}

static void missing_keys_have_the_fallback(void **state) {
    (void)state;
    check_equal(study_key_number(&key, "other", STUDY_KEY_POSITIVE, -1), -1);
    assert_int_equal(study_key_whole(&key, "other", 0, 5, 9), 9);
    assert_int_equal(study_key_choice(&key, "other", 1, (const char *const[]){"a"}, 4), 4);
    assert_int_equal(study_key_true(&key, "other"), 0);
    assert_null(study_key_text(&key, "other", NULL));
    assert_null(study_key_list(&key, "other", 0));
    char *word = study_key_text(&key, "other", "none");
    assert_string_equal(word, "none");
    assert_int_equal(problems.n, 0);
    study_key_missing(&key, "number", "a number");
    assert_int_equal(problems.n, 0);
    study_key_missing(&key, "other", "a number");
    assert_int_equal(problems.n, 1);
    assert_non_null(strstr(problems.text[0], "other: is missing: a number"));
}

static void wrong_keys_are_reported(void **state) {
    (void)state;
    check_equal(study_key_number(&key, "none", STUDY_KEY_POSITIVE, 8), 8);
    says("it.yaml:2: none = 0: must be a number, greater than 0");
    check_equal(study_key_number(&key, "minus", STUDY_KEY_NOT_NEGATIVE, 8), 8);
    says("it.yaml:3: minus = -3: must be a number, at least 0");
    check_equal(study_key_number(&key, "word", STUDY_KEY_ANY, 8), 8);
    says("it.yaml:4: word = fast: must be a number");
    check_equal(study_key_number(&key, "quoted", STUDY_KEY_ANY, 8), 8);
    says("it.yaml:5: quoted = \"7\": must be a number");
    check_equal(study_key_number(&key, "hex", STUDY_KEY_ANY, 8), 8);
    says("it.yaml:6: hex = 0x10: must be a number");
    assert_int_equal(study_key_whole(&key, "number", 0, 24, 8), 8);
    says("it.yaml:1: number = 2.5e1: must be a whole number, 0 to 24");
    assert_int_equal(study_key_choice(&key, "word", 2, (const char *const[]){"slow", "swift"}, 0), 0);
    says("it.yaml:4: word = fast: must be one of slow, swift");
    study_key_true(&key, "none");
    says("it.yaml:2: none = 0: can only be true: leave it out otherwise");
    assert_null(study_key_list(&key, "empty", 0));
    assert_int_equal(problems.n, 1);
}

static void unknown_keys_are_reported(void **state) {
    (void)state;
    static const char *const words[] = {"number", "none", "minus", "words", "quoted", "hex", "yes", "list", "empty"};
    assert_int_equal(study_key_known(&key, 9, words), 1);
    assert_int_equal(problems.n, 2);
    assert_string_equal(problems.text[0], "it.yaml:4: word = fast: unknown key; did you mean words?");
    assert_string_equal(problems.text[1], "it.yaml:10: inner: unknown key");
    const struct study_key value = {scene_node_child(root, "word"), "word", &problems};
    assert_int_equal(study_key_known(&value, 1, words), 0);
    assert_string_equal(problems.text[2], "it.yaml:4: word = fast: must be a mapping (number: ...)");
}

static void a_path_names_the_mapping(void **state) {
    (void)state;
    const struct study_key inner = {scene_node_child(root, "inner"), "inner", &problems};
    char *own = study_key_path(&key, "a"), *below = study_key_path(&inner, "a");
    assert_string_equal(own, "a");
    assert_string_equal(below, "inner.a");
    study_key_whole(&inner, "a", 2, 3, 2);
    assert_non_null(strstr(problems.text[0], "inner.a = 1: must be"));
}

#define TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)

int main(void) {
    const struct CMUnitTest tests[] = {TEST(right_keys_have_their_values), TEST(missing_keys_have_the_fallback),
                                       TEST(wrong_keys_are_reported), TEST(unknown_keys_are_reported),
                                       TEST(a_path_names_the_mapping)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
