/* A number that is measured from a table of a run. */
#pragma once
#include "program/study/gates/items.h"
#include "program/study/gates/parts.h"

/* The item's number: file in the folder of the runs, and either column of a table such as series.csv, reduced as a
 * study's quantity is, or in the row of a number; or quantity of a table with columns quantity and value; times factor.
 * 15 digits. Dies where there is none. */
char *study_gates_cell_text(const struct study_gates *g, const struct scene_node *item,
                            const struct study_gates_name *names);
