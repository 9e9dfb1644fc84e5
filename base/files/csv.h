/* Cells of CSV files. */
#pragma once
#include <stdio.h>

/* In quotes where it holds a comma, a quote or the end of a line. Not collective. */
void csv_put(FILE *file, const char *text);
