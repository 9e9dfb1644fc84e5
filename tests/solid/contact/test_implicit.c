/* Implicit contact: collisions are elastic whatever the step, momentum and angular momentum are kept, and bonds with
 * contact are stable up to the bonds' own limit. */
#include "solid/bonds/ghosts.h"
#include "solid/contact/contact.h"
#include "solid/contact/implicit.h"
#include "solid/contact/repulsion.h"
#include "solid/imposed/added_mass.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/reactions.h"
#include "solid/measure/energy.h"
#include "solid/solid.h"
#include "solid/step/integrate.h"
#include "solid/step/rates.h"
#include "solid/step/stable.h"
#include "solid/surface/surface.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

static const double mass = DENSITY * SPACING * SPACING * SPACING;

/* 2/omega of two free particles that just touch, s. */
static double contact_limit(const struct solid *s) { return 2 / sqrt(solid_contact_rate_touch(s)); }

static void advance(struct solid *s, double dt, int substeps) {
    solid_contact_update(s);
    solid_integrate(s, dt, substeps);
}

/* Two bodies of one particle, the first of the second material if `heavy`; contact's exponent is given. */
static struct solid *two(double exponent, int heavy, const struct solid_constraint *held) {
    const struct solid_body body[2] = {bodies_box(0, 0, 0, 1, 1, 1), bodies_box(2, 0, 0, 1, 1, 1)};
    struct solid_body bodies[2] = {body[0], body[1]};
    static const struct solid_material material[2] = {{YOUNG, DENSITY, INFINITY, 3, PHYSICS_CONSTANT, 0, 0},
                                                      {3 * YOUNG, 2.5 * DENSITY, INFINITY, 3, PHYSICS_CONSTANT, 0, 0}};
    bodies[0].material = heavy;
    struct solid_input in = bodies_input(2, bodies);
    in.materials = 2;
    in.material = material;
    in.contact = 1;
    in.contact_exponent = exponent;
    in.constraints = held ? 1 : 0;
    in.constraint = held;
    struct solid *s = solid_new(&in);
    s->stage.integrator = SOLID_VERLET;
    if (held) solid_constraint_mark(s);
    return s;
}

static struct solid_surface *begin(struct solid *s) {
    struct solid_surface *surface = solid_surface_new(s);
    solid_ghosts_update(s);
    return surface;
}

static void end(struct solid *s, struct solid_surface *surface) {
    solid_contact_free(s);
    solid_surface_free(surface);
    solid_free(s);
}

/* Head on, with steps from a hundredth to twenty times the explicit limit: the velocities after it are those of an
 * elastic collision. The solver's tolerance is 1e-6 of contact's acceleration in each of up to a hundred steps. */
static void collides(void **state) {
    (void)state;
    const double exponent[2] = {1, 2.5}, part[4] = {0.01, 0.3, 3, 20};
    for (int k = 0; k < 16; k++) {
        if (check_skips(k + 1, 1)) continue; /* a debug build takes 0.3 and 20 */
        const int heavy = k / 8;
        struct solid *s = two(exponent[k / 4 % 2], heavy, NULL);
        struct solid_surface *surface = begin(s);
        const double dt = part[k % 4] * contact_limit(s), m = heavy ? 2.5 : 1, v0 = 2e-4 * SPACING / contact_limit(s);
        for (int h = 0; h < s->n; h++) {
            s->d[0][h] = s->body[h] == 0 ? (1 - 1e-4) * SPACING : 0;
            s->v[0][h] = s->body[h] == 0 ? v0 : 0;
        }
        solid_ghosts_update(s);
        for (int i = 0; i < 200 + (int)(20 / part[k % 4]); i++) advance(s, dt, 1);
        const double expected[2] = {v0 * (m - 1) / (m + 1), v0 * 2 * m / (m + 1)};
        for (int h = 0; h < s->n; h++) check_close(s->v[0][h], expected[s->body[h]], 1e-5 * v0);
        double p = 0;
        for (int h = 0; h < s->n; h++) p += (s->body[h] == 0 ? m : 1) * s->v[0][h];
        check_close(par_sum(p), m * v0, (heavy ? 1e-8 : 1e-13) * v0); /* the quantum, over up to 2200 steps */
        end(s, surface);
    }
}

/* What is conserved, whole solid: momentum, angular momentum about the origin (N s, N m s), kinetic energy plus
 * contact's potential, J. */
struct kept {
    double p[3], l[3], energy;
};

static struct kept kept_of(struct solid *s) {
    struct kept k = {0};
    double sum[7] = {0};
    solid_ghosts_update(s);
    for (int h = 0; h < s->n; h++) {
        double x[3], v[3];
        solid_position(s, h, x);
        for (int c = 0; c < 3; c++) {
            v[c] = s->v[c][h];
            sum[c] += mass * v[c];
            sum[6] += 0.5 * mass * v[c] * v[c];
        }
        for (int c = 0; c < 3; c++)
            sum[3 + c] += mass * (x[(c + 1) % 3] * v[(c + 2) % 3] - x[(c + 2) % 3] * v[(c + 1) % 3]);
    }
    par_sum_array(sum, 7);
    for (int c = 0; c < 3; c++) {
        k.p[c] = sum[c];
        k.l[c] = sum[3 + c];
    }
    k.energy = sum[6] + solid_contact_force_energy(s);
    return k;
}

enum { GRAINS = 5 };

/* 5 x 5 x 5 grains of one particle, a spacing apart in x and nearly touching in y and z, with random velocities
 * towards the middle. */
static struct solid *cloud(struct solid_body body[GRAINS * GRAINS * GRAINS]) {
    for (int i = 0; i < GRAINS * GRAINS * GRAINS; i++)
        body[i] = bodies_box(2 * (i % GRAINS), 2 * (i / GRAINS % GRAINS), 2 * (i / GRAINS / GRAINS), 1, 1, 1);
    struct solid_input in = bodies_input(GRAINS * GRAINS * GRAINS, body);
    in.contact = 1;
    struct solid *s = solid_new(&in);
    s->stage.integrator = SOLID_VERLET;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            s->d[c][h] = (GRAINS - 0.5 - s->x0[c][h] / SPACING) * 0.46 * SPACING;
            s->v[c][h] = 4e-2 * (bodies_random(s->body[h], c) - 0.5) * SPACING / contact_limit(s);
        }
    return s;
}

/* Grains that hit each other many times, with a step above the explicit limit. */
static void keeps(void **state) {
    (void)state;
    struct solid_body body[GRAINS * GRAINS * GRAINS];
    struct solid *s = cloud(body);
    struct solid_surface *surface = begin(s);
    const double dt = 1.5 * contact_limit(s);
    const struct kept first = kept_of(s);
    double least = first.energy, held = 0;
    double speed = 0;
    for (int h = 0; h < s->n; h++) speed = fmax(speed, fabs(s->v[0][h]));
    speed = par_max(speed);
    for (int i = 0; i < 100; i++) {
        advance(s, 0.5 * dt, 2);
        const struct kept now = kept_of(s);
        check_close(now.energy / first.energy, 1, 1e-5);
        held = fmax(held, solid_contact_force_energy(s) / first.energy);
        least = fmin(least, now.energy);
        for (int c = 0; c < 3; c++) {
            check_close(now.p[c], first.p[c], 1e-12 * s->n_global * mass * speed);
            check_close(now.l[c], first.l[c], 1e-6 * s->n_global * mass * speed * 10 * SPACING);
        }
    }
    print_message("contact held up to %.3f of the energy\n", held);
    check_above(held, 0.01);
    end(s, surface);
}

/* A held particle: the other one bounces back, the constraint gets its impulse and no work; a driven one works. */
static void holds(void **state) {
    (void)state;
    struct solid *free = two(1, 0, NULL);
    const double slow = 0.5e-3 * SPACING / contact_limit(free); /* m/s */
    solid_free(free);
    for (int driven = 0; driven < 2; driven++) {
        struct solid_constraint held = {.low = {1.9 * SPACING, 0, 0},
                                        .high = {3.1 * SPACING, SPACING, SPACING},
                                        .direction = {1, 1, 1},
                                        .velocity = {driven ? -0.5 * slow : 0}};
        struct solid *s = two(1, 0, &held);
        struct solid_surface *surface = begin(s);
        const double dt = 2 * contact_limit(s), v0 = 1e-3 * SPACING / dt, u = held.velocity[0];
        check_close(v0, slow, 1e-12 * v0);
        for (int h = 0; h < s->n; h++) {
            s->d[0][h] = s->body[h] == 0 ? (1 - 2e-3) * SPACING : 0;
            s->v[0][h] = s->body[h] == 0 ? v0 : u;
        }
        solid_ghosts_update(s);
        solid_reactions_new(s);
        double impulse = 0;
        for (int i = 0; i < 40; i++) {
            struct solid_reaction reaction;
            solid_contact_update(s);
            solid_reactions_begin(s);
            solid_integrate(s, dt, 2);
            solid_reactions_measure(s, &reaction);
            impulse += reaction.force[0] * 2 * dt;
        }
        for (int h = 0; h < s->n; h++) check_close(s->v[0][h], s->body[h] == 0 ? 2 * u - v0 : u, 2e-6 * v0);
        check_close(impulse, -2 * mass * (v0 - u), 1e-5 * mass * v0);
        check_close(par_sum(s->e_constraint), 0.5 * mass * ((2 * u - v0) * (2 * u - v0) - v0 * v0),
                    1e-5 * mass * v0 * v0);
        end(s, surface);
    }
}

/* Added mass on the struck particle's face: it moves like a heavier one along the normal. */
static void carries(void **state) {
    (void)state;
    struct solid *s = two(1, 0, NULL);
    struct solid_surface *surface = begin(s);
    const double one[1] = {1}, none[1] = {0}, density[1] = {0.8 * DENSITY};
    int which[1] = {0};
    for (int h = 0; h < s->n; h++)
        if (s->body[h] == 1) which[0] = h;
    double lost[1] = {0}, before[1], from[1];
    const struct solid_added_mass added = {.n = 1,
                                           .h = which,
                                           .normal = {one, none, none},
                                           .density = density,
                                           .lost = lost,
                                           .before = before,
                                           .from = from};
    s->added = &added;
    const double dt = 3 * contact_limit(s), v0 = 1e-3 * SPACING / dt, m = 1.8;
    for (int h = 0; h < s->n; h++) {
        s->d[0][h] = s->body[h] == 0 ? (1 - 2e-3) * SPACING : 0;
        s->v[0][h] = s->body[h] == 0 ? v0 : 0;
    }
    solid_ghosts_update(s);
    for (int i = 0; i < 40; i++) advance(s, dt, 1);
    for (int h = 0; h < s->n; h++) check_close(s->v[0][h], v0 * (s->body[h] == 0 ? (1 - m) : 2) / (1 + m), 3e-6 * v0);
    /* what the fluid got is the added mass' kinetic energy */
    check_close(s->work_load, -0.5 * 0.8 * mass * (2 * v0 / (1 + m)) * (2 * v0 / (1 + m)), 1e-5 * mass * v0 * v0);
    s->added = NULL;
    end(s, surface);
}

/* Two bars that are thrown at each other at 0.97 of the bonds' limit and stay pressed together by a body force towards
 * the middle: the energy does not grow. Explicit contact at this step is unstable (its limit is less than half of it).
 */
static void bonds_alone_limit(void **state) {
    (void)state;
    const struct solid_body body[2] = {bodies_box(0, 0, 0, 6, 4, 4), bodies_box(6, 0, 0, 6, 4, 4)};
    struct solid_input in = bodies_input(2, body);
    in.contact = 1;
    in.contact_stiffness = 100;
    struct solid *s = solid_new(&in);
    s->stage.integrator = SOLID_VERLET;
    struct solid_surface *surface = begin(s);
    struct solid_rates rates;
    solid_rates_of(s, &rates);
    const double limit = solid_stable_of(&rates, SOLID_VERLET, 0, NULL), dt = 0.97 * limit;
    const double wave = sqrt(YOUNG / DENSITY), force = 2e-3 * YOUNG / (6 * SPACING);
    check_above(dt, 2 * solid_stable_linear(&rates, SOLID_VERLET, solid_contact_rate_touch(s)));
    for (int h = 0; h < s->n; h++) {
        s->v[0][h] = (s->body[h] == 0 ? 1 : -1) * 1e-3 * wave;
        s->load[0][h] = (s->body[h] == 0 ? 1 : -1) * force;
    }
    solid_ghosts_update(s);
    const double first = par_sum(0.5 * mass * s->n) * 1e-6 * wave * wave;
    double most = 0;
    for (int i = 0; i < (check_skips(1, 1) ? 600 : 2000); i++) {
        advance(s, dt, 1);
        if (i % 20) continue;
        const struct solid_energy e = solid_energy_measure(s);
        const double all = e.kinetic + e.strain + e.contact - par_sum(s->work_load);
        most = fmax(most, all / first);
    }
    print_message("largest energy over that at the start: %.4f\n", most);
    check_below(most, 1.02);
    end(s, surface);
}

/* The energy over that at the start, in the mean over the last half of 4000 steps. */
struct seen {
    double ends, half; /* with velocities at the ends of the steps, and in the middle of the steps before and after */
    double off;        /* the largest change of the sum of all energies, the integrator's included */
};

/* Two free bars that were thrown at each other, with a step of a part of the bonds' limit. */
static struct seen thrown(double part) {
    enum { STEPS = 4000 };
    const struct solid_body body[2] = {bodies_box(0, 0, 0, 6, 4, 4), bodies_box(6, 0, 0, 6, 4, 4)};
    struct solid_input in = bodies_input(2, body);
    in.contact = 1;
    struct solid *s = solid_new(&in);
    s->stage.integrator = SOLID_VERLET;
    struct solid_surface *surface = begin(s);
    struct solid_rates rates;
    solid_rates_of(s, &rates);
    const double dt = part * solid_stable_of(&rates, SOLID_VERLET, 0, NULL), v0 = 1e-3 * sqrt(YOUNG / DENSITY);
    for (int h = 0; h < s->n; h++) s->v[0][h] = (s->body[h] == 0 ? 1 : -1) * v0;
    solid_ghosts_update(s);
    const double first = par_sum(0.5 * mass * s->n) * v0 * v0;
    struct seen seen = {0};
    for (int i = 0; i < STEPS; i++) {
        advance(s, dt, 1);
        const struct solid_energy e = solid_energy_measure(s);
        seen.off = fmax(seen.off, fabs((e.kinetic + e.strain + e.contact + par_sum(s->e_integrator)) / first - 1));
        if (i < STEPS / 2) continue;
        double kick = 0; /* the squares of v - dt/2 a and v + dt/2 a in the mean, less that of v */
        for (int c = 0; c < 3; c++)
            for (int h = 0; h < s->n; h++) kick += 0.5 * mass * 0.25 * dt * dt * s->a[c][h] * s->a[c][h];
        const double all = e.kinetic + e.strain + e.contact;
        seen.ends += all / first / (STEPS / 2);
        seen.half += (all + par_sum(kick)) / first / (STEPS / 2);
    }
    end(s, surface);
    return seen;
}

/* The energy that an impact seems to lose is in fast waves, whose kinetic energy is smaller at the ends of steps than
 * in their middle. There it is all, but for 2e-4 by what the waves' phases leave in the mean. */
static void loses_nothing(void **state) {
    (void)state;
    const double part[2] = {0.97, 0.485}, lost[2] = {0.02, 0.005}; /* at least, at the ends: measured 0.024, 0.011 */
    for (int k = 0; k < 2; k++) {
        if (check_skips(k, 1)) continue;
        const struct seen seen = thrown(part[k]);
        print_message("steps of %.3f of the limit: energy %.5f at their ends, %.5f in their middle, off %.2g\n",
                      part[k], seen.ends, seen.half, seen.off);
        check_close(seen.half, 1, 2e-4);
        check_below(seen.off, 1e-3);
        check_above(1 - seen.ends, lost[k]);
    }
}

/* What damping dissipates is computed from the way of the particles, of which contact has a part: with next to no
 * damping, bars that collide dissipate nothing. */
static void dissipates_nothing(void **state) {
    (void)state;
    const struct solid_body body[2] = {bodies_box(0, 0, 0, 6, 4, 4), bodies_box(6, 0, 0, 6, 4, 4)};
    struct solid_input in = bodies_input(2, body);
    in.contact = 1;
    struct solid *s = solid_new(&in);
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .damping_relative = 1e-17};
    struct solid_surface *surface = begin(s);
    struct solid_rates rates;
    solid_rates_of(s, &rates);
    const double dt = 0.9 * solid_stable_of(&rates, SOLID_VERLET, 0, NULL), v0 = 1e-6 * sqrt(YOUNG / DENSITY);
    for (int h = 0; h < s->n; h++) s->v[0][h] = (s->body[h] == 0 ? 1 : -1) * v0;
    solid_ghosts_update(s);
    const double first = par_sum(0.5 * mass * s->n) * v0 * v0;
    double strain = 0, damped = 0;
    for (int i = 0; i < 60; i++) {
        advance(s, dt, 1);
        const struct solid_energy e = solid_energy_measure(s);
        strain = fmax(strain, e.strain);
        damped = fmax(damped, fabs(e.damped));
    }
    print_message("strain energy up to %.3f, dissipated up to %.2g of the energy\n", strain / first, damped / first);
    check_above(strain, 0.2 * first);
    check_below(damped, 1e-5 * first);
    end(s, surface);
}

/* The potential is the integral of the repulsion; the slope times the change of r^2 is the change of the potential, and
 * for equal depths it is the force. Depths from 1e-9 to 0.8, on both sides of the series' end, and apart. */
static void slopes(void **state) {
    (void)state;
    enum { DEPTHS = 9 };
    const double rc = 1.3, exponent[3] = {1, 2, 4.5},
                 depth[DEPTHS] = {-0.1, 0, 1e-9, 3e-9, 1e-6, 1e-3, 0.0299, 0.0301, 0.8};
    for (int k = 0; k < 3; k++) {
        const double n = exponent[k];
        for (int i = 0; i < DEPTHS; i++) {
            const double q = depth[i], r = rc * (1 - q), phi = solid_repulsion_potential(q, rc, n);
            check_close(solid_repulsion_depth(r * r, rc), q, 2e-16);
            const double closed =
                n == 1 ? rc * log(rc / r) - (rc - r) : rc / (n - 1) * (pow(rc / r, n - 1) - 1) - (rc - r);
            if (q >= 1e-3) check_close(phi / closed, 1, 1e-9);
            if (q > 0 && q < 1e-3) check_close(phi / (0.5 * n * rc * q * q), 1, n * q);
            if (q <= 0) check_equal(phi, 0);
            check_close(solid_repulsion_slope(q, phi, q, rc, n), q > 0 ? solid_repulsion(r, rc, n) / (2 * r) : 0,
                        (q > 0 ? 1e-15 + 1e-13 * pow(rc / r, n) : 0) / r);
            for (int j = 0; j < DEPTHS; j++) {
                const double other = solid_repulsion_potential(depth[j], rc, n),
                             change = rc * rc * (q - depth[j]) * (2 - q - depth[j]),
                             slope = solid_repulsion_slope(q, phi, depth[j], rc, n);
                check_close(slope * change, phi - other, 1e-13 * (phi + other));
                check_at_least(slope, 0);
            }
        }
    }
}

/* Two free particles that loads press on one another, with steps far above the explicit limit: a pair touches in one
 * iterate and not in the next. All substeps are solved, and the energy stays bounded. */
static void pressed(void **state) {
    (void)state;
    const double part[5] = {5, 6, 7, 12, 14};
    for (int k = 0; k < 5; k++) {
        const struct solid_body body[2] = {bodies_box(0, 0, 0, 1, 1, 1), bodies_box(1, 0, 0, 1, 1, 1)};
        struct solid_input in = bodies_input(2, body);
        in.contact = 1;
        struct solid *s = solid_new(&in);
        s->stage.integrator = SOLID_VERLET;
        struct solid_surface *surface = begin(s);
        const double dt = part[k] * contact_limit(s), a = 1e-6 * SPACING / (contact_limit(s) * contact_limit(s));
        double first = 0, later = 0;
        for (int i = 0; i < 400; i++) {
            for (int h = 0; h < s->n; h++) s->load[0][h] = (s->body[h] == 0 ? 1 : -1) * DENSITY * a;
            advance(s, dt, 1);
            check_equal(solid_integrate_check(s).failed, 0);
            double energy = 0;
            for (int h = 0; h < s->n; h++) energy += s->v[0][h] * s->v[0][h];
            energy = par_sum(energy);
            if (i < 20) first = fmax(first, energy);
            later = fmax(later, energy);
        }
        check_above(first, 0);
        check_at_most(later, 30 * first); /* as in cases/stability/solid */
        end(s, surface);
    }
}

/* A substep that cannot be solved is a fault with a place, until the next call; the state stays finite. */
static void tells_fault(void **state) {
    (void)state;
    struct solid *s = two(1, 0, NULL);
    struct solid_surface *surface = begin(s);
    const double limit = contact_limit(s);
    for (int h = 0; h < s->n; h++) s->d[0][h] = s->body[h] == 0 ? 1.01 * SPACING : 0;
    solid_ghosts_update(s);
    advance(s, 1e6 * limit, 1);
    const struct step_status status = solid_integrate_check(s);
    check_equal(par_max(status.failed), 1);
    if (status.failed) {
        assert_string_equal(status.field, "contact's error");
        check_above(status.value, 1e-6);
        check_equal(status.seen_in, STEP_STATUS_SOLID);
        check_close(status.x[1], 0.5 * SPACING, 1e-12 * SPACING);
    }
    for (int h = 0; h < s->n; h++) {
        s->d[0][h] = s->v[0][h] = 0;
        check_equal(isfinite(s->v[1][h]), 1);
    }
    solid_ghosts_update(s);
    solid_integrate(s, 0.1 * limit, 1);
    check_equal(solid_integrate_check(s).failed, 0);
    end(s, surface);
}

/* All energies, J. */
static double all_of(struct solid *s) {
    const struct solid_energy e = solid_energy_measure(s);
    return e.kinetic + e.strain + e.contact + e.damped + e.fracture + par_sum(s->e_integrator);
}

/* What absolute damping takes is computed from the way of the particles too, of which contact has a part: with it the
 * energies of bars that collide are constant, and without it they are off by percents. */
static void damps_what_it_takes(void **state) {
    (void)state;
    const struct solid_body body[2] = {bodies_box(0, 0, 0, 6, 4, 4), bodies_box(6, 0, 0, 6, 4, 4)};
    struct solid_input in = bodies_input(2, body);
    in.contact = 1;
    in.contact_stiffness = 100;
    struct solid *s = solid_new(&in);
    const double wave = sqrt(YOUNG / DENSITY), v0 = 1e-6 * wave;
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .damping_absolute = 0.2 * wave / SPACING};
    struct solid_surface *surface = begin(s);
    const double dt = 0.9 * solid_rates_stable_step(s, SOLID_VERLET);
    for (int h = 0; h < s->n; h++) s->v[0][h] = (s->body[h] == 0 ? 1 : -1) * v0;
    solid_ghosts_update(s);
    const double first = par_sum(0.5 * mass * s->n) * v0 * v0;
    double off = 0, strain = 0;
    for (int i = 0; i < 60; i++) {
        advance(s, dt, 1);
        off = fmax(off, fabs(all_of(s) + par_sum(s->damped_missed) - first));
        strain = fmax(strain, solid_energy_measure(s).strain);
    }
    print_message("off by %.2g of the energy at the start, strain energy up to %.2g\n", off / first, strain / first);
    check_above(strain, 0.01 * first);
    check_below(off, 1e-5 * first);
    end(s, surface);
}

/* Particles with random velocities break nearly all bonds within one call, and collide again and again, though none
 * moves by more than 0.02 spacings. A pair that was listed only after the call would overlap by then, with a hundred
 * times the energy that there is. */
static void collide_after_breaking(void **state) {
    (void)state;
    for (int general = 0; general < 2; general++) {
        const struct solid_body body = bodies_box(0, 0, 0, 6, 5, 5);
        struct solid_material weak = bodies_material;
        struct solid_input in = bodies_input(1, &body);
        weak.fracture_energy = 1e-9;
        in.material = &weak;
        in.contact = 1;
        in.general_bonds = general;
        struct solid *s = solid_new(&in);
        struct solid_surface *surface = begin(s);
        s->stage.breakage = 1;
        s->stage.integrator = SOLID_VERLET;
        for (int h = 0; h < s->n; h++)
            for (int c = 0; c < 3; c++) s->v[c][h] = 0.2 * (bodies_random(bodies_id(s, h), c) - 0.5);
        solid_contact_update(s);
        const double before = all_of(s);
        solid_integrate(s, 5e-7, 400);
        solid_contact_update(s);
        check_close(all_of(s), before, 1e-5 * before);
        for (int h = 0; h < s->n; h++) check_equal(s->flag[h] & SOLID_BROKEN, SOLID_BROKEN);
        end(s, surface);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(slopes),
                                       cmocka_unit_test(collides),
                                       cmocka_unit_test(keeps),
                                       cmocka_unit_test(holds),
                                       cmocka_unit_test(carries),
                                       cmocka_unit_test(bonds_alone_limit),
                                       cmocka_unit_test(loses_nothing),
                                       cmocka_unit_test(dissipates_nothing),
                                       cmocka_unit_test(damps_what_it_takes),
                                       cmocka_unit_test(pressed),
                                       cmocka_unit_test(tells_fault),
                                       cmocka_unit_test(collide_after_breaking)};
    const struct CMUnitTest many[] = {cmocka_unit_test(collides),
                                      cmocka_unit_test(keeps),
                                      cmocka_unit_test(holds),
                                      cmocka_unit_test(bonds_alone_limit),
                                      cmocka_unit_test(loses_nothing),
                                      cmocka_unit_test(dissipates_nothing),
                                      cmocka_unit_test(damps_what_it_takes),
                                      cmocka_unit_test(pressed),
                                      cmocka_unit_test(tells_fault),
                                      cmocka_unit_test(collide_after_breaking)};
    const int failed =
        par_size() == 1 ? cmocka_run_group_tests(tests, NULL, NULL) : cmocka_run_group_tests(many, NULL, NULL);
    par_end();
    return failed;
}
