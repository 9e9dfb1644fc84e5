#include "base/clock.h"
#include "base/par.h"
#include "solid/contact.h"
#include "solid/contact_pairs.h"

#include <string.h>

/* Pairs count up to this far beyond r_c, in r_c, with a weight that falls from 1 to 0: the bound moves smoothly with the
 * state, and sees a pair before it touches. */
static const double MARGIN = 0.02;

enum { XX, YY, ZZ, XY, XZ, YZ, TENSOR };

static void add(double *t, double rate, const double e[3]) {
    t[XX] += rate * e[0] * e[0];
    t[YY] += rate * e[1] * e[1];
    t[ZZ] += rate * e[2] * e[2];
    t[XY] += rate * e[0] * e[1];
    t[XZ] += rate * e[0] * e[2];
    t[YZ] += rate * e[1] * e[2];
}

static double norm2(const double t[TENSOR]) {
    return t[XX] * t[XX] + t[YY] * t[YY] + t[ZZ] * t[ZZ] +
           2 * (t[XY] * t[XY] + t[XZ] * t[XZ] + t[YZ] * t[YZ]);
}

/* The largest eigenvalue of a symmetric tensor that is not negative: (tr T^p)^{1/p} by squaring, p = 64, at most 2 % high. */
static double largest(const double t[TENSOR]) {
    double a[TENSOR], scale = 1, power = 1;
    memcpy(a, t, sizeof a);
    for (int i = 0; i < 6; i++) {
        const double trace = a[XX] + a[YY] + a[ZZ];
        if (!(trace > 0)) return 0;
        for (int k = 0; k < TENSOR; k++) a[k] /= trace;
        scale *= pow(trace, power);
        const double b[TENSOR] = {
            a[XX] * a[XX] + a[XY] * a[XY] + a[XZ] * a[XZ], a[XY] * a[XY] + a[YY] * a[YY] + a[YZ] * a[YZ],
            a[XZ] * a[XZ] + a[YZ] * a[YZ] + a[ZZ] * a[ZZ], a[XX] * a[XY] + a[XY] * a[YY] + a[XZ] * a[YZ],
            a[XX] * a[XZ] + a[XY] * a[YZ] + a[XZ] * a[ZZ], a[XY] * a[XZ] + a[YY] * a[YZ] + a[YZ] * a[ZZ]};
        memcpy(a, b, sizeof a);
        power *= 0.5;
    }
    return scale * pow(a[XX] + a[YY] + a[ZZ], power);
}

static void gather(const struct solid *s, struct solid_contact *c, int kind) {
    const struct solid_contact_pairs *p = &c->pairs[kind];
    const double exponent = s->in.contact_exponent, reach = (1 + MARGIN) * c->radius;
    int found[SOLID_CONTACT_BLOCK];
    for (int from = 0; from < p->n; from += SOLID_CONTACT_BLOCK) {
        const int n =
            solid_contact_pairs_touching(p, s->d, solid_contact_other_d(s, c, kind), from, reach, found);
        for (int k = 0; k < n; k++) {
            const struct solid_contact_touch t = solid_contact_touch_of(s, c, kind, found[k]);
            const double e[3] = {t.x[0] / t.r, t.x[1] / t.r, t.x[2] / t.r};
            const double weight = fmin((reach - t.r) / (MARGIN * c->radius), 1);
            const double rate = weight * t.k * exponent * pow(c->radius / t.r, exponent) / t.r;
            add(c->tensor + (size_t)t.h * TENSOR, rate * t.volume / c->density[s->body[t.h]], e);
            if (kind == SOLID_CONTACT_OWNED)
                add(c->tensor + (size_t)t.l * TENSOR, rate * s->volume[t.h] / t.density, e);
        }
    }
}

double solid_contact_rate2(struct solid *s) {
    struct solid_contact *c = s->contact;
    double most = 0;
    if (!s->in.contact || !c || !c->any) return 0;
    clock_begin(CLOCK_CONTACT);
    solid_ghosts_update(s);
    if (c->crossing.active) solid_crossing_update(s, &c->crossing);
    memset(c->tensor, 0, (size_t)s->n * TENSOR * sizeof *c->tensor);
    for (int kind = 0; kind < SOLID_CONTACT_KINDS; kind++) gather(s, c, kind);
    for (int h = 0; h < s->n; h++) {
        const double *t = c->tensor + (size_t)h * TENSOR;
        if (norm2(t) > most * most) most = fmax(most, largest(t));
    }
    most = par_max(most);
    clock_end(CLOCK_CONTACT);
    return 2 * most;
}
