/* Partial volumes.  (001: eq. 3.33, mended) */
#pragma once

/* The fraction of a cube (with this side, centred at xi from the origin, axes along x, y, z) inside the sphere of this
 * radius about the origin. Symmetric under permutations and signs of xi to the bit. Not collective. */
double solid_weight_fraction(const double xi[3], double side, double radius, int cells);

/* The same, looked up in a table of recent results: the particles of a lattice have few different ones. */
struct solid_weight_table; /* opaque */
struct solid_weight_table *solid_weight_table_new(void);
void solid_weight_table_free(struct solid_weight_table *table);
double solid_weight_fraction_cached(struct solid_weight_table *table, const double xi[3], double side, double radius,
                                    int cells);
