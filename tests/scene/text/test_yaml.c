/* A file of YAML or JSON is read to a tree; a missing or malformed one gives NULL. */
#include "scene/text/yaml.h"
#include "tests/check.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

static struct scene_node *tree_of(const char *text) {
    char path[] = "/tmp/frana_yaml_XXXXXX";
    const int file = mkstemp(path);
    assert_true(file >= 0);
    FILE *out = fdopen(file, "w");
    fputs(text, out);
    assert_int_equal(fclose(out), 0);
    struct scene_node *root = scene_yaml_read(path);
    unlink(path);
    return root;
}

static void json_is_read(void **state) {
    (void)state;
    struct scene_node *root = tree_of("{\"status\": \"done\", \"parts\": [{\"steps\": 12}, {\"steps\": 3}]}\n");
    assert_non_null(root);
    assert_string_equal(scene_node_child(root, "status")->value, "done");
    assert_string_equal(scene_node_find(root, "parts[1].steps")->value, "3");
    scene_node_free(root);
}

static void what_is_no_tree_is_null(void **state) {
    (void)state;
    assert_null(tree_of(""));
    assert_null(tree_of("{\"status\": "));
    assert_null(tree_of("[1, 2]\n")); /* a list, no mapping */
    assert_null(scene_yaml_read("/tmp/frana_yaml_there_is_no_such_file"));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(json_is_read), cmocka_unit_test(what_is_no_tree_is_null)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
