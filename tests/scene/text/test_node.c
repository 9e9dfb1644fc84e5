/* Nodes are found by their path, kept in order, and mistakes below a node are seen. */
#include "scene/text/node.h"
#include "tests/check.h"

/* {a: 1, list: [x, {b: 2}], ab: 3} */
static struct scene_node *tree(void) {
    struct scene_node *root = scene_node_new(SCENE_NODE_MAPPING, NULL, NULL);
    struct scene_node *list = scene_node_new(SCENE_NODE_LIST, "list", NULL);
    struct scene_node *inner = scene_node_new(SCENE_NODE_MAPPING, NULL, NULL);
    scene_node_append(root, scene_node_new(SCENE_NODE_SCALAR, "a", "1"));
    scene_node_append(root, list);
    scene_node_append(root, scene_node_new(SCENE_NODE_SCALAR, "ab", "3"));
    scene_node_append(list, scene_node_new(SCENE_NODE_SCALAR, NULL, "x"));
    scene_node_append(list, inner);
    scene_node_append(inner, scene_node_new(SCENE_NODE_SCALAR, "b", "2"));
    return root;
}

static void nodes_are_found_by_their_path(void **state) {
    (void)state;
    struct scene_node *root = tree();
    assert_string_equal(scene_node_find(root, "a")->value, "1");
    assert_string_equal(scene_node_find(root, "ab")->value, "3"); /* not a, with which it begins */
    assert_string_equal(scene_node_find(root, "list[0]")->value, "x");
    assert_string_equal(scene_node_find(root, "list[1].b")->value, "2");
    assert_ptr_equal(scene_node_find(root, ""), root);
    static const char *const none[] = {"abc", "l", "lis", "list[2]", "list[-1]", "list.b", "a[0]", "a.b", "list[1].c"};
    for (size_t k = 0; k < sizeof none / sizeof *none; k++)
        if (scene_node_find(root, none[k])) fail_msg("%s is found", none[k]);
    assert_ptr_equal(scene_node_child(root, "ab"), root->child[2]);
    assert_null(scene_node_child(root->child[1], "b")); /* a list has no keys */
    scene_node_free(root);
}

static void the_deepest_ancestor_is_near(void **state) {
    (void)state;
    struct scene_node *root = tree();
    assert_ptr_equal(scene_node_near(root, "list[1].c.d"), scene_node_find(root, "list[1]"));
    assert_ptr_equal(scene_node_near(root, "list[7].b"), scene_node_find(root, "list"));
    assert_ptr_equal(scene_node_near(root, "none"), root);
    assert_ptr_equal(scene_node_near(root, "list[1].b"), scene_node_find(root, "list[1].b"));
    scene_node_free(root);
}

/* Twenty nodes, each inserted in the middle: more than the first capacity. */
static void nodes_keep_their_order(void **state) {
    (void)state;
    struct scene_node *list = scene_node_new(SCENE_NODE_LIST, NULL, NULL);
    for (int i = 0; i < 20; i++)
        scene_node_insert(list, i / 2, scene_node_new(SCENE_NODE_SCALAR, NULL, (char[]){(char)('a' + i), '\0'}));
    char order[21] = "";
    for (int i = 0; i < list->n; i++) strcat(order, list->child[i]->value);
    assert_string_equal(order, "bdfhjlnprtsqomkigeca");
    scene_node_drop(list, 0);
    scene_node_drop(list, 18);
    scene_node_drop(list, 1);
    assert_int_equal(list->n, 17);
    assert_string_equal(list->child[0]->value, "d");
    assert_string_equal(list->child[1]->value, "h");
    assert_string_equal(list->child[16]->value, "c");
    scene_node_clear(list);
    assert_int_equal(list->n, 0);
    scene_node_free(list);
}

static void mistakes_below_are_seen(void **state) {
    (void)state;
    struct scene_node *root = tree();
    assert_true(scene_node_is_clean(root, "list"));
    scene_node_find(root, "list[1].b")->bad = 1;
    assert_false(scene_node_is_clean(root, "list"));
    assert_false(scene_node_is_clean(root, "list[1].b"));
    assert_true(scene_node_is_clean(root, "list[0]"));
    assert_true(scene_node_is_clean(root, "a"));
    assert_false(scene_node_is_clean(root, "none")); /* it does not exist */
    scene_node_free(root);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nodes_are_found_by_their_path), cmocka_unit_test(the_deepest_ancestor_is_near),
        cmocka_unit_test(nodes_keep_their_order), cmocka_unit_test(mistakes_below_are_seen)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
