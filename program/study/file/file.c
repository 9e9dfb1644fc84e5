/* Reads a study's file. */
#include "program/study/file/file.h"
#include "base/die.h"
#include "base/arena.h"
#include "base/files/read_file.h"
#include "scene/text/yaml.h"
#include "program/study/file/key.h"
#include "program/study/file/parts.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { BYTES_MAX = 1 << 20, REPEATS_MAX = 1000 };

static void read_names(struct study *s, const char *path) {
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path, *dot = strrchr(name, '.');
    s->path = arena_text("%s", path);
    s->folder = !slash ? arena_text(".") : arena_text("%.*s", slash == path ? 1 : (int)(slash - path), path);
    s->name = dot && dot > name ? arena_text("%.*s", (int)(dot - name), name) : arena_text("%s", name);
}

static void read_scene(struct study *s, const struct study_key *k) {
    study_key_missing(k, "scene", "the scene's file, as seen from the study's folder");
    char *scene = study_key_text(k, "scene", "");
    s->scene = scene[0] == '/' ? arena_text("%s", scene) : arena_text("%s/%s", s->folder, scene);
    if (*scene && access(s->scene, R_OK) != 0)
        scene_problem_value(k->problems, scene_node_child(k->mapping, "scene"), "scene",
                            "cannot be read: %s (looked for %s)", strerror(errno), s->scene);
}

static void read_launcher(struct study *s, const struct study_key *k) {
    s->launcher = study_key_text(k, "launcher", "mpiexec -n {ranks}");
    if (!strstr(s->launcher, "{ranks}"))
        scene_problem_value(k->problems, scene_node_child(k->mapping, "launcher"), "launcher",
                            "must say where {ranks} go");
}

/* Reports a reference to a method that does not exist. */
static void check_methods(const struct study *s, struct scene_problems *problems) {
    for (int i = 0; i < s->quantities; i++) {
        const char *method = s->quantity[i].reference.method;
        const struct scene_node place = {.kind = SCENE_NODE_MAPPING, .line = s->quantity[i].line};
        int found = !method;
        for (int m = 0; m < s->methods.n && !found; m++) found = !strcmp(s->methods.variant[m].name, method);
        if (!found) scene_problem_key(problems, &place, "reference.method", "there is no method %s", method);
    }
}

/* The same value twice is the same run twice, and would count as two. */
static void check_members(const struct study *s, const struct scene_node *values, struct scene_problems *problems) {
    for (int i = 0; i < s->members.n && s->members.n == values->n; i++)
        for (int j = 0; j < i; j++) {
            if (strcmp(s->members.text[i], s->members.text[j])) continue;
            scene_problem_value(problems, values->child[i], arena_text("ensemble.values[%d]", i), "is there twice");
            break;
        }
}

/* ensemble: {key: PATH, values: [...]}: each repeat sets the key to another value. */
static void read_ensemble(struct study *s, const struct study_key *k) {
    static const char *const word[] = {"key", "values"};
    const struct scene_node *node = scene_node_child(k->mapping, "ensemble");
    if (!node) return;
    const struct study_key in = {node, "ensemble", k->problems};
    if (!study_key_known(&in, 2, word)) return;
    study_key_missing(&in, "key", "the scene's key that differs, such as nonlocal.arrangement.seed");
    const struct scene_node *values = study_key_list(&in, "values", 1);
    if (scene_node_child(k->mapping, "repeats"))
        scene_problem_key(k->problems, node, "ensemble", "not together with repeats: each value is run once");
    char *key = study_key_text(&in, "key", "");
    if (values && values->n > REPEATS_MAX)
        scene_problem_key(k->problems, values, "ensemble.values", "has %d values, more than %d", values->n,
                          REPEATS_MAX);
    else if (values)
        study_sets_read_values(&s->members, key, values, "ensemble.values", k->problems);
    if (values) check_members(s, values, k->problems);
    if (values && values->n == 0) scene_problem_value(k->problems, values, "ensemble.values", "must not be empty");
    if (s->members.n > 0) s->repeats = s->members.n;
}

/* Methods and levels of a study of errors. */
static void read_levels(struct study *s, const struct study_key *k) {
    const struct scene_node *methods = scene_node_child(k->mapping, "methods"),
                            *levels = scene_node_child(k->mapping, "levels");
    study_key_missing(k, "methods", "a list, one curve each");
    study_key_missing(k, "levels",
                      "a list, the points of a curve from coarse to fine; without a reference, sweep: {key, values} or "
                      "ensemble: {key, values}");
    if (methods) study_variants_read(&s->methods, methods, "methods", 0, k->problems);
    if (levels) study_variants_read(&s->levels, levels, "levels", 1, k->problems);
}

static void read_study(struct study *s, const struct study_key *k) {
    static const char *const word[] = {"title",    "scene",      "ranks",     "repeats", "launcher", "set",  "methods",
                                       "quantity", "quantities", "reference", "levels",  "ensemble", "sweep"};
    if (!study_key_known(k, (int)(sizeof word / sizeof *word), word)) return;
    const struct scene_node *set = scene_node_child(k->mapping, "set"), *sweep = scene_node_child(k->mapping, "sweep");
    s->is_sweep = sweep || (scene_node_child(k->mapping, "ensemble") && !scene_node_child(k->mapping, "levels"));
    s->title = study_key_text(k, "title", s->name);
    s->ranks = study_key_whole(k, "ranks", 1, STUDY_RANKS_MAX, 1);
    s->repeats = study_key_whole(k, "repeats", 1, REPEATS_MAX, s->is_sweep ? 1 : 5);
    read_ensemble(s, k);
    read_scene(s, k);
    read_launcher(s, k);
    if (set) study_sets_read(&s->sets, set, "set", k->problems);
    if (s->is_sweep)
        study_sweep_read(s, k->mapping, k->problems);
    else
        read_levels(s, k);
    study_quantities_read(s, k->mapping, k->problems);
    check_methods(s, k->problems);
}

struct study *study_file_parse(const char *path, const char *text, size_t bytes, struct scene_problems *problems) {
    static const struct scene_yaml_what what = {"study", "scene: ..., methods: ..., levels: ..."};
    problems->file = path;
    struct scene_node *root = scene_yaml_parse_as(&what, text, bytes, problems);
    if (!root) return NULL;
    if (scene_node_child(root, "domain") && scene_node_child(root, "stages")) {
        scene_problem_line(problems, 0, "is a scene and not a study: frana run runs it");
        scene_node_free(root);
        return NULL;
    }
    struct study *s = arena_new(1, sizeof *s);
    const struct study_key k = {root, "", problems};
    read_names(s, path);
    read_study(s, &k);
    scene_node_free(root);
    scene_problem_sort(problems);
    return problems->n == 0 ? s : NULL;
}

struct study *study_file_new(const char *path) {
    struct scene_problems problems = {.file = path};
    if (read_file_is_special(path)) die_all(EXIT_CODE_SCENE, "%s: the study cannot be read: it is not a file", path);
    FILE *in = fopen(path, "rb");
    if (!in) die_all(EXIT_CODE_SCENE, "%s: the study cannot be read: %s", path, strerror(errno));
    char *text = arena_new(BYTES_MAX + 1, 1);
    errno = 0;
    const size_t bytes = fread(text, 1, BYTES_MAX + 1, in);
    if (ferror(in)) die_all(EXIT_CODE_SCENE, "%s: the study cannot be read: %s", path, strerror(errno));
    if (bytes > BYTES_MAX) die_all(EXIT_CODE_SCENE, "%s: the study is larger than %d MB", path, BYTES_MAX >> 20);
    fclose(in);
    struct study *s = study_file_parse(path, text, bytes, &problems);
    scene_problem_print(&problems);
    scene_problem_free(&problems);
    if (!s) exit(EXIT_CODE_SCENE);
    return s;
}
