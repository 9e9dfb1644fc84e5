/* Tests which of six cones around a particle are void.  (001: sec. 3.3.7) */
#include "solid/surface/sector.h"
#include "solid/bonds/lattice.h"
#include "solid/geometry/shape.h"

#include <math.h>
#include <string.h>

static const double reach = 1.5;    /* in spacings: between the first shell of six and the second one along an axis */
static const double rim = 1 - 1e-9; /* bonds at 45 degrees belong to no cone */

int solid_sector_of(const double xi[3], double spacing) {
    const double r2 = xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2];
    if (r2 > reach * reach * spacing * spacing) return -1;
    for (int c = 0; c < 3; c++)
        if (rim * xi[c] * xi[c] > 0.5 * r2) return 2 * c + (xi[c] < 0);
    return -1;
}

void solid_sector_axis(int f, double e[3]) {
    e[0] = e[1] = e[2] = 0;
    e[f / 2] = f % 2 ? -1 : 1;
}

double solid_sector_spacing(const struct solid *s, int h) {
    const enum solid_places places = solid_shape_of(&s->in.body[s->body[h]])->places;
    return places == SOLID_PLACES_POINTS ? cbrt(s->volume[h]) : s->in.spacing;
}

void solid_sector_classify(const struct solid *s, int h, const struct solid_family_view *view, struct solid_cones *w) {
    const double spacing = solid_sector_spacing(s, h);
    unsigned intact = 0, broken = 0, any = 0;
    memset(w, 0, sizeof *w);
    w->h = h;
    for (int b = 0; b < view->n; b++) {
        any |= view->intact[b];
        const int f = solid_sector_of(view->xi[b], spacing);
        if (f < 0) continue;
        if (view->intact[b]) {
            intact |= 1u << f;
        } else {
            broken |= 1u << f;
            if (w->bonds[f] < SOLID_CONE_BONDS) w->l[f][w->bonds[f]++] = view->l[b];
        }
    }
    w->bare = (uint8_t)(~(intact | broken) & 63u);
    w->broken = (uint8_t)(broken & ~intact);
    w->isolated = !any;
}

void solid_sector_near(const struct solid_stencil *stencil, int near[SOLID_FACES]) {
    for (int o = 0; o < stencil->n; o++) {
        const int f = solid_sector_of(stencil->offset[o].xi, stencil->spacing);
        if (f >= 0) near[f] = o;
    }
}

void solid_sector_classify_lattice(const struct solid *s, int h, const int near[SOLID_FACES], int intact,
                                   struct solid_cones *w) {
    const struct solid_lattice *lattice = s->family->lattice[s->body[h]];
    const int cell = lattice->cell[h - lattice->first], bit = cell % 8;
    const uint8_t *lambda = lattice->lambda + (size_t)lattice->row_of[cell / 8] * (size_t)lattice->stencil->n;
    memset(w, 0, sizeof *w);
    w->h = h;
    w->isolated = intact == 0;
    for (int f = 0; f < SOLID_FACES; f++) {
        const int l = lattice->local[cell + lattice->offset[near[f]].shift];
        if (l < 0) {
            w->bare |= (uint8_t)(1u << f);
        } else if (!(lambda[near[f]] >> bit & 1)) {
            w->broken |= (uint8_t)(1u << f);
            w->l[f][w->bonds[f]++] = l;
        }
    }
}

unsigned solid_sector_void(const struct solid *s, const struct solid_cones *w) {
    unsigned open = w->bare;
    const struct solid_material *material = &s->in.material[s->in.body[s->body[w->h]].material];
    const double r_thr = material->horizon_ratio * s->in.spacing;
    for (int f = 0; f < SOLID_FACES; f++) {
        if (!(w->broken >> f & 1)) continue;
        double r = 0;
        for (int b = 0; b < w->bonds[f]; b++) {
            double zeta[3];
            solid_relative(s, w->h, w->l[f][b], zeta);
            r += sqrt(zeta[0] * zeta[0] + zeta[1] * zeta[1] + zeta[2] * zeta[2]);
        }
        if (r > r_thr * w->bonds[f]) open |= 1u << f;
    }
    return open;
}
