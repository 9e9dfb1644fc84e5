/* The bond that is nearest to its limit. */
#include "solid/measure/reach.h"
#include "base/par.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/list.h"
#include "solid/bonds/materials.h"

#include <math.h>
#include <string.h>

static double stretch_of(double eps) { return eps / (1 + sqrt(1 + eps)); }

/* Stretch at which bond b of h's view breaks or begins to soften. */
static double limit_of(const struct solid *s, int h, const struct solid_family_view *view, int b) {
    const int body = s->body[h];
    const struct solid_list *list = s->family->list[body];
    const double eps = list ? solid_list_limit(list, h, list->start[h - list->first] + b)
                            : solid_materials_law(s->family->lattice[body], h, view->l[b])->eps_limit;
    return isfinite(eps) ? stretch_of(eps) : INFINITY;
}

static double part_of(const struct solid *s, int h, const struct solid_family_view *view, int b) {
    double xi2 = 0, q = 0;
    for (int c = 0; c < s->dim; c++) {
        const double xi = view->xi[b][c], eta = s->d[c][view->l[b]] - s->d[c][h];
        xi2 += xi * xi;
        q += eta * (xi + (xi + eta));
    }
    return stretch_of(q / xi2) / limit_of(s, h, view, b);
}

static double modulus_of(const struct solid *s, int h) {
    return s->in.material[solid_particle_material(s, h)].youngs_modulus;
}

static int softens(const struct solid *s, int h) {
    return s->in.material[solid_particle_material(s, h)].tensile_strength > 0;
}

static struct solid_reach of_all_ranks(const struct solid_reach *own, double beyond) {
    const double part = par_max(own->part);
    double of_it[3] = {0};
    if (own->part == part) memcpy(of_it, (const double[3]){own->critical, own->modulus, own->softens}, sizeof of_it);
    par_max_array(of_it, 3);
    return (struct solid_reach){part, of_it[0], of_it[1], lround(par_sum(beyond)), of_it[2] > 0};
}

struct solid_reach solid_reach_find(struct solid *s) {
    struct solid_reach most = {.part = 0};
    double beyond = 0;
    if (s->in.limit) return most;
    solid_ghosts_update(s);
    for (int h = 0; h < s->n; h++) {
        struct solid_family_view view;
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            const int l = view.l[b];
            if (!view.intact[b] || ((s->flag[h] | s->flag[l]) & SOLID_UNBREAKABLE)) continue;
            const double part = part_of(s, h, &view, b);
            beyond += 0.5 * (part > 1);
            if (!(part > most.part)) continue;
            most = (struct solid_reach){.part = part,
                                        .critical = limit_of(s, h, &view, b),
                                        .modulus = fmin(modulus_of(s, h), modulus_of(s, l)),
                                        .softens = softens(s, h)};
        }
    }
    return of_all_ranks(&most, beyond);
}
