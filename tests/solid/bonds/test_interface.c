/* Bonds between two bodies: as within one body where the materials are the same, equal and opposite forces where they
 * are not, and an energy to break of their own. */
#include "tests/solid/make.h"
#include "solid/bonds/interface.h"
#include "solid/bonds/ghosts.h"
#include "solid/contact/contact.h"
#include "solid/force/force.h"
#include "solid/measure/energy.h"
#include "solid/surface/surface.h"
#include "tests/check.h"

#include <stdlib.h>

enum { N = 16, HALF = 7, SIDE = 8 }; /* sites along x, those of the first body, and across */
static const double G0 = 0.05;

/* N x SIDE x SIDE sites, of a plate N x SIDE, in one body or two. dim 3: periodic across. */
struct joined {
    int dim, whole, periodic;
    double weak;                       /* fracture energy of the interface, 0: no interface */
    struct solid_material material[2]; /* the second one of the second body */
    enum solid_correction correction;
    int contact;
};

static struct solid *join(const struct joined *m) {
    const signed char turn[4] = {0};
    double corner[2][4][2];
    struct solid_outline outline[2];
    struct solid_body body[2] = {{.name = "first"}, {.name = "second"}};
    for (int b = 0; b < 2; b++) {
        const int from = b ? HALF : 0, to = b || m->whole ? N : HALF;
        const double x[2] = {from * SPACING, to * SPACING}, y[2] = {0, SIDE * SPACING};
        for (int k = 0; k < 4; k++) {
            corner[b][k][0] = x[k == 1 || k == 2];
            corner[b][k][1] = y[k / 2];
        }
        outline[b] = (struct solid_outline){0, 4, corner[b], corner[b], turn};
        body[b].material = b;
        body[b].shape = m->dim == 2 ? SOLID_POLYGON : SOLID_BOX;
        body[b].outlines = m->dim == 2;
        body[b].outline = &outline[b];
        for (int c = 0; c < 3; c++) {
            body[b].low[c] = c == 0 ? x[0] : 0;
            body[b].high[c] = c == 0 ? x[1] : y[1];
        }
    }
    const struct solid_interface interface = {{1, 0}, m->weak};
    struct solid_input in = {.model = m->dim == 2 ? PHYSICS_PLANE_STRESS : PHYSICS_3D,
                             .thickness = SPACING,
                             .spacing = SPACING,
                             .bodies = m->whole ? 1 : 2,
                             .body = body,
                             .materials = 2,
                             .material = m->material,
                             .interfaces = m->weak > 0 && !m->whole,
                             .interface = &interface,
                             .surface_correction = m->correction,
                             .general_bonds = 1,
                             .contact = m->contact,
                             .contact_stiffness = 15,
                             .contact_exponent = 1,
                             .contact_radius = 1};
    for (int c = 0; c < 3; c++) {
        in.periodic[c] = m->periodic && c > 0 && c < m->dim;
        in.length[c] = (c == 0 ? N : SIDE) * SPACING;
    }
    return solid_new(&in);
}

static const struct solid_material soft = {YOUNG, DENSITY, G0, 3, PHYSICS_CONSTANT, 0, 0},
                                   stiff = {2.5 * YOUNG, 3 * DENSITY, 4 * G0, 2, PHYSICS_CONICAL, 0, 0};

static int site_of(const struct solid *s, int h) {
    int site = 0;
    for (int c = s->dim - 1; c >= 0; c--) site = site * N + (int)floor(s->x0[c][h] / SPACING);
    return site;
}

static double jitter(int a, int c) {
    unsigned z = (unsigned)(3 * a + c + 1) * 2654435761u;
    z = (z ^ z >> 15) * 2246822519u;
    z = (z ^ z >> 13) * 3266489917u;
    return (double)((z ^ z >> 16) >> 8) * 0x1p-23 - 1;
}

/* Displaces all particles at random by up to `by` spacings. */
static void shake(struct solid *s, double by) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < s->dim; c++) s->d[c][h] = by * SPACING * jitter(site_of(s, h), c);
    solid_ghosts_update(s);
}

/* Accelerations by site, of all ranks. */
static double (*accelerations(const struct solid *s))[3] {
    double(*a)[3] = calloc(N * N * N, sizeof *a);
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < s->dim; c++) a[site_of(s, h)][c] = s->a[c][h];
    par_sum_array(&a[0][0], 3 * N * N * N);
    return a;
}

/* Two halves of one material, joined with its own fracture energy, are the whole body: a plate to the bit, whose sums
 * do not depend on their order. */
static void halves_are_the_whole(void **state) {
    (void)state;
    for (int kind = 0; kind < 16; kind++) {
        struct joined m = {.dim = kind & 1 ? 3 : 2,
                           .periodic = kind >> 1 & 1,
                           .weak = G0,
                           .material = {soft, soft},
                           .correction = kind & 4 ? SOLID_CORRECTION_ENERGY : SOLID_CORRECTION_VOLUME};
        for (int k = 0; k < 2; k++) m.material[k].ratio_excess = kind & 8 ? 0.1 : 0;
        struct solid *two = join(&m);
        m.whole = 1;
        struct solid *one = join(&m);
        assert_int_equal(two->bonds_total, one->bonds_total);
        shake(one, 1e-3);
        shake(two, 1e-3);
        const struct solid_energy e1 = solid_energy_measure(one), e2 = solid_energy_measure(two);
        solid_force(one, 0);
        solid_force(two, 0);
        double(*a)[3] = accelerations(one), (*b)[3] = accelerations(two);
        double worst = 0, most = 0;
        for (int i = 0; i < N * N * N; i++)
            for (int c = 0; c < m.dim; c++) {
                worst = check_worst(worst, a[i][c] - b[i][c]);
                most = check_worst(most, a[i][c]);
            }
        check_at_most(worst, m.dim == 2 ? 0 : 1e-13 * most);
        check_relative(e2.strain, e1.strain, 1e-13);
        if (m.dim == 3) { /* water does not see the interface */
            struct solid_surface *f1 = solid_surface_new(one), *f2 = solid_surface_new(two);
            check_above(f1->total, 0);
            assert_int_equal(f2->total, f1->total);
            solid_surface_free(f1);
            solid_surface_free(f2);
        }
        free(a);
        free(b);
        solid_free(one);
        solid_free(two);
    }
}

/* Two materials with different constants, densities, horizons, laws and Poisson's ratios: no net force, and forces that
 * are the energy's derivative. */
static void forces_of_two_materials(void **state) {
    (void)state;
    static const double excess[4][2] = {{0, 0}, {0.1, 0}, {0, -0.2}, {0.1, -0.2}};
    for (int kind = 0; kind < 8; kind++) {
        const int dim = kind & 1 ? 3 : 2;
        struct joined m = {.dim = dim, .weak = G0, .material = {soft, stiff}, .correction = SOLID_CORRECTION_ENERGY};
        for (int k = 0; k < 2; k++) m.material[k].ratio_excess = excess[kind >> 1][k];
        struct solid *s = join(&m);
        shake(s, 1e-3);
        solid_force(s, 0);
        double net[4] = {0};
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < dim; c++) {
                const double force = solid_density(s, h) * s->volume[h] * s->a[c][h];
                net[c] += force;
                net[3] += fabs(force);
            }
        par_sum_array(net, 4);
        for (int c = 0; c < dim; c++) check_at_most(fabs(net[c]), 1e-12 * net[3]);
        for (int x = HALF - 2; x < HALF + 2; x++) {
            const int site = (dim == 3 ? 3 * N * N : 0) + 4 * N + x, c = x % dim;
            double force = 0, energy[2];
            for (int k = 0; k < 2; k++) {
                shake(s, 1e-3);
                for (int h = 0; h < s->n; h++)
                    if (site_of(s, h) == site) s->d[c][h] += (k ? 1 : -1) * 1e-6 * SPACING;
                solid_ghosts_update(s);
                energy[k] = solid_energy_measure(s).strain;
            }
            for (int h = 0; h < s->n; h++)
                if (site_of(s, h) == site) force = solid_density(s, h) * s->volume[h] * s->a[c][h];
            check_relative(-(energy[1] - energy[0]) / (2e-6 * SPACING), par_sum(force), 1e-5);
        }
        solid_free(s);
    }
}

/* The bodies are moved apart at once: the bonds across the interface break and no others. Their area is the plane's
 * times the lattice's factor, whatever the interface's fracture energy, and the energy that they need is that area
 * times it.
 */
static void an_interface_takes_its_energy(void **state) {
    (void)state;
    for (int kind = 0; kind < 6; kind++) {
        const int dim = kind & 1 ? 3 : 2, mixed = kind >> 1 == 1, dilated = kind >> 1 == 2;
        struct joined m = {.dim = dim, .periodic = 1, .weak = 0.3 * G0, .material = {soft, soft}};
        if (dilated) m.material[1].ratio_excess = -0.1;
        if (mixed) {
            m.material[1] = stiff;
            m.material[1].micromodulus = PHYSICS_CONSTANT;
            m.material[1].horizon_ratio = 3;
        }
        struct solid *s = join(&m);
        const double s0 = solid_material_constants(s->in.model, SPACING, &soft, 3 * SPACING).s0 * sqrt(0.3);
        double held = 0;
        static struct solid_family_view view;
        /* of one material, just below the limit nothing breaks: eps of a bond along x is that of the gap over its
         * length */
        for (int h = 0; !mixed && h < s->n; h++) s->d[0][h] = s->body[h] ? 0.98 * s0 * SPACING : 0;
        solid_ghosts_update(s);
        solid_force(s, 1);
        solid_family_count(s);
        if (!mixed) assert_int_equal(s->bonds_broken, 0);
        for (int h = 0; h < s->n; h++) s->d[0][h] = s->body[h] ? 0.1 * SPACING : 0;
        solid_ghosts_update(s);
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                if (s->body[view.l[b]] == s->body[h]) continue;
                double xi2 = 0, eta = s->d[0][view.l[b]] - s->d[0][h];
                for (int c = 0; c < 3; c++) xi2 += view.xi[b][c] * view.xi[b][c];
                const double stretch = sqrt(1 + eta * (eta + 2 * view.xi[b][0]) / xi2) - 1;
                held += 0.25 * view.micro[b] * stretch * stretch * sqrt(xi2) * view.weight[b] * s->volume[h];
            }
        }
        const double before = solid_energy_measure(s).strain;
        solid_force(s, 1);
        solid_family_count(s);
        long across = 0, inside = 0;
        for (int h = 0; h < s->n; h++) {
            solid_family_view(s, h, &view);
            for (int b = 0; b < view.n; b++) {
                const int other = s->body[view.l[b]] != s->body[h];
                across += other;
                inside += !other && !view.intact[b];
                assert_int_equal(other, !view.intact[b]);
            }
        }
        assert_int_equal(par_sum_long(across) / 2, s->bonds_broken);
        assert_int_equal(par_sum_long(inside), 0);
        const double area = (dim == 3 ? SIDE * SPACING : 1) * SIDE * SPACING * (dim == 2 ? SPACING : 1);
        print_message("%d D, %s: crack_area over the interface's %.6f\n", dim,
                      mixed     ? "two materials"
                      : dilated ? "two Poisson's ratios"
                                : "one material",
                      par_sum(s->crack_area) / area);
        check_close(par_sum(s->crack_area) / area, dim == 3 ? 1.0131175 : 1.02801, 2e-5);
        if (!dilated) check_relative(par_sum(s->e_fracture), par_sum(held), 1e-12);
        check_relative(par_sum(s->e_fracture), before - solid_energy_measure(s).strain, 1e-12);
        solid_free(s);
    }
}

/* An interface that never breaks; bonds as a checkpoint stores them; contact leaves bonded pairs of two bodies alone.
 */
static void state_and_contact(void **state) {
    (void)state;
    struct joined m = {.dim = 2, .weak = INFINITY, .material = {soft, stiff}, .contact = 1};
    for (int k = 0; k < 2; k++) m.material[k].fracture_energy = INFINITY;
    struct solid *s = join(&m);
    for (int h = 0; h < s->n; h++) s->d[0][h] = s->body[h] ? -0.4 * SPACING : 0;
    solid_ghosts_update(s);
    solid_contact_update(s);
    solid_force(s, 1);
    check_equal(solid_contact_force_energy(s), 0); /* bonded, though nearer than r_c */
    for (int h = 0; h < s->n; h++) s->d[0][h] = s->body[h] ? 0.4 * SPACING : 0;
    solid_ghosts_update(s);
    solid_force(s, 1);
    solid_family_count(s);
    assert_int_equal(s->bonds_broken, 0);
    /* one bond of each particle at the interface is broken by hand; saved and loaded it is the same */
    static struct solid_family_view view;
    const int bytes = solid_family_bytes(s);
    uint8_t *bits = calloc((size_t)(s->n + 1) * (size_t)bytes, 1);
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++)
            if (view.intact[b] && s->body[view.l[b]] != s->body[h] && view.xi[b][1] == 0 &&
                fabs(view.xi[b][0]) < 1.5 * SPACING)
                solid_family_break(s, h, b);
    }
    solid_family_count(s);
    const long broken = s->bonds_broken;
    assert_int_equal(broken, SIDE);
    for (int h = 0; h < s->n; h++) solid_family_save(s, h, bits + (size_t)h * (size_t)bytes);
    solid_free(s);
    s = join(&m);
    for (int h = 0; h < s->n; h++) solid_family_load(s, h, bits + (size_t)h * (size_t)bytes);
    solid_family_count(s);
    assert_int_equal(s->bonds_broken, broken);
    free(bits);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(halves_are_the_whole), cmocka_unit_test(forces_of_two_materials),
        cmocka_unit_test(an_interface_takes_its_energy), cmocka_unit_test(state_and_contact)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
