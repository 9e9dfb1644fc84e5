/* The kinds of scenes that are solved at once, one file each. */
#pragma once
#include "meshless/problem/problem.h"

extern const struct meshless_problem meshless_problem_nonlocal;     /* nonlocal.c */
extern const struct meshless_problem meshless_problem_element_free; /* element_free.c */
