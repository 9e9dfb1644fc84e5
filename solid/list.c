#include "solid/list.h"
#include "base/memory.h"
#include "solid/family.h"
#include "solid/points.h"

#include <math.h>

static void *solid_array(long n, size_t size) { return memory_new(MEMORY_SOLID, (size_t)n + 1, size); }

static void arrays_new(struct solid_list *b) {
    b->id = solid_array(b->bonds, sizeof *b->id);
    b->l = solid_array(b->bonds, sizeof *b->l);
    for (int c = 0; c < 3; c++) b->xi[c] = solid_array(b->bonds, sizeof *b->xi[c]);
    b->inv_length2 = solid_array(b->bonds, sizeof *b->inv_length2);
    b->weight = solid_array(b->bonds, sizeof *b->weight);
    b->alpha = solid_array(b->bonds, sizeof *b->alpha);
    b->intact = solid_array(b->bonds, 1);
    for (long j = 0; j < b->bonds; j++) b->intact[j] = 1;
}

static void bond_set(struct solid_list *b, long j, long id, const double xi[3], double weight) {
    b->id[j] = id;
    for (int c = 0; c < 3; c++) b->xi[c][j] = xi[c];
    b->inv_length2[j] = 1 / (xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2]);
    b->weight[j] = weight;
}

/* Lattice bodies: the stencil's offsets, in its order. Twice: count, then fill. */
static void from_lattice(struct solid_list *b, const struct solid_sites *t,
                         const struct solid_stencil *stencil, long from, long to) {
    for (int fill = 0; fill < 2; fill++) {
        long j = 0;
        int i = 0;
        for (int q = 0; q < t->filled; q++) {
            const int row = t->order[q];
            if (t->start[row] < from || t->start[row] >= to) continue;
            for (int k = 0; k < 8; k++) {
                if (!(t->bits[row] >> k & 1)) continue;
                const int site[3] = {t->low[0] + 8 * (row % t->rows[0]) + k,
                                     t->low[1] + row / t->rows[0] % t->rows[1],
                                     t->low[2] + row / t->rows[0] / t->rows[1]};
                b->start[i++] = j;
                for (int o = 0; o < stencil->n; o++) {
                    const struct solid_offset *offset = &stencil->offset[o];
                    const int other[3] = {site[0] + offset->step[0], site[1] + offset->step[1],
                                          site[2] + offset->step[2]};
                    const long id = solid_sites_id(t, other);
                    if (id < 0) continue;
                    if (fill) bond_set(b, j, id, offset->xi, offset->weight);
                    j++;
                }
            }
        }
        b->start[i] = b->bonds = j;
        if (!fill) arrays_new(b);
    }
}

/* Points: |xi| < delta + spacing/2, delta the mean of the two ends' horizons, Gamma symmetric. */
static void from_points(struct solid_list *b, const struct solid_input *in, const struct solid_body *body,
                        const struct solid_sites *t, const struct solid_stencil *stencil, long low) {
    struct solid_points *points = solid_points_new(in, body, t, stencil->horizon);
    struct solid_points_near *near = memory_new(MEMORY_SOLID, 1, sizeof *near);
    for (int fill = 0; fill < 2; fill++) {
        long j = 0;
        for (int i = 0; i < b->n; i++) {
            b->start[i] = j;
            solid_points_near(points, low - t->first + i, near);
            for (int k = 0; fill && k < near->n; k++)
                bond_set(b, j + k, t->first + near->number[k], near->xi[k], near->weight[k]);
            j += near->n;
        }
        b->start[b->n] = b->bonds = j;
        if (!fill) arrays_new(b);
    }
    memory_free(near);
    solid_points_free(points);
}

struct solid_list *solid_list_new(const struct solid_input *in, const struct solid_body *body,
                                  const struct solid_sites *t, const struct solid_stencil *stencil,
                                  struct solid_law law, long from, long to, int first) {
    struct solid_list *b = memory_new(MEMORY_SOLID, 1, sizeof *b);
    b->law = law;
    b->full_volume = stencil->full_volume;
    b->first = first;
    const long low = from > t->first ? from : t->first,
               high = to < t->first + t->count ? to : t->first + t->count;
    b->n = high > low ? (int)(high - low) : 0;
    b->start = solid_array(b->n, sizeof *b->start);
    if (t->is_lattice)
        from_lattice(b, t, stencil, from, to);
    else
        from_points(b, in, body, t, stencil, low);
    return b;
}

void solid_list_free(struct solid_list *b) {
    if (!b) return;
    void *owned[] = {b->start,       b->id,     b->l,     b->xi[0],  b->xi[1], b->xi[2],
                     b->inv_length2, b->weight, b->alpha, b->intact, b};
    for (size_t i = 0; i < sizeof owned / sizeof owned[0]; i++) memory_free(owned[i]);
}

long solid_list_wanted(const struct solid_list *b, long from, long to, long *id) {
    long wanted = 0;
    for (long j = 0; j < b->bonds; j++) {
        if (b->id[j] >= from && b->id[j] < to) continue;
        if (id) id[wanted] = b->id[j];
        wanted++;
    }
    return wanted;
}

void solid_list_link(struct solid_list *b, const struct solid_numbering *numbering) {
    for (long j = 0; j < b->bonds; j++) {
        b->l[j] = solid_numbering_local(numbering, b->id[j]);
        ENSURE(b->l[j] >= 0, "particle %ld is not known here", b->id[j]);
    }
    memory_free(b->id);
    b->id = NULL;
}

void solid_list_volumes(const struct solid_list *b, double *family_volume) {
    for (int i = 0; i < b->n; i++) {
        double sum = 0;
        for (long j = b->start[i]; j < b->start[i + 1]; j++) sum += b->weight[j];
        family_volume[b->first + i] = sum;
    }
}

void solid_list_weights(struct solid_list *b, const double *family_volume, int surface_correction) {
    for (int i = 0; i < b->n; i++)
        for (long j = b->start[i]; j < b->start[i + 1]; j++)
            b->alpha[j] = surface_correction
                              ? 2 * b->full_volume / (family_volume[b->first + i] + family_volume[b->l[j]])
                              : 1;
}

int solid_list_longest(const struct solid_list *b) {
    long longest = 0;
    for (int i = 0; i < b->n; i++)
        if (b->start[i + 1] - b->start[i] > longest) longest = b->start[i + 1] - b->start[i];
    return (int)longest;
}

long solid_list_reverse(const struct solid_list *b, int h, long j) {
    const int l = b->l[j] - b->first;
    if (l < 0 || l >= b->n) return -1;
    for (long k = b->start[l]; k < b->start[l + 1]; k++)
        if (b->l[k] == h && b->xi[0][k] == -b->xi[0][j] && b->xi[1][k] == -b->xi[1][j] &&
            b->xi[2][k] == -b->xi[2][j])
            return k;
    return -1;
}
