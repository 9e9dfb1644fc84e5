/* Volumes, apertures and conductances of the wet particles. */
#include "cracks/aperture.h"
#include "cracks/outlet.h"
#include "cracks/pores.h"
#include "cracks/solve.h"
#include "cracks/struts.h"
#include "cracks/sums.h"

#include <math.h>

const cracks_vec *cracks_aperture_displacements(const struct cracks *c) {
    const struct cracks_struts *t = &c->struts;
    cracks_vec *u = c->work->u;
    for (int i = 0; i < t->n; i++) {
        u[i] = (cracks_vec){0};
        for (int k = 0; k < c->solid->dim; k++) u[i][k] = c->solid->d[k][t->h[i]];
    }
    cracks_struts_update(t, sizeof *u, u);
    return u;
}

void cracks_aperture_volume(const struct cracks *c, double *volume) {
    cracks_sums_volume(c, cracks_aperture_displacements(c), volume);
}

void cracks_aperture_open(const struct cracks *c) {
    cracks_sums_volume_of_cracks(c, cracks_aperture_displacements(c), c->open);
}

const double *cracks_aperture_cracks(const struct cracks *c) { return c->open ? c->open : c->volume; }

double cracks_aperture_of(const struct cracks *c, int i) {
    return c->struts.area_size[i] > 0 ? cracks_aperture_cracks(c)[i] / c->struts.area_size[i] : 0;
}

/* T_hl = (V/h^2)/mu (k0 + (|a_h|/V + |a_l|/V)/2 w^3/12),  w = (w_h + w_l)/2,  V the volume of a whole cell, h the
 * spacing. The layers of a column share the area of the crack, so that a flat crack conducts w^3/(12 mu) along the
 * lattice. */
void cracks_aperture_conductance(const struct cracks *c) {
    const struct cracks_struts *t = &c->struts;
    const double spacing = c->solid->in.spacing, factor = 0.5 / (spacing * spacing * c->in.viscosity * 12),
                 pores = c->in.porous ? cracks_pores_conductance(c) : 0;
    const struct cracks_rows *r = &t->rows;
    double *w = c->work->width;
    for (int i = 0; i < t->n; i++) w[i] = fmax(c->least_aperture, cracks_aperture_of(c, i));
    cracks_struts_update(t, sizeof *w, w);
    for (int i = 0; i < t->n + t->ghosts; i++) {
        r->u[0][t->place[i]] = t->area_size[i];
        r->u[1][t->place[i]] = w[i];
    }
    cracks_kernel_conductance(r->n, r->first, r->link_start, r->link_start + 1, r->link, pores, factor, r->u[0],
                              r->u[1], c->work->conductance, c->work->outflow);
}

/* A link of conductance T beside the elastic part dt a^2/m of its ends, for the largest mass: over the number of
 * spacings (T m/(dt a^2))^(1/2) pressures become equal in a substep, in which a wave of the solid passes less than one.
 * Where few struts are left on in a wide crack the number has no bound, and the pressures would be lost in rounding. */
void cracks_aperture_bound(const struct cracks *c, double dt) {
    enum { SPACINGS = 100 };
    const struct cracks_struts *t = &c->struts;
    const struct solid_input *in = &c->solid->in;
    double density = 0;
    for (int m = 0; m < in->materials; m++) density = fmax(density, in->material[m].density);
    const double mass = density * pow(in->spacing, c->solid->dim) * solid_depth(in);
    const double factor = SPACINGS * SPACINGS * dt * 0.5 / mass;
    const struct cracks_rows *r = &t->rows;
    double *open = c->work->z; /* work: [n + ghosts] */
    for (int i = 0; i < t->n; i++) open[i] = t->area_size[i] > 0;
    for (int k = 0; k < c->outlets->n; k++) open[cracks_struts_wet(t, c->outlets->h[k])] = 1;
    cracks_struts_update(t, sizeof *open, open);
    for (int i = 0; i < t->n + t->ghosts; i++) {
        r->u[0][t->place[i]] = factor * (t->area_size[i] * t->area_size[i]);
        r->u[1][t->place[i]] = open[i];
    }
    cracks_kernel_bound(r->n, r->first, r->link_start, r->link_start + 1, r->link, r->u[0], r->u[1],
                        c->work->conductance, c->work->outflow);
}
