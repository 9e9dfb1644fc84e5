/* Stable steps and stages. */
#pragma once
#include "coupling/run.h"
#include "program/check/costs.h"

/* Prints the stable steps of fluid and solid and, for each stage, its steps and parts; adds its costs. Collective. */
void check_limits_print(struct run *r, struct costs *costs);
