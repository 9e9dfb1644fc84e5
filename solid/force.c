#include "solid/force.h"
#include "solid/added_mass.h"
#include "solid/constraint.h"
#include "solid/contact.h"
#include "solid/integrate.h"
#include "solid/lattice.h"
#include "solid/list.h"

void solid_force_bonds(struct solid *s, int may_break, double damping_relative) {
    const struct solid_sweep sweep = {.may_break = may_break, .damping = damping_relative};
    const struct solid_family *f = s->family;
    double power = 0;
    for (int b = 0; b < f->bodies; b++)
        power += f->lattice[b] ? solid_lattice_force(s, f->lattice[b], &sweep)
                               : solid_list_force(s, f->list[b], &sweep);
    s->power_damped = power;
    s->sweeps++;
}

void solid_force_loads(struct solid *s, double damping_absolute) {
    const struct solid_family *f = s->family;
    double load_power = 0, damped_power = 0;
    for (int b = 0; b < f->bodies; b++) {
        const double density = s->in.material[s->in.body[b].material].density, inv_density = 1 / density;
        for (int c = 0; c < 3; c++) {
            const double *load = s->load[c], *v = s->v[c], gravity = s->in.body_force[c];
            double *a = s->a[c];
            for (int h = f->first[b]; h < f->first[b + 1]; h++) {
                load_power += s->volume[h] * (load[h] + density * gravity) * v[h];
                damped_power += s->volume[h] * density * damping_absolute * v[h] * v[h];
                a[h] += load[h] * inv_density + gravity - damping_absolute * v[h];
            }
        }
    }
    s->power_load = load_power;
    s->power_damped += damped_power;
}

void solid_force_rest(struct solid *s) {
    solid_force_loads(s, s->stage.damping_absolute);
    const double of_load = s->power_load;
    if (s->added) solid_added_mass_apply(s);
    s->power_added = s->power_load - of_load;
    solid_constraint_apply(s);
}

void solid_force(struct solid *s, int may_break) {
    solid_force_bonds(s, may_break && s->stage.breakage, s->stage.damping_relative);
    if (s->in.contact && s->contact) solid_contact_force(s);
    if (s->stage.integrator == SOLID_VERLET) solid_verlet_keep(s);
    solid_force_rest(s);
}
