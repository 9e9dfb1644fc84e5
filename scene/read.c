/* Reads a scene from text: parses, applies --set, checks, loads, fills in defaults, writes it resolved. */
#include "scene/read.h"
#include "base/side.h"
#include "base/text.h"
#include "scene/check/check.h"
#include "scene/default.h"
#include "scene/derive.h"
#include "scene/keys/load.h"
#include "scene/keys/walk.h"
#include "scene/set.h"
#include "scene/text/yaml.h"
#include "scene/turn.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* The folder that holds the file, absolute; malloc'ed. */
static char *folder_of(const char *path) {
    const char *slash = strrchr(path, '/');
    char *folder = !slash ? text_new(".") : slash == path ? text_new("/") : text_new("%.*s", (int)(slash - path), path);
    char *absolute = realpath(folder, NULL);
    if (!absolute) return folder;
    free(folder);
    return absolute;
}

/* Makes the file name at the key absolute, if the key exists, and checks that the file, or a folder where one may be,
 * can be read. */
static void resolve_file(struct scene_node *root, const char *path, int may_be_folder, const char *folder,
                         struct scene_problems *problems) {
    struct scene_node *node = scene_node_find(root, path);
    struct stat info;
    if (!node || !scene_node_is_clean(root, path)) return;
    char *absolute = node->value[0] == '/' ? text_new("%s", node->value) : text_new("%s/%s", folder, node->value);
    if (strlen(absolute) >= SCENE_PATH)
        scene_problem_value(problems, node, path, "with its folder is %zu characters long, at most %d are possible",
                            strlen(absolute), SCENE_PATH - 1);
    else if (stat(absolute, &info) != 0)
        scene_problem_value(problems, node, path, "there is no such file (looked for %s)", absolute);
    else if (!S_ISREG(info.st_mode) && !(may_be_folder && S_ISDIR(info.st_mode)))
        scene_problem_value(problems, node, path, "is not a file (looked for %s)", absolute);
    else if (access(absolute, R_OK) != 0)
        scene_problem_value(problems, node, path, "cannot be read (looked for %s)", absolute);
    if (strlen(absolute) < SCENE_PATH) {
        free(node->value);
        node->value = absolute;
    } else {
        node->bad = 1;
        free(absolute);
    }
}

/* The lists of a body, of its pieces and its holes. */
static void resolve_body(struct scene_node *root, int b, const char *folder, struct scene_problems *problems) {
    static const char *const list[] = {"pieces", "holes"};
    const struct scene_node *shape = scene_node_find(root, AT("solid.bodies[%d].shape", b));
    const int is_image = shape && shape->value && strcmp(shape->value, "image") == 0;
    resolve_file(root, AT("solid.bodies[%d].file", b), is_image, folder, problems);
    for (int k = 0; k < 2; k++) {
        const struct scene_node *parts = scene_node_find(root, AT("solid.bodies[%d].%s", b, list[k]));
        for (int i = 0; parts && i < parts->n; i++)
            resolve_file(root, AT("solid.bodies[%d].%s[%d].file", b, list[k], i), 0, folder, problems);
    }
}

static void resolve_files(struct scene_node *root, const char *path, struct scene_problems *problems) {
    char *folder = folder_of(path);
    const struct scene_node *bodies = scene_node_find(root, "solid.bodies");
    for (int d = 0; d < 3; d++)
        for (int end = 0; end < 2; end++)
            resolve_file(root, AT("fluid.sides.%s.file", side_name[d][end]), 0, folder, problems);
    for (int b = 0; bodies && b < bodies->n; b++) resolve_body(root, b, folder, problems);
    free(folder);
}

/* Loads a tree whose keys have been checked into the struct. */
static struct scene *load(const char *path, struct scene_node *root, int look_for_files,
                          struct scene_problems *problems) {
    struct scene *s = scene_load(root);
    snprintf(s->path, sizeof s->path, "%s", path);
    scene_derive_domain(s, root);
    scene_turn_derive(s, root);
    if (look_for_files) scene_check_image_open(s, root, problems);
    scene_default_fill(s, root, problems);
    scene_derive(s, root);
    const struct scene_check c = {s, root, problems};
    scene_check_parts(&c);
    scene_check_fluid(&c);
    scene_check_solid(&c);
    scene_check_stages(&c);
    scene_check_crack_fluid(&c);
    s->resolved = scene_yaml_emit(root);
    return s;
}

void scene_read_free(struct scene *s) {
    if (!s) return;
    free(s->resolved);
    s->resolved = NULL;
    scene_derive_free(s);
    scene_load_free(s);
}

struct scene *scene_read(const char *path, const char *text, size_t bytes, int n, const char *const *set,
                         int look_for_files, struct scene_problems *problems) {
    problems->file = path;
    if (strlen(path) >= SCENE_PATH) {
        scene_problem_line(problems, 0, "the scene's path is longer than %d characters", SCENE_PATH - 1);
        return NULL;
    }
    struct scene_node *root = scene_yaml_parse(text, bytes, problems);
    if (!root) return NULL;
    if (scene_node_child(root, "methods") && scene_node_child(root, "levels")) {
        scene_problem_line(problems, 0, "is a study and not a scene: frana study makes its runs");
        scene_node_free(root);
        return NULL;
    }
    scene_set(root, n, set, problems);
    scene_walk(root, problems);
    if (look_for_files) resolve_files(root, path, problems);
    struct scene *s = load(path, root, look_for_files, problems);
    scene_node_free(root);
    if (problems->n > 0) {
        scene_problem_sort(problems);
        scene_read_free(s);
        s = NULL;
    }
    return s;
}
