/* The energy that a bond has absorbed when it breaks at the end of a substep of velocity Verlet.
 *
 * Verlet's work of a force over a substep is the mean of its values at both ends times the displacement. A bond that
 * breaks at the end of a substep does not act there. With k for its stiffness, s for its stretch at the end and s_n for
 * that at the beginning, it has absorbed
 *     1/2 k s_n^2 + 1/2 k s_n (s - s_n) = 1/2 k s_n s
 * and not 1/2 k s^2. A bond that breaks at another time (before the first substep, or with RK3) has absorbed the full
 * 1/2 k s^2. For solid/ only. */
#pragma once
#include "solid/state.h"

void solid_absorbed_free(struct solid_absorbed *absorbed);
/* Before d and v change: copies the ghosts' d, if bonds may break. Not collective, nor is any function here. */
void solid_absorbed_save(struct solid *s);
/* Around the sweep at the end of the substep, where d is that of the end, a_old the acceleration of the beginning and v
 * = v_n + theta dt a_old, plus contact's change. */
void solid_absorbed_begin(struct solid *s, double dt, double theta);
void solid_absorbed_end(struct solid *s);
/* 1: a substep of Verlet is being made, so that what breaks has absorbed the energy above. */
int solid_absorbed_is(const struct solid *s);
/* The energy that the bond of h and l, X0_l - X0_h = xi, has absorbed, over 1/2 k s^2 with its present stretch s. */
double solid_absorbed_fraction(const struct solid *s, int h, int l, const double xi[3], double stretch);
