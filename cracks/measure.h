/* The numbers of the series. */
#pragma once
#include "cracks/cracks.h"

struct cracks_values {
    double injected;           /* through all injections since the start, m3 */
    double volume;             /* of the cracks by the present displacements, m3 */
    double cavity;             /* void that is not filled, m3 */
    double stored;             /* sum of S p, of cracks and pores, m3 */
    double leaked;             /* off the cracks' faces since the start, m3 */
    double residual;           /* volume - cavity + stored + leaked - injected, m3; volume and stored with those of the
                                * pores, less what was in the pores at the start */
    double injection_pressure; /* mean over the first injection's particles by their parts, Pa */
    double injection_rate;     /* of all injections in the last substep, m3/s */
    double pressure_mean;      /* by area, Pa */
    double area;               /* one face, m2 */
    double aperture_max;       /* m */
    double aperture_mean;      /* by area, m */
    long wet_particles;
};

/* Ghosts of the solid's displacements need not be current. Collective. */
struct cracks_values cracks_measure(const struct cracks *c);
