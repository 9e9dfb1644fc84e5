/* Contact: repulsion between unbonded particles against brute force, and its energy. */
#include "solid/bonds/ghosts.h"
#include "solid/contact/contact.h"
#include "solid/contact/list.h"
#include "solid/law/material.h"
#include "solid/measure/energy.h"
#include "solid/measure/motion.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "solid/surface/surface.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

enum { MOST = 2000 };

/* Every particle of the solid, on every rank, by global id. */
struct everyone {
    double x[MOST][3];
    int bonded_to[MOST]; /* scratch */
};
static struct everyone all;

static void gather(const struct solid *s) {
    check_at_most(s->n_global, MOST);
    memset(&all, 0, sizeof all);
    for (int h = 0; h < s->n; h++) {
        double x[3];
        solid_position(s, h, x);
        memcpy(all.x[bodies_id(s, h)], x, sizeof x);
    }
    par_sum_array(&all.x[0][0], 3 * MOST);
}

/* C_h/rho by brute force over all pairs at r < r_c; joined(h, l): whether an intact bond joins two ids. */
static void brute_force(const struct solid *s, int h, int (*joined)(long, long), double a[3]) {
    const double rc = s->in.contact_radius * SPACING, volume = SPACING * SPACING * SPACING;
    const double k = s->in.contact_stiffness * solid_material_micromodulus(&bodies_material, SPACING);
    const long i = bodies_id(s, h);
    a[0] = a[1] = a[2] = 0;
    for (long j = 0; j < s->n_global; j++) {
        double x[3], r = 0;
        if (i == j || joined(i, j)) continue;
        for (int c = 0; c < 3; c++) {
            x[c] = all.x[i][c] - all.x[j][c];
            if (s->in.periodic[c]) x[c] -= s->in.length[c] * rint(x[c] / s->in.length[c]);
            r += x[c] * x[c];
        }
        r = sqrt(r);
        if (r >= rc) continue;
        const double f = k * (pow(rc / r, s->in.contact_exponent) - 1) * volume / DENSITY;
        for (int c = 0; c < 3; c++) a[c] += f * x[c] / r;
    }
}

/* k_c V_l/rho: the repulsion of a pair at half of r_c, m/s2. */
static double scale(const struct solid *s) {
    return s->in.contact_stiffness * solid_material_micromodulus(&bodies_material, SPACING) * SPACING * SPACING *
           SPACING / DENSITY;
}

static void clear(struct solid *s) {
    for (int c = 0; c < 3; c++) memset(s->a[c], 0, (size_t)s->n * sizeof(double));
}

/* solid_contact_force against brute force, momentum, and the sense along x of the two halves' forces (mass-weighted).
 */
static void check_force(struct solid *s, int (*joined)(long, long)) {
    double sum[4] = {0, 0, 0, 0};
    gather(s);
    clear(s);
    solid_contact_force(s);
    for (int h = 0; h < s->n; h++) {
        double a[3];
        brute_force(s, h, joined, a);
        for (int c = 0; c < 3; c++) {
            check_close(s->a[c][h], a[c], 1e-12 * scale(s));
            sum[c] += s->a[c][h];
            sum[3] += fabs(s->a[c][h]);
        }
    }
    par_sum_array(sum, 4);
    check_above(sum[3], 0);
    for (int c = 0; c < 3; c++) check_close(sum[c], 0, 1e-13 * sum[3]);
}

static long first_of_second; /* global id at which the second body starts */
static int same_body(long i, long j) { return (i < first_of_second) == (j < first_of_second); }

static struct solid *two_blocks(int gap, int periodic, int general, double exponent) {
    const struct solid_body body[2] = {bodies_box(0, 0, 0, 6, 6, 6), bodies_box(6 + gap, 0, 0, 6, 6, 6)};
    struct solid_input in = bodies_input(2, body);
    in.contact = 1;
    in.general_bonds = general;
    in.contact_exponent = exponent;
    in.periodic[0] = periodic;
    in.length[0] = 30 * SPACING;
    first_of_second = 216;
    return solid_new(&in);
}

static void push_second(struct solid *s, const double by[3]) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) s->d[c][h] = s->body[h] == 1 ? by[c] : 0;
    solid_ghosts_update(s);
}

/* Nothing is made before anything can touch: one unbroken body, two bodies far apart, also when asked to have none. */
static void nothing_before_touch(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 7, 7, 7);
    struct solid_input in = bodies_input(1, &body);
    in.contact = 1;
    struct solid *s = solid_new(&in);
    struct solid_surface *f = solid_surface_new(s);
    solid_contact_update(s);
    assert_null(s->contact);
    check_equal(solid_contact_force_energy(s), 0);
    bodies_open(s, 0, 3, 0.3 * SPACING);
    solid_contact_update(s);
    assert_null(s->contact);
    bodies_cut(s, 0, 3);
    solid_contact_update(s);
    assert_non_null(s->contact);
    solid_surface_free(f);
    solid_contact_free(s);
    assert_null(s->contact);
    solid_free(s);

    s = two_blocks(4, 0, 0, 1);
    f = solid_surface_new(s);
    solid_contact_update(s);
    assert_null(s->contact);
    push_second(s, (double[]){-3.0 * SPACING, 0, 0});
    solid_contact_update(s);
    assert_null(s->contact);
    push_second(s, (double[]){-3.7 * SPACING, 0, 0});
    solid_contact_update(s);
    assert_non_null(s->contact);
    clear(s);
    solid_contact_force(s);
    for (int h = 0; h < s->n; h++) check_equal(s->a[0][h], 0);
    s->in.contact = 0;
    solid_contact_free(s);
    solid_contact_update(s);
    assert_null(s->contact);
    solid_surface_free(f);
    solid_free(s);
}

/* Two blocks pushed into each other: the force is the law's, equal and opposite, and pushes them apart. */
static void two_bodies(void **state) {
    (void)state;
    for (int general = 0; general < 2; general++)
        for (int periodic = 0; periodic < 2; periodic++) {
            struct solid *s = two_blocks(4, periodic, general, periodic ? 2 : 1);
            struct solid_surface *f = solid_surface_new(s);
            /* second body onto the first: from the right, or round the period from the left */
            const double way = periodic ? 14.3 : -4.3;
            push_second(s, (double[]){way * SPACING, 0.21 * SPACING, -0.13 * SPACING});
            solid_contact_update(s);
            assert_non_null(s->contact);
            check_force(s, same_body);
            double total = 0;
            for (int h = 0; h < s->n; h++)
                if (s->body[h] == 1) total += s->a[0][h];
            check_above(par_sum(total) * (periodic ? -1 : 1), 0);
            /* a little further without new lists */
            for (int h = 0; h < s->n; h++) s->d[1][h] += 0.1 * SPACING * (bodies_random(bodies_id(s, h), 5) - 0.5);
            solid_ghosts_update(s);
            check_force(s, same_body);
            solid_surface_free(f);
            solid_contact_free(s);
            solid_free(s);
        }
}

static double cut_at;
static int halves(long i, long j) {
    int side[2];
    const long id[2] = {i, j};
    for (int k = 0; k < 2; k++) side[k] = all.bonded_to[id[k]];
    return side[0] == side[1];
}

/* A cut block whose halves are pressed together, then slid over each other: broken-bond pairs, then non-bonded pairs.
 */
static void cut_block(void **state) {
    (void)state;
    const struct solid_body body = bodies_box(0, 0, 0, 10, 6, 6);
    for (int general = 0; general < 2; general++)
        for (int slide = 0; slide < 2; slide++) {
            struct solid_input in = bodies_input(1, &body);
            in.contact = 1;
            in.general_bonds = general;
            struct solid *s = solid_new(&in);
            struct solid_surface *f = solid_surface_new(s);
            cut_at = 5 * SPACING;
            for (int step = 0; step <= 4; step++) { /* the update sees it move, and break in two goes */
                bodies_cut_short(s, 0, 5, step < 4 ? 1.2 * SPACING : INFINITY);
                for (int h = 0; h < s->n; h++) {
                    const int right = s->x0[0][h] > cut_at;
                    s->d[0][h] = right ? (slide ? -0.2 : -0.3 * step / 4) * SPACING : 0;
                    s->d[1][h] = right && slide ? 4.55 * SPACING * step / 4 : 0;
                }
                solid_surface_update(s, f);
                solid_contact_update(s);
            }
            double side[MOST] = {0};
            for (int h = 0; h < s->n; h++) side[bodies_id(s, h)] = s->x0[0][h] > cut_at;
            par_sum_array(side, MOST);
            gather(s);
            clear(s);
            solid_contact_force(s);
            double sum[3] = {0, 0, 0}, right = 0, size = 0;
            for (int i = 0; i < MOST; i++) all.bonded_to[i] = (int)side[i];
            for (int h = 0; h < s->n; h++) {
                double a[3];
                brute_force(s, h, halves, a);
                for (int c = 0; c < 3; c++) {
                    check_close(s->a[c][h], a[c], 1e-12 * scale(s));
                    sum[c] += s->a[c][h];
                }
                size += fabs(s->a[0][h]);
                if (side[bodies_id(s, h)] > 0) right += s->a[0][h];
            }
            par_sum_array(sum, 3);
            size = par_sum(size);
            check_above(par_sum(right), 0.1 * size);
            for (int c = 0; c < 3; c++) check_close(sum[c], 0, 1e-13 * size);
            solid_surface_free(f);
            solid_contact_free(s);
            solid_free(s);
        }
}

/* The force is the derivative of the potential: d(energy)/d(displacement) against the sum of forces. */
static void force_from_energy(void **state) {
    (void)state;
    const double exponent[2] = {1, 3};
    for (int k = 0; k < 2; k++) {
        struct solid *s = two_blocks(4, 0, 0, exponent[k]);
        struct solid_surface *f = solid_surface_new(s);
        double energy[2];
        const double step = 1e-4 * SPACING;
        push_second(s, (double[]){-4.3 * SPACING, 0, 0});
        solid_contact_update(s);
        for (int side = 0; side < 2; side++) {
            push_second(s, (double[]){-4.3 * SPACING + (side ? step : -step), 0, 0});
            energy[side] = solid_contact_force_energy(s);
        }
        push_second(s, (double[]){-4.3 * SPACING, 0, 0});
        clear(s);
        solid_contact_force(s);
        double force = 0;
        for (int h = 0; h < s->n; h++)
            if (s->body[h] == 1) force += DENSITY * s->volume[h] * s->a[0][h];
        force = par_sum(force);
        check_above(energy[0], energy[1]);
        check_above(energy[1], 0);
        check_relative(energy[0] - energy[1], 2 * step * force, 1e-6);
        struct solid_motion motion[2];
        solid_motion_measure(s, motion);
        check_relative(motion[1].contact[0], force, 1e-9);
        check_relative(motion[0].contact[0], -force, 1e-9);
        check_relative(motion[1].displacement[0], -4.3 * SPACING, 1e-12);
        solid_surface_free(f);
        solid_contact_free(s);
        solid_free(s);
    }
}

/* Two blocks meet and part: momentum to round-off, energy to the integrator's error. */
static void bounce(void **state) {
    (void)state;
    struct solid *s = two_blocks(1, 0, 0, 1);
    struct solid_surface *f = solid_surface_new(s);
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET};
    const double speed = 1, dt = 0.25 * SPACING / sqrt(YOUNG / DENSITY);
    for (int h = 0; h < s->n; h++) s->v[0][h] = s->body[h] == 1 ? -speed : speed;
    const double start = solid_energy_measure(s).kinetic;
    double worst = 0, touching = 0, velocity = 0, momentum = 0;
    for (int step = 0; step < 800; step++) {
        solid_contact_update(s);
        solid_integrate(s, dt, 1);
        if (step % 10) continue;
        solid_ghosts_update(s);
        const struct solid_energy e = solid_energy_measure(s);
        touching = fmax(touching, e.contact);
        worst = check_worst(worst, e.kinetic + e.strain + e.contact - start);
    }
    for (int h = 0; h < s->n; h++) {
        momentum += s->v[0][h];
        if (s->body[h] == 1) velocity += s->v[0][h] / 216;
    }
    velocity = par_sum(velocity);
    momentum = par_sum(momentum);
    print_message("bounce: energy out by %.2e, at most %.2f of it in contact, velocity after %.3f of that before\n",
                  worst / start, touching / start, velocity / speed);
    check_above(touching, 0.02 * start);
    check_equal(solid_contact_force_energy(s), 0);
    check_above(velocity, 0.3 * speed);
    check_close(momentum, 0, 1e-10 * 432 * speed);
    check_below(worst, 5e-3 * start);
    solid_surface_free(f);
    solid_contact_free(s);
    solid_free(s);
}

/* r_c (log(r_c/r) - 1) + r, m: the potential of a pair over k V V, for the exponent 1. */
static double of_pair(double rc, double r) { return rc * log(rc / r) - (rc - r); }

/* r_c = 1.5 spacings. Particles of one body repel each other only once they are nearer than at the start: bonds that
 * break at rest make neither force nor energy. Two bodies repel each other from r_c on. */
static void near_at_start(void **state) {
    (void)state;
    for (int bodies = 1; bodies <= 2; bodies++) {
        const struct solid_body body[2] = {bodies_box(0, 0, 0, 6 / bodies, 6, 6), bodies_box(3, 0, 0, 3, 6, 6)};
        struct solid_input in = bodies_input(bodies, body);
        in.contact = 1;
        in.contact_radius = 1.5;
        struct solid *s = solid_new(&in);
        struct solid_surface *f = solid_surface_new(s);
        if (bodies == 1) bodies_cut(s, 0, 3);
        const double k = in.contact_stiffness * solid_material_micromodulus(&bodies_material, SPACING);
        const double unit = k * pow(SPACING, 7);
        for (int closed = 0; closed < 2; closed++) {
            const double x = 1 - 0.01 * closed; /* the two halves' distance in spacings */
            bodies_open(s, 0, 3, (x - 1) * SPACING);
            solid_ghosts_update(s);
            solid_contact_update(s);
            assert_non_null(s->contact);
            clear(s);
            solid_contact_force(s);
            double most = 0;
            for (int h = 0; h < s->n; h++) most = fmax(most, fabs(s->a[0][h]));
            /* 36 pairs along x, 120 along the diagonals of squares; the diagonals of cubes are longer than r_c */
            const double straight = bodies == 1 ? 1 : 1.5, across = bodies == 1 ? sqrt(2) : 1.5;
            const double expected = unit * (36 * of_pair(straight, x) + 120 * of_pair(across, hypot(x, 1)));
            check_close(solid_contact_force_energy(s), expected, 1e-9 * unit);
            if (bodies == 1 && !closed)
                check_equal(par_max(most), 0);
            else
                check_above(par_max(most), 1e-3 * scale(s));
        }
        solid_surface_free(f);
        solid_contact_free(s);
        solid_free(s);
    }
}

/* A grain that flies along the face of a block is a fast particle: it moves much further than others until the lists
 * are made again, and finds whom it meets all the same. */
static void fast_particle(void **state) {
    (void)state;
    const struct solid_body body[2] = {bodies_box(0, 0, 0, 6, 6, 6), bodies_box(8, 0, 2, 1, 1, 1)};
    struct solid_input in = bodies_input(2, body);
    in.contact = 1;
    first_of_second = 216;
    struct solid *s = solid_new(&in);
    struct solid_surface *f = solid_surface_new(s);
    const double step = 0.04;
    double longest = 0, way = 0, built = NAN;
    for (int i = 0; i < 130; i++) {
        push_second(s, (double[]){-2.2 * SPACING, (0.1 + step * i) * SPACING, 0});
        solid_contact_update(s);
        check_force(s, same_body);
        double at = -INFINITY;
        for (int h = 0; h < s->n; h++)
            if (s->body[h] == 1) at = s->contact->listed_d[1][h];
        at = par_max(at);
        way = at == built ? way + step : 0;
        built = at;
        longest = fmax(longest, way);
    }
    check_above(longest, 0.5);
    check_at_most(longest, 0.625 + step);
    solid_contact_free(s);
    solid_surface_free(f);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_before_touch), cmocka_unit_test(two_bodies), cmocka_unit_test(cut_block),
        cmocka_unit_test(force_from_energy),    cmocka_unit_test(bounce),     cmocka_unit_test(near_at_start),
        cmocka_unit_test(fast_particle),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
