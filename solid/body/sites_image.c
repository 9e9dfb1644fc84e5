/* Finds the lattice sites in the voxels of an image, each rank in its slices. All indices are whole numbers: a site's
 * voxel is (site - corner)/sites, rounded down. */
#include "solid/body/bricks.h"
#include "solid/body/sites_image.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_piece.h"
#include "solid/voxels/voxels.h"

#include <math.h>
#include <string.h>

/* sites without a particle before and behind the image, as other shapes have them */
enum { BEFORE = 1, MARGIN = 3 };

/* Whether the site is in the image; its voxel. */
static int voxel_of(const struct solid_voxels *v, const int site[3], int at[3]) {
    for (int c = 0; c < 3; c++) {
        at[c] = site[c] - v->corner[c];
        if (at[c] < 0 || at[c] >= v->n[c] * v->sites[c]) return 0;
        at[c] /= v->sites[c];
    }
    return 1;
}

int solid_sites_image_is(const struct solid_voxels *v, const uint64_t *bits, const int site[3]) {
    int at[3];
    return voxel_of(v, site, at) && solid_voxels_is(v, bits, at[0], at[1], at[2]);
}

int solid_sites_image_kind(const struct solid_voxels *v, const int site[3]) {
    int at[3];
    return voxel_of(v, site, at) ? solid_voxels_kind(v, at[0], at[1], at[2]) : 0;
}

/* A line of voxels as sites: bit b is site b - SOLID_ROW - BEFORE. Returns whether there is any. */
static int sites_of(const struct solid_voxels *v, int j, int k, uint8_t *line, size_t bytes) {
    const uint64_t *voxel = v->bits + solid_voxels_line(v, j, k);
    uint64_t any = 0;
    for (long w = 0; w < v->words; w++) any |= voxel[w];
    memset(line, 0, bytes);
    if (!any) return 0;
    for (int i = 0, b = SOLID_ROW + BEFORE; i < v->n[0]; i++) {
        if (!(voxel[i / 64] >> i % 64 & 1)) {
            b += v->sites[0];
            continue;
        }
        for (int s = 0; s < v->sites[0]; s++, b++) line[b / 8] |= (uint8_t)(1u << b % 8);
    }
    return 1;
}

/* Row r of a line when rows begin `shift` sites earlier. */
static uint8_t row_of(const uint8_t *line, int r, int shift) {
    const unsigned two = line[r] | (unsigned)line[r + 1] << 8;
    return (uint8_t)(two >> (SOLID_ROW - shift));
}

static int rows_of(int sites, int shift) { return (sites + shift - 1) / SOLID_ROW + 1; }

/* The shift that gives the fewest rows with a site, of equals the least. */
static int best_shift(const struct solid_voxels *v, const int slices[2], uint8_t *line, size_t bytes, int along) {
    long rows[SOLID_ROW] = {0};
    int best = 0;
    for (int k = slices[0]; k < slices[1]; k++)
        for (int j = 0; j < v->n[1]; j++) {
            if (!sites_of(v, j, k, line, bytes)) continue;
            for (int shift = 0; shift < SOLID_ROW; shift++)
                for (int r = 0; r < rows_of(along, shift); r++) rows[shift] += row_of(line, r, shift) != 0;
        }
    par_sum_long_array(rows, SOLID_ROW);
    for (int shift = 1; shift < SOLID_ROW; shift++)
        if (rows[shift] < rows[best]) best = shift;
    return best;
}

/* The shifts along y and z that give a plane of bricks through the middle, as for other shapes. */
static void middle_shift(const struct solid_voxels *v, const int slices[2], int shift[3]) {
    const int lines = v->n[1] > v->n[2] ? v->n[1] : v->n[2];
    for (int c = 1; c < 3; c++) {
        const int n = BEFORE + v->n[c] * v->sites[c];
        long *voxels = memory_new(MEMORY_SOLID, (size_t)lines, sizeof *voxels),
             *layer = memory_new(MEMORY_SOLID, (size_t)n, sizeof *layer);
        for (int k = slices[0]; k < slices[1]; k++)
            for (int j = 0; j < v->n[1]; j++) {
                const uint64_t *word = v->bits + solid_voxels_line(v, j, k);
                for (long w = 0; w < v->words; w++) voxels[c == 1 ? j : k] += __builtin_popcountll(word[w]);
            }
        par_sum_long_array(voxels, v->n[c]);
        for (int i = 0; i < n - BEFORE; i++) layer[BEFORE + i] = voxels[i / v->sites[c]];
        shift[c] = solid_bricks_shift(layer, n);
        MEMORY_FREE(voxels, layer);
    }
}

static void reach_to(struct solid_sites *sites, int top[3], int c, int from, int to, int is_first) {
    if (is_first || from < sites->base[c]) sites->base[c] = from;
    if (is_first || to > top[c]) top[c] = to;
}

/* Lowest and highest sites of the line's voxels. */
static void note_line(const struct solid_voxels *v, int j, int k, struct solid_sites *sites, int top[3]) {
    const uint64_t *voxel = v->bits + solid_voxels_line(v, j, k);
    long first = 0, last = v->words - 1;
    while (!voxel[first]) first++;
    while (!voxel[last]) last--;
    const int low[3] = {(int)(64 * first) + __builtin_ctzll(voxel[first]), j, k},
              high[3] = {(int)(64 * last) + 63 - __builtin_clzll(voxel[last]), j, k};
    for (int c = 0; c < 3; c++)
        reach_to(sites, top, c, v->corner[c] + low[c] * v->sites[c], v->corner[c] + (high[c] + 1) * v->sites[c] - 1,
                 sites->count == 0);
}

/* The count and the extent of all ranks' sites, and the map of all on every node. */
static void unite(struct solid_sites *sites, int top[3]) {
    double low[3], high[3];
    for (int c = 0; c < 3; c++) {
        low[c] = sites->count > 0 ? sites->base[c] : INFINITY;
        high[c] = sites->count > 0 ? top[c] : -INFINITY;
    }
    par_min_array(low, 3);
    par_max_array(high, 3);
    sites->count = par_sum_long(sites->count);
    for (int c = 0; c < 3 && sites->count > 0; c++) {
        sites->base[c] = (int)low[c];
        top[c] = (int)high[c];
    }
    par_shared_unite(sites->map);
}

void solid_sites_image(const struct solid_voxels *v, struct solid_sites *sites, int top[3]) {
    const int along = v->n[0] * v->sites[0] + MARGIN;
    const int slices[2] = {par_piece_low(v->n[2], par_size(), par_rank()),
                           par_piece_low(v->n[2], par_size(), par_rank() + 1)};
    const size_t bytes = (size_t)(along + 4 * SOLID_ROW) / 8;
    uint8_t *line = memory_new(MEMORY_SOLID, bytes, 1);
    const int shift = best_shift(v, slices, line, bytes, along);
    int before[3];
    middle_shift(v, slices, before);
    for (int c = 1; c < 3; c++) {
        sites->low[c] = v->corner[c] - BEFORE - before[c];
        sites->rows[c] = v->n[c] * v->sites[c] + MARGIN + before[c];
    }
    sites->low[0] = v->corner[0] - BEFORE - shift;
    sites->rows[0] = rows_of(along, shift);
    solid_bricks_share(sites);
    for (int k = slices[0]; k < slices[1]; k++)
        for (int j = 0; j < v->n[1]; j++) {
            if (!sites_of(v, j, k, line, bytes)) continue;
            note_line(v, j, k, sites, top);
            for (int e = 0; e < v->sites[1] * v->sites[2]; e++) {
                const int at[2] = {before[1] + BEFORE + j * v->sites[1] + e % v->sites[1],
                                   before[2] + BEFORE + k * v->sites[2] + e / v->sites[1]};
                for (int r = 0; r < sites->rows[0]; r++) {
                    const uint8_t bits = row_of(line, r, shift);
                    sites->bits[solid_bricks_row(sites, r, at[0], at[1])] = bits;
                    sites->count += __builtin_popcount(bits);
                }
            }
        }
    unite(sites, top);
    memory_free(line);
}
