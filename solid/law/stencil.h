/* The stencil of a lattice's family.  (001: sec. 3.3.5, eqs 3.32, 3.33) */
#pragma once

/* One directed bond of the lattice's family. */
struct solid_offset {
    int step[3];        /* X0_l - X0_h in lattice spacings */
    double xi[3];       /* m */
    double length;      /* |xi|, m */
    double inv_length2; /* 1/|xi|^2, 1/m2 */
    double weight;      /* Gamma V_l, m3 */
};

/* The complete family |xi| < delta + spacing/2, ordered z, y, x: the reverse of offset o is n-1-o. */
struct solid_stencil {
    int n, reach; /* number of offsets; the largest |step| */
    double spacing, horizon;
    double full_volume; /* V0 = sum of weights, m3 */
    struct solid_offset *offset;
};

/* m: horizon / spacing. Dies (exit 2) on a family larger than SOLID_FAMILY_MAX. Collective (same input on all
 * ranks). */
struct solid_stencil *solid_stencil_new(double spacing, double m);
void solid_stencil_free(struct solid_stencil *stencil);
