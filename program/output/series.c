/* Writes series.csv: measures the run's integral quantities and appends one row a sample. */
#include "program/output/outputs.h"
#include "program/output/flow_balance.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/control/sample_watch.h"
#include "coupling/control/strained.h"
#include "coupling/interface/deposit.h"
#include "coupling/interface/place.h"
#include "coupling/load/reaction.h"
#include "cracks/cracks.h"
#include "base/files/folder.h"
#include "physics/darcy.h"
#include "solid/bonds/family.h"
#include "solid/measure/damage.h"
#include "solid/measure/fragments.h"
#include "solid/measure/motion.h"
#include "solid/refine/refine.h"

#include <math.h>
#include <stdlib.h>

enum {
    NEED_FLUID = 1,
    NEED_IMMERSED = 2,
    NEED_BONDS = 4,
    NEED_ALONE = 8,
    NEED_REFINED = 16,
    NEED_REACTION = 32,
    NEED_CONTACT = 64,
    NEED_SPACE = 128,
    NEED_CRACKS = 256
};

static const struct column {
    const char *name, *unit;
    int needs;
    size_t at; /* offset in struct series_sample */
} all_columns[] = {
#define COLUMN(name, unit, needs, field)                                                                               \
    { name, unit, needs, offsetof(struct series_sample, field) }
    COLUMN("step", "1", 0, step),
    COLUMN("t", "s", 0, t),
    COLUMN("dt", "s", 0, dt),
    COLUMN("div_max", "1/s", NEED_FLUID, fluid.divergence_max),
    COLUMN("cfl", "1", NEED_FLUID, cfl),
    COLUMN("u_bulk", "m/s", NEED_FLUID, fluid.bulk_velocity),
    COLUMN("dp", "Pa", NEED_IMMERSED, medium.pressure_drop),
    COLUMN("porosity", "1", NEED_IMMERSED, medium.porosity),
    COLUMN("porosity_effective", "1", NEED_IMMERSED, medium.porosity_effective),
    COLUMN("permeability", "m2", NEED_IMMERSED, medium.permeability),
    COLUMN("permeability_md", "mD", NEED_IMMERSED, permeability_md),
    COLUMN("reynolds_k", "1", NEED_IMMERSED, medium.reynolds),
    COLUMN("tortuosity", "1", NEED_IMMERSED, medium.tortuosity),
    COLUMN("specific_surface", "1/m", NEED_IMMERSED, medium.specific_surface),
    COLUMN("velocity_x", "m/s", NEED_IMMERSED, medium.mean_velocity[0]),
    COLUMN("velocity_y", "m/s", NEED_IMMERSED, medium.mean_velocity[1]),
    COLUMN("velocity_z", "m/s", NEED_IMMERSED, medium.mean_velocity[2]),
    COLUMN("load_x", "N", NEED_IMMERSED, load[0]),
    COLUMN("load_y", "N", NEED_IMMERSED, load[1]),
    COLUMN("load_z", "N", NEED_IMMERSED, load[2]),
    COLUMN("forcing_x", "N", NEED_IMMERSED, forcing[0]),
    COLUMN("forcing_y", "N", NEED_IMMERSED, forcing[1]),
    COLUMN("forcing_z", "N", NEED_IMMERSED, forcing[2]),
    COLUMN("momentum_residual", "1", NEED_IMMERSED, momentum_residual),
    COLUMN("angular_momentum_residual", "1", NEED_IMMERSED | NEED_BONDS, angular_momentum_residual),
    COLUMN("e_kinetic_fluid", "J", NEED_FLUID, fluid.kinetic_energy),
    COLUMN("dissipation", "W", NEED_FLUID, fluid.dissipation),
    COLUMN("slip_loss", "W", NEED_REACTION, slip_loss),
    COLUMN("inner_power", "W", NEED_REACTION | NEED_BONDS, inner_power),
    COLUMN("e_kinetic_solid", "J", NEED_BONDS, energy.kinetic),
    COLUMN("e_strain", "J", NEED_BONDS, energy.strain),
    COLUMN("e_damped", "J", NEED_BONDS, energy.damped),
    COLUMN("e_fracture", "J", NEED_BONDS, energy.fracture),
    COLUMN("crack_area", "m2", NEED_BONDS, crack_area),
    COLUMN("energy_per_area", "J/m2", NEED_BONDS, energy_per_area),
    COLUMN("work_fluid", "J", NEED_BONDS | NEED_IMMERSED, work_load),
    COLUMN("work_load", "J", NEED_BONDS | NEED_ALONE, work_load),
    COLUMN("e_constraint", "J", NEED_BONDS | NEED_ALONE, e_constraint),
    COLUMN("e_contact", "J", NEED_BONDS | NEED_CONTACT, energy.contact),
    COLUMN("momentum_x", "N s", NEED_BONDS, momentum[0]),
    COLUMN("momentum_y", "N s", NEED_BONDS, momentum[1]),
    COLUMN("momentum_z", "N s", NEED_BONDS | NEED_SPACE, momentum[2]),
    COLUMN("angular_momentum_x", "N m s", NEED_BONDS | NEED_SPACE, angular_momentum[0]),
    COLUMN("angular_momentum_y", "N m s", NEED_BONDS | NEED_SPACE, angular_momentum[1]),
    COLUMN("angular_momentum_z", "N m s", NEED_BONDS, angular_momentum[2]),
    COLUMN("given_x", "N", NEED_BONDS | NEED_ALONE, given[0]),
    COLUMN("given_y", "N", NEED_BONDS | NEED_ALONE, given[1]),
    COLUMN("given_z", "N", NEED_BONDS | NEED_ALONE | NEED_SPACE, given[2]),
    COLUMN("injected_volume", "m3", NEED_CRACKS, cracks.injected),
    COLUMN("crack_volume", "m3", NEED_CRACKS, cracks.volume),
    COLUMN("cavity_volume", "m3", NEED_CRACKS, cracks.cavity),
    COLUMN("leaked_volume", "m3", NEED_CRACKS, cracks.leaked),
    COLUMN("volume_residual", "m3", NEED_CRACKS, cracks.residual),
    COLUMN("injection_pressure", "Pa", NEED_CRACKS, cracks.injection_pressure),
    COLUMN("injection_rate", "m3/s", NEED_CRACKS, cracks.injection_rate),
    COLUMN("crack_pressure_mean", "Pa", NEED_CRACKS, cracks.pressure_mean),
    COLUMN("crack_area_wet", "m2", NEED_CRACKS, cracks.area),
    COLUMN("aperture_max", "m", NEED_CRACKS, cracks.aperture_max),
    COLUMN("aperture_mean", "m", NEED_CRACKS, cracks.aperture_mean),
    COLUMN("wet_particles", "1", NEED_CRACKS, cracks.wet_particles),
    COLUMN("mouth_volume", "m3", NEED_CRACKS | NEED_FLUID, cracks.entered),
    COLUMN("handed_volume", "m3", NEED_CRACKS | NEED_FLUID, cracks.handed),
    COLUMN("unshared_volume", "m3", NEED_CRACKS | NEED_FLUID, cracks.unshared),
    COLUMN("mouth_rate", "m3/s", NEED_CRACKS | NEED_FLUID, cracks.outlet_rate),
    COLUMN("mouth_pressure", "Pa", NEED_CRACKS | NEED_FLUID, cracks.outlet_pressure),
    COLUMN("mouths", "1", NEED_CRACKS | NEED_FLUID, cracks.outlets),
    COLUMN("resolved_volume", "m3", NEED_CRACKS | NEED_FLUID, cracks.resolved),
    COLUMN("particles", "1", NEED_BONDS | NEED_REFINED, particles),
    COLUMN("damage_mean", "1", NEED_BONDS, damage_mean),
    COLUMN("damage_max", "1", NEED_BONDS, damage_max),
    COLUMN("bonds_intact", "1", NEED_BONDS, bonds_intact),
    COLUMN("bonds_broken", "1", NEED_BONDS, bonds_broken),
    COLUMN("fragments", "1", NEED_BONDS, fragments),
    COLUMN("largest_fragment", "1", NEED_BONDS, largest_fragment),
    COLUMN("interface_particles", "1", NEED_IMMERSED, interface_particles),
    COLUMN("particles_outside", "1", NEED_IMMERSED, particles_outside),
    COLUMN("e_integrator", "J", NEED_BONDS, e_integrator),
    COLUMN("e_waves", "J", NEED_BONDS, e_waves),
#undef COLUMN
};
enum { ALL_COLUMNS = sizeof all_columns / sizeof *all_columns };

struct series {
    struct outputs_base base;
    int column[ALL_COLUMNS];
    struct series_sample now;
    double momentum[3]; /* of the fluid before the step, N s */
    double angular[3];  /* angular momentum of the fluid before the step, about the domain's centre, N m s */
    int prepared;
    struct flow_balance flow; /* of a flow without bodies */
    /* State of the solid at the last measurements; -1: none yet. */
    long damage_bonds_broken, damage_refinements; /* number of broken bonds and of refinements: damage, fragments */
    long bonds_moved;                             /* r->moved: energies, momentum */
    long outside_step;                            /* step: particles outside the domain */
    int capacity;
    double *damage; /* [capacity], work */
};

/* The parts that the run has, as bits NEED_. */
static int parts_of(const struct run *r) {
    return (r->needs.fluid ? NEED_FLUID : 0) | (r->needs.immersed ? NEED_IMMERSED : 0) |
           (r->needs.bonds ? NEED_BONDS : 0) | (r->needs.fluid ? 0 : NEED_ALONE) |
           (r->solid && r->solid->refine ? NEED_REFINED : 0) | (r->reaction ? NEED_REACTION : 0) |
           (r->needs.contact || (r->solid && r->solid->walls) ? NEED_CONTACT : 0) |
           (r->solid && r->solid->dim == 3 ? NEED_SPACE : 0) | (r->cracks ? NEED_CRACKS : 0);
}

static int begin(void *self, struct run *r) {
    struct series *s = self;
    const int have = parts_of(r);
    for (int k = 0; k < ALL_COLUMNS; k++)
        if ((all_columns[k].needs & have) == all_columns[k].needs) s->column[s->base.columns++] = k;
    s->damage_bonds_broken = s->bonds_moved = s->outside_step = -1;
    s->base.rows = 1;
    return 1;
}

static void open(void *self, struct run *r, const char *folder, long resume_step) {
    struct series *s = self;
    (void)r;
    const char *name[ALL_COLUMNS], *unit[ALL_COLUMNS];
    char path[FOLDER_PATH];
    folder_path(path, folder, "series.csv");
    for (int k = 0; k < s->base.columns; k++) {
        name[k] = all_columns[s->column[k]].name;
        unit[k] = all_columns[s->column[k]].unit;
    }
    s->base.table = table_new(path, s->base.columns, name, unit, resume_step);
}

/* Stores the values from which rates over the step are computed. */
static void prepare(void *self, struct run *r) {
    struct series *s = self;
    if (r->needs.fluid && !r->needs.immersed) flow_balance_prepare(&s->flow, r);
    if (!r->needs.immersed) return;
    fluid_measures_momentum(r->fluid, s->momentum, s->angular);
    fluid_box_force_begin(r->fluid);
    s->prepared = 1;
    reaction_add_works(r);
}

static void cancel(void *self, struct run *r) {
    struct series *s = self;
    double box[3];
    if (s->prepared) fluid_box_force_end(r->fluid, box);
    s->prepared = 0;
    flow_balance_cancel(&s->flow, r);
}

static double larger(const double x[3], double least) {
    return fmax(least, sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]));
}

/* |d(angular momentum)/dt - couple on the box - couple of the forcing| over the step, over the couple of the forcing
 * and its force with half of the domain's longest side as the arm, or at least over that of `least`. After
 * fluid_box_force_end. least: as flow_balance_least_force. */
static double angular_momentum_residual(const struct series *s, struct run *r, double least) {
    double box[3], couple[3], inner[3], residual = 0, scale = 0, half = 0;
    const int is_known = fluid_box_couple_end(r->fluid, box);
    if (!is_known) return NAN;
    ibm_couple_forcing(r->ibm, r->dt, couple);
    reaction_inner_couple(r, inner);
    for (int c = 0; c < 3; c++) couple[c] += inner[c];
    for (int c = 0; c < 3; c++) half = fmax(half, 0.5 * fluid_grid_of(r->fluid)->length[c]);
    for (int c = 0; c < 3; c++) {
        residual += pow((s->now.fluid.angular[c] - s->angular[c]) / r->dt - box[c] - couple[c], 2);
        scale += pow(couple[c], 2) + pow(half * s->now.forcing[c], 2);
    }
    sample_watch_angular(r, sqrt(residual), larger(box, fmax(sqrt(scale), half * least)));
    scale = fmax(scale, pow(half * least, 2));
    return scale > 0 ? sqrt(residual / scale) : NAN;
}

/* |d(momentum)/dt - box force - forcing| over the step, over |forcing| or flow_balance_least_force, if that is larger:
 * a body in its own stream forces nothing but round-off. */
static double momentum_residual(struct series *s, struct run *r) {
    double box[3], residual = 0, scale = 0;
    s->now.angular_momentum_residual = NAN;
    if (!s->prepared) return NAN;
    s->prepared = 0;
    fluid_box_force_end(r->fluid, box);
    const double least = flow_balance_least_force(r, s->now.fluid.kinetic_energy);
    if (r->needs.bonds) s->now.angular_momentum_residual = angular_momentum_residual(s, r, least);
    for (int c = 0; c < 3; c++) {
        const double rate = (s->now.fluid.momentum[c] - s->momentum[c]) / r->dt;
        residual += pow(rate - box[c] - s->now.forcing[c], 2);
        scale += pow(s->now.forcing[c], 2);
    }
    sample_watch_momentum(r, sqrt(residual), larger(box, fmax(sqrt(scale), least)));
    scale = fmax(scale, least * least);
    return scale > 0 ? sqrt(residual / scale) : NAN;
}

/* Number of particles outside the domain. */
static double particles_outside(const struct run *r) {
    long outside = 0;
    for (int h = 0; h < r->solid->n; h++) outside += !place_is_inside(fluid_grid_of(r->fluid), r->solid, h);
    return (double)par_sum_long(outside);
}

static void sample_immersed(struct series *s, struct run *r) {
    if (r->scene->stage[r->stage].solid == SCENE_SOLID_RIGID) r->load_kind->sample(r);
    s->now.medium = deposit_measure(r);
    s->now.permeability_md = 1e3 * s->now.medium.permeability / PHYSICS_DARCY;
    for (int c = 0; c < 3; c++) s->now.load[c] = r->load[c];
    ibm_forcing_total(r->ibm, s->now.forcing);
    if (r->reaction) s->now.slip_loss = r->stage_step > 0 ? reaction_slip_loss(r) : 0;
    if (r->reaction) s->now.inner_power = reaction_inner_power(r);
    s->now.momentum_residual = momentum_residual(s, r);
    s->now.interface_particles = (double)r->surface->total;
    if (s->outside_step < r->moved) s->now.particles_outside = particles_outside(r);
    s->outside_step = r->step;
}

/* Damage and fragments are measured again only after more bonds have broken. */
static void sample_damage(struct series *s, struct run *r, const struct outputs_found *found) {
    struct solid *solid = r->solid;
    solid_family_count(solid);
    s->now.bonds_broken = (double)solid->bonds_broken;
    s->now.bonds_intact = (double)(solid->bonds_total - solid->bonds_broken);
    s->now.particles = (double)solid->n_global;
    if (solid->bonds_broken == s->damage_bonds_broken && solid_refine_events(solid) == s->damage_refinements) return;
    s->damage_bonds_broken = solid->bonds_broken;
    s->damage_refinements = solid_refine_events(solid);
    if (solid->n >= s->capacity) {
        memory_free(s->damage);
        s->capacity = solid->n + solid->n / 4 + 1;
        s->damage = memory_new(MEMORY_OUTPUT, (size_t)s->capacity, sizeof *s->damage);
    }
    double sum = 0, largest = 0;
    solid_damage_measure(solid, s->damage);
    for (int h = 0; h < solid->n; h++) {
        sum += s->damage[h];
        largest = fmax(largest, s->damage[h]);
    }
    s->now.damage_mean = par_sum(sum) / (double)solid->n_global;
    s->now.damage_max = par_max(largest);
    s->now.fragments = found->fragments;
    s->now.largest_fragment = found->largest_fragment;
    if (found->fragments >= 0) return;
    struct solid_fragment *list;
    s->now.fragments = solid_fragments_measure(solid, NULL, &list);
    s->now.largest_fragment = s->now.fragments > 0 ? (double)list[0].particles : 0;
    free(list);
}

/* Momentum, angular momentum about the domain's centre and loads of the whole solid. */
static void sample_motion(struct series *s, struct run *r) {
    const int bodies = r->solid->in.bodies;
    double centre[3];
    for (int c = 0; c < 3; c++) centre[c] = 0.5 * r->scene->domain.size[c];
    solid_motion_angular_momentum(r->solid, centre, s->now.angular_momentum);
    struct solid_motion *motion = memory_new(MEMORY_OUTPUT, (size_t)bodies, sizeof *motion);
    solid_motion_measure(r->solid, motion);
    for (int c = 0; c < 3; c++) {
        s->now.momentum[c] = s->now.given[c] = 0;
        for (int b = 0; b < bodies; b++) {
            s->now.momentum[c] += motion[b].momentum[c];
            s->now.given[c] += motion[b].load[c];
        }
    }
    memory_free(motion);
}

static void sample_bonds(struct series *s, struct run *r, const struct outputs_found *found) {
    if (s->bonds_moved == r->moved) return;
    s->bonds_moved = r->moved;
    s->now.energy = solid_energy_measure(r->solid);
    double share[] = {r->solid->work_load, r->solid->e_constraint, r->solid->crack_area, r->solid->e_integrator};
    par_sum_array(share, 4);
    s->now.work_load = share[0];
    s->now.e_constraint = share[1];
    s->now.crack_area = share[2];
    s->now.energy_per_area = share[2] > 0 ? s->now.energy.fracture / share[2] : 0;
    s->now.e_integrator = share[3];
    s->now.e_waves = strained_waves(r);
    sample_motion(s, r);
    sample_damage(s, r, found);
}

/* Where as much is taken out as is given all parts are round-off, beside the volume that the cracks might have. */
static void sample_cracks(struct series *s, struct run *r) {
    static const double LEAST = 1e-6;
    const struct cracks_values v = s->now.cracks = cracks_measure(r->cracks);
    const double part[] = {v.volume,   v.cavity,  v.stored,   v.leaked,
                           v.injected, v.entered, v.resolved, r->cracks->filled};
    double largest = LEAST * v.area * v.aperture_max;
    for (size_t k = 0; k < sizeof part / sizeof *part; k++) largest = fmax(largest, fabs(part[k]));
    sample_watch_cracks(r, fmax(fabs(v.residual), v.misplaced), largest);
    sample_watch_push(r, v.on_solid, v.on_fluid, v.on_size);
    sample_watch_leak(r, v.leaked, largest);
}

static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    struct series *s = self;
    s->now.step = (double)r->step;
    s->now.t = r->t;
    s->now.dt = r->dt;
    if (r->needs.fluid) s->now.fluid = fluid_measures_of(r->fluid);
    s->now.cfl = r->dt * s->now.fluid.convection_rate;
    if (r->needs.fluid) sample_watch_divergence(r, s->now.fluid.divergence_max, s->now.fluid.convection_rate);
    if (r->needs.fluid && !r->needs.immersed) flow_balance_check(&s->flow, r, &s->now.fluid);
    if (r->needs.immersed) sample_immersed(s, r);
    if (r->needs.bonds) sample_bonds(s, r, m->found);
    if (r->cracks) sample_cracks(s, r);
    double row[ALL_COLUMNS];
    for (int k = 0; k < s->base.columns; k++)
        row[k] = *(const double *)(const void *)((const char *)&s->now + all_columns[s->column[k]].at);
    table_add(s->base.table, row);
    m->found->series = s->now;
}

static void free_series(void *self) { memory_free(((struct series *)self)->damage); }

const struct output output_series = {
    .file = {"series.csv"},
    .bytes = sizeof(struct series),
    .begin = begin,
    .open = open,
    .sample = sample,
    .free = free_series,
    .prepare = prepare,
    .cancel = cancel,
};
