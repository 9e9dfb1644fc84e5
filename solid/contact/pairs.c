/* Lists of pairs that may touch: memory and growth. */
#include "solid/contact/pairs.h"
#include "base/memory.h"
#include "solid/contact/room.h"

void solid_contact_pairs_free(struct solid_contact_pairs *p) {
    void *const list[] = {p->h, p->l, p->xi[0], p->xi[1], p->xi[2]};
    for (size_t k = 0; k < sizeof list / sizeof list[0]; k++) memory_free(list[k]);
}

void solid_contact_pairs_add(struct solid_contact_pairs *p, int h, int l, const double xi[3]) {
    if (p->n == p->capacity) {
        int capacity[4] = {p->capacity, p->capacity, p->capacity, p->capacity};
        p->h = solid_contact_room(p->h, &p->capacity, p->n + 1, sizeof *p->h);
        p->l = solid_contact_room(p->l, &capacity[0], p->n + 1, sizeof *p->l);
        for (int c = 0; c < p->dim; c++)
            p->xi[c] = solid_contact_room(p->xi[c], &capacity[1 + c], p->n + 1, sizeof *p->xi[c]);
    }
    p->h[p->n] = h;
    p->l[p->n] = l;
    for (int c = 0; c < p->dim; c++) p->xi[c][p->n] = xi[c];
    p->n++;
}
