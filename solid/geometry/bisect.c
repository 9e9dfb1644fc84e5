/* Orders the bricks of a body by recursive bisection, the order in which particles are numbered. */
#include "solid/geometry/bisect.h"
#include "base/memory.h"

#include <stdlib.h>
#include <string.h>

/* A cut is across the longest side. A side that was cut last counts 4/3 of its length, so that two cuts in a row are
 * parallel where sides are nearly equal: then a third of the body, too, ends at a plane and not in a corner. */
enum { AGAIN = 4, ONCE = 3 };
/* In percent of the weight: if no plane of bricks is so near to a half, the layer that holds the half is a part of its
 * own, and a border within it is a plane with one step. */
enum { UNEVEN = 8 };

struct work {
    struct solid_bisect_item *item, *sorted;
    long *before; /* weight before each layer */
    int side;
};

/* The bricks with the numbers from .. to-1 in the order. */
struct part {
    long from, to;
    int low[3], high[3]; /* bricks */
    int length[3];       /* sites */
    int last;            /* direction of the cut that made it, -1: none */
    int first;           /* direction of the whole body's cut; -1: it is not given */
    int is_ring[3];
};

static void bound(const struct work *w, struct part *p) {
    int low[3] = {0}, high[3] = {0};
    for (long i = p->from; i < p->to; i++) {
        const struct solid_bisect_item *t = &w->item[i];
        for (int c = 0; c < 3; c++) {
            const int a = t->at[c] * w->side + t->low[c], b = t->at[c] * w->side + t->high[c];
            if (i == p->from || a < low[c]) low[c] = a;
            if (i == p->from || b > high[c]) high[c] = b;
            if (i == p->from || t->at[c] < p->low[c]) p->low[c] = t->at[c];
            if (i == p->from || t->at[c] + 1 > p->high[c]) p->high[c] = t->at[c] + 1;
        }
    }
    for (int c = 0; c < 3; c++) p->length[c] = high[c] - low[c];
}

/* The direction of the next cut; -1: the part is one brick. A ring is cut in two places, so its length counts half. Of
 * equal sides z is cut first, then y: along x the rows of eight sites are never cut, and bricks are not centred. */
static int across(const struct part *p) {
    int best = -1;
    long longest = 0;
    for (int c = 2; c >= 0; c--) {
        if (p->high[c] - p->low[c] < 2) continue;
        const long length = (long)p->length[c] * (p->is_ring[c] ? 1 : 2) * (c == p->last ? AGAIN : ONCE);
        if (length > longest) {
            longest = length;
            best = c;
        }
    }
    return best;
}

/* The planes of bricks, from..to, between which the middle layer is: equal where one plane is near enough to a half. */
static void planes(struct work *w, const struct part *p, int c, int plane[2]) {
    const int layers = p->high[c] - p->low[c];
    long *before = w->before;
    memset(before, 0, ((size_t)layers + 1) * sizeof *before);
    for (long i = p->from; i < p->to; i++) before[w->item[i].at[c] - p->low[c] + 1] += w->item[i].weight;
    for (int k = 0; k < layers; k++) before[k + 1] += before[k];
    const long all = before[layers];
    int best = 1, middle = 0;
    for (int k = 2; k < layers; k++)
        if (labs(2 * before[k] - all) < labs(2 * before[best] - all)) best = k;
    plane[0] = plane[1] = p->low[c] + best;
    if (100 * labs(2 * before[best] - all) <= 2 * UNEVEN * all) return;
    while (2 * before[middle + 1] <= all) middle++;
    plane[0] = p->low[c] + (middle > 0 ? middle : 1);
    plane[1] = p->low[c] + (middle + 1 < layers ? middle + 1 : middle);
}

/* Sorts by the two planes; sets where the second and the third part begin. */
static void divide(struct work *w, const struct part *p, int c, const int plane[2], long begin[2]) {
    long n[3] = {0}, at[3];
    for (long i = p->from; i < p->to; i++) n[(w->item[i].at[c] >= plane[0]) + (w->item[i].at[c] >= plane[1])]++;
    at[0] = p->from;
    at[1] = begin[0] = at[0] + n[0];
    at[2] = begin[1] = at[1] + n[1];
    for (long i = p->from; i < p->to; i++)
        w->sorted[at[(w->item[i].at[c] >= plane[0]) + (w->item[i].at[c] >= plane[1])]++] = w->item[i];
    memcpy(w->item + p->from, w->sorted + p->from, (size_t)(p->to - p->from) * sizeof *w->item);
}

static void order(struct work *w, struct part p) {
    if (p.to - p.from < 2) return;
    bound(w, &p);
    const int c = p.first >= 0 && p.high[p.first] - p.low[p.first] > 1 ? p.first : across(&p);
    if (c < 0) return;
    int plane[2];
    long begin[2];
    planes(w, &p, c, plane);
    divide(w, &p, c, plane, begin);
    const long border[4] = {p.from, begin[0], begin[1], p.to};
    p.last = c;
    p.first = -1;
    p.is_ring[c] = 0;
    for (int k = 0; k < 3; k++) {
        p.from = border[k];
        p.to = border[k + 1];
        order(w, p);
    }
}

void solid_bisect_order(struct solid_bisect_item *item, long n, int side, const int is_ring[3], int first) {
    struct work w = {.item = item, .side = side};
    struct part all = {.to = n, .last = -1, .first = first};
    int most = 0;
    if (n < 2) return;
    bound(&w, &all);
    for (int c = 0; c < 3; c++) {
        all.is_ring[c] = is_ring[c];
        if (all.high[c] - all.low[c] > most) most = all.high[c] - all.low[c];
    }
    w.sorted = memory_new(MEMORY_SOLID, (size_t)n, sizeof *w.sorted);
    w.before = memory_new(MEMORY_SOLID, (size_t)most + 1, sizeof *w.before);
    order(&w, all);
    MEMORY_FREE(w.sorted, w.before);
}
