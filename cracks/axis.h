/* The area of a particle at which the faces of several cracks cancel. */
#pragma once
#include "cracks/table.h"

/* Sum of omega/2 |n.xi|/|xi| over the struts, m2, with n the main axis of the sum of omega xi xi/|xi|^2. */
double cracks_axis_area(const struct cracks_table *table, int struts, const uint16_t *kind);
