/* Divides the segments of a lattice into slabs for threads. */
#include "solid/bonds/slabs.h"
#include "base/memory.h"
#include "base/threads.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/segments.h"

#include <limits.h>

/* The segments of one layer along z, and the range of the field arrays that they write, with all lanes. */
struct layer {
    int segments, low, high;
    int slab;
};

static int layer_of(const struct solid_lattice *lattice, const struct solid_segments *segments, int g) {
    return segments->cell[g] / (lattice->size[0] * lattice->size[1]);
}

static void take(struct layer *layer, const struct solid_segments *segments, int g) {
    layer->segments++;
    if (segments->at[g] < layer->low) layer->low = segments->at[g];
    if (segments->at[g] + 2 * SOLID_ROW > layer->high) layer->high = segments->at[g] + 2 * SOLID_ROW;
    for (long i = segments->first[g]; i < segments->first[g + 1]; i++)
        if (segments->far[i] + 2 * SOLID_ROW > layer->high) layer->high = segments->far[i] + 2 * SOLID_ROW;
}

/* A slab ends once it has its share of the segments, and the next slab begins beyond everything that the previous
 * one writes. Returns their number. */
static int divide(struct layer *layer, int layers, int part) {
    int slab = 0, has = 0, high = 0, before = 0;
    for (int z = 0; z < layers; z++) {
        if (has >= part && layer[z].low >= before) {
            slab++;
            before = high;
            has = high = 0;
        }
        layer[z].slab = slab;
        has += layer[z].segments;
        if (layer[z].segments && layer[z].high > high) high = layer[z].high;
    }
    return slab + 1;
}

struct solid_slabs solid_slabs_new(const struct solid_lattice *lattice, const struct solid_segments *segments, int from,
                                   int to) {
    struct solid_slabs slabs = {0, NULL, NULL};
    if (threads_count() == 1 || from == to) return slabs;
    const int layers = lattice->size[2], most = 2 * threads_count();
    struct layer *layer = solid_store_array((size_t)layers, sizeof *layer);
    for (int z = 0; z < layers; z++) layer[z].low = INT_MAX;
    for (int g = from; g < to; g++) take(&layer[layer_of(lattice, segments, g)], segments, g);
    slabs.n = divide(layer, layers, (to - from + most - 1) / most);
    slabs.first = solid_store_array((size_t)slabs.n + 1, sizeof *slabs.first);
    slabs.segment = solid_store_array((size_t)(to - from), sizeof *slabs.segment);
    for (int z = 0; z < layers; z++) slabs.first[layer[z].slab + 1] += layer[z].segments;
    for (int i = 0; i < slabs.n; i++) slabs.first[i + 1] += slabs.first[i];
    int *next = memory_copy(MEMORY_SOLID, slabs.first, (size_t)slabs.n, sizeof *next);
    for (int g = from; g < to; g++) slabs.segment[next[layer[layer_of(lattice, segments, g)].slab]++] = g;
    MEMORY_FREE(next, layer);
    return slabs;
}

void solid_slabs_free(struct solid_slabs *slabs) { MEMORY_FREE(slabs->first, slabs->segment); }
