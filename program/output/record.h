/* run.json: version, machine, wall time by part, and the parts left out.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"
#include "base/files/json.h"
#include "program/output/timeline.h"

/* status: "running", "done", "stopped", "unstable". Collective. */
void record_write(struct run *r, struct timeline *t, const char *folder, const char *status, int exit_code);
/* Seconds of the steps, set-up left out, that led to the checkpoint of this step, by the folder's run.json; NAN: not
 * known. Collective. */
double record_earlier(const char *folder, long step);
/* Sentences on the parts that the scene leaves out. Returns how many. Not collective. */
enum { RECORD_LEFT_OUT = 16, RECORD_SENTENCE = 160 };
int record_left_out(const struct scene *scene, char sentence[RECORD_LEFT_OUT][RECORD_SENTENCE]);
/* One line for each of version, MPI, HDF5, FFTW. Not collective. */
void record_version(char *text, int size);
/* Members of run.json: version, compiler, libraries, host. Not collective. */
void record_write_version(struct json *j);
