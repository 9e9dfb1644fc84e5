/* Pores: conductance and storage of the intact solid. */
#include "cracks/pores.h"

#include <math.h>

double cracks_pores_conductance(const struct cracks *c) {
    const struct solid *s = c->solid;
    return c->in.pores.permeability * pow(s->in.spacing, s->dim - 2) * solid_depth(&s->in) / c->in.viscosity;
}

double cracks_pores_storage(const struct cracks *c, int i) {
    return c->solid->volume[c->struts.h[i]] / c->in.pores.modulus;
}
