/* Strain, kinetic and contact energy; energy and largest stretch of each particle's bonds.  (001: eq. 3.23) */
#include "base/par.h"
#include "solid/bonds/family.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/list.h"
#include "solid/bonds/soft.h"
#include "solid/contact/contact.h"
#include "solid/force/dilatation.h"
#include "solid/force/strain.h"
#include "solid/imposed/walls.h"
#include "solid/measure/energy.h"

#include <math.h>

/* Stretch of the b-th bond of h:  s = eps/(1 + sqrt(1 + eps)),  eps = (2 xi.eta + eta.eta)/|xi|^2 */
static double stretch_of(const struct solid *s, int h, const struct solid_family_view *view, int b, double *length) {
    double xi2 = 0, q = 0;
    for (int c = 0; c < s->dim; c++) {
        const double xi = view->xi[b][c], eta = s->d[c][view->l[b]] - s->d[c][h];
        xi2 += xi * xi;
        q += eta * (xi + (xi + eta));
    }
    const double eps = q / xi2;
    *length = sqrt(xi2);
    return eps / (1 + sqrt(1 + eps));
}

/* Half of the energy in each of h's bonds, (1/2) alpha c s^2 |xi| Gamma V_l V_h, divided by V_h, J/m3.  (001: eq.
 * 3.23) */
static double of_view(const struct solid *s, int h, const struct solid_family_view *view) {
    double sum = 0;
    for (int b = 0; b < view->n; b++) {
        if (!view->intact[b]) continue;
        double length;
        const double stretch = stretch_of(s, h, view, b, &length);
        sum += view->alpha[b] * view->micro[b] * stretch * stretch * length * view->weight[b];
    }
    return 0.25 * sum;
}

/* The same for the i-th particle of a list, whose stiffness is alpha c Gamma V_l/(rho |xi|) with |xi| in spacings.
 * *most: the largest stretch, -1 without an intact bond. */
static double of_bonds(const struct solid *s, const struct solid_list *list, int i, double *most) {
    const double scale = 1 / list->spacing;
    double sum = 0;
    *most = -1;
    for (long j = list->start[i]; j < list->end[i]; j++) {
        if (!solid_list_is_intact(list, j)) continue;
        const int h = list->first + i, l = solid_list_other(list, j);
        double xi[3], q = 0;
        const double length = solid_list_steps(list, j, xi), xi2 = length * length;
        for (int c = 0; c < list->dim; c++) {
            const double eta = scale * (s->d[c][l] - s->d[c][h]);
            q += eta * (xi[c] + (xi[c] + eta));
        }
        const double eps = q / xi2, stretch = eps / (1 + sqrt(1 + eps));
        *most = fmax(*most, stretch);
        double stiffness = list->stiffness[j];
        if (solid_list_is_soft(list, j)) stiffness *= -solid_soft_share(s, h, (int)(j - list->start[i]));
        sum += stiffness * xi2 * stretch * stretch;
    }
    return 0.25 * list->law.density * list->spacing * sum;
}

/* J, of the particles from .. to - 1. */
static double kinetic_of(const struct solid *s, int from, int to) {
    const double *restrict volume = s->volume;
    double sum = 0;
    for (int h = from, end; h < to; h = end) {
        double part = 0;
        end = solid_density_end(s, h, to);
        for (int i = h; i < end; i++) {
            double v2 = 0;
            for (int c = 0; c < s->dim; c++) v2 += s->v[c][i] * s->v[c][i];
            part += volume[i] * v2;
        }
        sum += 0.5 * solid_density(s, h) * part;
    }
    return sum;
}

struct solid_energy solid_energy_measure(struct solid *s) {
    enum { KINETIC, STRAIN, DAMPED, FRACTURE, WALLS, SUMS };
    double sum[SUMS] = {[DAMPED] = s->e_damped, [FRACTURE] = s->e_fracture};
    solid_ghosts_update(s);
    for (int b = 0; b < s->family->bodies; b++)
        sum[KINETIC] += kinetic_of(s, s->family->first[b], s->family->first[b + 1]);
    sum[STRAIN] = solid_strain_energy(s);
    solid_walls_list(s);
    sum[WALLS] = solid_walls_energy(s);
    par_sum_array(sum, SUMS);
    struct solid_energy e = {.kinetic = sum[KINETIC],
                             .strain = sum[STRAIN],
                             .contact = s->in.contact ? solid_contact_force_energy(s) : 0,
                             .damped = sum[DAMPED],
                             .fracture = sum[FRACTURE]};
    if (s->balance) e.damped -= e.strain + e.fracture;
    if (s->balance == SOLID_BALANCE_CONTACT) e.damped -= e.contact;
    e.contact += sum[WALLS];
    return e;
}

void solid_energy_bonds_of(const struct solid *s, int h, double *energy, double *stretch) {
    struct solid_family_view view;
    double length;
    const struct solid_list *list = s->family->list[s->body[h]];
    if (list) {
        *energy = of_bonds(s, list, h - list->first, stretch) + solid_dilatation_density(s, h);
        return;
    }
    solid_family_view(s, h, &view);
    *energy = of_view(s, h, &view) + solid_dilatation_density(s, h);
    *stretch = -1;
    for (int b = 0; b < view.n; b++)
        if (view.intact[b]) *stretch = fmax(*stretch, stretch_of(s, h, &view, b, &length));
}

void solid_energy_bonds(const struct solid *s, double *energy, double *stretch) {
    for (int h = 0; h < s->n; h++) solid_energy_bonds_of(s, h, &energy[h], &stretch[h]);
}
