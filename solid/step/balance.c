/* Adds energies of pairs to e_damped while velocity Verlet's pairs are damped, and subtracts them afterwards. */
#include "solid/step/balance.h"
#include "base/par.h"
#include "solid/bonds/ghosts.h"
#include "solid/contact/contact.h"
#include "solid/contact/implicit.h"
#include "solid/force/strain.h"

static enum solid_balance of_stage(const struct solid *s) {
    if (s->stage.integrator != SOLID_VERLET || !(s->stage.damping_relative > 0)) return SOLID_BALANCE_NONE;
    return s->in.contact && !solid_contact_implicit_is(s) ? SOLID_BALANCE_CONTACT : SOLID_BALANCE_BONDS;
}

/* This rank's share, J. */
static double energy_of(struct solid *s, enum solid_balance balance) {
    solid_ghosts_update(s);
    const double contact = balance == SOLID_BALANCE_CONTACT ? solid_contact_force_energy(s) : 0;
    return solid_strain_energy(s) + s->e_fracture + (par_rank() == 0 ? contact : 0);
}

void solid_balance_end(struct solid *s) {
    if (s->balance == SOLID_BALANCE_NONE) return;
    s->e_damped -= energy_of(s, (enum solid_balance)s->balance);
    s->balance = SOLID_BALANCE_NONE;
}

void solid_balance_begin(struct solid *s) {
    const enum solid_balance balance = of_stage(s);
    if (s->balance == (long)balance) return;
    solid_balance_end(s);
    if (balance == SOLID_BALANCE_NONE) return;
    s->e_damped += energy_of(s, balance);
    s->balance = balance;
}
