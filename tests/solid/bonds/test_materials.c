/* Several materials in one lattice body: forces, energies, limits and densities of both ends of each bond; the same
 * bits as one material where the numbers are the same. */
#include "tests/solid/make.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/materials.h"
#include "solid/bonds/segments.h"
#include "solid/contact/contact.h"
#include "solid/force/force.h"
#include "solid/measure/energy.h"
#include "solid/measure/fragments.h"
#include "solid/measure/motion.h"
#include "solid/measure/stress.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "solid/step/relax.h"
#include "solid/voxels/voxels.h"
#include "tests/check.h"
#include "tests/solid/derivative.h"

#include <stdlib.h>

static const double G0 = 0.05;

enum pattern { ONE, HALVES, GRAINS, RANDOM, LAYER };

/* A box of sites, one a voxel. */
struct mix {
    int sites[3], periodic[3];
    enum pattern pattern;
    int at; /* HALVES: the first site of kind 1 along x; LAYER: the only ones, along y, are this and the next three */
    struct solid_material material[3];
    int kinds, contact, constraints;
    const struct solid_constraint *constraint;
    double body_force[3];
};

/* as macros for the table below, because a struct is no constant in C17 */
#define QUARTZ                                                                                                         \
    { YOUNG, DENSITY, G0, 3, PHYSICS_CONSTANT, 0, 0 }
#define CLAY                                                                                                           \
    { 0.3 * YOUNG, 0.8 * DENSITY, 0.2 * G0, 3, PHYSICS_CONSTANT, 0, 0 }
#define ORE                                                                                                            \
    { 2.2 * YOUNG, 1.9 * DENSITY, 3 * G0, 3, PHYSICS_CONSTANT, 0, 0 }
static const struct solid_material quartz = QUARTZ, clay = CLAY, ore = ORE;

static int kind_at(const struct mix *m, const int site[3]) {
    const int block[3] = {site[0] / 5, site[1] / 5, site[2] / 5}, *cell = m->pattern == RANDOM ? site : block;
    switch (m->pattern) {
    case ONE:
        return 0;
    case HALVES:
        return site[0] >= m->at;
    case GRAINS:
    case RANDOM:
        return (int)(((unsigned)((cell[2] * 37 + cell[1]) * 41 + cell[0] + 5) * 2654435761u >> 16) %
                     (unsigned)m->kinds);
    case LAYER:
        return site[1] >= m->at && site[1] < m->at + 4;
    }
    return 0;
}

static int kind_of(const struct mix *m, const struct solid *s, int h) {
    int site[3];
    for (int c = 0; c < 3; c++) site[c] = (int)floor(s->x0[c][h] / SPACING);
    return kind_at(m, site);
}

static struct solid *mixed(const struct mix *m) {
    struct solid_body body = {.name = "rock", .shape = SOLID_IMAGE};
    const int corner[3] = {0};
    struct solid_voxels *v = solid_voxels_new(m->sites, NULL, corner);
    if (m->pattern != ONE) {
        body.image_materials = m->kinds;
        for (int k = 0; k < m->kinds; k++) body.image_material[k] = k;
        solid_voxels_kinds(v, m->kinds);
    }
    for (int k = 0; k < m->sites[2]; k++)
        for (int j = 0; j < m->sites[1]; j++)
            for (int i = 0; i < m->sites[0]; i++) {
                solid_voxels_set(v, v->bits, i, j, k);
                solid_voxels_set_kind(v, kind_at(m, (const int[3]){i, j, k}), i, j, k);
            }
    body.voxels = v;
    struct solid_input in = {.spacing = SPACING,
                             .bodies = 1,
                             .body = &body,
                             .materials = 3,
                             .material = m->material,
                             .constraints = m->constraints,
                             .constraint = m->constraint,
                             .surface_correction = SOLID_CORRECTION_ENERGY,
                             .contact = m->contact,
                             .contact_stiffness = 15,
                             .contact_exponent = 1,
                             .contact_radius = 1};
    for (int c = 0; c < 3; c++) {
        body.high[c] = m->sites[c] * SPACING;
        in.periodic[c] = m->periodic[c];
        in.length[c] = body.high[c];
        in.body_force[c] = m->body_force[c];
    }
    par_barrier(); /* the bits are the node's: all ranks have set them */
    struct solid *s = solid_new(&in);
    solid_voxels_free(v);
    return s;
}

static void shake(struct solid *s, double by) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            s->d[c][h] = by * SPACING * noise(s, h, c);
            s->v[c][h] = 0.1 * noise(s, h, c + 3);
        }
    solid_ghosts_update(s);
}

static double length_of(const double *xi) { return sqrt(xi[0] * xi[0] + xi[1] * xi[1] + xi[2] * xi[2]); }

static double stretch_of(const struct solid *s, int h, const struct solid_family_view *view, int b) {
    double eta[3], zeta2 = 0, xi2 = 0;
    for (int c = 0; c < 3; c++) {
        eta[c] = s->d[c][view->l[b]] - s->d[c][h];
        zeta2 += (view->xi[b][c] + eta[c]) * (view->xi[b][c] + eta[c]);
        xi2 += view->xi[b][c] * view->xi[b][c];
    }
    return sqrt(zeta2 / xi2) - 1;
}

/* c0 and s0 of a bond between two materials, by the formula of an interface. */
static void bond_of(const struct mix *m, int a, int b, double *c0, double *s0) {
    const double ca = solid_material_micromodulus(&m->material[a], SPACING),
                 cb = solid_material_micromodulus(&m->material[b], SPACING),
                 sa = solid_material_critical_stretch(&m->material[a], SPACING),
                 sb = solid_material_critical_stretch(&m->material[b], SPACING);
    *c0 = (ca + cb) / 2;
    *s0 = sqrt((ca * sa * sa + cb * sb * sb) / (ca + cb));
}

static const struct mix table[] = {
    {.sites = {17, 11, 10}, .pattern = GRAINS, .material = {QUARTZ, CLAY, ORE}, .kinds = 3},
    {.sites = {13, 8, 9}, .pattern = RANDOM, .periodic = {1, 1, 0}, .material = {CLAY, ORE, QUARTZ}, .kinds = 3},
    {.sites = {24, 7, 8}, .pattern = HALVES, .at = 11, .material = {QUARTZ, CLAY, ORE}, .kinds = 2}};
enum { TABLE = sizeof table / sizeof *table };

/* Accelerations, damping's power and strain energy by scalar sums over each family. */
static void sums_over_families(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int t = 0; t < TABLE; t++)
        for (int large = 0; large < 2; large++) {
            const struct mix *m = &table[t];
            struct solid *s = mixed(m);
            const double damping = 1e9;
            s->stage.damping_relative = damping; /* so that the ghosts' velocities are current */
            shake(s, large ? 3e-2 : 1e-4);
            solid_force_bonds(s, 0, damping);
            double worst = 0, most = 0, strain = 0, power = 0, net[3] = {0}, all = 0;
            for (int h = 0; h < s->n; h++) {
                const int own = kind_of(m, s, h);
                double a[3] = {0};
                check_equal(solid_particle_material(s, h), own);
                check_close(solid_density(s, h), m->material[own].density, 0);
                solid_family_view(s, h, &view);
                for (int b = 0; b < view.n; b++) {
                    double c0, s0, zeta[3], closing = 0;
                    bond_of(m, own, kind_of(m, s, view.l[b]), &c0, &s0);
                    check_relative(view.micro[b], c0, 1e-14);
                    const double stretch = stretch_of(s, h, &view, b), length = length_of(view.xi[b]),
                                 now = length * (1 + stretch);
                    for (int c = 0; c < 3; c++) {
                        zeta[c] = view.xi[b][c] + s->d[c][view.l[b]] - s->d[c][h];
                        closing += (s->v[c][view.l[b]] - s->v[c][h]) * zeta[c] / now;
                    }
                    const double elastic = view.alpha[b] * c0 * stretch * view.weight[b],
                                 viscous = damping * closing * view.weight[b];
                    for (int c = 0; c < 3; c++) a[c] += (elastic + viscous) * zeta[c] / now / solid_density(s, h);
                    strain += 0.25 * view.alpha[b] * c0 * stretch * stretch * length * view.weight[b] * s->volume[h];
                    power += 0.5 * viscous * closing * s->volume[h];
                }
                for (int c = 0; c < 3; c++) {
                    const double force = solid_density(s, h) * s->volume[h] * s->a[c][h];
                    worst = check_worst(worst, a[c] - s->a[c][h]);
                    most = check_worst(most, a[c]);
                    net[c] += force;
                    all += fabs(force);
                }
            }
            check_at_most(par_max(worst), 1e-10 * par_max(most));
            check_relative(solid_energy_measure(s).strain, par_sum(strain), 1e-9);
            check_relative(par_sum(s->power_damped), par_sum(power), 1e-9);
            for (int c = 0; c < 3; c++) check_at_most(fabs(par_sum(net[c])), 1e-12 * par_sum(all));
            double *energy = malloc((size_t)(2 * s->n + 1) * sizeof *energy), sum = 0;
            solid_energy_bonds(s, energy, energy + s->n);
            for (int h = 0; h < s->n; h++) sum += energy[h] * s->volume[h];
            check_relative(par_sum(sum), par_sum(strain), 1e-9);
            free(energy);
            solid_free(s);
        }
}

/* What a body of one material has, and one of several whose numbers are the same: every bit. */
static void equal_numbers(void **state) {
    (void)state;
    for (int t = 0; t < TABLE; t++) {
        struct mix m = table[t];
        for (int k = 0; k < 3; k++) m.material[k] = quartz;
        struct solid *two = mixed(&m), *one;
        m.pattern = ONE;
        one = mixed(&m);
        check_equal(one->material == NULL, 1);
        check_equal(two->material != NULL, 1);
        check_equal(one->n, two->n);
        struct solid *const both[] = {one, two};
        double(*stress[2])[6];
        struct solid_energy energy[2];
        struct solid_rates rates[2];
        for (int k = 0; k < 2; k++) {
            both[k]->stage.damping_relative = 1e9;
            solid_rates_of(both[k], &rates[k]);
            both[k]->stage.breakage = 1;
            shake(both[k], 6e-4);
            solid_force(both[k], 1);
            solid_ghosts_update(both[k]);
            solid_family_count(both[k]);
            stress[k] = calloc((size_t)both[k]->n + 1, sizeof *stress[k]);
            solid_stress_measure(both[k], stress[k]);
            energy[k] = solid_energy_measure(both[k]);
        }
        check_above(one->bonds_broken, 100);
        check_equal(one->bonds_broken, two->bonds_broken);
        check_equal(memcmp(&rates[0], &rates[1], sizeof rates[0]), 0);
        check_equal(energy[0].strain == energy[1].strain && energy[0].kinetic == energy[1].kinetic, 1);
        check_equal(one->e_fracture == two->e_fracture && one->crack_area == two->crack_area, 1);
        for (int h = 0; h < one->n; h++) {
            for (int c = 0; c < 3; c++) check_equal(one->a[c][h] == two->a[c][h], 1);
            for (int c = 0; c < 6; c++) check_relative(stress[0][h][c], stress[1][h][c], 1e-12);
        }
        for (int k = 0; k < 2; k++) {
            free(stress[k]);
            solid_free(both[k]);
        }
    }
}

/* Segments of one kind are those whose bonds join one kind only; both sorts occur. */
static void segments_of_a_kind(void **state) {
    (void)state;
    const struct mix m = {
        .sites = {64, 16, 12}, .pattern = HALVES, .at = 29, .material = {quartz, clay, ore}, .kinds = 2};
    struct solid *s = mixed(&m);
    const struct solid_lattice *t = s->family->lattice[0];
    int count[3] = {0};
    for (int g = 0; g < t->segments->n; g++) {
        const int kind = t->materials->segment[g];
        int low = 64, high = -1;
        for (int k = 0; k < SOLID_ROW; k++)
            if (t->segments->owned[g] >> k & 1) {
                const int h = t->local[t->segments->cell[g] + k], x = (int)floor(s->x0[0][h] / SPACING);
                low = x < low ? x : low;
                high = x > high ? x : high;
            }
        check_equal(kind, high + 3 < 29 ? 0 : low - 3 >= 29 ? 1 : SOLID_MATERIALS_SEVERAL);
        count[kind == SOLID_MATERIALS_SEVERAL ? 2 : kind]++;
    }
    for (int k = 0; k < 3; k++) check_above(par_sum_long(count[k]), 100);
    solid_free(s);
}

/* The body is stretched along x: bonds break beyond the limit of their two ends, and no others. */
static void limits(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int t = 0; t < TABLE; t++)
        for (int tough = 0; tough < 2; tough++) {
            struct mix m = table[t];
            if (tough) m.material[0].fracture_energy = INFINITY;
            m.periodic[0] = 0;
            struct solid *s = mixed(&m);
            double low = INFINITY, high = 0;
            for (int k = 0; k < m.kinds; k++) {
                const double s0 = solid_material_critical_stretch(&m.material[k], SPACING);
                low = fmin(low, s0);
                high = fmax(high, isfinite(s0) ? s0 : 0);
            }
            double energy = 0, area = 0;
            long broken = 0;
            for (int turn = 0; turn < 5; turn++) {
                const double stretch = 0.87 * low + turn / 4. * (1.11 * high - 0.87 * low);
                for (int h = 0; h < s->n; h++) s->d[0][h] = stretch * s->x0[0][h];
                solid_ghosts_update(s);
                for (int h = 0; h < s->n; h++) {
                    solid_family_view(s, h, &view);
                    for (int b = 0; b < view.n; b++) {
                        const int own = kind_of(&m, s, h), other = kind_of(&m, s, view.l[b]);
                        double c0, s0, now = stretch_of(s, h, &view, b);
                        bond_of(&m, own, other, &c0, &s0);
                        if (!view.intact[b] || !(now > s0)) continue;
                        const double held =
                            0.25 * view.alpha[b] * c0 * length_of(view.xi[b]) * view.weight[b] * s->volume[h];
                        energy += held * now * now;
                        area +=
                            held * s0 * s0 * 2 / (m.material[own].fracture_energy + m.material[other].fracture_energy);
                        broken++;
                    }
                }
                solid_force(s, 1);
                solid_force(s, 1); /* judged before the forces are computed */
                solid_ghosts_update(s);
                for (int h = 0; h < s->n; h++) {
                    solid_family_view(s, h, &view);
                    for (int b = 0; b < view.n; b++) {
                        double c0, s0;
                        bond_of(&m, kind_of(&m, s, h), kind_of(&m, s, view.l[b]), &c0, &s0);
                        check_equal(!view.intact[b], !view.intact[b] || stretch_of(s, h, &view, b) > s0);
                    }
                }
                solid_family_count(s);
                check_equal(2 * s->bonds_broken, par_sum_long(broken));
            }
            check_above(s->bonds_broken, 1000);
            check_relative(par_sum(s->e_fracture), par_sum(energy), 1e-10);
            check_relative(par_sum(s->crack_area), par_sum(area), 1e-10);
            solid_free(s);
        }
}

/* Two halves are moved apart: crack_area is the border's area times the lattice's factor, as within one material. */
static void border(void **state) {
    (void)state;
    const struct mix m = {.sites = {20, 8, 8},
                          .periodic = {0, 1, 1},
                          .pattern = HALVES,
                          .at = 9,
                          .material = {quartz, clay, ore},
                          .kinds = 2};
    struct solid *s = mixed(&m);
    for (int h = 0; h < s->n; h++) s->d[0][h] = kind_of(&m, s, h) ? 0.1 * SPACING : 0;
    solid_ghosts_update(s);
    const double held = solid_energy_measure(s).strain;
    solid_force(s, 1);
    solid_family_count(s);
    check_close(par_sum(s->crack_area) / (64 * SPACING * SPACING), 1.0131175, 2e-5);
    check_relative(par_sum(s->e_fracture), held, 1e-12);
    check_close(solid_energy_measure(s).strain, 0, 0);
    solid_free(s);
}

/* Mean strain of a bar between the sites from and to, held at one end and pulled at the other, and without contraction;
 * stress 1 kPa. */
static double strain_of_bar(enum pattern pattern, double stiffer, int sites, int from, int to) {
    const struct solid_constraint clamp = {.low = {-1, -1, -1}, .high = {3 * SPACING, 1, 1}, .direction = {1, 1, 1}};
    struct mix m = {.sites = {sites, 4, 4},
                    .periodic = {0, 1, 1},
                    .pattern = pattern,
                    .at = sites / 2,
                    .material = {quartz, quartz, ore},
                    .kinds = 2,
                    .constraints = 1,
                    .constraint = &clamp};
    m.material[1].youngs_modulus = stiffer * YOUNG;
    m.material[1].density = 2 * DENSITY;
    struct solid *s = mixed(&m);
    for (int h = 0; h < s->n; h++)
        if (s->x0[0][h] > (sites - 1) * SPACING) s->load[0][h] = 1e3 / SPACING;
    check_above(solid_relax(s, 1e-7, 40000), 10);
    double d[2] = {0};
    for (int h = 0; h < s->n; h++)
        for (int e = 0; e < 2; e++)
            if (fabs(s->x0[0][h] / SPACING - 0.5 - (e ? to : from)) < 0.1) d[e] += s->d[0][h] / 16;
    par_sum_array(d, 2);
    double(*stress)[6] = calloc((size_t)s->n + 1, sizeof *stress), far = 0, near = 0;
    solid_ghosts_update(s);
    solid_stress_measure(s, stress);
    for (int h = 0; h < s->n; h++) {
        const double x = s->x0[0][h] / SPACING, off = stress[h][0] / 1e3 - 1;
        if (x < 7 || x > sites - 7) continue;
        if (fabs(x - sites / 2) > 7)
            far = check_worst(far, off);
        else
            near = check_worst(near, off);
    }
    check_below(far, 0.01);
    check_below(near, 0.25); /* a mean over the family */
    print_message("stress: off by at most %.4f far from the border, %.4f near to it\n", far, near);
    free(stress);
    solid_free(s);
    return (d[1] - d[0]) / ((to - from) * SPACING);
}

/* Two layers in series: the strain is the mean of both layers'. What differs belongs to the border, some tenths of a
 * spacing of the softer layer whatever the length: with the length the stiffness converges to the analytic one. */
static void layers_in_series(void **state) {
    (void)state;
    const double stiffer[] = {3, 0.25};
    for (int k = 0; k < 2; k++) {
        double border[2];
        for (int q = 0; q < 2; q++) {
            const int sites = q ? 48 : 24, from = sites / 4, to = sites - 1 - from;
            const double one = strain_of_bar(ONE, 1, sites, from, to),
                         two = strain_of_bar(HALVES, stiffer[k], sites, from, to);
            border[q] = (two / one - 0.5 * (1 + 1 / stiffer[k])) * (to - from) * fmin(stiffer[k], 1);
            print_message("two layers of %d spacings, %.2f times as stiff: %.5f of the analytic strain, the border "
                          "%.4f spacings\n",
                          sites, stiffer[k], two / one / (0.5 * (1 + 1 / stiffer[k])), border[q]);
        }
        check_close(border[0], 0, 0.6);
        check_close(border[1], border[0], 1e-3);
    }
}

/* Mass, momentum, kinetic energy, weight and fragments take each particle's density. */
static void densities(void **state) {
    (void)state;
    for (int t = 0; t < TABLE; t++) {
        struct mix m = table[t];
        m.body_force[1] = -9.81;
        struct solid *s = mixed(&m);
        struct solid_motion motion;
        struct solid_fragment *fragment;
        long *id = malloc(((size_t)s->n + 1) * sizeof *id);
        double mass = 0, momentum = 0, kinetic = 0;
        shake(s, 0);
        for (int h = 0; h < s->n; h++) {
            const double own = m.material[kind_of(&m, s, h)].density * s->volume[h];
            mass += own;
            momentum += own * s->v[0][h];
            for (int c = 0; c < 3; c++) kinetic += 0.5 * own * s->v[c][h] * s->v[c][h];
        }
        solid_motion_measure(s, &motion);
        check_relative(motion.mass, par_sum(mass), 1e-12);
        check_close(motion.momentum[0], par_sum(momentum), 1e-10 * par_sum(mass));
        check_relative(motion.kinetic, par_sum(kinetic), 1e-12);
        check_relative(motion.load[1], -9.81 * par_sum(mass), 1e-12);
        check_relative(solid_energy_measure(s).kinetic, par_sum(kinetic), 1e-12);
        check_equal(solid_fragments_measure(s, id, &fragment), 1);
        check_relative(fragment->mass, par_sum(mass), 1e-12);
        solid_force(s, 0);
        for (int h = 0; h < s->n; h++) check_close(s->a[1][h], -9.81, 1e-6);
        free(fragment);
        free(id);
        solid_free(s);
    }
}

/* A body that is shaken until it breaks: the books close as those of one material, and momentum is kept although torn
 * particles of different density push each other. */
static void books(void **state) {
    (void)state;
    for (int verlet = 0; verlet < 2; verlet++) {
        struct mix m = table[0];
        m.contact = 1;
        struct solid *s = mixed(&m);
        double net[4] = {0};
        s->stage = (struct solid_stage){.integrator = verlet ? SOLID_VERLET : SOLID_RK3, .breakage = 1};
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) s->v[c][h] = 0.05 * noise(s, h, c);
        solid_ghosts_update(s);
        const double start = solid_energy_measure(s).kinetic,
                     dt = 0.05 * solid_rates_stable_step(s, s->stage.integrator);
        for (int k = 0; k < 60; k++) {
            solid_contact_update(s);
            solid_integrate(s, dt, 1);
        }
        const struct solid_energy e = solid_energy_measure(s);
        solid_family_count(s);
        const double now = e.kinetic + e.strain + e.contact + par_sum(s->e_fracture);
        print_message(
            "%s: %ld of %ld bonds broken, fracture %.3f, contact %.5f of the energy; the books are open by %.2e\n",
            verlet ? "Verlet" : "RK3", s->bonds_broken, s->bonds_total, par_sum(s->e_fracture) / start,
            e.contact / start, now / start - 1);
        check_above(s->bonds_broken, 1000);
        check_close(now / start, 1, verlet ? 8e-3 : 5e-4); /* of one material 6e-3 and 3e-4 */
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) {
                net[c] += solid_density(s, h) * s->volume[h] * (s->v[c][h] - 0.05 * noise(s, h, c));
                net[3] += solid_density(s, h) * s->volume[h] * fabs(s->v[c][h]);
            }
        par_sum_array(net, 4);
        for (int c = 0; c < 3; c++) check_at_most(fabs(net[c]), 1e-11 * net[3]);
        solid_free(s);
    }
}

/* A plate with a layer of a weaker material is pulled across the layer: it breaks there and nowhere else. */
static void crack_in_the_layer(void **state) {
    (void)state;
    static struct solid_family_view view;
    const struct solid_constraint end[] = {
        {.low = {-1, -1, -1}, .high = {1, 3 * SPACING, 1}, .direction = {1, 1, 1}, .velocity = {0, -0.008, 0}},
        {.low = {-1, 21 * SPACING, -1}, .high = {1, 1, 1}, .direction = {1, 1, 1}, .velocity = {0, 0.008, 0}}};
    struct mix m = {.sites = {16, 24, 4},
                    .periodic = {0, 0, 1},
                    .pattern = LAYER,
                    .at = 13,
                    .material = {quartz, quartz, ore},
                    .kinds = 2,
                    .constraints = 2,
                    .constraint = end};
    m.material[1].fracture_energy = 0.3 * G0;
    struct solid *s = mixed(&m);
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .breakage = 1};
    for (int h = 0; h < s->n; h++) s->v[1][h] = 0.016 * (s->x0[1][h] / (24 * SPACING) - 0.5);
    solid_ghosts_update(s);
    const double dt = 0.5 * solid_rates_stable_step(s, SOLID_VERLET);
    long outside = 0;
    for (int k = 0; k < 2000 && s->bonds_broken < 2000; k += 10) {
        solid_integrate(s, dt, 10);
        solid_family_count(s);
    }
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++)
            outside += !view.intact[b] && kind_of(&m, s, h) == 0 && kind_of(&m, s, view.l[b]) == 0 &&
                       (s->x0[1][h] - 15 * SPACING) * (s->x0[1][h] + view.xi[b][1] - 15 * SPACING) > 0;
    }
    check_at_least(s->bonds_broken, 2000);
    check_equal(par_sum_long(outside), 0);
    solid_free(s);
}

/* Materials of several Poisson's ratios: the forces are the derivative of the energy, and equal and opposite, whichever
 * materials the ends of a bond have. One of the three has the ratio of bonds alone. */
static void test_ratios(void **state) {
    (void)state;
    const double excess[3] = {0.15, -0.3, 0};
    for (enum pattern pattern = HALVES; pattern <= LAYER; pattern++) {
        struct mix m = {.sites = {19, 10, 11},
                        .periodic = {0, 0, 1},
                        .pattern = pattern,
                        .at = pattern == HALVES ? 9 : 3,
                        .material = {QUARTZ, CLAY, ORE},
                        .kinds = pattern == HALVES || pattern == LAYER ? 2 : 3};
        double total[4] = {0};
        for (int k = 0; k < 3; k++) m.material[k].ratio_excess = excess[k];
        struct solid *s = mixed(&m);
        shake(s, 1e-3);
        check_derivative(s, 1e-5, noise);
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) {
                const double force = solid_density(s, h) * s->volume[h] * s->a[c][h];
                total[c] += force;
                total[3] += fabs(force);
            }
        par_sum_array(total, 4);
        for (int c = 0; c < 3; c++) check_close(total[c] / total[3], 0, 1e-14);
        solid_free(s);
    }
}

/* Two halves of the same shear modulus and nu = 0.4 and 0.1, in a uniform shear: no dilatation, the same stress in
 * both, so no force anywhere inside, at the joint neither. With another shear modulus there is one at the joint. */
static void test_patch(void **state) {
    (void)state;
    for (int same = 0; same < 2; same++) {
        struct mix m = {
            .sites = {30, 22, 22}, .pattern = HALVES, .at = 15, .kinds = 2, .material = {QUARTZ, QUARTZ, ORE}};
        m.material[0].ratio_excess = 0.15;
        m.material[1].ratio_excess = -0.15;
        m.material[1].youngs_modulus *= same ? 1.1 / 1.4 : 1;
        struct solid *s = mixed(&m);
        double largest = 0;
        for (int h = 0; h < s->n; h++) s->d[1][h] = 1e-8 * s->x0[0][h];
        solid_ghosts_update(s);
        solid_force(s, 0);
        for (int h = 0; h < s->n; h++) {
            double depth = 1e300;
            for (int c = 0; c < 3; c++)
                depth = fmin(depth, fmin(s->x0[c][h], m.sites[c] * SPACING - s->x0[c][h]) / SPACING);
            if (depth < 10) continue; /* the surface correction reaches three horizons */
            for (int c = 0; c < 3; c++) largest = fmax(largest, fabs(s->a[c][h]));
        }
        largest = par_max(largest) * DENSITY * SPACING / (1e-8 * YOUNG);
        if (same)
            check_below(largest, 1e-7); /* the square of the strain */
        else
            check_above(largest, 1e-3);
        solid_free(s);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(sums_over_families),
                                       cmocka_unit_test(equal_numbers),
                                       cmocka_unit_test(limits),
                                       cmocka_unit_test(border),
                                       cmocka_unit_test(densities),
                                       cmocka_unit_test(books),
                                       cmocka_unit_test(segments_of_a_kind),
                                       cmocka_unit_test(layers_in_series),
                                       cmocka_unit_test(crack_in_the_layer),
                                       cmocka_unit_test(test_ratios),
                                       cmocka_unit_test(test_patch)};
    const int failed = par_size() == 1 ? cmocka_run_group_tests(tests, NULL, NULL)
                                       : _cmocka_run_group_tests("ranks", tests, 6, NULL, NULL);
    par_end();
    return failed;
}
