/* Pores: conductance, storage and the first filling of the intact solid. */
#include "cracks/pores.h"
#include "base/par.h"
#include "cracks/aperture.h"

#include <math.h>

double cracks_pores_conductance(const struct cracks *c) {
    const struct solid *s = c->solid;
    return c->in.pores.permeability * pow(s->in.spacing, s->dim - 2) * solid_depth(&s->in) / c->in.viscosity;
}

double cracks_pores_storage(const struct cracks *c, int i) {
    return c->solid->volume[c->struts.h[i]] / c->in.pores.modulus;
}

void cracks_pores_fill(struct cracks *c) {
    double filled = 0;
    cracks_aperture_volume(c, c->volume);
    cracks_aperture_open(c);
    for (int i = 0; i < c->struts.n; i++) {
        const double pores = c->volume[i] - c->open[i];
        c->storage[i] = cracks_pores_storage(c, i);
        c->cavity[i] = c->open[i];
        c->content[i] = pores + c->storage[i] * c->p[i];
        filled += c->content[i];
    }
    c->filled = par_sum(filled);
}
