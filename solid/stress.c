#include "solid/family.h"
#include "solid/measures.h"
#include "solid/tensors.h"

#include <math.h>

static void add(double t[6], const double x[3], const double y[3], double w) {
    for (int c = 0; c < 3; c++) {
        const int k = (c + 1) % 3;
        t[c] += w * x[c] * y[c];
        t[3 + c] += 0.5 * w * (x[c] * y[k] + x[k] * y[c]);
    }
}

/* Flux of the bonds' forces: sigma = (1/2) sum lambda alpha c0 s zeta zeta^T/|zeta| Gamma V; symmetric in any deformation,
 * in the frame of space.  (Lehoucq & Silling 2008, for forces along the bonds) */
void solid_measure_stress(const struct solid *s, double (*stress)[6]) {
    struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        const double c0 = solid_micromodulus(&s->in.material[s->in.body[s->body[h]].material], s->in.spacing);
        double *t = stress[h];
        for (int k = 0; k < 6; k++) t[k] = 0;
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            if (!view.intact[b]) continue;
            double zeta[3], xi2 = 0, zeta2 = 0, q = 0;
            for (int c = 0; c < 3; c++) {
                const double xi = view.xi[b][c], eta = s->d[c][view.l[b]] - s->d[c][h];
                zeta[c] = xi + eta;
                xi2 += xi * xi;
                zeta2 += zeta[c] * zeta[c];
                q += eta * (xi + zeta[c]);
            }
            const double length = sqrt(xi2), now = sqrt(zeta2), stretch = q / (length * (now + length));
            if (now > 0) add(t, zeta, zeta, 0.5 * view.alpha[b] * c0 * stretch / now * view.weight[b]);
        }
    }
}

/* G = (sum w eta xi^T)(sum w xi xi^T)^-1 over intact bonds, w = Gamma V/|xi|^2: exact where the displacement is affine,
 * whatever is broken. */
static void gradient(const struct solid *s, int h, const struct solid_family_view *view, double g[3][3]) {
    double shape[6] = {0}, inverse[6], m[3][3] = {{0}};
    for (int b = 0; b < view->n; b++) {
        if (!view->intact[b]) continue;
        const double *xi = view->xi[b];
        const double w = view->weight[b] / (xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2]);
        add(shape, xi, xi, w);
        for (int i = 0; i < 3; i++) {
            const double eta = w * (s->d[i][view->l[b]] - s->d[i][h]);
            for (int j = 0; j < 3; j++) m[i][j] += eta * xi[j];
        }
    }
    solid_tensors_inverse(shape, 1e-6, inverse);
    const double k[3][3] = {{inverse[0], inverse[3], inverse[5]},
                            {inverse[3], inverse[1], inverse[4]},
                            {inverse[5], inverse[4], inverse[2]}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) g[i][j] = m[i][0] * k[0][j] + m[i][1] * k[1][j] + m[i][2] * k[2][j];
}

/* Green's strain (G + G^T + G^T G)/2 in the undeformed frame: nothing under rigid rotation, however large, and the small
 * strain where displacements are small. A family that leaves a direction without bonds has no strain in it. */
void solid_measure_strain(const struct solid *s, double (*strain)[6]) {
    struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        double g[3][3];
        solid_family_view(s, h, &view);
        gradient(s, h, &view, g);
        for (int c = 0; c < 3; c++) {
            const int k = (c + 1) % 3;
            strain[h][c] = g[c][c];
            strain[h][3 + c] = 0.5 * (g[c][k] + g[k][c]);
            for (int i = 0; i < 3; i++) {
                strain[h][c] += 0.5 * g[i][c] * g[i][c];
                strain[h][3 + c] += 0.5 * g[i][c] * g[i][k];
            }
        }
    }
}
