/* Finds whether a run folder holds the run of a scene, and how much of it. */
#include "program/run/status.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/read_file.h"
#include "scene/text/yaml.h"

#include <stdlib.h>
#include <string.h>

enum run_status run_status_of(const char *folder, const struct scene *scene) {
    char path[FOLDER_PATH];
    enum run_status state = RUN_STATUS_NONE;
    if (!folder_has_run(folder)) return state;
    if (par_rank() == 0) {
        char *resolved = read_file(folder_path(path, folder, "scene.resolved.yaml"));
        const int same = resolved && !strcmp(resolved, scene->resolved);
        struct scene_node *root = same ? scene_yaml_read(folder_path(path, folder, "run.json")) : NULL;
        const struct scene_node *status = root ? scene_node_child(root, "status") : NULL;
        char *latest = same ? read_file(folder_path(path, folder, "checkpoint/latest")) : NULL;
        state = !same ? RUN_STATUS_OTHER_SCENE : latest ? RUN_STATUS_RESUMABLE : RUN_STATUS_BEGUN;
        if (status && !strcmp(status->value, "done")) state = RUN_STATUS_DONE;
        free(latest);
        free(resolved);
        if (root) scene_node_free(root);
    }
    par_bcast(&state, sizeof state, 0);
    return state;
}
