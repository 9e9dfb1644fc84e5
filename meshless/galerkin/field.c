/* Displacement, gradient and stress of the solution. */
#include "meshless/galerkin/field.h"
#include "meshless/galerkin/mls.h"

void meshless_field_at(const struct galerkin *g, const struct galerkin_place *at, double u[2], double grad[2][2]) {
    struct galerkin_shape shape;
    meshless_mls_need(g, at, &shape);
    for (int c = 0; c < 2; c++) {
        u[c] = grad[c][0] = grad[c][1] = 0;
        for (int i = 0; i < shape.n; i++) {
            const double value = g->solution.u[2 * shape.node[i] + c];
            u[c] += value * shape.phi[i];
            for (int k = 0; k < 2; k++) grad[c][k] += value * shape.d[i][k];
        }
    }
}

void meshless_field_stress(const struct galerkin *g, const double grad[2][2], double stress[3]) {
    const double shear = grad[0][1] + grad[1][0];
    for (int c = 0; c < 2; c++) stress[c] = g->elastic[c][0] * grad[0][0] + g->elastic[c][1] * grad[1][1];
    stress[2] = g->elastic[2][2] * shear;
}
