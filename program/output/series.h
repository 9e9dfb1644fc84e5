/* A row of series.csv.  (docs/run-folder.md) */
#pragma once

/* Names and units are those of the columns, which series.c lists. 0: a quantity that the scene does not have. */
struct series_sample {
    double step, t, dt, div_max, cfl, u_bulk, dp, porosity, porosity_effective, permeability, tortuosity;
    double permeability_md, reynolds_k, specific_surface, velocity[3];
    double load[3], forcing[3], momentum_residual, angular_momentum_residual;
    double e_kinetic_fluid, dissipation, e_kinetic_solid, e_strain, e_damped, e_fracture, crack_area, energy_per_area,
        work_fluid, work_load, e_constraint, e_contact, momentum[3], angular_momentum[3], given[3], slip_loss,
        inner_power;
    double particles, damage_mean, damage_max, bonds_intact, bonds_broken, fragments, largest_fragment,
        interface_particles, particles_outside, e_integrator;
    double injected_volume, crack_volume, cavity_volume, leaked_volume, volume_residual, injection_pressure,
        injection_rate, crack_pressure_mean, crack_area_wet, aperture_max, aperture_mean, wet_particles, mouth_volume,
        handed_volume, unshared_volume, mouth_rate, mouth_pressure, mouths, resolved_volume;
};
