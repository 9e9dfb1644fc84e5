/* Records broken-bond pairs, and lists those near enough to touch. */
#include "solid/bonds/family.h"
#include "solid/bonds/broken_tracker.h"
#include "solid/contact/list.h"
#include "solid/contact/pairs.h"
#include "solid/contact/reserve.h"

/* Lists h and l if they are nearer than reach. */
static void list_if_near(const struct solid *s, struct solid_contact *c, int h, int l, double reach) {
    double xi[3], r2 = 0;
    for (int k = 0; k < s->dim; k++) {
        const double x0 = solid_contact_list_initial_offset(s, s->x0[k][h], s->x0[k][l]);
        const double x = x0 + (s->d[k][h] - s->d[k][l]), nearest = solid_shortest(s, k, x);
        xi[k] = x0 - (x - nearest);
        r2 += nearest * nearest;
    }
    if (r2 < reach * reach)
        solid_contact_pairs_add(&c->pairs[l < s->n ? SOLID_CONTACT_OWNED : SOLID_CONTACT_BOND_GHOST], h, l, xi);
}

/* Records the bonds of h that have broken since the last check. */
static void record(struct solid *s, struct solid_contact *c, int h) {
    int other[SOLID_FAMILY_MAX];
    const int broken = solid_family_newly_broken(s, h, c->recorded + (size_t)h * (size_t)solid_family_bytes(s), other);
    if (broken > 0) c->record = ++s->versions;
    for (int k = 0; k < broken; k++) {
        const int l = other[k];
        if (l <= h) continue; /* both owned: recorded for the other end */
        if (c->broken == c->broken_capacity) {
            int capacity = c->broken_capacity;
            c->broken_h = solid_contact_reserve(c->broken_h, &capacity, c->broken + 1, sizeof *c->broken_h);
            c->broken_l = solid_contact_reserve(c->broken_l, &c->broken_capacity, c->broken + 1, sizeof *c->broken_l);
        }
        c->broken_h[c->broken] = h;
        c->broken_l[c->broken++] = l;
    }
}

void solid_contact_broken_scan(struct solid *s, struct solid_contact *c) {
    for (int h = 0; h < s->n; h++)
        if (s->flag[h] & SOLID_BROKEN) record(s, c, h);
    solid_broken_tracker_find(c->tracker, s);
}

void solid_contact_broken_update(struct solid *s, struct solid_contact *c, double further) {
    const int before = c->broken, found = solid_broken_tracker_find(c->tracker, s);
    for (int k = 0; k < found; k++) record(s, c, c->tracker->h[k]);
    for (int k = before; k < c->broken; k++) {
        const int h = c->broken_h[k], l = c->broken_l[k];
        list_if_near(s, c, h, l, further + solid_contact_list_reach(c, 2 * c->is_fast[h], 2 * c->is_fast[l]));
    }
}

void solid_contact_broken_list(const struct solid *s, struct solid_contact *c) {
    for (int k = 0; k < c->broken; k++) {
        const int h = c->broken_h[k], l = c->broken_l[k];
        list_if_near(s, c, h, l, solid_contact_list_reach(c, c->is_fast[h], c->is_fast[l]));
    }
}
