/* Reads the result and the costs of a run from its run.json. */
#include "program/study/runs/outcome.h"
#include "base/version.h"
#include "base/files/folder.h"
#include "scene/text/yaml.h"
#include "program/study/text.h"

#include <math.h>
#include <string.h>

static double number(const struct scene_node *root, const char *path) {
    const struct scene_node *node = scene_node_find(root, path);
    return node ? study_text_number(node->value) : NAN;
}

static int says(const struct scene_node *root, const char *key, const char *text) {
    const struct scene_node *node = scene_node_child(root, key);
    return node && node->kind == SCENE_NODE_SCALAR && !strcmp(node->value, text);
}

struct study_outcome study_outcome_read(const char *folder) {
    struct study_outcome o = {.wall = NAN, .setup = NAN, .cell_step = NAN, .bond_sweep = NAN, .memory = NAN};
    char path[FOLDER_PATH];
    struct scene_node *root = scene_yaml_read(folder_path(path, folder, "run.json"));
    if (!root) return o;
    const int done = says(root, "status", "done"), unstable = says(root, "status", "unstable");
    o.state = done ? STUDY_DONE : unstable ? STUDY_FAILED : STUDY_TODO;
    o.exit_code = (int)number(root, "exit_code");
    o.setup = number(root, "setup_seconds");
    o.wall = number(root, "wall_seconds") - (isnan(o.setup) ? 0 : o.setup);
    if (scene_node_child(root, "wall_seconds_earlier")) o.wall += number(root, "wall_seconds_earlier");
    o.cell_step = number(root, "ns_per_cell_step");
    o.bond_sweep = number(root, "ns_per_directed_bond_sweep");
    o.steps = (long)number(root, "steps");
    o.ranks = (int)number(root, "ranks");
    const struct scene_node *memory = scene_node_child(root, "peak_memory_bytes_per_rank");
    for (int k = 0; memory && k < memory->n; k++)
        o.memory = (k ? o.memory : 0) + study_text_number(memory->child[k]->value);
    o.same_build = says(root, "revision", FRANA_REVISION) && says(root, "compiler", FRANA_COMPILER) &&
                   says(root, "flags", FRANA_FLAGS);
    scene_node_free(root);
    return o;
}
