/* How far bodies are apart, which speed contact can stop, and what bodies hold that stand in each other's reach. */
#include "solid/contact/passing.h"
#include "base/par.h"
#include "solid/contact/contact.h"
#include "solid/contact/list.h"
#include "solid/contact/pairs_touching.h"
#include "solid/contact/repulsion.h"
#include "solid/law/material.h"

#include <math.h>

/* Spacings: contact's lists hold pairs up to r_c and this (solid/contact/contact.c). */
static const double SKIN = 0.35;

/* A part of r_c: round-off of particles that stand at r_c. */
static const double TOUCHING = 1e-6;

double solid_contact_passing_unseen(void) { return SKIN; }

/* The distance of two boxes along the direction in which they are farthest apart. */
static double separation(const struct solid *s, const double *a, const double *b) {
    double most = -INFINITY;
    for (int c = 0; c < s->dim; c++) {
        const double extent = -a[3 + c] - a[c] - b[3 + c] - b[c];
        const double middles = fabs(solid_shortest(s, c, 0.5 * (a[c] - a[3 + c]) - 0.5 * (b[c] - b[3 + c])));
        most = fmax(most, middles - 0.5 * extent);
    }
    return most;
}

double solid_contact_passing_gap(const struct solid *s) {
    solid_contact_bounds bounds[SOLID_CONTACT_BODIES];
    double least = INFINITY;
    solid_contact_bounds_of(s, bounds);
    for (int b = 0; b < s->in.bodies; b++)
        for (int other = 0; other < b; other++) least = fmin(least, separation(s, bounds[b], bounds[other]));
    return fmax(0, least - (s->in.contact_radius + SKIN) * s->in.spacing);
}

double solid_contact_passing_held_speed(const struct solid *s) {
    const double rc = s->in.contact_radius * s->in.spacing, volume = pow(s->in.spacing, s->dim) * solid_depth(&s->in);
    double least = INFINITY;
    for (int m = 0; m < s->in.materials; m++) {
        const struct solid_material *material = &s->in.material[m];
        const double potential = s->in.contact_stiffness * solid_material_c0(&s->in, material) * volume * volume *
                                 solid_repulsion_potential(0.5, rc, s->in.contact_exponent);
        least = fmin(least, sqrt(4 * potential / (material->density * volume))); /* 1/4 m v^2 */
    }
    return least;
}

/* Adds this rank's pairs that are nearer than r_c, those with a particle of another rank by half. */
static void search(const struct solid *s, const struct solid_contact *c, struct solid_contact_overlap *found) {
    int at[SOLID_CONTACT_BLOCK];
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++)
        for (int from = 0; from < c->pairs[kind].n; from += SOLID_CONTACT_BLOCK) {
            const int n = solid_contact_pairs_touching(c, kind, from, c->radius, at);
            for (int k = 0; k < n; k++) {
                const struct solid_contact_touch t = solid_contact_pairs_touch(s, c, kind, at[k]);
                if (t.r >= (1 - TOUCHING) * t.radius) continue;
                found->least = fmin(found->least, t.r);
                found->pairs += kind == SOLID_CONTACT_OWNED ? 1 : 0.5;
            }
        }
}

struct solid_contact_overlap solid_contact_passing_overlap(struct solid *s) {
    struct solid_contact_overlap found = {.least = INFINITY};
    const int broke = s->broke, made = !s->contact;
    if (made) solid_contact_update(s);
    if (s->contact && s->contact->any) {
        found.potential = solid_contact_force_energy(s);
        search(s, s->contact, &found);
    }
    found.least = par_min(found.least);
    found.pairs = par_sum(found.pairs);
    if (made) solid_contact_free(s);
    s->broke = broke;
    return found;
}
