/* Force sweep over the bonds that soften: history, breaking, forces, energy. */
#include "solid/force/sweep_soft.h"
#include "base/ensure.h"
#include "solid/bonds/breaks.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/law/softening.h"

#include <math.h>

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

/* What stands for the square of the stretch in the energy that a bond releases while its largest stretch rises from
 * `most` to `now`. With s and share of the stiffness f, the energy under the law is 1/2 k (s_1 s_2)(f_1 - f_2).
 * Verlet's work of a step is the mean of both ends' forces times the way, which is the same. RK3 goes the whole step on
 * the old secant, and the stiffness is lowered at its end: 1/2 k s_2^2 (f_1 - f_2). */
static double square_of(enum solid_integrator integrator, double most, double now) {
    switch (integrator) {
    case SOLID_RK3:
        return now * now;
    case SOLID_VERLET:
        return most * now;
    }
    ENSURE(0, "integrator %d", (int)integrator);
}

/* Raises the history to the present stretch. Returns the share of the stiffness that is left. */
static double bring_up(struct solid *s, struct solid_soft_bond *bond, double stretch, double s_e, double s_c) {
    const double before = solid_softening_share(s_e, s_c, bond->most), most = bond->most;
    if (!(stretch > most)) return before;
    bond->most = stretch;
    const double now = solid_softening_share(s_e, s_c, stretch);
    const double energy = energy_of(s, bond, square_of(s->stage.integrator, most, stretch)) * (before - now);
    s->e_fracture += energy;
    bond->released += energy;
    return now;
}

/* Sums of at most SOLID_FAMILY_MAX numbers that do not depend on their order: rounded to a common digit, which leaves
 * room for the sum within 53 bits. (So are the families' sums in a plate, solid/force/sweep_family.h.) */
struct sums {
    int n;
    double force[SOLID_FAMILY_MAX][3];
    double largest; /* of all components */
};

static double sum_of(const struct sums *sums, int c) {
    int power;
    double sum = 0;
    (void)frexp(sums->largest, &power);
    double room = 1.5;
    while (room < sums->n) room *= 2;
    const double shift = ldexp(2 * room, power);
    for (int k = 0; k < sums->n; k++) sum += (sums->force[k][c] + shift) - shift;
    return sum;
}

/* Adds the bond's force on h per volume to the sums; returns the power of its damping per volume. */
static double push(const struct solid *s, const struct solid_soft_bond *bond, const struct extension *e, double share,
                   double damping, struct sums *sums) {
    double along = share * bond->elastic * e->stretch / (bond->length * (1 + e->stretch)), power = 0;
    if (damping > 0) {
        double closing = 0;
        for (int c = 0; c < s->dim; c++) closing += (s->v[c][bond->l] - s->v[c][bond->h]) * e->zeta[c];
        const double viscous = share * damping * bond->weight / (bond->length * bond->length) * closing / (1 + e->eps);
        power = viscous * closing;
        along += viscous;
    }
    ENSURE(sums->n < SOLID_FAMILY_MAX, "particle %d has too many softening bonds", bond->h);
    for (int c = 0; c < s->dim; c++) {
        const double force = along * e->zeta[c];
        sums->force[sums->n][c] = force;
        sums->largest = fmax(sums->largest, fabs(force));
    }
    sums->n++;
    return power;
}

static double fracture_energy_of(const struct solid *s, int h) {
    return s->in.material[s->in.body[s->body[h]].material].fracture_energy;
}

double solid_sweep_soft(struct solid *s, const struct solid_sweep *sweep) {
    struct solid_soft *soft = s->soft;
    double power = 0;
    int kept = 0;
    if (soft->is_hidden) return 0;
    solid_soft_order(soft);
    for (int i = 0, next; i < soft->n; i = next) {
        const int h = soft->bond[i].h;
        struct sums sums;
        double s_e, s_c;
        sums.n = 0;
        sums.largest = 0;
        solid_soft_limits(s, h, &s_e, &s_c);
        for (next = i; next < soft->n && soft->bond[next].h == h; next++) {
            struct solid_soft_bond bond = soft->bond[next];
            const struct extension e = extension_of(s, &bond);
            const double share =
                sweep->may_break ? bring_up(s, &bond, e.stretch, s_e, s_c) : solid_softening_share(s_e, s_c, bond.most);
            if (share == 0) {
                const double area = energy_of(s, &bond, s_e * s_c) / fracture_energy_of(s, h);
                s->crack_area += area;
                if (s->breaks) solid_breaks_add(s, h, bond.l, bond.xi, bond.released, area);
                solid_soft_break(s, &bond);
                continue;
            }
            power += 0.5 * s->volume[h] * push(s, &bond, &e, share, sweep->damping, &sums);
            soft->bond[kept++] = bond;
        }
        const double inv_density = 1 / solid_density(s, h);
        for (int c = 0; c < s->dim && sums.largest > 0; c++) s->a[c][h] += sum_of(&sums, c) * inv_density;
    }
    soft->n = kept;
    return power;
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
