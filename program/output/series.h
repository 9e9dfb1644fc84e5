/* series.csv: the columns of a scene, and a sample of them.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

struct series;    /* opaque */
struct fragments; /* program/output/fragments.h */

/* resume_step < 0: a new file. Collective. */
struct series *series_new(struct run *r, const char *folder, long resume_step);
int series_columns(const struct run *r); /* of series.csv. Not collective. */
void series_free(struct series *s);
/* To be called before the step after which a sample is taken: stores the values from which rates are computed.
 * Collective. */
void series_prepare(struct series *s, struct run *r);
/* Drops what series_prepare stored, if no sample was taken after that step. Collective. */
void series_leave(struct series *s, struct run *r);
/* Measures and appends a row. pieces: after fragments_sample of this step; NULL: the fragments are measured here.
 * Collective. */
void series_sample(struct series *s, struct run *r, const struct fragments *pieces);

/* The last sample, for lines in the log. NaN: a quantity that the scene does not have. */
struct series_sample {
    double step, t, dt, div_max, cfl, u_bulk, dp, porosity, porosity_effective, permeability, tortuosity;
    double permeability_md, reynolds_k, specific_surface, velocity[3];
    double load[3], forcing[3], momentum_residual;
    double e_kinetic_fluid, dissipation, e_kinetic_solid, e_strain, e_damped, e_fracture, crack_area, energy_per_area,
        work_fluid, work_load, e_constraint, e_contact, momentum[3], given[3], slip_loss, inner_power;
    double particles, damage_mean, damage_max, bonds_intact, bonds_broken, fragments, largest_fragment,
        interface_particles, particles_outside;
    double injected_volume, crack_volume, cavity_volume, leaked_volume, volume_residual, injection_pressure,
        injection_rate, crack_pressure_mean, crack_area_wet, aperture_max, aperture_mean, wet_particles, mouth_volume,
        handed_volume, unshared_volume, mouth_rate, mouth_pressure, mouths, resolved_volume;
};
const struct series_sample *series_last(const struct series *s);
