/* What part of a full family's stress a particle's unbroken family bears in its present state of stress. A family that
 * a surface has cut has fewer bonds, and alpha is not 1: the flux of its bonds' forces is `share` times the stress.
 *
 *     share = C_h(S, e)/C_0(S, e)      C(S, e) = (1/2) sum alpha c Gamma V (xi.S xi)(xi.e xi)/|xi|^3
 *     e = (1 + nu) S - nu tr(S) 1      the strain, but for a factor, of the stress S
 *
 * S is the flux with xi in place of zeta: it does not turn with the body. C_h is the sum over the unbroken family, C_0
 * that of a full one, with the two constants of a cubic lattice. A stress is the flux over the share. A uniform strain
 * of uniaxial stress is thus read within a percent at faces and edges, with any correction. Broken bonds lower the flux
 * and not the share. */
#pragma once
#include "base/vec_type.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/row.h"

/* Full families: sums of c Gamma V xi_x^4/(2 |xi|^3) and of xi_x^2 xi_y^2, Pa; nu is that of the dimension. */
struct solid_share_full {
    double c11, c12, nu;
    double size, horizon; /* of the cells of a list, spacings */
    double micro; /* > 0: the micromodulus of all bonds, whatever the family's; what the family lacks is then a matter
                   * of its places only */
    int dim;
};

struct solid_share_full solid_share_of_lattice(const struct solid_lattice *lattice);
/* Of the i-th particle of a list; last: the answer for another particle, which is returned if it is the same. */
struct solid_share_full solid_share_of_list(const struct solid_list *list, int i, const struct solid_share_full *last);

/* A family with less of a stress is taken to bear this part: what is read is then at most four times the flux. */
#define SOLID_SHARE_MIN 0.25

/* The share of particle h with the view of its bonds, for the flux s of its intact bonds in the reference frame. */
double solid_share_view(const struct solid_share_full *full, const struct solid_family_view *view, const double s[6]);
/* The same of a vec of families of a lattice's row; made: bits of their bonds when nothing had broken
 * (solid/bonds/lattice.h), square: solid/bonds/row.h. */
vec solid_share_row(const struct solid_share_full *full, const struct solid_row *row, const uint8_t *made,
                    const double (*square)[6], const vec s[6]);
