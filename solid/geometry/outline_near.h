/* The particles nearest to a cell that has none. For solid/ only. */
#pragma once
#include "solid/geometry/outline.h"

enum { SOLID_OUTLINE_NEAR = 16 };

/* The particles nearest to the centre of cell i, j, among the cells up to `reach` rows and columns away (without the
 * cell itself); all that are equally near; on request only those with their centre in the body. Returns how many. */
int solid_outline_near(const struct solid_outline_cells *cells, int i, int j, int reach, int only_inside,
                       long near[SOLID_OUTLINE_NEAR]);
