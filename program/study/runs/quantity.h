/* Reads the number that a study measures from a run folder. */
#pragma once
#include "program/study/file/file.h"

/* NAN if the folder does not have the number, with a sentence in *why (else NULL). *wrong: 1 if no run of
 * the study can have it, because the series has no such column. */
double study_quantity_value(const struct study_quantity *q, const char *folder, char **why, int *wrong);
