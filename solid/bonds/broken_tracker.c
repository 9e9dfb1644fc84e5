/* Finds the particles that have lost bonds since the last check. */
#include "solid/bonds/broken_tracker.h"

#include "base/memory.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list_lanes.h"

#include <string.h>

int solid_broken_tracker_take(struct solid *s, enum solid_broke reader) {
    const int unread = s->broke & (SOLID_BROKE_NEW | (int)reader);
    if (!unread) return 0;
    if (s->broke & SOLID_BROKE_NEW)
        s->broke = SOLID_BROKE_SURFACE | (s->in.contact ? SOLID_BROKE_CONTACT : 0) | (s->push ? SOLID_BROKE_PUSH : 0);
    s->broke &= ~(int)reader;
    return 1;
}

static void compare(struct solid_broken_tracker *tracker, int h, int intact) {
    if (intact == tracker->intact[h]) return;
    tracker->intact[h] = (uint16_t)intact;
    tracker->h[tracker->found++] = h;
}

static void find_in_lattice(struct solid_broken_tracker *tracker, const struct solid_lattice *lattice,
                            unsigned *row_version) {
    const int n = lattice->stencil->n;
    for (int r = 0; r < lattice->rows; r++) {
        if (lattice->row_version[r] == row_version[r]) continue;
        row_version[r] = lattice->row_version[r];
        const uint8_t *lambda = lattice->lambda + (size_t)r * (size_t)n;
        int h = lattice->row_first[r];
        for (int k = 0; k < SOLID_ROW; k++) {
            if (!(lattice->row_owned[r] >> k & 1)) continue;
            int intact = 0;
            for (int o = 0; o < n; o++) intact += lambda[o] >> k & 1;
            compare(tracker, h++, intact);
        }
    }
}

/* Only particles with the flag SOLID_BROKEN have lost bonds. */
static void find_in_list(struct solid_broken_tracker *tracker, const struct solid_list *list, const uint8_t *flag) {
    for (int i = 0; i < list->n; i++) {
        if (!(flag[list->first + i] & SOLID_BROKEN)) continue;
        int intact = 0;
        for (long j = list->start[i]; j < list->end[i]; j += SOLID_LIST_BLOCK)
            intact += __builtin_popcount(solid_list_lanes_block_intact(list, j));
        compare(tracker, list->first + i, intact);
    }
}

int solid_broken_tracker_find(struct solid_broken_tracker *tracker, const struct solid *s) {
    unsigned *row_version = tracker->row_version;
    tracker->found = 0;
    for (int b = 0; b < s->family->bodies; b++) {
        const struct solid_lattice *lattice = s->family->lattice[b];
        if (lattice) {
            find_in_lattice(tracker, lattice, row_version);
            row_version += lattice->rows;
        } else {
            find_in_list(tracker, s->family->list[b], s->flag);
        }
    }
    return tracker->found;
}

static size_t rows_of(const struct solid *s) {
    size_t rows = 0;
    for (int b = 0; b < s->family->bodies; b++)
        if (s->family->lattice[b]) rows += (size_t)s->family->lattice[b]->rows;
    return rows;
}

void solid_broken_tracker_reset(struct solid_broken_tracker *tracker, const struct solid *s) {
    memset(tracker->intact, 0xff, (size_t)s->n * sizeof *tracker->intact); /* more than any particle has, so that all
                                                                            * count as changed */
    memset(tracker->row_version, 0xff, rows_of(s) * sizeof *tracker->row_version);
}

struct solid_broken_tracker *solid_broken_tracker_new(const struct solid *s) {
    struct solid_broken_tracker *tracker = memory_new(MEMORY_SOLID, 1, sizeof *tracker);
    tracker->intact = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *tracker->intact);
    tracker->h = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *tracker->h);
    tracker->row_version = memory_new(MEMORY_SOLID, rows_of(s) + 1, sizeof *tracker->row_version);
    solid_broken_tracker_reset(tracker, s);
    solid_broken_tracker_find(tracker, s);
    return tracker;
}

void solid_broken_tracker_copy(struct solid_broken_tracker *to, const struct solid_broken_tracker *from,
                               const struct solid *s) {
    memcpy(to->intact, from->intact, (size_t)s->n * sizeof *to->intact);
    memcpy(to->row_version, from->row_version, rows_of(s) * sizeof *to->row_version);
}

void solid_broken_tracker_free(struct solid_broken_tracker *tracker) {
    if (!tracker) return;
    MEMORY_FREE(tracker->intact, tracker->h, tracker->row_version, tracker);
}
