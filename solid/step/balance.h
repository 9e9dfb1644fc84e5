/* The energy that pairwise damping dissipates with velocity Verlet: from the balance of energy of the pairs' forces.
 *
 * With F for the pairs' forces and d for the displacement, the kinetic energy changes in a substep by
 *     W = sum of 1/2 (F(n) + F(n+1)) . (d(n+1) - d(n))
 * but for a sum over dt^2/8 rho V a^2 whose terms cancel from substep to substep. The part of elastic bonds is the loss
 * of strain energy plus e_fracture (solid/force/absorbed.h): exactly, where forces are linear in d, else to second
 * order. So e_damped = - W - change of strain energy - change of e_fracture      (and of explicit contact's energy)
 * In a balance (s->balance) s->e_damped contains strain energy and e_fracture. Then a substep subtracts W, and only
 * measures compute the strain energy. */
#pragma once
#include "solid/state.h"

/* begin: before substeps; adds those energies to e_damped where a balance starts. end: before d or bonds change
 * otherwise; takes them out again. Each computes the strain energy then only. Collective. */
void solid_balance_begin(struct solid *s);
void solid_balance_end(struct solid *s);
