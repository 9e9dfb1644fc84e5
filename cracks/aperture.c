/* Volumes, apertures and conductances of the wet particles. */
#include "cracks/aperture.h"
#include "cracks/mouth.h"
#include "cracks/pores.h"
#include "cracks/solve.h"
#include "cracks/struts.h"

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
    const struct cracks_struts *t = &c->struts;
    const cracks_vec *u = cracks_aperture_displacements(c);
    cracks_kernel_volume(t->n, t->start, t->other, t->kind, c->table.half, u, volume);
}

void cracks_aperture_open(const struct cracks *c) {
    const struct cracks_struts *t = &c->struts;
    const cracks_vec *u = cracks_aperture_displacements(c);
    cracks_kernel_volume_part(t->n, t->start, t->middle, t->other, t->kind, c->table.half, u, c->open);
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
    double *w = c->work->width;
    for (int i = 0; i < t->n; i++) w[i] = fmax(c->least_aperture, cracks_aperture_of(c, i));
    cracks_struts_update(t, sizeof *w, w);
    for (int i = 0; i < t->n; i++)
        for (int k = t->link_start[i]; k < t->link_start[i + 1]; k++) {
            const int l = t->link[k];
            const double mean = 0.5 * (w[i] + w[l]);
            c->work->conductance[k] = pores + factor * (t->area_size[i] + t->area_size[l]) * (mean * mean * mean);
        }
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
    double *w = c->work->width;
    for (int i = 0; i < t->n; i++)
        if (!(t->area_size[i] > 0)) w[i] = 0;
    for (int k = 0; k < c->mouths->n; k++) {
        const int i = cracks_struts_wet(t, c->mouths->h[k]);
        w[i] = fmax(w[i], c->least_aperture);
    }
    cracks_struts_update(t, sizeof *w, w);
    for (int i = 0; i < t->n; i++)
        for (int k = t->link_start[i]; k < t->link_start[i + 1]; k++) {
            const double a = t->area_size[i], b = t->area_size[t->link[k]];
            const int is_open = w[i] > 0 && w[t->link[k]] > 0;
            const double most = is_open * SPACINGS * SPACINGS * dt * 0.5 * (a * a + b * b) / mass;
            c->work->conductance[k] = fmin(c->work->conductance[k], most);
        }
}
