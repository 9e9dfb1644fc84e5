/* A row of series.csv.  (docs/run-folder.md) */
#pragma once
#include "coupling/medium/medium.h"
#include "cracks/measure.h"
#include "solid/measure/energy.h"

/* series.c lists the columns, with their units. 0: a quantity that the scene does not have. */
struct series_sample {
    double step, t, dt, cfl;
    struct fluid_measures fluid;
    struct medium_values medium;
    double permeability_md, load[3], forcing[3], momentum_residual, angular_momentum_residual, slip_loss, inner_power;
    double interface_particles, particles_outside;
    struct solid_energy energy;
    double e_constraint, e_integrator, e_waves, work_load, crack_area, energy_per_area, momentum[3],
        angular_momentum[3], given[3];
    double particles, damage_mean, damage_max, bonds_intact, bonds_broken, fragments, largest_fragment;
    struct cracks_values cracks;
};
