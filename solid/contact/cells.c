/* Hashes points into cells and finds those near a position, also across periodic sides. */
#include "solid/contact/cells.h"

#include "base/memory.h"
#include "solid/contact/room.h"

#include <math.h>

static void cell_of(const struct solid_cells *cells, const double x[3], int cell[3]) {
    for (int c = 0; c < 3; c++) {
        const double at = floor(x[c] / cells->size[c]);
        const double wrapped = cells->count[c] ? at - cells->count[c] * floor(at / cells->count[c]) : at;
        cell[c] = (int)fmax(-1e9, fmin(1e9, wrapped));
    }
}

static int slot(const struct solid_cells *cells, const int cell[3]) {
    const unsigned key = (unsigned)cell[0] * 73856093u ^ (unsigned)cell[1] * 19349663u ^ (unsigned)cell[2] * 83492791u;
    return (int)((key ^ key >> 15) & (unsigned)cells->mask);
}

void solid_contact_cells_fill(struct solid_cells *cells, int n, const double (*x)[3], double reach,
                              const int periodic[3], const double length[3]) {
    cells->n = n;
    cells->x = x;
    for (int c = 0; c < 3; c++) {
        cells->count[c] = periodic[c] ? (int)fmax(1, floor(length[c] / reach)) : 0;
        cells->size[c] = periodic[c] ? length[c] / cells->count[c] : reach;
    }
    for (cells->mask = 63; cells->mask < 2 * n;) cells->mask = 2 * cells->mask + 1;
    cells->head = solid_contact_room(cells->head, &cells->head_capacity, cells->mask + 1, sizeof *cells->head);
    cells->next = solid_contact_room(cells->next, &cells->next_capacity, n, sizeof *cells->next);
    cells->cell = solid_contact_room(cells->cell, &cells->cell_capacity, n, sizeof *cells->cell);
    for (int k = 0; k <= cells->mask; k++) cells->head[k] = -1;
    for (int i = n - 1; i >= 0; i--) {
        cell_of(cells, x[i], cells->cell[i]);
        const int k = slot(cells, cells->cell[i]);
        cells->next[i] = cells->head[k];
        cells->head[k] = i;
    }
}

void solid_contact_cells_free(struct solid_cells *cells) {
    memory_free(cells->head);
    memory_free(cells->next);
    memory_free(cells->cell);
    *cells = (struct solid_cells){0};
}

enum { AROUND = 5 };

/* The cells c - rings, ..., c + rings; each once if a period has fewer cells. */
static int around(int cell, int count, int rings, int out[AROUND]) {
    int n = 0;
    for (int step = -rings; step <= rings; step++) {
        const int c = count ? (cell + step + 2 * count) % count : cell + step;
        int known = 0;
        for (int k = 0; k < n; k++) known |= out[k] == c;
        if (!known) out[n++] = c;
    }
    return n;
}

int solid_contact_cells_near(const struct solid_cells *cells, const double x[3], int rings, int *found) {
    int cell[3], list[3][AROUND], number[3], n = 0;
    cell_of(cells, x, cell);
    for (int c = 0; c < 3; c++) number[c] = around(cell[c], cells->count[c], rings, list[c]);
    for (int i = 0; i < number[0]; i++)
        for (int j = 0; j < number[1]; j++)
            for (int k = 0; k < number[2]; k++) {
                const int at[3] = {list[0][i], list[1][j], list[2][k]};
                for (int p = cells->head[slot(cells, at)]; p >= 0; p = cells->next[p])
                    if (cells->cell[p][0] == at[0] && cells->cell[p][1] == at[1] && cells->cell[p][2] == at[2])
                        found[n++] = p;
            }
    return n;
}
