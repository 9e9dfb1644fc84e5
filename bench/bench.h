/* frana bench: times of kernels and whole steps, compared with the machine's limits.  (docs/performance.md) */
#pragma once
#include "program/command.h"

int bench_run(const struct command *c);   /* measures; with --table writes the pages' tables. Collective. */
int bench_table(const struct command *c); /* Not collective. */
