/* frana calibrate: what cracks take, where a notch starts and what a smooth bar bears, for the materials of a scene. */
#pragma once
#include "program/command/command.h"
#include "scene/scene.h"

/* Writes small scenes, runs them one after the other, and reports. A run that is done is not made again. Returns the
 * exit code. Collective. */
int calibrate_run(const struct command *c, const struct scene *scene);
