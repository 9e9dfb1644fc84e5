/* Principal values and directions of a tensor of permeability. */
#include "physics/darcy.h"
#include "base/ensure.h"

#include <lapacke.h>
#include <math.h>

struct physics_darcy_principal physics_darcy_principal_of(const double K[3][3]) {
    struct physics_darcy_principal p;
    double a[9], w[3], odd = 0, even = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            a[3 * i + j] = 0.5 * (K[i][j] + K[j][i]);
            even += pow(K[i][j] + K[j][i], 2);
            odd += pow(K[i][j] - K[j][i], 2);
        }
    p.asymmetry = even > 0 ? sqrt(odd / even) : NAN;
    ENSURE(LAPACKE_dsyev(LAPACK_ROW_MAJOR, 'V', 'U', 3, a, 3, w) == 0, "a tensor of %g m2", K[0][0]);
    for (int q = 0; q < 3; q++) { /* LAPACK: the smallest first, a vector a column */
        int most = 0;
        p.value[q] = w[2 - q];
        for (int i = 1; i < 3; i++)
            if (fabs(a[3 * i + 2 - q]) > fabs(a[3 * most + 2 - q]) * (1 + 1e-9)) most = i;
        const double sign = a[3 * most + 2 - q] < 0 ? -1 : 1;
        for (int i = 0; i < 3; i++) p.along[q][i] = sign * a[3 * i + 2 - q];
    }
    return p;
}
