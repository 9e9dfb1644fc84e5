/* frana check: what a run will cost in steps, files and time. */
#pragma once
#include "coupling/run.h"

/* Prints steps, sweeps, bytes of the files, and the time, from what earlier runs on this machine took (program/speed.h)
 * or, with measure, from steps that are taken here: some of each stage, within about 10 s in all. out: a folder on the
 * disk that the run will write. Rank 0 prints. Collective. */
void costs_say(struct run *r, const char *out, int measure);
/* Number of files of fields, and bytes of one. Not collective. */
long costs_dumps(const struct run *r);
double costs_dump_bytes(const struct run *r);
