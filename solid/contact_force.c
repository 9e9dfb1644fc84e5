#include "base/clock.h"
#include "base/par.h"
#include "base/par_exchange.h"
#include "solid/contact.h"
#include "solid/contact_list.h"
#include "solid/surface_sector.h"

#include <math.h>

/* (r_c/r)^{n_c} - 1 and its potential int_r^{r_c}, m.  (001: eq. 3.40) */
static double repulsion(double r, double rc, double exponent) {
    return (exponent == 1 ? rc / r : pow(rc / r, exponent)) - 1;
}

static double potential(double r, double rc, double exponent) {
    if (exponent == 1) return rc * log(rc / r) - (rc - r);
    return rc / (exponent - 1) * (pow(rc / r, exponent - 1) - 1) - (rc - r);
}

void solid_contact_exchange(struct solid *s, struct solid_contact *c) {
    for (int k = 0; k < c->sent; k++)
        for (int i = 0; i < 3; i++) c->sent_x[k][i] = s->x0[i][c->sent_h[k]] + s->d[i][c->sent_h[k]];
    par_exchange_forward(c->exchange, c->sent_x, c->other_x, sizeof *c->sent_x);
}

/* One directed pair now: X_h - X_l, the other's volume, k_c; returns r, at least 1e-6 r_c so that nothing divides by 0. */
static double pair(const struct solid *s, const struct solid_contact *c, int h, int l, int is_stranger,
                   double x[3], double *volume, double *stiffness) {
    double c0;
    if (is_stranger && l >= s->n) {
        const int k = l - s->n;
        for (int i = 0; i < 3; i++) {
            x[i] = s->x0[i][h] + s->d[i][h] - c->other_x[k][i];
            if (s->in.periodic[i]) x[i] -= s->in.length[i] * rint(x[i] / s->in.length[i]);
        }
        *volume = c->other[k].volume;
        c0 = c->other[k].c0;
    } else {
        solid_relative(s, h, l, x);
        for (int i = 0; i < 3; i++) x[i] = -x[i];
        *volume = s->volume[l];
        c0 = solid_contact_stiffness_of(s, s->body[l]);
    }
    *stiffness = s->in.contact_stiffness * 0.5 * (c0 + solid_contact_stiffness_of(s, s->body[h]));
    return fmax(sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]), 1e-6 * c->radius);
}

static void push(struct solid *s, const struct solid_contact *c, const struct solid_contact_pairs *p,
                 int are_strangers) {
    for (int k = 0; k < p->n; k++) {
        const int h = p->h[k];
        double x[3], volume, stiffness;
        const double r = pair(s, c, h, p->l[k], are_strangers, x, &volume, &stiffness);
        if (r >= c->radius) continue;
        const double density = s->in.material[s->in.body[s->body[h]].material].density;
        const double f = stiffness * repulsion(r, c->radius, s->in.contact_exponent) * volume / (density * r);
        for (int i = 0; i < 3; i++) s->a[i][h] += f * x[i];
    }
}

/* Half of each pair's potential from either end. */
static double energy(const struct solid *s, const struct solid_contact *c,
                     const struct solid_contact_pairs *p, int are_strangers) {
    double sum = 0;
    for (int k = 0; k < p->n; k++) {
        const int h = p->h[k];
        double x[3], volume, stiffness;
        const double r = pair(s, c, h, p->l[k], are_strangers, x, &volume, &stiffness);
        if (r < c->radius)
            sum += 0.5 * stiffness * potential(r, c->radius, s->in.contact_exponent) * volume * s->volume[h];
    }
    return sum;
}

void solid_contact_force(struct solid *s) {
    struct solid_contact *c = s->contact;
    if (!c->any) return;
    clock_begin(CLOCK_CONTACT);
    if (c->crossing) solid_contact_exchange(s, c);
    push(s, c, &c->broken, 0);
    push(s, c, &c->strangers, 1);
    clock_end(CLOCK_CONTACT);
}

double solid_contact_energy(struct solid *s) {
    struct solid_contact *c = s->contact;
    if (!c || !c->any) return 0;
    if (c->crossing) solid_contact_exchange(s, c);
    return par_sum(energy(s, c, &c->broken, 0) + energy(s, c, &c->strangers, 1));
}
