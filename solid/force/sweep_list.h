/* The force sweep over the list store. */
#pragma once
#include "solid/bonds/list.h"

/* Copies the displacements to the records. Not collective. */
void solid_sweep_list_fill(const struct solid *s, const struct solid_list *list);
/* Does the work of both solid_sweep_lattice_begin and _end. */
double solid_sweep_list(struct solid *s, struct solid_list *list, const struct solid_sweep *sweep);
