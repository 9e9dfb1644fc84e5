/* J and interaction integrals by Gauss points in polar coordinates about the tip. */
#include "meshless/galerkin/intensity.h"
#include "meshless/galerkin/cells.h"
#include "meshless/galerkin/cut.h"
#include "meshless/galerkin/field.h"
#include "physics/crack_tip.h"

#include <math.h>

static struct physics_crack_tip material_of(const struct galerkin_input *in) {
    return (struct physics_crack_tip){in->youngs_modulus, in->poisson_ratio, in->plane_strain};
}

double meshless_intensity_widest(const struct galerkin *g, int tip) {
    const struct galerkin_tip *its = &g->tip[tip];
    double widest = fmin(meshless_cut_depth(&g->in, its->x), meshless_cut_part(g, its)->length);
    widest = fmin(widest, meshless_cut_from_bends(g, its, its->x));
    for (int c = 0; c < g->lines; c++)
        if (c != its->line) widest = fmin(widest, meshless_cut_from_line(&g->line[c], its->x));
    return widest;
}

/* Gradient and stress of the solution in the tip's frame. */
static void in_frame(const struct galerkin *g, const struct galerkin_tip *tip, const struct galerkin_place *at,
                     double grad[2][2], double stress[3]) {
    double u[2], own[2][2];
    const double q[2][2] = {{tip->along[0], tip->along[1]}, {-tip->along[1], tip->along[0]}};
    meshless_field_at(g, at, u, own);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            grad[i][j] = 0;
            for (int a = 0; a < 2; a++)
                for (int b = 0; b < 2; b++) grad[i][j] += q[i][a] * q[j][b] * own[a][b];
        }
    meshless_field_stress(g, grad, stress);
}

struct galerkin_intensity meshless_intensity_of(const struct galerkin *g, int number, double radius) {
    enum { POINTS = 8 };
    const struct galerkin_tip *tip = &g->tip[number];
    const struct physics_crack_tip material = material_of(&g->in);
    const double pi = acos(-1), inner = 0.5 * radius;
    const int sectors = 4 + (int)ceil(pi * radius / (0.5 * g->in.spacing)); /* a half circle's, two a spacing */
    const int layers = 1 + (int)ceil((radius - inner) / (0.5 * g->in.spacing));
    double x[POINTS], w[POINTS], mixed[3] = {0, 0, 0}, j = 0;
    meshless_cells_gauss(POINTS, x, w);
    for (int sector = -sectors; sector < sectors; sector++)
        for (int layer = 0; layer < layers; layer++)
            for (int a = 0; a < POINTS; a++)
                for (int b = 0; b < POINTS; b++) {
                    const double t = pi * (sector + x[a]) / sectors;
                    const double r = inner + (radius - inner) * (layer + x[b]) / layers;
                    const double area = w[a] * w[b] * r * pi / sectors * (radius - inner) / layers;
                    const double c = cos(t), s = sin(t);
                    struct galerkin_place at;
                    double grad[2][2], stress[3];
                    at.x[0] = at.see[0] = tip->x[0] + r * (c * tip->along[0] - s * tip->along[1]);
                    at.x[1] = at.see[1] = tip->x[1] + r * (c * tip->along[1] + s * tip->along[0]);
                    in_frame(g, tip, &at, grad, stress);
                    const double q[2] = {-c / (radius - inner), -s / (radius - inner)};
                    const double shear = grad[0][1] + grad[1][0];
                    const double energy = 0.5 * (stress[0] * grad[0][0] + stress[1] * grad[1][1] + stress[2] * shear);
                    j += area * ((stress[0] * grad[0][0] + stress[2] * grad[1][0] - energy) * q[0] +
                                 (stress[2] * grad[0][0] + stress[1] * grad[1][0]) * q[1]);
                    for (int mode = 0; mode < 3; mode++) {
                        double own[3], u[2], slope[2];
                        physics_crack_tip_field(&material, mode, r, t, own, u, slope);
                        const double work = own[0] * grad[0][0] + own[1] * grad[1][1] + own[2] * shear;
                        mixed[mode] +=
                            area *
                            ((stress[0] * slope[0] + stress[2] * slope[1] + own[0] * grad[0][0] + own[2] * grad[1][0] -
                              work) *
                                 q[0] +
                             (stress[2] * slope[0] + stress[1] * slope[1] + own[2] * grad[0][0] + own[1] * grad[1][0]) *
                                 q[1]);
                    }
                }
    const double modulus = physics_crack_tip_modulus(&material);
    return (struct galerkin_intensity){.k = {0.5 * modulus * mixed[0], 0.5 * modulus * mixed[1]},
                                       .j = j,
                                       .k_j = sqrt(fmax(j, 0) * modulus),
                                       .t = modulus * mixed[2]};
}
