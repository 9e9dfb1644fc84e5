/* The record of the bonds that break. */
#include "solid/bonds/breaks.h"
#include "base/memory.h"

void solid_breaks_begin(struct solid *s) {
    if (!s->breaks) s->breaks = memory_new(MEMORY_SOLID, 1, sizeof *s->breaks);
}

void solid_breaks_free(struct solid_breaks *b) {
    if (!b) return;
    MEMORY_FREE(b->record, b);
}

/* Whether h comes first of the two ends; of a bond with the particle's own periodic image, whether xi points up. */
static int is_first(const struct solid *s, int h, int l, const double xi[3]) {
    for (int c = 0; c < s->dim; c++)
        if (s->x0[c][h] != s->x0[c][l]) return s->x0[c][h] < s->x0[c][l];
    for (int c = 0; c < s->dim; c++)
        if (xi[c] != 0) return xi[c] > 0;
    return 1;
}

void solid_breaks_add(struct solid *s, int h, int l, const double xi[3], double energy, double area) {
    struct solid_breaks *b = s->breaks;
    if (b->made++ < b->read) return;
    const int first = is_first(s, h, l, xi), from = first ? h : l;
    MEMORY_MORE(MEMORY_SOLID, b->record, b->n, b->capacity);
    struct solid_break *r = &b->record[b->n++];
    *r = (struct solid_break){.energy = energy, .area = area};
    for (int c = 0; c < s->dim; c++) {
        r->x[c] = s->x0[c][from];
        r->xi[c] = first ? xi[c] : -xi[c];
    }
}

void solid_breaks_stamp(struct solid_breaks *b, long step, double t) {
    for (long i = b->stamped > b->read ? b->stamped : b->read; i < b->made; i++) {
        b->record[i - b->read].step = step;
        b->record[i - b->read].t = t;
    }
    b->stamped = b->made;
}

void solid_breaks_restore(struct solid_breaks *b, long made) {
    b->made = made;
    if (b->stamped > made) b->stamped = made;
    b->n = made > b->read ? made - b->read : 0;
}

void solid_breaks_drop(struct solid_breaks *b) {
    b->read += b->n;
    b->n = 0;
}
