/* Tables whose columns are given as "step 1|t s|momentum_* N s": names and units; * stands for x and y and, in space
 * (dim 3), z. */
#pragma once
#include "base/files/table.h"

int table_columns_count(const char *columns, int dim); /* Not collective. */
/* Begins or continues the table folder/file as table_new does. Collective. */
struct table *table_columns_new(const char *folder, const char *file, const char *columns, int dim, long resume_step);
