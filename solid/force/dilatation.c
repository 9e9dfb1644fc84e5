/* The dilatation of the families, its pressure on their bonds, and its energy. */
#include "solid/force/dilatation.h"
#include "base/par_ghost.h"
#include "solid/bonds/interface.h"
#include "solid/bonds/breaks.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/soft.h"
#include "solid/force/absorbed.h"
#include "solid/force/dilatation_families.h"
#include "solid/force/dilatation_loss.h"
#include "solid/force/sweep_lattice.h"
#include "solid/force/sweep_list.h"
#include "solid/force/sweep_soft.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int has_excess(const struct solid_input *in, int b) {
    const struct solid_body *body = &in->body[b];
    int excess = in->material[body->material].ratio_excess != 0;
    for (int k = 0; k < body->image_materials; k++) excess |= in->material[body->image_material[k]].ratio_excess != 0;
    return excess;
}

int solid_dilatation_is(const struct solid_input *in, int b) {
    int beyond = has_excess(in, b);
    for (int other = 0; in->interfaces > 0 && other < in->bodies; other++)
        beyond |= solid_interface_joins(in, b, other) && has_excess(in, other);
    return beyond;
}

void solid_dilatation_new(struct solid *s) {
    const struct solid_family *f = s->family;
    const size_t owned = (size_t)s->n + 1;
    int any = 0;
    for (int b = 0; b < f->bodies; b++) any |= solid_dilatation_is(&s->in, b);
    if (!any || s->in.rigid) return;
    struct solid_dilatation *d = s->dilatation = memory_new(MEMORY_SOLID, 1, sizeof *d);
    d->of_body = memory_new(MEMORY_SOLID, (size_t)f->bodies, 1);
    d->extension = memory_new(MEMORY_SOLID, owned, sizeof *d->extension);
    d->full = memory_new(MEMORY_SOLID, owned, sizeof *d->full);
    d->excess = memory_new(MEMORY_SOLID, owned, sizeof *d->excess);
    d->pressure = memory_new(MEMORY_SOLID, owned + (size_t)s->n_ghost, sizeof *d->pressure);
    for (int c = 0; c < s->dim; c++) d->sum[c] = memory_new(MEMORY_SOLID, owned, sizeof *d->sum[c]);
    for (int b = 0; b < f->bodies; b++) {
        d->of_body[b] = (uint8_t)solid_dilatation_is(&s->in, b);
        if (!d->of_body[b]) continue;
        solid_dilatation_families(s, b, d->full, d->excess);
        if (f->lattice[b]) solid_lattice_pressure_new(f->lattice[b]);
        if (f->list[b]) solid_list_pressure_new(f->list[b]);
    }
}

void solid_dilatation_free(struct solid_dilatation *d) {
    if (!d) return;
    for (int c = 0; c < 3; c++) memory_free(d->sum[c]);
    MEMORY_FREE(d->of_body, d->extension, d->full, d->excess, d->pressure, d->loss, d);
}

void solid_dilatation_renew(struct solid *s) {
    solid_dilatation_free(s->dilatation);
    s->dilatation = NULL;
    solid_dilatation_new(s);
}

static int by_particle(const void *a, const void *b) {
    const struct solid_dilatation_loss *x = a, *y = b;
    return (x->h > y->h) - (x->h < y->h);
}

/* 1/2 excess (M/M_0) theta theta' of h with theta = n S/M, J/m3; S' and S'': sums at two states, N/m2. */
static double energy_of(const struct solid *s, int h, double first, double second, double m) {
    const struct solid_dilatation *d = s->dilatation;
    return m > 0 ? 0.5 * d->excess[h] * (s->dim * first) * (s->dim * second) / (m * d->full[h]) : 0;
}

/* The energy that the dilatation of h has absorbed up to now and loses with its n bonds that broke or softened, J. The
 * sums S and M are those of the bonds that are left. With S for all bonds and S' for those left, at the beginning (1)
 * and at the end (2) of a substep of Verlet, whose work is the mean of both ends' forces times the way, it is
 * proportional to S_1 S_2/M - S'_1 S'_2/M', otherwise to the same of the present values only (solid/force/absorbed.h).
 */
static double absorbed_of(const struct solid *s, int h, double sum, double m, const struct solid_dilatation_loss *loss,
                          int n) {
    double all = sum, lost_before = 0, whole = m;
    for (int k = 0; k < n; k++) {
        all += loss[k].stiffness * loss[k].now;
        lost_before += loss[k].stiffness * loss[k].before;
        whole += loss[k].stiffness;
    }
    const double all_before = solid_absorbed_is(s) ? s->dilatation->extension[h] : all,
                 left_before = solid_absorbed_is(s) ? all_before - lost_before : sum;
    return s->volume[h] * (energy_of(s, h, all_before, all, whole) - energy_of(s, h, left_before, sum, m));
}

static double density_of(const struct solid *s, int b) {
    const struct solid_family *f = s->family;
    return f->lattice[b] ? f->lattice[b]->law.density : f->list[b]->law.density * f->list[b]->spacing;
}

static void lose(struct solid *s) {
    struct solid_dilatation *d = s->dilatation;
    qsort(d->loss, (size_t)d->losses, sizeof *d->loss, by_particle);
    for (int i = 0, next; i < d->losses; i = next) {
        const int h = d->loss[i].h;
        const double density = density_of(s, s->body[h]);
        for (next = i + 1; next < d->losses && d->loss[next].h == h;) next++;
        const double energy = absorbed_of(s, h, density * d->sum[0][h], density * d->sum[1][h], &d->loss[i], next - i);
        s->e_fracture += energy;
        for (int k = i; k < next; k++) {
            const struct solid_dilatation_loss *loss = &d->loss[k];
            if (loss->soft >= 0)
                s->soft->bond[loss->soft].released += energy / (next - i);
            else if (s->breaks)
                solid_breaks_add(s, h, loss->l, loss->xi, energy / (next - i), 0);
        }
    }
    d->losses = 0;
}

/* P from the sums of the first pass. */
static void find(struct solid *s) {
    struct solid_dilatation *d = s->dilatation;
    const struct solid_family *f = s->family;
    for (int b = 0; b < f->bodies; b++) {
        const double density = d->of_body[b] ? density_of(s, b) : 0, n2 = s->dim * s->dim;
        for (int h = f->first[b]; d->of_body[b] && h < f->first[b + 1]; h++) {
            const double sum = d->sum[0][h], m = d->sum[1][h];
            d->extension[h] = density * sum;
            d->pressure[h] = m > 0 ? n2 * d->excess[h] / d->full[h] * (sum / m) : 0;
        }
    }
}

static void swap_sums(struct solid *s) {
    for (int c = 0; c < s->dim; c++) {
        double *const t = s->a[c];
        s->a[c] = s->dilatation->sum[c];
        s->dilatation->sum[c] = t;
    }
}

/* The first pass over the bodies that have one, from the exchange of the ghosts' d on. */
static void extend(struct solid *s, struct solid_sweep sweep) {
    const struct solid_family *f = s->family;
    sweep.part = SOLID_SWEEP_EXTENSIONS;
    swap_sums(s);
    for (int b = 0; b < f->bodies; b++)
        if (s->dilatation->of_body[b] && f->lattice[b]) solid_sweep_lattice_begin(s, f->lattice[b], &sweep);
    par_ghost_end(s->ghost);
    for (int b = 0; b < f->bodies; b++) {
        if (!s->dilatation->of_body[b]) continue;
        if (f->lattice[b])
            solid_sweep_lattice_end(s, f->lattice[b], &sweep);
        else
            solid_sweep_list(s, f->list[b], &sweep);
    }
    swap_sums(s);
    if (s->soft) solid_sweep_soft_extend(s, sweep.may_break, s->dilatation->sum[0], s->dilatation->sum[1]);
}

static void spread(const struct solid *s, int ghosts) {
    const struct solid_family *f = s->family;
    for (int b = 0; b < f->bodies; b++) {
        const struct solid_lattice *lattice = f->lattice[b];
        if (s->dilatation->of_body[b] && lattice)
            solid_lattice_pressure_set(lattice, ghosts ? 0 : lattice->ghosts,
                                       ghosts ? lattice->ghosts : lattice->copies, s->dilatation->pressure);
        if (s->dilatation->of_body[b] && !lattice && ghosts)
            solid_list_pressure_set(f->list[b], s->dilatation->pressure);
    }
}

double solid_dilatation_force(struct solid *s, struct solid_sweep sweep) {
    struct solid_dilatation *d = s->dilatation;
    const struct solid_family *f = s->family;
    struct solid_sweep pressed = sweep;
    double power = 0;
    extend(s, sweep);
    if (d->losses > 0) lose(s);
    find(s);
    par_ghost_begin(s->ghost, 1, &d->pressure, s->n);
    spread(s, 0);
    pressed.part = SOLID_SWEEP_PRESSED;
    pressed.may_break = 0;
    for (int b = 0; b < f->bodies; b++)
        if (f->lattice[b]) power += solid_sweep_lattice_begin(s, f->lattice[b], d->of_body[b] ? &pressed : &sweep);
    par_ghost_end(s->ghost);
    spread(s, 1);
    for (int b = 0; b < f->bodies; b++) {
        const struct solid_sweep *part = d->of_body[b] ? &pressed : &sweep;
        power +=
            f->lattice[b] ? solid_sweep_lattice_end(s, f->lattice[b], part) : solid_sweep_list(s, f->list[b], part);
    }
    return power;
}

/* The sums at the present d: [n] of particles of bodies with two passes; the other numbers are left as they are. */
static void sums(const struct solid *s, double *extension, double *weight) {
    const struct solid_dilatation *d = s->dilatation;
    const struct solid_family *f = s->family;
    const struct solid_sweep sweep = {.part = SOLID_SWEEP_EXTENSIONS, .is_measure = 1};
    struct solid to = *s; /* whose a is work */
    memcpy(to.a, d->sum, sizeof to.a);
    for (int b = 0; b < f->bodies; b++) {
        if (!d->of_body[b]) continue;
        if (f->lattice[b]) {
            solid_sweep_lattice_begin(&to, f->lattice[b], &sweep);
            solid_sweep_lattice_end(&to, f->lattice[b], &sweep);
        } else {
            solid_sweep_list(&to, f->list[b], &sweep);
        }
    }
    if (s->soft) solid_sweep_soft_extend(&to, 0, d->sum[0], d->sum[1]);
    for (int b = 0; b < f->bodies; b++) {
        const double density = d->of_body[b] ? density_of(s, b) : 0;
        for (int h = f->first[b]; d->of_body[b] && h < f->first[b + 1]; h++) {
            extension[h] = density * d->sum[0][h];
            weight[h] = density * d->sum[1][h];
        }
    }
}

void solid_dilatation_stress(const struct solid *s, double *stress) {
    double *sum = memory_new(MEMORY_SOLID, 2 * ((size_t)s->n + 1), sizeof *sum), *m = sum + s->n;
    sums(s, sum, m);
    for (int h = 0; h < s->n; h++) stress[h] = m[h] > 0 ? s->dilatation->excess[h] * s->dim * sum[h] / m[h] : 0;
    memory_free(sum);
}

double solid_dilatation_energy(const struct solid *s) {
    double all = 0;
    if (!s->dilatation) return 0;
    double *sum = memory_new(MEMORY_SOLID, 2 * ((size_t)s->n + 1), sizeof *sum), *m = sum + s->n;
    sums(s, sum, m);
    for (int h = 0; h < s->n; h++)
        if (m[h] > 0) all += s->volume[h] * energy_of(s, h, sum[h], sum[h], m[h]);
    memory_free(sum);
    return all;
}

double solid_dilatation_density(const struct solid *s, int h) {
    struct solid_family_view view;
    double sum = 0, m = 0;
    if (!s->dilatation || !s->dilatation->of_body[s->body[h]]) return 0;
    solid_family_view(s, h, &view);
    for (int b = 0; b < view.n; b++) {
        double xi2 = 0, q = 0;
        if (!view.intact[b]) continue;
        for (int c = 0; c < s->dim; c++) {
            const double xi = view.xi[b][c], eta = s->d[c][view.l[b]] - s->d[c][h];
            xi2 += xi * xi;
            q += eta * (xi + (xi + eta));
        }
        const double part = view.micro[b] * view.weight[b] * sqrt(xi2), eps = q / xi2;
        m += part;
        sum += part * eps / (1 + sqrt(1 + eps));
    }
    return energy_of(s, h, sum, sum, m);
}
