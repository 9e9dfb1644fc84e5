/* Bonds that broke or softened in this sweep, for the energy of the dilatations of their ends
 * (solid/force/dilatation.h). For solid/ only. */
#pragma once
#include "solid/state.h"

struct solid_dilatation_loss {
    int h, l;
    double xi[3];
    double stiffness;   /* what the bond's part of M_h has fallen by, N/m2 */
    double now, before; /* its stretch; and that at the beginning of the substep, or `now` (solid/force/absorbed.h) */
    int soft;           /* its number in s->soft if it softens on, else -1 */
};

/* The sweep breaks or softens the bond of h and l, xi = X0_l - X0_h, m; to be called for each end that is owned here.
 * Not collective. */
void solid_dilatation_loss_add(struct solid *s, const struct solid_dilatation_loss *loss);
