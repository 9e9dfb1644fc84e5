/* frana bench: times of kernels and whole steps, beside what the machine could do at best.  (docs/performance.md) */
#pragma once
#include "program/command.h"

int bench_run(const struct command *c);   /* measures, or with --table makes the pages' tables. Collective. */
int bench_table(const struct command *c); /* Not collective. */
