/* Upper bounds of the eigenfrequencies of refined plates, for the stable step. */
#include "base/par.h"
#include "base/vec.h"
#include "solid/bonds/list.h"
#include "solid/bonds/store.h"
#include "solid/force/dilatation.h"
#include "solid/law/material.h"
#include "solid/refine/parts.h"

#include <math.h>

/* u.K u = 1/2 sum over bonds of k (e.(u_h - u_l))^2 <= 2 sum u_h.T_h u_h,  T_h = sum k e e. If the two halves of a bond
 * differ (one-sided horizons), it is an estimate only. beyond: the dilatation's energy over that of the family's bonds
 * without alpha is at most this (solid/force/dilatation.h). */
static double rate2_of(const struct solid_list *list, int i, double beyond) {
    vec xx = vec_set(0), yy = vec_set(0), xy = vec_set(0);
    for (long j = list->start[i]; j < list->end[i]; j += VEC_LANES) {
        const vec stiffness = vec_load(list->stiffness + j), x = vec_load_floats(solid_list_step(list, j, 0)),
                  y = vec_load_floats(solid_list_step(list, j, 1)), size = vec_absmax(stiffness, stiffness),
                  whole = beyond > 0 ? size + beyond * vec_load(list->plain + j) : size,
                  k = whole * vec_reciprocal(x * x + y * y);
        xx += k * x * x;
        yy += k * y * y;
        xy += k * x * y;
    }
    const double a = vec_sum(xx), b = vec_sum(yy);
    return (a + b + hypot(a - b, 2 * vec_sum(xy))) / list->spacing;
}

static double beyond_of(const struct solid *s, int h) {
    const struct solid_dilatation *d = s->dilatation;
    if (!d || !d->of_body[s->body[h]]) return 0;
    return fmax(d->excess[h] * 2 * s->dim * s->dim / d->full[h], 0);
}

double solid_refine_rate_bound(const struct solid *s) {
    double most = 0;
    for (int b = 0; b < s->in.bodies; b++) {
        const struct solid_list *list = s->family->list[b];
        for (int i = 0; i < list->n; i++) most = fmax(most, rate2_of(list, i, beyond_of(s, list->first + i)));
    }
    return par_max(most);
}

/* Of a wave exp(i k.x) on an endless lattice: the largest eigenvalue of
 *     sum K V/(rho |xi|) (1 - cos k.xi) e e + excess/rho f f,  f = n/M_0 sum K V e sin k.xi  (solid/force/dilatation.h)
 * here in spacings; the largest one over all waves is searched for in a quarter of the Brillouin zone. */
enum { WAVES = 48 };

struct lattice_bond {
    double xi[2], xx, yy, xy; /* spacings; k e e */
};

struct lattice {
    int n;
    double beyond; /* the factor of the dilatation's part, of sums of k |xi|^2 xi sin k.xi; 0: none */
    struct lattice_bond bond[SOLID_FAMILY_MAX];
};

static void bonds_of(struct lattice *to, const struct solid_bond_law *law, double horizon, double side) {
    const struct solid_end end = {side, horizon, side * side};
    const int reach = (int)(horizon / side + 1);
    to->n = 0;
    for (int j = -reach; j <= reach; j++)
        for (int i = -reach; i <= reach; i++) {
            const double xi[3] = {i * side, j * side, 0}, length2 = xi[0] * xi[0] + xi[1] * xi[1];
            if (length2 == 0 || to->n == SOLID_FAMILY_MAX || !solid_pair_exists(law, xi, &end, &end)) continue;
            const double k =
                solid_pair_of(law, xi, &end, &end).stiffness * end.volume / (law->density * length2 * sqrt(length2));
            to->bond[to->n++] =
                (struct lattice_bond){{xi[0], xi[1]}, k * xi[0] * xi[0], k * xi[1] * xi[1], k * xi[0] * xi[1]};
        }
}

/* The excess is k less the bonds' k_b = M_0/(2 n^2); M_0/rho = spacing unit sum k |xi|^4. */
static void dilate(struct lattice *l, const struct solid_cloud *cloud, double bulk_modulus) {
    double full = 0;
    for (int b = 0; b < l->n; b++) {
        const double *xi = l->bond[b].xi;
        full += (l->bond[b].xx + l->bond[b].yy) * (xi[0] * xi[0] + xi[1] * xi[1]);
    }
    const double of_bonds = cloud->law.density * cloud->spacing * cloud->unit * full / 8;
    l->beyond = (bulk_modulus / of_bonds - 1) / (2 * full);
}

static double of_wave(const struct lattice *l, double kx, double ky) {
    double xx = 0, yy = 0, xy = 0, fx = 0, fy = 0;
    for (int b = 0; b < l->n; b++) {
        const struct lattice_bond *bond = &l->bond[b];
        const double phase = kx * bond->xi[0] + ky * bond->xi[1], factor = 1 - cos(phase);
        xx += factor * bond->xx;
        yy += factor * bond->yy;
        xy += factor * bond->xy;
        if (l->beyond == 0) continue;
        fx += sin(phase) * (bond->xx + bond->yy) * bond->xi[0];
        fy += sin(phase) * (bond->xx + bond->yy) * bond->xi[1];
    }
    xx += l->beyond * fx * fx;
    yy += l->beyond * fy * fy;
    xy += l->beyond * fx * fy;
    return 0.5 * (xx + yy + hypot(xx - yy, 2 * xy));
}

double solid_refine_rate_lattice(const struct solid *s, int level) {
    double most = 0;
    struct lattice l;
    for (int b = 0; b < s->in.bodies; b++) {
        const struct solid_cloud *cloud = s->family->cloud[b];
        const struct solid_material *material = &s->in.material[s->in.body[b].material];
        const double horizon = s->refine->in.horizon_kept ? cloud->law.horizon : ldexp(cloud->law.horizon, -level),
                     side = ldexp(1, -level), unit = cloud->unit / (cloud->spacing * cloud->spacing);
        if (!solid_refine_plan_is_possible(s, b)) continue;
        bonds_of(&l, &cloud->law, horizon, side);
        l.beyond = 0;
        if (material->ratio_excess != 0)
            dilate(&l, cloud, solid_material_dilatation(s->in.model, material).bulk_modulus);
        for (int i = 0; l.n > 0 && i <= WAVES; i++)
            for (int j = 0; j <= WAVES; j++)
                most =
                    fmax(most, unit * cloud->spacing * of_wave(&l, M_PI / side * i / WAVES, M_PI / side * j / WAVES));
    }
    return most;
}
