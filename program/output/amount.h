/* What a run writes: how many samples, files of fields and checkpoints, and their bytes. */
#pragma once
#include "coupling/run.h"

/* How often something is written that is due every so many steps (0: never) and at the end of each stage, after the
 * steps from + 1 .. to of the run. Not collective. */
long amount_samples(const struct run *r, long every, long from, long to);
/* Number of files of fields of the whole run, and bytes of one. Not collective. */
long amount_fields(const struct run *r);
double amount_fields_bytes(const struct run *r);
/* Bytes of the files of fields and the checkpoints that are written after the steps from + 1 .. to, those included that
 * are deleted again. Collective. */
double amount_bytes(struct run *r, long from, long to);
