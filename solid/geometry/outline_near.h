/* The particles nearest to a cell that has none. Inside the room only. */
#pragma once
#include "solid/geometry/outline.h"

enum { SOLID_OUTLINE_NEAR = 16 };

/* Those nearest to the centre of cell i, j among the cells up to reach rows and columns away (itself not), all that are
 * equally near; only those with their centre in the body where asked. Returns how many. */
int solid_outline_near(const struct solid_outline_cells *cells, int i, int j, int reach, int only_inside,
                       long near[SOLID_OUTLINE_NEAR]);
