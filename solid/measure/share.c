/* The part of a full family's stress that a particle's unbroken family bears, by which the flux is divided. */
#include "solid/measure/share.h"
#include "physics/micromodulus.h"
#include "solid/bonds/materials.h"

#include <math.h>

struct solid_share_full solid_share_of_lattice(const struct solid_lattice *lattice) {
    struct solid_share_full full = {.nu = 1. / 4, .dim = 3, .micro = lattice->materials ? lattice->law.c0 : 0};
    for (int o = 0; o < lattice->stencil->n; o++) {
        const struct solid_offset *bond = &lattice->stencil->offset[o];
        const double f = 0.5 * lattice->law.c0 * bond->weight / (bond->length * bond->length * bond->length),
                     x2 = bond->xi[0] * bond->xi[0], y2 = bond->xi[1] * bond->xi[1];
        full.c11 += f * x2 * x2;
        full.c12 += f * x2 * y2;
    }
    return full;
}

struct solid_share_full solid_share_of_list(const struct solid_list *list, int i, const struct solid_share_full *last) {
    const struct solid_end *h = &list->particle[i];
    const struct solid_bond_law *law = &list->law;
    if (last->size == h->size && last->horizon == h->horizon) return *last;
    const double side = ldexp(1, (int)rint(log2(h->size)));
    const int reach = (int)(h->horizon / side + 1), deep = law->dim == 3 ? reach : 0;
    double cell = list->unit, c = law->c;
    for (int k = 0; k < law->dim; k++) cell *= side;
    for (int k = 0; k <= law->dim; k++) c *= law->horizon / h->horizon; /* c0 is proportional to delta^-(dim + 1) */
    struct solid_share_full full = {
        .nu = law->dim == 3 ? 1. / 4 : 1. / 3, .size = h->size, .horizon = h->horizon, .dim = law->dim};
    for (int k = -deep; k <= deep; k++)
        for (int j = -reach; j <= reach; j++)
            for (int l = -reach; l <= reach; l++) {
                const double xi[3] = {l * side, j * side, k * side},
                             length = sqrt((xi[0] * xi[0] + xi[1] * xi[1]) + xi[2] * xi[2]);
                if (length == 0 || !solid_pair_holds(law, xi, h->horizon, side)) continue;
                const double f = 0.5 * c * law->micromodulus->profile(length / h->horizon) * cell * list->spacing *
                                 solid_pair_gamma(law, xi, h->horizon, side) / (length * length * length);
                full.c11 += f * (xi[0] * xi[0]) * (xi[0] * xi[0]);
                full.c12 += f * (xi[0] * xi[0]) * (xi[1] * xi[1]);
            }
    return full;
}

/* xi.t xi; t: a tensor [6], square: products of xi's components (solid/bonds/row.h) */
#define ALONG(t, square)                                                                                               \
    ((t)[0] * (square)[0] + (t)[1] * (square)[1] + (t)[2] * (square)[2] +                                              \
     2 * ((t)[3] * (square)[3] + (t)[4] * (square)[4] + (t)[5] * (square)[5]))

double solid_share_view(const struct solid_share_full *full, const struct solid_family_view *view, const double s[6]) {
    const double trace = full->dim == 3 ? s[0] + s[1] + s[2] : s[0] + s[1];
    double e[6], whole = 0, own = 0;
    for (int k = 0; k < 6; k++) e[k] = (1 + full->nu) * s[k] - (k < full->dim ? full->nu * trace : 0);
    for (int c = 0; c < full->dim; c++) {
        for (int k = 0; k < full->dim; k++) whole += (c == k ? full->c11 : full->c12) * s[c] * e[k];
        if (full->dim == 3 || c == 0) whole += 4 * full->c12 * s[3 + c] * e[3 + c];
    }
    for (int b = 0; b < view->n; b++) {
        const double *xi = view->xi[b], micro = full->micro > 0 ? full->micro : view->micro[b];
        const double square[6] = {xi[0] * xi[0], xi[1] * xi[1], xi[2] * xi[2],
                                  xi[0] * xi[1], xi[1] * xi[2], xi[2] * xi[0]};
        const double xi2 = square[0] + square[1] + square[2];
        own += view->alpha[b] * micro * view->weight[b] * ALONG(s, square) * ALONG(e, square) / (xi2 * sqrt(xi2));
    }
    if (!(whole > 0)) return 1;
    return fmax(0.5 * own / whole, SOLID_SHARE_MIN);
}

/* xi.e xi = (1 + nu) xi.S xi - nu tr(S) |xi|^2 */
vec solid_share_row(const struct solid_share_full *full, const struct solid_row *row, const uint8_t *made,
                    const double (*square)[6], const vec s[6]) {
    const vec trace = s[0] + s[1] + s[2];
    vec e[6], whole = vec_set(0), own = whole;
    for (int k = 0; k < 6; k++) e[k] = (1 + full->nu) * s[k] - (k < 3 ? full->nu * trace : vec_set(0));
    for (int c = 0; c < 3; c++) {
        for (int k = 0; k < 3; k++) whole += (c == k ? full->c11 : full->c12) * s[c] * e[k];
        whole += 4 * full->c12 * s[3 + c] * e[3 + c];
    }
    for (const uint16_t *bond = row->bond; bond < row->end; bond++) {
        const struct solid_lattice_offset *from = &row->t->offset[*bond];
        const double length2 = square[*bond][0] + square[*bond][1] + square[*bond][2];
        const vec squared = ALONG(s, square[*bond]);
        own += vec_where(made[*bond] >> row->first, (from->elastic * from->inv_length2) * solid_row_alpha(row, *bond)) *
               squared * ((1 + full->nu) * squared - (full->nu * length2) * trace);
    }
    vec share = vec_max(0.5 * row->t->law.density * own / whole, vec_set(SOLID_SHARE_MIN));
    for (int k = 0; k < VEC_LANES; k++)
        if (!(whole[k] > 0)) share[k] = 1;
    return share;
}
