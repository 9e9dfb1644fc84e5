/* Declarations common to both bond stores. For solid/ only. */
#pragma once
#include "base/memory.h"
#include "solid/body/number.h"
#include "solid/law/stencil.h"

/* Constants of the bonds of a body.  (001: eqs 3.21, 3.27) */
struct solid_law {
    double c0;           /* N/m6 */
    double density;      /* kg/m3 */
    double eps_limit;    /* (1 + s0)^2 - 1; of the bilinear law (1 + s_e)^2 - 1 */
    double s_e, s_c;     /* of the bilinear law; 0: brittle */
    double bonds_energy; /* J/m2, solid_material_bonds_energy */
};

/* What a sweep computes. A body whose material has the Poisson's ratio of bonds alone has its forces in one sweep; any
 * other has two (solid/force/dilatation.h). */
enum solid_sweep_part {
    SOLID_SWEEP_FORCES,     /* a: forces of bonds alone */
    SOLID_SWEEP_EXTENSIONS, /* a[0], a[1]: sums over the family; bonds break here */
    SOLID_SWEEP_PRESSED     /* a: forces with the pressure; what the sweep before has copied to the stores is read */
};

/* Options of a sweep over the bonds. */
struct solid_sweep {
    int may_break;
    double damping; /* k_d, N s/m7 */
    enum solid_sweep_part part;
    int is_measure; /* 1: leaves no trace for later sweeps; with SOLID_SWEEP_EXTENSIONS */
};

struct solid_lattice;
struct solid_list;
struct solid_cloud;

/* The stores of the bodies: one of the two for each body; the other is NULL. */
struct solid_family {
    int bodies;
    struct solid_lattice **lattice;
    struct solid_list **list;
    struct solid_cloud **cloud; /* of a plate with lists: kept as long as the solid; else NULL */
    int stencils;
    struct solid_stencil **stencil; /* [stencils] by material */
    int *first;                     /* [bodies + 1] local index of the body's first owned particle */
    int bytes;                      /* bytes of lambda per particle in a checkpoint */
};

/* Zeroed, for n items and one more. */
static inline void *solid_store_array(size_t n, size_t size) { return memory_new(MEMORY_SOLID, n + 1, size); }
