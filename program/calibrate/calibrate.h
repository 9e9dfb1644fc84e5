/* frana calibrate: effective fracture energy, the load at which a notch starts and the strength of a smooth bar, for
 * the materials of a scene. */
#pragma once
#include "program/command/command.h"
#include "scene/scene.h"

/* Writes small scenes, runs them one after the other, and reports. A run that is done is not repeated. Returns the
 * exit code. Collective. */
int calibrate_run(const struct command *c, const struct scene *scene);
