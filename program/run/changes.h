/* What has changed in the scene since the checkpoint that a run goes on from. */
#pragma once
#include "scene/scene.h"

/* Compares the scene with the one in the folder of the checkpoint FOLDER/checkpoint/NAME, and says in the log which
 * values differ: as a warning, as the run's files then belong to two scenes; of stages without, as these are often
 * changed to go on. Titles and outputs do not count. Says nothing where that scene is not there. Not collective, to be
 * called on all ranks. */
void changes_log(const char *checkpoint, const struct scene *scene);
