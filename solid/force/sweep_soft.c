/* Force sweep over the bonds that soften: history, breaking, forces, energy. */
#include "solid/force/sweep_soft.h"
#include "base/ensure.h"
#include "solid/bonds/breaks.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/force/absorbed.h"
#include "solid/force/dilatation.h"
#include "solid/force/dilatation_loss.h"
#include "solid/law/material.h"
#include "solid/law/softening.h"

#include <math.h>
#include <string.h>

/* eps and stretch of a bond now. All signs are opposite at the other end, and nothing else differs: both ends get the
 * same values to the bit. */
struct extension {
    double zeta[3], eps, stretch;
};

static struct extension extension_of(const struct solid *s, const struct solid_soft_bond *bond) {
    struct extension e = {{0}, 0, 0};
    for (int c = 0; c < s->dim; c++) {
        const double eta = s->d[c][bond->l] - s->d[c][bond->h];
        e.zeta[c] = bond->xi[c] + eta;
        e.eps += eta * (bond->xi[c] + e.zeta[c]);
    }
    e.eps /= bond->length * bond->length;
    e.stretch = e.eps / (1 + sqrt(1 + e.eps));
    return e;
}

/* Of one end's half of the bond at full stiffness, J; stretch2: the square of its stretch. */
static double energy_of(const struct solid *s, const struct solid_soft_bond *bond, double stretch2) {
    return 0.25 * bond->elastic * stretch2 * bond->length * s->volume[bond->h];
}

/* What stands for the square of the stretch in the energy that a bond releases while its largest stretch rises to
 * `now`. With s and share of the stiffness f, the energy under the law is 1/2 k (s_1 s_2)(f_1 - f_2). In a substep of
 * Verlet s_1 is the stretch at its beginning, which may be less than the largest: the mean of both ends' forces times
 * the way is the gain of the bond's energy and this (solid/force/absorbed.h). RK3 goes the whole step on the old
 * secant, and the stiffness is lowered at its end: 1/2 k s_2^2 (f_1 - f_2). So it is where a stage begins with bonds
 * beyond their limits, after one that let none soften or an initial displacement. Between states of rest it is the
 * energy under the law, up to s_c, whatever the integrator of other stages: what is beyond it the relaxation takes. */
static double square_of(const struct solid *s, const struct solid_soft_bond *bond, double now, double s_c) {
    if (s->is_quasi_static) return bond->most * fmin(now, s_c);
    switch (s->stage.integrator) {
    case SOLID_RK3:
        return now * now;
    case SOLID_VERLET:
        if (!solid_absorbed_is(s)) return now * now;
        return solid_absorbed_fraction(s, bond->h, bond->l, bond->xi, now) * now * now;
    }
    ENSURE(0, "integrator %d", (int)s->stage.integrator);
}

/* Raises the history to the present stretch. Returns the share of the stiffness that is left. */
static double bring_up(struct solid *s, struct solid_soft_bond *bond, double stretch, double s_e, double s_c) {
    const double before = solid_softening_share(s_e, s_c, bond->most);
    if (!(stretch > bond->most)) return before;
    const double now = solid_softening_share(s_e, s_c, stretch);
    const double energy = energy_of(s, bond, square_of(s, bond, stretch, s_c)) * (before - now);
    bond->most = stretch;
    s->e_fracture += energy;
    bond->released += energy;
    return now;
}

/* Sums of at most SOLID_FAMILY_MAX numbers that do not depend on their order: rounded to a common digit, which leaves
 * room for the sum within 53 bits. (So are the families' sums in a plate, solid/force/sweep_family.h.) */
struct sums {
    int n;
    double part[SOLID_FAMILY_MAX][3];
    double largest[3];
};

static double sum_of(const struct sums *sums, int c, double largest) {
    int power;
    double sum = 0;
    (void)frexp(largest, &power);
    double headroom = 1.5;
    while (headroom < sums->n) headroom *= 2;
    const double shift = ldexp(2 * headroom, power);
    for (int k = 0; k < sums->n; k++) sum += (sums->part[k][c] + shift) - shift;
    return sum;
}

static void add_part(const struct solid_soft_bond *bond, const double part[3], struct sums *sums) {
    ENSURE(sums->n < SOLID_FAMILY_MAX, "particle %d has too many softening bonds", bond->h);
    for (int c = 0; c < 3; c++) {
        sums->part[sums->n][c] = part[c];
        sums->largest[c] = fmax(sums->largest[c], fabs(part[c]));
    }
    sums->n++;
}

static int is_dilated(const struct solid *s, int h) { return s->dilatation && s->dilatation->of_body[s->body[h]]; }

/* P of both ends of the bond times its stiffness without alpha, over its length now, N/m4. */
static double pressed(const struct solid *s, const struct solid_soft_bond *bond, const struct extension *e) {
    const double *pressure = s->dilatation->pressure;
    const double length2 = bond->length * bond->length;
    return solid_soft_plain(s, bond) * (pressure[bond->h] + pressure[bond->l]) / (length2 * (1 + e->stretch));
}

/* Adds the bond's force on h per volume to the sums; returns the power of its damping per volume. */
static double push(const struct solid *s, const struct solid_soft_bond *bond, const struct extension *e, double share,
                   double damping, struct sums *sums) {
    double along = share * bond->elastic * e->stretch / (bond->length * (1 + e->stretch)), power = 0;
    if (is_dilated(s, bond->h)) along += share * pressed(s, bond, e);
    if (damping > 0) {
        double closing = 0;
        for (int c = 0; c < s->dim; c++) closing += (s->v[c][bond->l] - s->v[c][bond->h]) * e->zeta[c];
        const double viscous = share * damping * bond->weight / (bond->length * bond->length) * closing / (1 + e->eps);
        power = viscous * closing;
        along += viscous;
    }
    add_part(bond, (double[]){along * e->zeta[0], along * e->zeta[1], along * e->zeta[2]}, sums);
    return power;
}

static double bonds_energy_of(const struct solid *s, int h) {
    return solid_material_bonds_energy(s->in.model, &s->in.material[s->in.body[s->body[h]].material]);
}

static void tear(struct solid *s, const struct solid_soft_bond *bond, double s_e, double s_c) {
    const double area = energy_of(s, bond, s_e * s_c) / bonds_energy_of(s, bond->h);
    s->crack_area += area;
    if (s->breaks) solid_breaks_add(s, bond->h, bond->l, bond->xi, bond->released, area);
    solid_soft_break(s, bond);
}

/* The bonds of h: no part yet, and the two stretches of the law. */
static void begin(const struct solid *s, int h, struct sums *sums, double *s_e, double *s_c) {
    sums->n = 0;
    memset(sums->largest, 0, sizeof sums->largest);
    solid_soft_limits(s, h, s_e, s_c);
}

double solid_sweep_soft(struct solid *s, const struct solid_sweep *sweep) {
    struct solid_soft *soft = s->soft;
    double power = 0;
    int kept = 0;
    if (soft->is_hidden) return 0;
    solid_soft_order(soft);
    for (int i = 0, next; i < soft->n; i = next) {
        const int h = soft->bond[i].h, rises = sweep->may_break && !is_dilated(s, h);
        struct sums sums;
        double s_e, s_c;
        begin(s, h, &sums, &s_e, &s_c);
        for (next = i; next < soft->n && soft->bond[next].h == h; next++) {
            struct solid_soft_bond bond = soft->bond[next];
            const struct extension e = extension_of(s, &bond);
            const double share =
                rises ? bring_up(s, &bond, e.stretch, s_e, s_c) : solid_softening_share(s_e, s_c, bond.most);
            if (share == 0) {
                tear(s, &bond, s_e, s_c);
                continue;
            }
            power += 0.5 * s->volume[h] * push(s, &bond, &e, share, sweep->damping, &sums);
            soft->bond[kept++] = bond;
        }
        const double inv_density = 1 / solid_density(s, h),
                     largest = fmax(fmax(sums.largest[0], sums.largest[1]), s->dim == 3 ? sums.largest[2] : 0);
        for (int c = 0; c < s->dim && largest > 0; c++) s->a[c][h] += sum_of(&sums, c, largest) * inv_density;
    }
    soft->n = kept;
    return power;
}

/* The dilatation of h loses what the bond's stiffness has fallen by. soft: -1, or the bond's number if it is left. */
static void lose(struct solid *s, const struct solid_soft_bond *bond, double stretch, double fallen, int soft) {
    solid_dilatation_loss_add(s,
                              &(struct solid_dilatation_loss){
                                  .h = bond->h,
                                  .l = bond->l,
                                  .xi = {bond->xi[0], bond->xi[1], bond->xi[2]},
                                  .stiffness = fallen * solid_soft_plain(s, bond),
                                  .now = stretch,
                                  .before = stretch * solid_absorbed_fraction(s, bond->h, bond->l, bond->xi, stretch),
                                  .soft = soft});
}

void solid_sweep_soft_extend(struct solid *s, int may_break, double *extension, double *weight) {
    struct solid_soft *soft = s->soft;
    int kept = 0;
    if (soft->is_hidden) return;
    solid_soft_order(soft);
    for (int i = 0, next; i < soft->n; i = next) {
        const int h = soft->bond[i].h, rises = may_break && is_dilated(s, h);
        const struct solid_list *list = s->family->list[s->body[h]];
        const double per = solid_density(s, h) * (list ? list->spacing : 1);
        struct sums sums;
        double s_e, s_c;
        begin(s, h, &sums, &s_e, &s_c);
        for (next = i; next < soft->n && soft->bond[next].h == h; next++) {
            struct solid_soft_bond bond = soft->bond[next];
            const double before = solid_softening_share(s_e, s_c, bond.most), stretch = extension_of(s, &bond).stretch,
                         share = rises ? bring_up(s, &bond, stretch, s_e, s_c) : before;
            if (share < before) lose(s, &bond, stretch, before - share, share > 0 ? kept : -1);
            if (share == 0) {
                tear(s, &bond, s_e, s_c);
                continue;
            }
            soft->bond[kept++] = bond;
            if (!is_dilated(s, h)) continue;
            const double part = share * solid_soft_plain(s, &bond);
            add_part(&bond, (double[]){part * stretch, part, 0}, &sums);
        }
        if (sums.largest[0] > 0) extension[h] += sum_of(&sums, 0, sums.largest[0]) / per;
        if (sums.largest[1] > 0) weight[h] += sum_of(&sums, 1, sums.largest[1]) / per;
    }
    soft->n = kept;
}

double solid_sweep_soft_energy(const struct solid *s) {
    double sum = 0;
    if (!s->soft || s->soft->is_hidden) return 0;
    for (int i = 0; i < s->soft->n; i++) {
        const struct solid_soft_bond *bond = &s->soft->bond[i];
        const struct extension e = extension_of(s, bond);
        double s_e, s_c;
        solid_soft_limits(s, bond->h, &s_e, &s_c);
        sum += solid_softening_share(s_e, s_c, bond->most) * energy_of(s, bond, e.stretch * e.stretch);
    }
    return sum;
}
