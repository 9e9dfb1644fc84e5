/* Finds whether a run folder holds the run of a scene, and how much of it. */
#include "program/made.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/whole.h"
#include "scene/text/yaml.h"

#include <stdlib.h>
#include <string.h>

enum made made_in(const char *folder, const struct scene *scene) {
    char path[FOLDER_PATH];
    enum made state = MADE_NOTHING;
    if (!folder_has_run(folder)) return state;
    if (par_rank() == 0) {
        char *resolved = whole_new(folder_path(path, folder, "scene.resolved.yaml"));
        const int same = resolved && !strcmp(resolved, scene->resolved);
        struct scene_node *root = same ? scene_yaml_read(folder_path(path, folder, "run.json")) : NULL;
        const struct scene_node *status = root ? scene_node_child(root, "status") : NULL;
        char *latest = same ? whole_new(folder_path(path, folder, "checkpoint/latest")) : NULL;
        state = !same ? MADE_OTHER : latest ? MADE_CHECKPOINT : MADE_PART;
        if (status && !strcmp(status->value, "done")) state = MADE_ALL;
        free(latest);
        free(resolved);
        if (root) scene_node_free(root);
    }
    par_bcast(&state, sizeof state, 0);
    return state;
}
