/* Partial volumes and the stencil of a lattice's family.  (001: eq. 3.33, mended) */
#pragma once

/* The fraction of a cube (with this side, centred at xi from the origin, axes along x, y, z) inside the sphere of this
 * radius about the origin. Symmetric under permutations and signs of xi to the bit. Not collective. */
double solid_weight_fraction(const double xi[3], double side, double radius, int cells);

/* The same, looked up in a table of recent results: the particles of a lattice have few different ones. */
struct solid_weight_table; /* opaque */
struct solid_weight_table *solid_weight_table_new(void);
void solid_weight_table_free(struct solid_weight_table *table);
double solid_weight_fraction_kept(struct solid_weight_table *table, const double xi[3], double side, double radius,
                                  int cells);

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
struct solid_stencil *solid_weight_stencil_new(double spacing, double m);
void solid_weight_stencil_free(struct solid_stencil *stencil);
