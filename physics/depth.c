/* Estimates the depth of a lattice site below a surface from the weighted number of its neighbours. */
#include "physics/depth.h"

#include <math.h>

enum { SHELLS = 5 };
/* sites at r^2 = 0 .. 4, and those of them that are not above a face along the lattice */
static const int sites[SHELLS] = {1, 6, 12, 8, 6}, below_face[SHELLS] = {1, 5, 8, 4, 5};

int physics_depth_weight(int r2, int reach2) { return r2 <= reach2 ? (reach2 + 1 - r2) * (reach2 + 1 - r2) : 0; }

static double weight_of(const int number[SHELLS], int reach2) {
    int sum = 0;
    for (int r2 = 0; r2 < SHELLS; r2++) sum += number[r2] * physics_depth_weight(r2, reach2);
    return sum;
}

static double integral(double z, double b) {
    const double q = z * z / b;
    return z * (1 - 1 / (b * b * b) - q * (1 - q * (3 / 5.0 - q / 7)));
}

/* d with F(d) = fraction, by bisection: F rises with d. */
static double inverse(double fraction, int reach2) {
    const double far = sqrt(reach2), b = reach2 + 1;
    double low = -far, high = far;
    for (int n = 0; n < 60; n++) {
        const double d = 0.5 * (low + high);
        *(integral(d, b) < (2 * fraction - 1) * integral(far, b) ? &low : &high) = d;
    }
    return 0.5 * (low + high);
}

double physics_depth(int present, int reach2) {
    const double all = weight_of(sites, reach2);
    const double face = inverse(weight_of(below_face, reach2) / all, reach2);
    return fmin(1, fmax(0, inverse(present / all, reach2) - face + 0.5));
}
