/* What a run folder holds of the run of a scene. */
#pragma once
#include "scene/scene.h"

enum made { MADE_NOTHING, MADE_PART, MADE_CHECKPOINT, MADE_ALL, MADE_OTHER };

/* part: begun, without a checkpoint; checkpoint: the run can be resumed; all: it is done; other: another scene's run.
 * Collective. */
enum made made_in(const char *folder, const struct scene *scene);
