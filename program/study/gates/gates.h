/* A file of gates: the studies, runs and numbers of a case, and what the numbers must hold.  (docs/study.md) */
#pragma once
#include "program/study/study.h"

/* Whether the file has a key gates at its top. */
int study_gates_is(const char *path);
/* Makes the studies and runs, measures, and writes summary.csv and shown.csv; with STUDY_COLLECT it judges what is
 * there already. study: makes one study with this program. Returns 1 if a number misses its tolerance. */
int study_gates_run(const struct study_options *o, const char *program,
                    int (*study)(const struct study_options *o, const char *program));
