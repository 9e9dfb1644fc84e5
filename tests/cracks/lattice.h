/* Sums over the lattice's family with partial areas and volumes that are found here, column by column. */
#pragma once
#include "tests/check.h"

#include <math.h>

/* The part of the cell at (x, y, z), x >= y >= z >= 0, inside the ball (plate: disc) of radius m, by the midpoint rule
 * over its columns along x: exact heights. */
static inline double lattice_part(const double at[3], double m, int dim, int columns) {
    double sum = 0;
    for (int j = 0; j < columns; j++)
        for (int k = 0; k < (dim == 3 ? columns : 1); k++) {
            const double y = at[1] + (j + 0.5) / columns - 0.5, z = dim == 3 ? at[2] + (k + 0.5) / columns - 0.5 : 0,
                         left = m * m - y * y - z * z;
            if (left > 0) sum += fmax(0, fmin(1, sqrt(left) - at[0] + 0.5));
        }
    return sum / pow(columns, dim - 1);
}

struct lattice_sums {
    double omega0;   /* of sum omega |xi| = 2 dim h^dim t: over h t in a plate, over h^2 in space */
    double confined; /* modulus of compression along a row without strain across it, over 1.2 E */
};

/* Of a constant micromodulus and plane strain. In a plate the family has every cell that the disc meets; in space those
 * whose centre is less than half a spacing beyond the horizon. */
static inline struct lattice_sums lattice_sums(int dim, double m, int columns) {
    const int reach = (int)m + 1;
    const double pi = acos(-1), c = dim == 3 ? 12 / (pi * pow(m, 4)) : 48 / (5 * pi * pow(m, 3));
    double length = 0, stiffness = 0;
    for (int i = 1; i <= reach; i++) /* i >= j >= k >= 0 stand for all permutations and signs */
        for (int j = 0; j <= i; j++)
            for (int k = 0; k <= (dim == 3 ? j : 0); k++) {
                const double at[3] = {i, j, k}, xi2 = i * i + j * j + k * k, xi = sqrt(xi2);
                if (dim == 3 && xi2 >= (m + 0.5) * (m + 0.5)) continue;
                double times = 2 * (j ? 2 : 1) * (k ? 2 : 1); /* signs, then orders */
                if (dim == 2)
                    times *= i == j ? 1 : 2;
                else
                    times *= i == j && j == k ? 1 : i == j || j == k ? 3 : 6;
                const double part = times * lattice_part(at, m, dim, columns);
                length += part * xi;
                stiffness += 0.5 * c * part * (pow(i, 4) + pow(j, 4) + pow(k, 4)) / dim / pow(xi, 3);
            }
    return (struct lattice_sums){2 * dim / length, stiffness / 1.2};
}
