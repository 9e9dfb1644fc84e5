/* The kinds of scenes that are solved at once. */
#pragma once
#include "meshless/problem/problem.h"

/* The table: a line for each file of this folder that defines a struct meshless_problem. */
#define MESHLESS_PROBLEMS(LINE)                                                                                        \
    LINE(nonlocal)                                                                                                     \
    LINE(element_free)

#define MESHLESS_PROBLEMS_DECLARE(name) extern const struct meshless_problem meshless_problem_##name;
MESHLESS_PROBLEMS(MESHLESS_PROBLEMS_DECLARE)
#undef MESHLESS_PROBLEMS_DECLARE
