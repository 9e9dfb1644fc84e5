/* frana init: scenes to begin with. */
#pragma once

/* Copies the scene of a case to folder/CASE.yaml, with comments on its keys; the exit code. NULL: lists the cases. Dies
 * (exit 2) on an unknown case or a file that is there already, (exit 4) on one that cannot be written. Not collective.
 */
int init_scene(const char *name, const char *folder);
