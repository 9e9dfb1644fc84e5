/* run.json: version, machine, wall time by part, and the parts left out.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"
#include "program/output/timeline.h"

/* status: "running", "done", "stopped", "unstable". Collective. */
void run_json_write(struct run *r, struct timeline *t, const char *folder, const char *status, int exit_code);
/* Seconds of the steps, set-up left out, that led to the checkpoint of this step, by the folder's run.json; NAN: not
 * known. Collective. */
double run_json_earlier_seconds(const char *folder, long step);
