/* frana check: bodies that stand close before a side through which the flow leaves. */
#pragma once
#include "coupling/run.h"

/* Collective. */
void check_outlet_print(const struct run *r);
