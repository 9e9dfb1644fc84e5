/* Mandel's slab under a constant load. With the plates' displacement instead, and Terzaghi's column:
 * cases/verification/consolidation. */
#include "cracks/struts.h"
#include "tests/physics/consolidation.h"
#include "tests/cracks/struts_of.h"
#include "solid/imposed/time.h"
#include "solid/step/integrate.h"
#include "tests/cracks/porous.h"

/* Mandel's slab |x| <= a: WIDE columns, of which the outer two are drained; a is the distance of their centres from the
 * middle. Each particle is held along y with the same strain along y, so that rows are alike, but for those within
 * a horizon of the ends, whose families are not whole: the slab is so high that they hardly count in its middle. */
enum { HALF = 32, WIDE = 2 * HALF + 1, HIGH = 96 };

/* Moves all particles along y with the same rate of strain. */
static void strain(struct solid *s, double rate) {
    for (int h = 0; h < s->n; h++) s->v[1][h] = rate * (s->x0[1][h] - 0.5 * HIGH * SPACING);
}

/* The mean compression along y across the plane between the two middle rows, of bonds and fluid, over the width 2 a. */
static double compression(const struct cracks *c) {
    static struct solid_family_view view;
    const struct solid *s = c->solid;
    const struct cracks_struts *t = &c->struts;
    const double middle = 0.5 * HIGH * SPACING;
    uint16_t kind[2 * SOLID_FAMILY_MAX];
    int other[2 * SOLID_FAMILY_MAX];
    double sum = 0;
    for (int i = 0; i < t->n; i++) { /* every particle is wet: i is h */
        const int h = t->h[i];
        if (s->x0[1][h] > middle || s->x0[1][h] < middle - 4 * SPACING) continue;
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            const double *xi = view.xi[b];
            if (s->x0[1][h] + xi[1] < middle) continue;
            const double x = xi[0] + s->d[0][view.l[b]] - s->d[0][h], y = xi[1] + s->d[1][view.l[b]] - s->d[1][h];
            const double length = hypot(xi[0], xi[1]), now = hypot(x, y), stretch = (now - length) / length;
            sum -= view.alpha[b] * view.micro[b] * stretch * view.weight[b] * s->volume[h] * y / now;
        }
        const int struts = struts_of(c, i, kind, other);
        for (int k = 0; k < struts; k++) {
            if (s->x0[1][h] + c->table.step[kind[k]][1] * SPACING < middle) continue;
            sum += (c->p[i] + c->p[other[k]]) * c->table.half[kind[k]][1];
        }
    }
    return par_sum(sum) / (2 * HALF * SPACING * THICKNESS);
}

/* Pressure in the middle. */
static double centre_of(const struct cracks *c) {
    double sum[2] = {0, 0};
    for (int i = 0; i < c->struts.n; i++) {
        const int h = c->struts.h[i];
        if ((int)floor(c->solid->x0[0][h] / SPACING) != HALF ||
            fabs(c->solid->x0[1][h] - 0.5 * HIGH * SPACING) > SPACING)
            continue;
        sum[0] += c->p[i];
        sum[1]++;
    }
    par_sum_array(sum, 2);
    return sum[0] / sum[1];
}

/* Plates with a mass: load - compression accelerates them. A strain rate that changes makes the pressure rise by
 * rho a^2/3 times the change, because the slab has to move along x; so plates that weigh less than that, or follow the
 * missing load without inertia, swing with the time step. */
struct plates {
    double load, inertia, damping, rate; /* Pa, Pa s2, 1/s, 1/s */
    const struct solid_time *time;       /* of the load */
};

static void press(struct cracks *c, struct plates *p, double dt, int steps) {
    for (int step = 0; step < steps; step++) {
        const double missing = compression(c) - p->load * solid_time_factor(p->time, c->solid->t);
        p->rate += dt * (missing / p->inertia - p->damping * p->rate);
        strain(c->solid, p->rate);
        solid_integrate(c->solid, dt, 1);
    }
    assert_int_equal(c->status.failed, 0);
}

static void mandel(double biot, double modulus) {
    enum { WAVES = 60, RAMP = 16 };
    const double load = 3e6, a = HALF * SPACING, viscosity = 1e-3, dt = 2.2 * porous_dt();
    const struct solid_constraint held = {.high = {1, 1, 1}, .direction = {0, 1, 0}};
    struct solid *s = make((struct make){.sites = {WIDE, HIGH, 0}, .constraints = 1, .constraint = &held});
    const double K = porous_confined(s), storage = 1 / modulus + biot * biot / K, wave = a * sqrt(DENSITY / K);
    const double period = WAVES * wave;
    struct physics_consolidation rock = {K / 1.2, 0.25, biot, modulus, storage * a * a / period};
    const double later = consolidation_undrained(&rock);
    const double first = consolidation_skempton(&rock) * (1 + later) / 3 * load;
    const int sealed = (int)lrint(24 * wave / dt);
    double t[RAMP + 3], factor[RAMP + 3] = {0};
    for (int i = 0; i <= RAMP; i++) {
        t[i] = i * 16 * wave / RAMP;
        factor[i] = 0.5 * (1 - cos(acos(-1) * i / RAMP));
    }
    t[RAMP + 1] = sealed * dt;
    t[RAMP + 2] = sealed * dt + wave;
    factor[RAMP + 1] = 1;
    const struct solid_time pressed = {RAMP + 1, t, factor, 0}, drained = {RAMP + 3, t, factor, 0};
    const struct cracks_injection side[2] = {
        {.high = {SPACING, 1, 1}, .is_pressure = 1, .value = first, .time = drained},
        {.low = {2 * HALF * SPACING, 0, 0}, .high = {1, 1, 1}, .is_pressure = 1, .value = first, .time = drained}};
    const struct cracks_input input = {.viscosity = viscosity,
                                       .least_aperture = 1e-8,
                                       .least_pressure = -1e9,
                                       .porous = 1,
                                       .pores = {rock.mobility * viscosity, biot, modulus},
                                       .injections = 2,
                                       .injection = side};
    const double damping = 0.2 / wave;
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .damping_absolute = damping};
    struct cracks *c = cracks_new(&input, s);
    cracks_begin(c, 1);
    struct plates plates = {load, DENSITY * a * a, damping, 0, &pressed};
    press(c, &plates, dt, sealed);
    check_relative(centre_of(c), first, 0.03);
    const double start = s->t + 0.5 * wave, T[] = {0.1, 0.2, 0.5};
    for (size_t k = 0; k < sizeof T / sizeof T[0]; k++) {
        press(c, &plates, dt, (int)lrint((start + T[k] * period - s->t) / dt));
        const double now = (s->t - start) / period, p = centre_of(c) / first;
        check_close(compression(c) / load, 1, 0.01);
        check_close(p, consolidation_mandel(0.25, later, 0, now), 0.03);
    }
    cracks_free(c);
    solid_free(s);
}

static void incompressible(void **state) {
    (void)state;
    mandel(1, INFINITY);
}

static void compressible(void **state) {
    (void)state;
    mandel(0.8, 2 * YOUNG);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(incompressible), cmocka_unit_test(compressible)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
