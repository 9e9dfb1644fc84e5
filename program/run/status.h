/* What a run folder holds of the run of a scene. */
#pragma once
#include "scene/scene.h"

enum run_status { RUN_STATUS_NONE, RUN_STATUS_BEGUN, RUN_STATUS_RESUMABLE, RUN_STATUS_DONE, RUN_STATUS_OTHER_SCENE };

/* BEGUN: without a checkpoint. RESUMABLE: it has one. Collective. */
enum run_status run_status_of(const char *folder, const struct scene *scene);
