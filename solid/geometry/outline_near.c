/* The particles nearest to a cell that has no particle. */
#include "solid/geometry/outline_near.h"

int solid_outline_near(const struct solid_outline_cells *cells, int i, int j, int reach, int only_inside,
                       long near[SOLID_OUTLINE_NEAR]) {
    long nearest = 0;
    int n = 0;
    for (int dj = -reach; dj <= reach; dj++)
        for (int di = -reach; di <= reach; di++) {
            const long away = (long)di * di + (long)dj * dj;
            if (away == 0 || (n > 0 && away > nearest)) continue;
            const long k = solid_outline_cells_at(cells, i + di, j + dj);
            if (k < 0 || (only_inside && !cells->cell[k].is_inside)) continue;
            if (away < nearest) n = 0;
            nearest = away;
            if (n < SOLID_OUTLINE_NEAR) near[n++] = k;
        }
    return n;
}
