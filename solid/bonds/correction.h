/* The surface correction: a factor alpha of each bond, greater than 1 where a surface has cut its ends' families.
 *
 *     alpha_hl = 2/(w_h + w_l)                                 the same from both ends
 *     none      w_h = 1
 *     volume    w_h = V_h/V0                                   (001: eqs 3.43, 3.44)
 *     energy    w_h = phi_h (phi_h/<phi>_h)^2.1                     (after Madenci & Oterkus 2014, Le & Bobaru 2018)
 *               phi_h = max over e of Psi_h(e)/Psi_0(e)
 *               Psi_h(e) = sum over the unbroken family of c |xi| Gamma V s^2,  s = (1 + nu) (xi.e)^2/|xi|^2 - nu
 *               <phi>_h = phi_h + (1/V0) sum Gamma V_l (phi_l - phi_h)
 *
 * Psi_h(e) is the energy of h under uniaxial stress along e, and Psi_0(e) that of a full family. The largest ratio is
 * the one along the surface, where a body can bear stress. With w = phi a bar has the right stiffness. In bending it is
 * too soft, because a bond takes the strain of its middle, which is nearer to the axis than its outer end. The power of
 * phi/<phi> moves stiffness from the layers below a surface to the outermost one; the sum over a wall does not change.
 * The exponent is chosen by the bending stiffness of bars, plates and strips (docs/design/solid-bonds.md).
 *
 * Bodies of points and refined bodies take `volume` in place of `energy`: their families differ by chance or by level,
 * and the largest ratio would take that for stiffness. */
#pragma once
#include "solid/state.h"

/* w of all particles known here, by local index, from V_h of these. Collective. */
void solid_correction_of(struct solid *s, double *w);
