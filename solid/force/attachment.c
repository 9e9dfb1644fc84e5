/* Place, velocity and force of markers by their weights. */
#include "solid/force/attachment.h"
#include "base/par_ghost.h"
#include "solid/state.h"

#include <string.h>

void solid_attachment_arm(const struct solid_attachment *a, const struct solid *s, int i, double arm[3]) {
    const struct solid_attachment_weights *w = a->weights[i];
    arm[0] = arm[1] = arm[2] = 0;
    for (int k = 0; k < w->n; k++) {
        double zeta[3];
        solid_relative(s, a->h[i], w->other[k], zeta);
        for (int c = 0; c < 3; c++) arm[c] += w->share[k] * zeta[c];
    }
}

void solid_attachment_velocity(const struct solid_attachment *a, const struct solid *s, int i, double v[3]) {
    const struct solid_attachment_weights *w = a->weights[i];
    for (int c = 0; c < 3; c++) v[c] = w->own * s->v[c][a->h[i]];
    for (int k = 0; k < w->n; k++)
        for (int c = 0; c < 3; c++) v[c] += w->share[k] * s->v[c][w->other[k]];
}

void solid_attachment_spread(struct solid_attachment *a, const struct solid *s, const double (*force)[3]) {
    for (int c = 0; c < 3; c++) memset(a->given[c], 0, sizeof(double) * (size_t)(s->n + s->n_ghost));
    for (int i = 0; i < a->n; i++) {
        const struct solid_attachment_weights *w = a->weights[i];
        for (int c = 0; c < 3; c++) a->given[c][a->h[i]] += w->own * force[i][c];
        for (int k = 0; k < w->n; k++)
            for (int c = 0; c < 3; c++) a->given[c][w->other[k]] += w->share[k] * force[i][c];
    }
    par_ghost_add(s->ghost, 3, a->given, s->n);
}

void solid_attachment_refresh(struct solid *s) { par_ghost_update(s->ghost, 3, s->v, s->n); }
