/* The JSON Schema of scenes accepts every scene of the cases and the tests, refuses broken ones, and nothing that the
 * reader accepts; the list of keys is that of the tables. */
#include "scene/keys/describe.h"
#include "scene/keys/key.h"
#include "scene/text/yaml.h"
#include "tests/scene/keys/json_schema.h"
#include "tests/scene/scene_sample.h"

#include <glob.h>

static struct scene_node *schema;

static int begin(void **state) {
    (void)state;
    char *text = NULL, *why = NULL;
    size_t bytes;
    FILE *to = open_memstream(&text, &bytes);
    scene_describe_schema(to);
    fclose(to);
    schema = scene_yaml_parse_value(text, &why); /* JSON is YAML */
    if (!schema) fail_msg("%s", why);
    free(text);
    return 0;
}

static int end(void **state) {
    (void)state;
    scene_node_free(schema);
    return 0;
}

static void every_scene_is_accepted(void **state) {
    (void)state;
    static const char *const place[] = {"/cases/*/*.yaml", "/cases/*/*/*.yaml", "/tests/scene/scenes/*.yaml",
                                        "/tests/*/*.yaml", "/tests/*/*/*.yaml"};
    glob_t found;
    int n = 0;
    for (int k = 0; k < 5; k++) {
        char *pattern = text_new("%s%s", FRANA_SOURCE_DIR, place[k]);
        glob(pattern, k ? GLOB_APPEND : 0, NULL, &found);
        free(pattern);
    }
    for (size_t i = 0; i < found.gl_pathc; i++) {
        if (strstr(found.gl_pathv[i], "/study") || strstr(found.gl_pathv[i], "/gates.yaml")) continue;
        struct scene_node *scene = scene_yaml_read(found.gl_pathv[i]);
        if (!scene || !json_admits(schema, scene)) fail_msg("%s is refused", found.gl_pathv[i]);
        scene_node_free(scene);
        n++;
    }
    globfree(&found);
    check_at_least(n, 100);
}

/* Whether the reader accepts the tree as a scene in the samples' folder. */
static int reader_admits(const struct scene_node *root) {
    struct scene_problems problems;
    char *text = scene_yaml_emit(root);
    struct scene *s = sample_read(text, 0, NULL, &problems);
    const int good = s != NULL;
    scene_read_free(s);
    scene_problem_free(&problems);
    free(text);
    return good;
}

struct count {
    int made, refused, by_both;
};

/* What the reader accepts, the schema accepts. */
static void compare(const struct scene_node *root, const char *what, const char *key, struct count *n) {
    const int refused = !json_admits(schema, root), accepted = reader_admits(root);
    if (refused && accepted) fail_msg("the reader accepts and the schema refuses a scene with %s %s", key, what);
    n->made++;
    n->refused += !accepted;
    n->by_both += refused && !accepted;
}

/* Each value of the tree is exchanged for others, each key left out, and to each mapping an unknown key is added. */
static void spoil(struct scene_node *root, struct scene_node *node, struct count *n) {
    static const char *const value[] = {"-1", "1.5", "no_such_word"};
    for (int i = 0; i < node->n; i++) {
        struct scene_node *child = node->child[i];
        const char *key = child->key ? child->key : "an entry";
        if (child->kind == SCENE_NODE_SCALAR) {
            double number = 0;
            char *good = child->value;
            const int is_number = json_kind_of(child, &number) == JSON_NUMBER;
            for (size_t k = 0; k < sizeof value / sizeof *value; k++) {
                child->value = (char *)value[k];
                compare(root, value[k], key, n);
                if (k == 2 && is_number && json_admits(schema, root)) fail_msg("%s: a word is accepted", key);
            }
            child->value = good;
        }
        spoil(root, child, n);
        memmove(node->child + i, node->child + i + 1, (size_t)(node->n - i - 1) * sizeof child);
        node->n--;
        compare(root, "left out", key, n);
        memmove(node->child + i + 1, node->child + i, (size_t)(node->n - i) * sizeof child);
        node->child[i] = child;
        node->n++;
    }
    if (node->kind != SCENE_NODE_MAPPING) return;
    scene_node_append(node, scene_node_new(SCENE_NODE_SCALAR, "no_such_key", "1"));
    if (json_admits(schema, root)) fail_msg("an unknown key in %s is accepted", node->key ? node->key : "the scene");
    scene_node_drop(node, node->n - 1);
}

static void spoilt_scenes_are_refused(void **state) {
    (void)state;
    static const char *const sample[] = {"plate", "fluid", "crack_fluid", "block"};
    struct count n = {0};
    for (int k = 0; k < 4; k++) {
        if (check_skips(k, 2)) continue;
        char *path = text_new("%s%s.yaml", SCENES, sample[k]);
        struct scene_node *root = scene_yaml_read(path);
        assert_true(json_admits(schema, root) && reader_admits(root));
        spoil(root, root, &n);
        scene_node_free(root);
        free(path);
    }
    print_message("%d scenes, %d refused, %d of them by the schema\n", n.made, n.refused, n.by_both);
    check_above(n.refused, 0.5 * n.made);
    /* The rest are numbers that are wrong only beside others, and names of other entries. */
    check_above(n.by_both, 0.8 * n.refused);
}

/* Each line is that of a key; returns the line after those of the section. */
static const char *check_lines(const struct scene_value *v, const char *path, const char *at) {
    const struct scene_value *element = v->type == SCENE_LIST ? v->entry : v;
    for (const struct scene_key *key = element->type == SCENE_SECTION ? element->keys : NULL; key && key->name; key++) {
        char *section = text_new("%s%s", path, v->type == SCENE_LIST ? "[]" : ""),
             *inner = scene_key_path(section, key), *start = text_new("%s\t%s\t", inner, key->unit);
        if (strncmp(at, start, strlen(start)) != 0) fail_msg("not %s: %.60s", start, at);
        at = check_lines(&key->value, inner, at + strcspn(at, "\n") + 1);
        free(section);
        free(inner);
        free(start);
        if (key->described) break;
    }
    return at;
}

static void keys_are_those_of_the_tables(void **state) {
    (void)state;
    char *text = NULL;
    size_t bytes;
    FILE *to = open_memstream(&text, &bytes);
    scene_describe_keys(to, "");
    fclose(to);
    assert_int_equal(*check_lines(&scene_table_scene, "", text), '\0');
    free(text);
    text = scene_describe_key("solid.bodies[3].voxel");
    assert_string_equal(
        text, "voxel (m): image: the edge of a voxel, or its three edges along x, y, z: [a, b, c]; needed for a raw "
              "file, numpy and STL; the spacing times 1 to 64, or, if the edges are equal, divided by 2 to 64");
    free(text);
    assert_null(scene_describe_key("solid.no_such_key"));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_scene_is_accepted),
                                       cmocka_unit_test(spoilt_scenes_are_refused),
                                       cmocka_unit_test(keys_are_those_of_the_tables)};
    return cmocka_run_group_tests(tests, begin, end);
}
