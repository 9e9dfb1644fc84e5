#include "base/par.h"
#include "solid/family.h"
#include "solid/measures.h"

#include <math.h>

/* s = (2 xi.eta + eta.eta)/(|xi| (|xi + eta| + |xi|)): no difference of nearly equal lengths.  (SPEC 2) */
static double stretch_of(const double xi[3], const double eta[3], double *length) {
    double xi2 = 0, q = 0, zeta2 = 0;
    for (int c = 0; c < 3; c++) {
        const double zeta = xi[c] + eta[c];
        xi2 += xi[c] * xi[c];
        zeta2 += zeta * zeta;
        q += eta[c] * (xi[c] + zeta);
    }
    *length = sqrt(xi2);
    return q / (*length * (sqrt(zeta2) + *length));
}

/* sum over bonds of (1/2) alpha c0 s^2 |xi| Gamma V V, half of it from either end.  (001: eq. 3.23) */
static double strain_energy(const struct solid *s, int h, const struct solid_family_view *view) {
    double sum = 0;
    for (int b = 0; b < view->n; b++) {
        if (!view->intact[b]) continue;
        double eta[3], length;
        for (int c = 0; c < 3; c++) eta[c] = s->d[c][view->l[b]] - s->d[c][h];
        const double stretch = stretch_of(view->xi[b], eta, &length);
        sum += view->alpha[b] * stretch * stretch * length * view->weight[b];
    }
    return 0.25 * sum * s->volume[h];
}

struct solid_energy solid_measure_energy(struct solid *s) {
    struct solid_family_view view;
    double sum[2] = {0, 0}, c0 = 0;
    solid_ghosts_update(s);
    for (int h = 0, body = -1; h < s->n; h++) {
        const struct solid_material *material = &s->in.material[s->in.body[s->body[h]].material];
        if (s->body[h] != body) c0 = solid_micromodulus(material, s->in.spacing);
        body = s->body[h];
        double v2 = 0;
        for (int c = 0; c < 3; c++) v2 += s->v[c][h] * s->v[c][h];
        sum[0] += 0.5 * material->density * s->volume[h] * v2;
        solid_family_view(s, h, &view);
        sum[1] += c0 * strain_energy(s, h, &view);
    }
    par_sum_array(sum, 2);
    return (struct solid_energy){sum[0], sum[1]};
}
