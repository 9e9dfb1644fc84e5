/* Loads that conserve momentum: each body's sum is corrected to the force that the forcing takes from the fluid. */
#pragma once
#include "coupling/load/load.h"

extern const struct load_kind balance_kind;
