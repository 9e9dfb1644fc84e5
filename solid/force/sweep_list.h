/* The force sweep over lists of bonds. */
#pragma once
#include "solid/bonds/list.h"

/* Puts the displacements into the records. Not collective. */
void solid_sweep_list_fill(const struct solid *s, const struct solid_list *list);
/* As solid_sweep_lattice_begin and _end in one. */
double solid_sweep_list(struct solid *s, struct solid_list *list, const struct solid_sweep *sweep);
