/* Lists of pairs that may touch: memory, growth, order. */
#include "solid/contact/pairs.h"
#include "base/memory.h"
#include "solid/contact/reserve.h"

#include <string.h>

void solid_contact_pairs_free(struct solid_contact_pairs *p) { MEMORY_FREE(p->h, p->l, p->xi[0], p->xi[1], p->xi[2]); }

void solid_contact_pairs_add(struct solid_contact_pairs *p, int h, int l, const double xi[3]) {
    const int padded = p->n + VEC_LANES; /* pairs are read a vec at a time */
    if (padded > p->capacity) {
        int capacity[4] = {p->capacity, p->capacity, p->capacity, p->capacity};
        p->h = solid_contact_reserve(p->h, &p->capacity, padded, sizeof *p->h);
        p->l = solid_contact_reserve(p->l, &capacity[0], padded, sizeof *p->l);
        for (int c = 0; c < p->dim; c++)
            p->xi[c] = solid_contact_reserve(p->xi[c], &capacity[1 + c], padded, sizeof *p->xi[c]);
    }
    p->h[p->n] = h;
    p->l[p->n] = l;
    for (int c = 0; c < p->dim; c++) p->xi[c][p->n] = xi[c];
    p->n++;
}

/* Puts the items of an array in their order: item k goes to place[k]. */
static void permute(void *items, size_t size, int n, const int *place, char *work) {
    for (int k = 0; k < n; k++) memcpy(work + size * (size_t)place[k], (char *)items + size * (size_t)k, size);
    memcpy(items, work, size * (size_t)n);
}

void solid_contact_pairs_order(struct solid_contact_pairs *p, int particles) {
    int *next = memory_new(MEMORY_SOLID, (size_t)particles + 1, sizeof *next),
        *place = memory_new(MEMORY_SOLID, (size_t)p->n + 1, sizeof *place);
    void *work = memory_new(MEMORY_SOLID, (size_t)p->n + 1, sizeof(double));
    for (int k = 0; k < p->n; k++) next[p->h[k] + 1]++;
    for (int h = 0; h < particles; h++) next[h + 1] += next[h];
    for (int k = 0; k < p->n; k++) place[k] = next[p->h[k]]++;
    permute(p->h, sizeof *p->h, p->n, place, work);
    permute(p->l, sizeof *p->l, p->n, place, work);
    for (int c = 0; c < p->dim; c++) permute(p->xi[c], sizeof *p->xi[c], p->n, place, work);
    MEMORY_FREE(next, place, work);
}
