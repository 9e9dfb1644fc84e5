#include "solid/list.h"

#include <math.h>

/* The number that decides on a bond; both ends get the same to the bit: all signs turn, nothing else. */
static __attribute__((noinline)) double bond_eps(const double xi[3], const double eta[3],
                                                 double inv_length2) {
    double q = 0;
    for (int c = 0; c < 3; c++) q += eta[c] * (xi[c] + (xi[c] + eta[c]));
    return q * inv_length2;
}

/* The bond j of particle h is broken on h's side. */
static void break_bond(struct solid *s, struct solid_list *b, int h, long j, double eps) {
    const double stretch = eps / (1 + sqrt(1 + eps)), length = 1 / sqrt(b->inv_length2[j]);
    b->intact[j] = 0;
    s->flag[h] |= SOLID_BROKEN;
    s->broke = 1;
    s->e_fracture +=
        0.25 * b->law.c0 * b->alpha[j] * stretch * stretch * length * b->weight[j] * s->volume[h];
}

/* Bond forces as in the lattice's sweep, one bond after another, always with the square root. */
double solid_list_force(struct solid *s, struct solid_list *b, const struct solid_sweep *sweep) {
    const double limit = sweep->may_break ? b->law.eps_limit : INFINITY, inv_density = 1 / b->law.density;
    double power = 0;
    for (int i = 0; i < b->n; i++) {
        const int h = b->first + i;
        double force[3] = {0}, closing_work = 0;
        for (long j = b->start[i]; j < b->start[i + 1]; j++) {
            if (!b->intact[j]) continue;
            const int l = b->l[j];
            const double xi[3] = {b->xi[0][j], b->xi[1][j], b->xi[2][j]};
            const double eta[3] = {s->d[0][l] - s->d[0][h], s->d[1][l] - s->d[1][h], s->d[2][l] - s->d[2][h]};
            const double eps = bond_eps(xi, eta, b->inv_length2[j]);
            if (eps > limit && !((s->flag[h] | s->flag[l]) & SOLID_UNBREAKABLE)) {
                break_bond(s, b, h, j, eps);
                continue;
            }
            const double q = sqrt(1 + eps), zeta[3] = {xi[0] + eta[0], xi[1] + eta[1], xi[2] + eta[2]};
            double f = b->alpha[j] * b->law.c0 * b->weight[j] * sqrt(b->inv_length2[j]) * eps / ((1 + q) * q);
            if (sweep->damping > 0) {
                double closing = 0;
                for (int c = 0; c < 3; c++) closing += (s->v[c][l] - s->v[c][h]) * zeta[c];
                const double fd = sweep->damping * b->weight[j] * b->inv_length2[j] * closing / (1 + eps);
                closing_work += fd * closing;
                f += fd;
            }
            for (int c = 0; c < 3; c++) force[c] += f * zeta[c];
        }
        for (int c = 0; c < 3; c++) s->a[c][h] = force[c] * inv_density;
        power += closing_work * s->volume[h];
    }
    return 0.5 * power;
}
