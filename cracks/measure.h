/* The numbers of the series. */
#pragma once
#include "cracks/cracks.h"

struct cracks_values {
    double injected;           /* through all injections since the start, m3 */
    double volume;             /* of the cracks by the present displacements, m3 */
    double cavity;             /* void that is not filled, m3 */
    double stored;             /* sum of S p, of cracks and pores, m3 */
    double leaked;             /* off the cracks' faces since the start, m3 */
    double entered;            /* through the outlets since the start, m3; 0 without a fluid outside, as the next six */
    double unshared;           /* volume + resolved - handed: by which cracks widen the solid and the fluid outside does
                                * not give way, m3 */
    double outlet_rate;        /* of all outlets in the last step, m3/s */
    double outlet_pressure;    /* mean over the outlets, Pa */
    double outlets;            /* their number */
    double handed;             /* of it, given by the fluid outside, m3 */
    double resolved;           /* fluid in struts that were switched off since the start, m3 */
    double residual;           /* volume - cavity + stored + leaked + resolved - injected - entered, m3; volume
                                * and stored with those of the pores, less what was in the pores at the start */
    double misplaced;          /* sum of the sizes of the differences between the volumes by the present displacements
                                * and those that the particles' fluid fills, m3; 0 while it does not flow */
    double on_solid, on_fluid; /* sums of F.d of the pressures' forces and the displacements, and of p times the volumes
                                * that these open, J: the same; 0 while the fluid does not flow */
    double on_size;            /* the sum of the sizes of both kinds of terms, the first ones times 1e-9, J */
    double injection_pressure; /* mean over the first injection's particles by their parts, Pa */
    double injection_rate;     /* of all injections in the last substep, m3/s */
    double pressure_mean;      /* by area, Pa */
    double area;               /* of the cracks, m2: half of it on either side */
    double aperture_max;       /* m */
    double aperture_mean;      /* by area, m */
    double wet_particles;      /* their number */
};

/* The fields of the solid's particles, [the solid's n]: pressure, Pa; aperture, m; |a_h|, m2; void that is not filled,
 * m3. 0 where a particle is not wet. Not collective. */
enum { CRACKS_FIELDS = 4 };
extern const char *const cracks_measure_field_name[CRACKS_FIELDS];
void cracks_measure_field(const struct cracks *c, int field, double *value);
/* Ghosts of the solid's displacements need not be current. Collective. */
struct cracks_values cracks_measure(const struct cracks *c);
