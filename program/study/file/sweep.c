/* Reads the sweep of a study's file: the values of a key, or points that set several keys. */
#include "base/arena.h"
#include "program/study/file/key.h"
#include "program/study/file/parts.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_MAX = 1000 };

/* A place on the axis is a number; a word has none. */
static double place_of(const struct scene_node *node, const char *path, struct scene_problems *problems) {
    double place;
    if (study_key_number_of(node, &place)) return place;
    scene_problem_value(problems, node, path,
                        "must be a number; words are methods, and lists are points: [{at: 1, set: {...}}, ...]");
    return NAN;
}

static void read_values(struct study *s, const struct study_key *k, const struct scene_node *values) {
    char *key = study_key_text(k, "key", "");
    for (int i = 0; i < values->n; i++) {
        char *path = arena_text("sweep.values[%d]", i);
        struct scene_node *child[] = {values->child[i]};
        const struct scene_node one = {.kind = SCENE_NODE_LIST, .n = 1, .child = child};
        struct study_variant v = {.size = NAN, .line = child[0]->line, .at = place_of(child[0], path, k->problems)};
        v.name = arena_text("%s", child[0]->kind == SCENE_NODE_SCALAR ? child[0]->value : "");
        study_sets_read_values(&v.sets, key, &one, path, k->problems);
        study_variants_add(&s->levels, &v);
    }
}

static void read_point(struct study *s, const struct study_key *k) {
    static const char *const word[] = {"at", "set", "ranks"};
    struct study_variant v = {.size = NAN, .at = NAN, .line = k->mapping->line};
    if (!study_key_known(k, 3, word)) return;
    const struct scene_node *at = scene_node_child(k->mapping, "at"), *set = scene_node_child(k->mapping, "set");
    study_key_missing(k, "at", "its place on the axis");
    study_key_missing(k, "set", "what it sets in the scene");
    if (at) v.at = place_of(at, study_key_path(k, "at"), k->problems);
    v.name = arena_text("%s", at && at->kind == SCENE_NODE_SCALAR ? at->value : "");
    v.ranks = study_key_whole(k, "ranks", 1, STUDY_RANKS_MAX, 0);
    if (set) study_sets_read(&v.sets, set, study_key_path(k, "set"), k->problems);
    study_variants_add(&s->levels, &v);
}

static void read_points(struct study *s, const struct scene_node *points, struct scene_problems *problems) {
    for (int i = 0; i < points->n; i++)
        read_point(s, &(struct study_key){points->child[i], arena_text("sweep.points[%d]", i), problems});
}

static void check_order(const struct study *s, const struct scene_node *node, struct scene_problems *problems) {
    if (s->levels.n > POINTS_MAX)
        scene_problem_key(problems, node, "sweep", "has %d points, more than %d", s->levels.n, POINTS_MAX);
    for (int i = 1; i < s->levels.n; i++) {
        const double before = s->levels.variant[i - 1].at, at = s->levels.variant[i].at;
        const struct scene_node place = {.kind = SCENE_NODE_MAPPING, .line = s->levels.variant[i].line};
        if (isnan(before) || isnan(at) || at > before) continue;
        scene_problem_key(problems, &place, "sweep", "must go from small to large: %g follows %g", at, before);
        return;
    }
}

/* The label of the axis: its name, or the key's last word, and its unit. */
static char *axis_of(const struct study_key *k) {
    char *key = study_key_text(k, "key", "point"), *name = study_key_text(k, "name", NULL),
         *unit = study_key_text(k, "unit", "");
    const char *dot = strrchr(key, '.');
    return arena_text("%s%s%s%s", name ? name : dot ? dot + 1 : key, *unit ? "  [" : "", unit, *unit ? "]" : "");
}

static void read_sweep(struct study *s, const struct study_key *k) {
    static const char *const word[] = {"key", "values", "points", "name", "unit"};
    if (!study_key_known(k, 5, word)) return;
    const int has_key = scene_node_child(k->mapping, "key") != NULL,
              has_values = scene_node_child(k->mapping, "values") != NULL,
              has_points = scene_node_child(k->mapping, "points") != NULL;
    s->axis = axis_of(k);
    if (has_key != has_values || has_values == has_points) {
        scene_problem_key(k->problems, k->mapping, "sweep", "needs key and values, or points, and not both");
        return;
    }
    const struct scene_node *list = study_key_list(k, has_values ? "values" : "points", 1);
    if (list && has_values)
        read_values(s, k, list);
    else if (list)
        read_points(s, list, k->problems);
    check_order(s, k->mapping, k->problems);
}

/* A variant that sets nothing, and has the line of what stands in its place. */
static void add_plain(struct study_variants *v, const char *name, const struct scene_node *instead) {
    const int line = instead ? instead->line : 1;
    study_variants_add(v,
                       &(struct study_variant){.name = arena_text("%s", name), .size = NAN, .line = line, .at = NAN});
}

void study_sweep_read(struct study *s, const struct scene_node *root, struct scene_problems *problems) {
    const struct scene_node *sweep = scene_node_child(root, "sweep"), *methods = scene_node_child(root, "methods");
    if (scene_node_child(root, "levels"))
        scene_problem_key(problems, sweep, "sweep", "not together with levels: a sweep has no error");
    if (methods)
        study_variants_read(&s->methods, methods, "methods", 0, problems);
    else
        add_plain(&s->methods, "all", sweep);
    if (sweep)
        read_sweep(s, &(struct study_key){sweep, "sweep", problems});
    else
        add_plain(&s->levels, "all", scene_node_child(root, "ensemble"));
}
