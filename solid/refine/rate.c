/* Upper bounds of the eigenfrequencies of refined plates, for the stable step. */
#include "base/par.h"
#include "solid/bonds/list.h"
#include "solid/bonds/store.h"
#include "solid/imposed/constraint.h"
#include "solid/refine/parts.h"

#include <math.h>

/* u.K u = 1/2 sum over bonds of k (e.(u_h - u_l))^2 <= 2 sum u_h.T_h u_h,  T_h = sum k e e. If the two halves of a bond
 * differ (one-sided horizons), it is an estimate only. */
static double rate2_of(const struct solid_list *list, int i) {
    vec xx = vec_set(0), yy = vec_set(0), xy = vec_set(0);
    for (long j = list->start[i]; j < list->end[i]; j += VEC_LANES) {
        const vec stiffness = vec_load(list->stiffness + j), x = vec_load_floats(solid_list_step(list, j, 0)),
                  y = vec_load_floats(solid_list_step(list, j, 1)),
                  k = vec_absmax(stiffness, stiffness) * vec_reciprocal(x * x + y * y);
        xx += k * x * x;
        yy += k * y * y;
        xy += k * x * y;
    }
    const double a = vec_sum(xx), b = vec_sum(yy);
    return (a + b + hypot(a - b, 2 * vec_sum(xy))) / list->spacing;
}

double solid_refine_rate_bound(const struct solid *s) {
    double most = 0;
    for (int b = 0; b < s->in.bodies; b++)
        for (int i = 0; i < s->family->list[b]->n; i++) most = fmax(most, rate2_of(s->family->list[b], i));
    return par_max(most);
}

/* Of a wave exp(i k.x) on an endless lattice: the largest eigenvalue of sum K V/(rho |xi|) (1 - cos k.xi) e e, here in
 * spacings; the largest one over all waves is searched for in a quarter of the Brillouin zone. */
enum { WAVES = 48 };

struct lattice_bond {
    double xi[2], xx, yy, xy; /* spacings; k e e */
};

static int bonds_of(const struct solid_bond_law *law, double horizon, double side, struct lattice_bond *bond) {
    const struct solid_end end = {side, horizon, side * side};
    const int reach = (int)(horizon / side + 1);
    int n = 0;
    for (int j = -reach; j <= reach; j++)
        for (int i = -reach; i <= reach; i++) {
            const double xi[3] = {i * side, j * side, 0}, length2 = xi[0] * xi[0] + xi[1] * xi[1];
            if (length2 == 0 || n == SOLID_FAMILY_MAX || !solid_pair_exists(law, xi, &end, &end)) continue;
            const double k =
                solid_pair_of(law, xi, &end, &end).stiffness * end.volume / (law->density * length2 * sqrt(length2));
            bond[n++] = (struct lattice_bond){{xi[0], xi[1]}, k * xi[0] * xi[0], k * xi[1] * xi[1], k * xi[0] * xi[1]};
        }
    return n;
}

static double of_wave(const struct lattice_bond *bond, int n, double kx, double ky) {
    double xx = 0, yy = 0, xy = 0;
    for (int b = 0; b < n; b++) {
        const double factor = 1 - cos(kx * bond[b].xi[0] + ky * bond[b].xi[1]);
        xx += factor * bond[b].xx;
        yy += factor * bond[b].yy;
        xy += factor * bond[b].xy;
    }
    return 0.5 * (xx + yy + hypot(xx - yy, 2 * xy));
}

double solid_refine_rate_lattice(const struct solid *s, int level) {
    double most = 0;
    struct lattice_bond bond[SOLID_FAMILY_MAX];
    for (int b = 0; b < s->in.bodies; b++) {
        const struct solid_cloud *cloud = s->family->cloud[b];
        const double horizon = s->refine->in.horizon_kept ? cloud->law.horizon : ldexp(cloud->law.horizon, -level),
                     side = ldexp(1, -level), unit = cloud->unit / (cloud->spacing * cloud->spacing);
        const int n = solid_refine_plan_is_possible(s, b) ? bonds_of(&cloud->law, horizon, side, bond) : 0;
        for (int i = 0; n > 0 && i <= WAVES; i++)
            for (int j = 0; j <= WAVES; j++)
                most = fmax(most,
                            unit * cloud->spacing * of_wave(bond, n, M_PI / side * i / WAVES, M_PI / side * j / WAVES));
    }
    return most;
}
