/* Records particle pairs whose bond broke, and lists those near enough to touch. */
#include "base/memory.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lost.h"
#include "solid/contact/list.h"
#include "solid/contact/pairs.h"
#include "solid/contact/room.h"

#include <math.h>

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

/* What the rounding of a length to single precision may add to it. */
static const double ROUNDED = 1e-6;

static float length_of(const struct solid *s, int h, int l) {
    double r2 = 0;
    for (int k = 0; k < s->dim; k++) {
        const double x = solid_shortest(s, k, s->x0[k][h] - s->x0[k][l]);
        r2 += x * x;
    }
    return (float)(sqrt(r2) * (1 - ROUNDED));
}

/* Records the bonds of h that have broken since the last check. */
static void record(struct solid *s, struct solid_contact *c, int h) {
    int other[SOLID_FAMILY_MAX];
    const int torn = solid_family_torn(s, h, c->known + (size_t)h * (size_t)solid_family_bytes(s), other);
    if (torn > 0) c->record = ++s->versions;
    for (int k = 0; k < torn; k++) {
        const int l = other[k];
        if (l <= h) continue; /* both owned: recorded for the other end */
        const int n = c->torn + 1;
        c->torn_h = solid_contact_room(c->torn_h, &c->torn_capacity[0], n, sizeof *c->torn_h);
        c->torn_l = solid_contact_room(c->torn_l, &c->torn_capacity[1], n, sizeof *c->torn_l);
        c->torn_length = solid_contact_room(c->torn_length, &c->torn_capacity[2], n, sizeof *c->torn_length);
        c->torn_h[c->torn] = h;
        c->torn_l[c->torn] = l;
        c->torn_length[c->torn++] = length_of(s, h, l);
    }
}

void solid_contact_torn_scan(struct solid *s, struct solid_contact *c) {
    for (int h = 0; h < s->n; h++)
        if (s->flag[h] & SOLID_BROKEN) record(s, c, h);
    solid_lost_find(c->lost, s);
}

void solid_contact_torn_news(struct solid *s, struct solid_contact *c, double further) {
    const int before = c->torn, found = solid_lost_find(c->lost, s);
    for (int k = 0; k < found; k++) record(s, c, c->lost->h[k]);
    for (int k = before; k < c->torn; k++) {
        const int h = c->torn_h[k], l = c->torn_l[k];
        list_if_near(s, c, h, l, further + solid_contact_list_reach(c, 2 * c->runs[h], 2 * c->runs[l]));
    }
}

/* How far each particle is from where it was, but for the mean displacement. */
static void find_ways(const struct solid *s, float *way) {
    double mean[3] = {0};
    for (int k = 0; k < s->dim; k++)
        for (int h = 0; h < s->n; h++) mean[k] += s->d[k][h] / s->n;
    for (int h = 0; h < s->n + s->n_ghost; h++) {
        double r2 = 0;
        for (int k = 0; k < s->dim; k++) r2 += (s->d[k][h] - mean[k]) * (s->d[k][h] - mean[k]);
        way[h] = (float)(sqrt(r2) * (1 + ROUNDED));
    }
}

/* Most of the record's pairs stand as far from each other as at the start, and are told by that. */
void solid_contact_torn_list(const struct solid *s, struct solid_contact *c) {
    const float farthest = (float)(solid_contact_list_reach(c, 1, 1) * (1 + ROUNDED));
    find_ways(s, c->way);
    for (int k = 0; k < c->torn; k++) {
        const int h = c->torn_h[k], l = c->torn_l[k];
        if (c->torn_length[k] > farthest + (c->way[h] + c->way[l]) * (float)(1 + ROUNDED)) continue;
        list_if_near(s, c, h, l, solid_contact_list_reach(c, c->runs[h], c->runs[l]));
    }
}
