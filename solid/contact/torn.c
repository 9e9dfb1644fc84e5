/* Records particle pairs whose bond broke, and lists those near enough to touch. */
#include "base/memory.h"
#include "solid/bonds/family.h"
#include "solid/bonds/broken_tracker.h"
#include "solid/contact/list.h"
#include "solid/contact/pairs.h"
#include "solid/contact/room.h"

/* Lists h and l if they are nearer than reach. */
static void list_if_near(const struct solid *s, struct solid_contact *c, int h, int l, double reach) {
    double xi[3], r2 = 0;
    for (int k = 0; k < s->dim; k++) {
        const double x0 = solid_contact_list_between(s, s->x0[k][h], s->x0[k][l]);
        const double x = x0 + (s->d[k][h] - s->d[k][l]), nearest = solid_shortest(s, k, x);
        xi[k] = x0 - (x - nearest);
        r2 += nearest * nearest;
    }
    if (r2 < reach * reach)
        solid_contact_pairs_add(&c->pairs[l < s->n ? SOLID_CONTACT_OWNED : SOLID_CONTACT_GHOST], h, l, xi);
}

/* Records the bonds of h that have broken since the last check. */
static void record(struct solid *s, struct solid_contact *c, int h) {
    int other[SOLID_FAMILY_MAX];
    const int torn = solid_family_torn(s, h, c->known + (size_t)h * (size_t)solid_family_bytes(s), other);
    if (torn > 0) c->record = ++s->versions;
    for (int k = 0; k < torn; k++) {
        const int l = other[k];
        if (l <= h) continue; /* both owned: recorded for the other end */
        if (c->torn == c->torn_capacity) {
            int capacity = c->torn_capacity;
            c->torn_h = solid_contact_room(c->torn_h, &capacity, c->torn + 1, sizeof *c->torn_h);
            c->torn_l = solid_contact_room(c->torn_l, &c->torn_capacity, c->torn + 1, sizeof *c->torn_l);
        }
        c->torn_h[c->torn] = h;
        c->torn_l[c->torn++] = l;
    }
}

void solid_contact_torn_scan(struct solid *s, struct solid_contact *c) {
    for (int h = 0; h < s->n; h++)
        if (s->flag[h] & SOLID_BROKEN) record(s, c, h);
    solid_broken_tracker_find(c->tracker, s);
}

void solid_contact_torn_news(struct solid *s, struct solid_contact *c, double further) {
    const int before = c->torn, found = solid_broken_tracker_find(c->tracker, s);
    for (int k = 0; k < found; k++) record(s, c, c->tracker->h[k]);
    for (int k = before; k < c->torn; k++) {
        const int h = c->torn_h[k], l = c->torn_l[k];
        list_if_near(s, c, h, l, further + solid_contact_list_reach(c, 2 * c->runs[h], 2 * c->runs[l]));
    }
}

void solid_contact_torn_list(const struct solid *s, struct solid_contact *c) {
    for (int k = 0; k < c->torn; k++) {
        const int h = c->torn_h[k], l = c->torn_l[k];
        list_if_near(s, c, h, l, solid_contact_list_reach(c, c->runs[h], c->runs[l]));
    }
}
