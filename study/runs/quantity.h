/* The number that a study measures, from a run folder. */
#pragma once
#include "study/file/file.h"

/* NAN, with a sentence in *why (malloc'ed, else NULL), where the folder does not give it. *wrong: 1 where no run of the
 * study will, because the series has no such column. */
double study_quantity_value(const struct study_quantity *q, const char *folder, char **why, int *wrong);
