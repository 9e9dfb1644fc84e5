/* Compares the scene of a resumed run with the one of its checkpoint. */
#include "program/run/changes.h"
#include "base/arena.h"
#include "base/files/folder.h"
#include "base/files/log.h"
#include "base/par.h"
#include "scene/text/yaml.h"

#include <stdlib.h>
#include <string.h>

enum { LISTED = 5 }; /* changes that a line names */

struct changes {
    int n;
    const char *text;
};

static const char *value_of(const struct scene_node *node) {
    if (!node) return "missing";
    return node->kind == SCENE_NODE_SCALAR ? node->value : node->kind == SCENE_NODE_LIST ? "a list" : "a section";
}

static void add(struct changes *to, const char *path, const struct scene_node *was, const struct scene_node *is) {
    if (to->n++ < LISTED)
        to->text = arena_text("%s%s%s: %s, now %s", to->text, *to->text ? "; " : "", path, value_of(was), value_of(is));
}

static void compare(const char *path, const struct scene_node *was, const struct scene_node *is, struct changes *to);

static const char *below(const char *path, const char *key) {
    return arena_text("%s%s%s", path, *path && *key != '[' ? "." : "", key);
}

/* Members that both have, and those that one has. */
static void compare_mappings(const char *path, const struct scene_node *was, const struct scene_node *is,
                             struct changes *to) {
    for (int i = 0; i < is->n; i++)
        compare(below(path, is->child[i]->key), scene_node_child(was, is->child[i]->key), is->child[i], to);
    for (int i = 0; i < was->n; i++)
        if (!scene_node_child(is, was->child[i]->key)) add(to, below(path, was->child[i]->key), was->child[i], NULL);
}

static void compare(const char *path, const struct scene_node *was, const struct scene_node *is, struct changes *to) {
    if (!was || !is || was->kind != is->kind) {
        add(to, path, was, is);
        return;
    }
    if (is->kind == SCENE_NODE_SCALAR && strcmp(was->value, is->value) != 0) add(to, path, was, is);
    if (is->kind == SCENE_NODE_MAPPING) compare_mappings(path, was, is, to);
    for (int i = 0; is->kind == SCENE_NODE_LIST && (i < is->n || i < was->n); i++)
        compare(below(path, arena_text("[%d]", i)), i < was->n ? was->child[i] : NULL, i < is->n ? is->child[i] : NULL,
                to);
}

static void say(const char *what, const struct changes *changes) {
    if (changes->n == 0) return;
    const char *more = changes->n > LISTED ? arena_text("; and %d more", changes->n - LISTED) : "";
    log_line("%s since the checkpoint: %s%s", what, changes->text, more);
}

/* Path of the scene beside the folder in which the checkpoint is; NULL: it is in none. */
static const char *scene_beside(const char *checkpoint) {
    char path[FOLDER_PATH], *folder = arena_keep(realpath(checkpoint, NULL));
    for (int up = 0; up < 2; up++) {
        char *slash = folder ? strrchr(folder, '/') : NULL;
        if (!slash) return NULL;
        *slash = 0;
    }
    return arena_text("%s", folder_path(path, folder, "scene.resolved.yaml"));
}

void changes_log(const char *checkpoint, const struct scene *scene) {
    struct changes all = {.text = ""}, stages = {.text = ""};
    if (par_rank() != 0) return;
    const char *path = scene_beside(checkpoint);
    char *why = NULL;
    struct scene_node *was = path ? scene_yaml_read(path) : NULL;
    struct scene_node *is = was ? scene_yaml_parse_value(scene->resolved, &why) : NULL;
    for (int i = 0; is && i < is->n; i++) {
        const char *key = is->child[i]->key;
        if (!strcmp(key, "title") || !strcmp(key, "output")) continue;
        compare(key, scene_node_child(was, key), is->child[i], !strcmp(key, "stages") ? &stages : &all);
    }
    for (int i = 0; is && i < was->n; i++)
        if (!scene_node_child(is, was->child[i]->key)) add(&all, was->child[i]->key, was->child[i], NULL);
    say("warning: the scene has changed", &all);
    say("the stages have changed", &stages);
    if (was) scene_node_free(was);
    if (is) scene_node_free(is);
    arena_free();
}
