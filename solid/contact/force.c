/* Short-range repulsion of the listed pairs: accelerations and potential energy.  (001: eq. 3.40) */
#include "base/clock.h"
#include "base/par.h"
#include "solid/contact/contact.h"
#include "solid/contact/pairs_touching.h"
#include "solid/contact/repulsion.h"

/* Adds the accelerations of the touching particles to their ends'. */
static void push(const struct solid *s, struct solid_contact *c, int kind) {
    int found[SOLID_CONTACT_BLOCK];
    for (int from = 0; from < c->pairs[kind].n; from += SOLID_CONTACT_BLOCK) {
        const int n = solid_contact_pairs_touching(c, kind, from, c->radius, found);
        for (int k = 0; k < n; k++) {
            const struct solid_contact_touch t = solid_contact_pairs_touch(s, c, kind, found[k]);
            if (t.r >= t.radius) continue;
            const double f = t.k * solid_repulsion(t.r, t.radius, s->in.contact_exponent) / t.r;
            const double on_h = f * t.l->volume / c->density[t.h->material],
                         on_l = f * t.h->volume / c->density[t.l->material];
            for (int i = 0; i < s->dim; i++) {
                t.h->push[i] += solid_contact_list_rounded(on_h * t.x[i], c->quantum);
                if (kind == SOLID_CONTACT_OWNED) t.l->push[i] -= solid_contact_list_rounded(on_l * t.x[i], c->quantum);
            }
        }
    }
}

/* A pair's potential energy; half of it if another rank counts the other half. */
static double energy(const struct solid *s, const struct solid_contact *c, int kind) {
    int found[SOLID_CONTACT_BLOCK];
    double sum = 0;
    for (int from = 0; from < c->pairs[kind].n; from += SOLID_CONTACT_BLOCK) {
        const int n = solid_contact_pairs_touching(c, kind, from, c->radius, found);
        for (int k = 0; k < n; k++) {
            const struct solid_contact_touch t = solid_contact_pairs_touch(s, c, kind, found[k]);
            if (t.r >= t.radius) continue;
            sum += t.k *
                   solid_repulsion_potential(solid_repulsion_depth(t.r * t.r, t.radius), t.radius,
                                             s->in.contact_exponent) *
                   t.l->volume * t.h->volume;
        }
    }
    return kind == SOLID_CONTACT_OWNED ? sum : 0.5 * sum;
}

/* Adds the pairs' forces to those of their bodies, N. */
static void push_bodies(const struct solid *s, const struct solid_contact *c, int kind, double (*force)[3]) {
    int found[SOLID_CONTACT_BLOCK];
    for (int from = 0; from < c->pairs[kind].n; from += SOLID_CONTACT_BLOCK) {
        const int n = solid_contact_pairs_touching(c, kind, from, c->radius, found);
        for (int k = 0; k < n; k++) {
            const struct solid_contact_touch t = solid_contact_pairs_touch(s, c, kind, found[k]);
            const int own = t.h->body, other = t.l->body;
            if (t.r >= t.radius || own == other) continue;
            const double f =
                t.k * solid_repulsion(t.r, t.radius, s->in.contact_exponent) / t.r * t.l->volume * t.h->volume;
            for (int i = 0; i < s->dim; i++) {
                force[own][i] += f * t.x[i];
                if (kind == SOLID_CONTACT_OWNED) force[other][i] -= f * t.x[i];
            }
        }
    }
}

void solid_contact_force(struct solid *s) {
    struct solid_contact *c = s->contact;
    if (!c->any) return;
    clock_begin(CLOCK_CONTACT);
    solid_contact_ends_update(s, c);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) push(s, c, kind);
    for (int k = 0; k < c->ends->n; k++) {
        struct solid_contact_end *e = &c->ends->end[k];
        for (int i = 0; i < s->dim; i++) {
            if (e->push[i] != 0) s->a[i][e->particle] += e->push[i];
            e->push[i] = 0;
        }
    }
    clock_end(CLOCK_CONTACT);
}

void solid_contact_force_on_bodies(struct solid *s, double (*force)[3]) {
    struct solid_contact *c = s->contact;
    if (!s->in.contact || !c || !c->any || s->in.bodies < 2) return;
    solid_contact_ends_update(s, c);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) push_bodies(s, c, kind, force);
}

double solid_contact_force_energy(struct solid *s) {
    struct solid_contact *c = s->contact;
    double sum = 0;
    if (!c || !c->any) return 0;
    solid_contact_ends_update(s, c);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) sum += energy(s, c, kind);
    return par_sum(sum);
}
