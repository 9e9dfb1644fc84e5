/* Stress from the flux of bond forces and strain by least squares over the family.  (Lehoucq and Silling 2008) */
#include "solid/bonds/family.h"
#include "solid/bonds/materials.h"
#include "solid/bonds/row.h"
#include "solid/bonds/soft.h"
#include "solid/force/dilatation.h"
#include "solid/law/material.h"
#include "solid/measure/share.h"
#include "solid/measure/stress.h"
#include "solid/measure/tensors.h"

#include <math.h>
#include <string.h>

#define REAL vec
#define OF(op) vec_##op
#define NAME(name) stress_##name
#include "solid/force/series_of.h"

/* 1: no particle known to this rank is displaced, so that there is neither stress nor strain: a solid at rest at the
 * beginning of a run. */
static int is_undeformed(const struct solid *s) {
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n + s->n_ghost; h++)
            if (s->d[c][h] != 0) return 0;
    return 1;
}

static void add(double t[6], const double x[3], const double y[3], double w) {
    for (int c = 0; c < 3; c++) {
        const int k = (c + 1) % 3;
        t[c] += w * x[c] * y[c];
        t[3 + c] += 0.5 * w * (x[c] * y[k] + x[k] * y[c]);
    }
}

static double ratio_of(const struct solid *s, int h) {
    return solid_material_poisson_ratio(s->in.model, &s->in.material[solid_particle_material(s, h)]);
}

/* Adds excess theta, which is isotropic in the spatial frame (solid/force/dilatation.h). */
static void add_dilatation(const struct solid *s, double (*stress)[6]) {
    double *pressure = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof *pressure);
    solid_dilatation_stress(s, pressure);
    for (int h = 0; h < s->n; h++) {
        for (int c = 0; c < s->dim; c++) stress[h][c] += pressure[h];
        if (s->in.model == PHYSICS_PLANE_STRAIN) stress[h][2] += 2 * ratio_of(s, h) * pressure[h];
    }
    memory_free(pressure);
}

/* Flux of the bonds' forces: sigma = (1/2) sum lambda alpha c0 s zeta zeta^T/|zeta| Gamma V; symmetric in any
 * deformation, in the spatial frame.  (Lehoucq & Silling 2008, for forces along the bonds) Divided by the family's
 * share (solid/measure/share.h), so that a particle at a surface reads what one inside does. */
static void stress_of_view(const struct solid *s, int h, const struct solid_family_view *view,
                           const struct solid_share_full *full, double t[6]) {
    double still[6] = {0}; /* the same with xi in place of zeta */
    for (int k = 0; k < 6; k++) t[k] = 0;
    for (int b = 0; b < view->n; b++) {
        if (!view->intact[b]) continue;
        double zeta[3] = {0}, xi2 = 0, zeta2 = 0, q = 0;
        for (int c = 0; c < s->dim; c++) {
            const double xi = view->xi[b][c], eta = s->d[c][view->l[b]] - s->d[c][h];
            zeta[c] = xi + eta;
            xi2 += xi * xi;
            zeta2 += zeta[c] * zeta[c];
            q += eta * (xi + zeta[c]);
        }
        const double length = sqrt(xi2), now = sqrt(zeta2), stretch = q / (length * (now + length));
        const double force = 0.5 * view->alpha[b] * view->micro[b] * stretch * view->weight[b];
        if (now > 0) add(t, zeta, zeta, force / now);
        add(still, view->xi[b], view->xi[b], force / length);
    }
    const double share = solid_share_view(full, view, still);
    for (int k = 0; k < 6; k++) t[k] /= share;
    if (s->in.model == PHYSICS_PLANE_STRAIN) t[2] = ratio_of(s, h) * (t[0] + t[1]);
}

/* The same for families of a row, over half the density and not yet divided by their shares: s/|zeta| = g(eps)/|xi|.
 * still, not for families inside: its force is s/|xi| = (1 + eps)(1 - g) times that, as 1/(1 + s) = 1 - g. At eps = -1,
 * where both particles are at one place, the flux is 0. */
static inline __attribute__((always_inline)) void stress_of_row(const struct solid_row *row, const double (*square)[6],
                                                                const int inside, vec t[6], vec still[6]) {
    for (int k = 0; k < 6; k++) t[k] = still[k] = vec_set(0);
    for (const uint16_t *bond = row->bond; bond < row->end; bond++) {
        const int o = *bond;
        const struct solid_lattice_offset *from = &row->t->offset[o];
        vec z[3];
        solid_row_eta(row, o, z);
        const vec eps = vec_max(vec_where(solid_row_lambda(row, o), solid_row_eps(row, o, z)), vec_set(-1 + 1e-15)),
                  g = stress_g_times(eps, vec_set(1), SERIES_LONG); /* broken bonds, whose eps may be large: 0 */
        vec f = g * (from->elastic * solid_row_alpha(row, o));
        if (row->t->materials)
            f *= vec_load(row->t->materials->half + solid_lattice_place(row->t, row->cell)) +
                 vec_load(row->t->materials->half + solid_lattice_place(row->t, row->cell + from->shift));
        for (int c = 0; c < 3; c++) z[c] += from->xi[c];
        for (int c = 0; c < 3; c++) {
            const vec along = f * z[c];
            t[c] += along * z[c];
            t[3 + c] += along * z[(c + 1) % 3];
        }
        const vec at_rest = f * ((1 + eps) * (1 - g));
        for (int k = 0; k < 6 && !inside; k++) still[k] += at_rest * square[o][k];
    }
}

/* Whether all families of a row are full and uncorrected. */
static int is_inside(const struct solid *s, const struct solid_lattice *lattice, int r) {
    int inside = lattice->row_bulk[r];
    for (int i = 0; inside && i < __builtin_popcount(lattice->row_owned[r]); i++)
        inside = s->family_volume[lattice->row_first[r] + i] == lattice->stencil->full_volume;
    return inside;
}

static void stress_of_lattice(const struct solid *s, const struct solid_lattice *lattice, double (*stress)[6]) {
    const struct solid_share_full full = solid_share_of_lattice(lattice);
    const vec half_density = vec_set(0.5 * lattice->law.density);
    double square[SOLID_FAMILY_MAX][6];
    uint8_t made[SOLID_FAMILY_MAX]; /* the unbroken families, whatever has broken */
    struct solid_family_view view;
    solid_row_squares(lattice, square);
    solid_row_begin(s, lattice);
    for (int r = 0; r < lattice->rows; r++) {
        const int inside = is_inside(s, lattice, r);
        if (!inside) solid_lattice_initial_bonds(lattice, r, made);
        for (int first = 0; first < SOLID_ROW; first += VEC_LANES) {
            const struct solid_row row = solid_row_of(lattice, r, first);
            vec sum[6], still[6], scale = half_density;
            if (inside) {
                stress_of_row(&row, square, 1, sum, still);
            } else {
                stress_of_row(&row, square, 0, sum, still);
                scale /= solid_share_row(&full, &row, made, square, still);
            }
            for (int k = 0; k < 6; k++) solid_row_put(&row, sum[k] * scale, &stress[lattice->row_first[r]][k], 6);
        }
    }
    /* a lattice's rows know only whether a bond is intact, not how stiff a softening one is */
    for (int i = 0, h = -1; s->soft && i < s->soft->n; i++) {
        if (s->soft->bond[i].h == h || s->family->lattice[s->body[s->soft->bond[i].h]] != lattice) continue;
        h = s->soft->bond[i].h;
        solid_family_view(s, h, &view);
        stress_of_view(s, h, &view, &full, stress[h]);
    }
}

static void stress_of_list(const struct solid *s, const struct solid_list *list, double (*stress)[6]) {
    struct solid_share_full full = {0};
    struct solid_family_view view;
    for (int i = 0; i < list->n; i++) {
        full = solid_share_of_list(list, i, &full);
        solid_family_view(s, list->first + i, &view);
        stress_of_view(s, list->first + i, &view, &full, stress[list->first + i]);
    }
}

void solid_stress_measure(const struct solid *s, double (*stress)[6]) {
    if (is_undeformed(s)) {
        memset(stress, 0, (size_t)s->n * sizeof *stress);
        return;
    }
    for (int b = 0; b < s->family->bodies; b++) {
        if (s->family->lattice[b])
            stress_of_lattice(s, s->family->lattice[b], stress);
        else
            stress_of_list(s, s->family->list[b], stress);
    }
    if (s->dilatation) add_dilatation(s, stress);
}

/* G = (sum w eta xi^T)(sum w xi xi^T)^-1 over intact bonds, w = Gamma V/|xi|^2: exact for an affine displacement,
 * whichever bonds are broken. The two sums of as many particles as a vec has lanes; mixed[i][j]: eta_i xi_j. */
struct moments {
    vec shape[6], mixed[3][3];
};

static void moments_of_view(const struct solid *s, int h, const struct solid_family_view *view, struct moments *m,
                            int lane) {
    double shape[6] = {0}, mixed[3][3] = {{0}};
    for (int b = 0; b < view->n; b++) {
        if (!view->intact[b]) continue;
        const double *xi = view->xi[b];
        const double w = view->weight[b] / (xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2]);
        add(shape, xi, xi, w);
        for (int i = 0; i < s->dim; i++) {
            const double eta = w * (s->d[i][view->l[b]] - s->d[i][h]);
            for (int j = 0; j < 3; j++) mixed[i][j] += eta * xi[j];
        }
    }
    for (int k = 0; k < 6; k++) m->shape[k][lane] = shape[k];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) m->mixed[i][j][lane] = mixed[i][j];
}

static void moments_of_row(const struct solid_row *row, const double (*square)[6], struct moments *m) {
    vec shape[6], mixed[3][3];
    for (int k = 0; k < 6; k++) shape[k] = vec_set(0);
    memset(mixed, 0, sizeof mixed);
    for (const uint16_t *bond = row->bond; bond < row->end; bond++) {
        const struct solid_offset *from = &row->t->stencil->offset[*bond];
        const vec w = vec_where(solid_row_lambda(row, *bond), vec_set(from->weight * from->inv_length2));
        vec eta[3];
        solid_row_eta(row, *bond, eta);
        for (int k = 0; k < 6; k++) shape[k] += w * square[*bond][k];
        for (int i = 0; i < 3; i++) {
            const vec weighted = w * eta[i];
            for (int j = 0; j < 3; j++) mixed[i][j] += weighted * from->xi[j];
        }
    }
    memcpy(m->shape, shape, sizeof shape);
    memcpy(m->mixed, mixed, sizeof mixed);
}

/* Green's strain (G + G^T + G^T G)/2 in the undeformed frame: zero under any rigid rotation, and the small strain if
 * displacements are small. If a family has no bonds in a direction, its strain in that direction is 0. */
static void strain_of(const struct moments *m, vec strain[6]) {
    vec inverse[6], g[3][3];
    solid_tensors_inverse(m->shape, 1e-6, inverse);
    const vec k[3][3] = {{inverse[0], inverse[3], inverse[5]},
                         {inverse[3], inverse[1], inverse[4]},
                         {inverse[5], inverse[4], inverse[2]}};
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            g[i][j] = m->mixed[i][0] * k[0][j] + m->mixed[i][1] * k[1][j] + m->mixed[i][2] * k[2][j];
    for (int c = 0; c < 3; c++) {
        const int e = (c + 1) % 3;
        strain[c] = g[c][c];
        strain[3 + c] = 0.5 * (g[c][e] + g[e][c]);
        for (int i = 0; i < 3; i++) {
            strain[c] += 0.5 * g[i][c] * g[i][c];
            strain[3 + c] += 0.5 * g[i][c] * g[i][e];
        }
    }
}

/* The strain across a plate in plane stress over the sum of those in it. */
static double thinner(const struct solid *s, int h) {
    const double nu = ratio_of(s, h);
    return s->dilatation ? -nu / (1 - nu) : -0.5;
}

/* The strain of particles h .. h+n-1 of a body in the list store, at most as many as a vec has lanes. */
static void strain_of_some(const struct solid *s, int h, int n, double (*strain)[6]) {
    struct solid_family_view view;
    struct moments m;
    vec strains[6];
    memset(&m, 0, sizeof m);
    for (int i = 0; i < n; i++) {
        solid_family_view(s, h + i, &view);
        moments_of_view(s, h + i, &view, &m, i);
    }
    strain_of(&m, strains);
    if (s->in.model == PHYSICS_PLANE_STRESS) strains[2] = thinner(s, h) * (strains[0] + strains[1]);
    for (int i = 0; i < n; i++)
        for (int k = 0; k < 6; k++) strain[h + i][k] = strains[k][i];
}

void solid_stress_strain(const struct solid *s, double (*strain)[6]) {
    struct moments m;
    vec strains[6];
    if (is_undeformed(s)) {
        memset(strain, 0, (size_t)s->n * sizeof *strain);
        return;
    }
    for (int b = 0; b < s->family->bodies; b++) {
        const struct solid_lattice *lattice = s->family->lattice[b];
        const int end = s->family->first[b + 1];
        double square[SOLID_FAMILY_MAX][6];
        if (lattice) solid_row_squares(lattice, square);
        if (lattice) solid_row_begin(s, lattice);
        for (int r = 0; lattice && r < lattice->rows; r++)
            for (int first = 0; first < SOLID_ROW; first += VEC_LANES) {
                const struct solid_row row = solid_row_of(lattice, r, first);
                moments_of_row(&row, square, &m);
                strain_of(&m, strains);
                for (int k = 0; k < 6; k++) solid_row_put(&row, strains[k], &strain[lattice->row_first[r]][k], 6);
            }
        for (int h = s->family->first[b]; !lattice && h < end; h += VEC_LANES)
            strain_of_some(s, h, end - h < VEC_LANES ? end - h : VEC_LANES, strain);
    }
}
