/* Pores and leak-off: balances of volume and momentum, steady flow, undrained response, Carter's law. */
#include "base/par.h"
#include "cracks/measure.h"
#include "cracks/project.h"
#include "cracks/solve.h"
#include "cracks/struts.h"
#include "cracks/sums.h"
#include "solid/imposed/reactions.h"
#include "solid/measure/energy.h"
#include "solid/step/integrate.h"
#include "tests/cracks/lattice.h"
#include "tests/cracks/porous.h"
#include "tests/one_rank.h"

#include <stdio.h>
#include <stdlib.h>

static const double SOLVED = 1e-7; /* the pressures' tolerance, cracks/solve.c */
enum { KINDS = 8, STEPS = 60, NUMBERS = 8, ROWS = 3 };
enum { SPACE = 1, BREAKS = 2, LEAKS = 4 };

static struct cracks *begin(struct solid *s, int kind) {
    const double mid = 10 * SPACING;
    struct cracks_injection in = {
        .low = {mid - SPACING, mid - 3 * SPACING, 0}, .high = {mid + SPACING, mid + 3 * SPACING, 0}, .value = 2e-3};
    if (kind & SPACE)
        in = (struct cracks_injection){.low = {3e-3, 3e-3, 4e-3}, .high = {6e-3, 6e-3, 6e-3}, .value = 2e-3};
    const struct cracks_input input = {.viscosity = 1e-3,
                                       .compressibility = 1e-10,
                                       .least_aperture = 1e-8,
                                       .leak_off = kind & LEAKS ? 2e-6 : 0,
                                       .porous = !(kind & LEAKS),
                                       .pores = {1e-12, 0.7, 2 * YOUNG},
                                       .injections = 1,
                                       .injection = &in};
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .breakage = (kind & BREAKS) > 0};
    struct cracks *c = cracks_new(&input, s);
    cracks_begin(c, 1);
    return c;
}

/* Pumps into a crack in a porous or leaking body; value: numbers of some steps. */
static void pump(int kind, double (*value)[NUMBERS]) {
    const double half = 3 * SPACING, mid = 10 * SPACING, dt = 0.3 * SPACING / sqrt(YOUNG / DENSITY);
    const double line[2][3] = {{mid - half, mid, 0}, {mid + half, mid, 0}};
    const double quad[4][3] = {{2e-3, 2e-3, 5e-3}, {7e-3, 2e-3, 5e-3}, {7e-3, 7e-3, 5e-3}, {2e-3, 7e-3, 5e-3}};
    const struct solid_cut flat = {2, line}, plane = {4, quad};
    const int space = (kind & SPACE) > 0;
    struct solid *s = make((struct make){.sites = {space ? 9 : 20, space ? 9 : 20, space ? 10 : 0},
                                         .cuts = 1,
                                         .cut = space ? &plane : &flat,
                                         .fracture_energy = kind & BREAKS ? 20 : 0,
                                         .list = kind == (SPACE | BREAKS)});
    struct cracks *c = begin(s, kind);
    double momentum[4] = {0};
    for (int step = 0; step < STEPS; step++) {
        solid_integrate(s, dt, 1);
        assert_int_equal(c->status.failed, 0);
        cracks_project_end(c);
        const struct cracks_values v = cracks_measure(c);
        check_close(v.residual / (v.injected + v.volume), 0, 1e-12);
        check_above(v.injected, 0);
        if (step % (STEPS / ROWS) < STEPS / ROWS - 1) continue;
        const double row[NUMBERS] = {v.injected, v.volume,        v.stored, v.injection_pressure,
                                     v.leaked,   v.pressure_mean, v.area,   v.wet_particles};
        memcpy(value[step / (STEPS / ROWS)], row, sizeof row);
    }
    if (kind & BREAKS) {
        solid_family_count(s);
        check_above((double)c->renewals, 5);
    }
    if (kind & LEAKS)
        check_above(value[ROWS - 1][4], 0);
    else
        check_above(value[ROWS - 1][2], 0);
    for (int h = 0; h < s->n; h++)
        for (int k = 0; k < s->dim; k++) {
            const double mv = DENSITY * s->volume[h] * s->v[k][h];
            momentum[k] += mv;
            momentum[3] += fabs(mv);
        }
    par_sum_array(momentum, 4);
    for (int k = 0; k < 3; k++) check_close(momentum[k] / momentum[3], 0, 1e-12);
    cracks_free(c);
    solid_free(s);
}

/* What was injected is in cracks, pores and voids or has leaked off, also when bonds break; momentum stays 0. The
 * numbers are the same on any number of ranks: one rank writes them to a file, more ranks compare. */
static void balance(void **state) {
    (void)state;
    for (int kind = 0; kind < KINDS; kind++) {
        double value[ROWS][NUMBERS], expected[ROWS][NUMBERS];
        char name[64];
        snprintf(name, sizeof name, "cracks_test_pores_%d", kind);
        pump(kind, value);
        one_rank_expects(name, value, sizeof value, expected);
        for (int i = 0; i < ROWS; i++)
            for (int k = 0; k < NUMBERS; k++) check_close(value[i][k], expected[i][k], 1e-8 * fabs(expected[i][k]));
    }
}

/* Steady flow along a bar that does not move: k0 A dp/(mu L), with L between the centres of the first and the last
 * layer, to what the solve leaves of what is injected. */
static void darcy(void **state) {
    (void)state;
    for (int dim = 2; dim <= 3; dim++) {
        const int n = 17, w = 6;
        const double h = SPACING, low = 2e5, high = 9e5, permeability = 3e-13;
        const struct solid_constraint held = {.high = {1, 1, 1}, .direction = {1, 1, 1}};
        struct solid *s = make((struct make){.sites = {n, w, dim == 3 ? w : 0}, .constraints = 1, .constraint = &held});
        const struct cracks_injection end[2] = {
            {.high = {h, w * h, w * h}, .is_pressure = 1, .value = high},
            {.low = {(n - 1) * h, 0, 0}, .high = {n * h, w * h, w * h}, .is_pressure = 1, .value = low}};
        const struct cracks_input input = {.viscosity = 1e-3,
                                           .least_aperture = 1e-8,
                                           .porous = 1,
                                           .pores = {permeability, 0.6, 3e10},
                                           .injections = 2,
                                           .injection = end};
        s->stage = (struct solid_stage){.integrator = SOLID_VERLET};
        struct cracks *c = cracks_new(&input, s);
        cracks_begin(c, 1);
        const double area = w * h * (dim == 3 ? w * h : THICKNESS), length = (n - 1) * h;
        const double flow = permeability / 1e-3 * area * (high - low) / length;
        for (int step = 0; step < 3; step++) solid_integrate(s, 1e6, 1); /* far beyond the time of diffusion */
        assert_int_equal(c->status.failed, 0);
        check_relative(c->rate[0], flow, SOLVED);
        check_relative(c->rate[1], -flow, SOLVED);
        cracks_free(c);
        solid_free(s);
    }
}

enum { LONG = 22, HIGH = 8, WIDE = 8, DEEP_END = 4 }; /* struts reach 3 spacings: an end's innermost layer lacks none */
static const double PERMEABILITY = 3e-13, DROP = 7e5, VISCOSITY = 1e-3;

/* The flow out of the particles below a layer, which have the pressure 1 where all above have 0. */
static double conductance_across(const struct cracks *c, int layer) {
    const struct cracks_struts *t = &c->struts;
    double *p = calloc((size_t)(t->n + t->ghosts) + 1, sizeof *p), *flow = calloc((size_t)t->n + 1, sizeof *flow);
    double sum = 0;
    for (int i = 0; i < t->n + t->ghosts; i++) p[i] = c->solid->x0[1][t->h[i]] < layer * SPACING;
    cracks_sums_flow(c, 1, p, flow);
    for (int i = 0; i < t->n; i++) sum += p[i] * flow[i];
    free(p);
    free(flow);
    return par_sum(sum);
}

/* The rate along y through a plate or a block (periodic in x) between ends of given pressures. Its upper half, seen
 * along x in a plate and along z in a block, is moved by `opening`, and a crack between the halves begins at y = 0 and
 * has this length. */
static double rate_along(int dim, double opening, double length, double *conductance) {
    const double h = SPACING, mid = 0.5 * HIGH * h, end = LONG * h, wide = WIDE * h;
    const double line[2][3] = {{mid, -h, 0}, {mid, length, 0}};
    const double quad[4][3] = {{-h, -h, mid}, {wide + h, -h, mid}, {wide + h, length, mid}, {-h, length, mid}};
    const struct solid_cut flat = {2, line}, plane = {4, quad};
    struct solid_constraint held[2] = {{.high = {1, 1, 1}, .direction = {1, 1, 1}},
                                       {.high = {1, 1, 1}, .direction = {1, 1, 1}, .has_displacement = 1}};
    held[1].low[dim == 3 ? 2 : 0] = mid;
    held[1].displacement[dim == 3 ? 2 : 0] = opening;
    struct solid *s = make((struct make){.sites = {dim == 3 ? WIDE : HIGH, LONG, dim == 3 ? HIGH : 0},
                                         .periodic = dim == 3 ? 2 : 0,
                                         .cuts = length > 0,
                                         .cut = dim == 3 ? &plane : &flat,
                                         .constraints = 2,
                                         .constraint = held});
    const struct cracks_injection side[2] = {
        {.high = {1, DEEP_END * h, 1}, .is_pressure = 1, .value = DROP + 2e5},
        {.low = {0, end - DEEP_END * h, 0}, .high = {1, 1, 1}, .is_pressure = 1, .value = 2e5}};
    const struct cracks_input input = {.viscosity = VISCOSITY,
                                       .least_aperture = 1e-8,
                                       .porous = 1,
                                       .pores = {PERMEABILITY, 0.6, 3e10},
                                       .injections = 2,
                                       .injection = side};
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET};
    struct cracks *c = cracks_new(&input, s);
    cracks_begin(c, 1);
    for (int step = 0; step < 3; step++) solid_integrate(s, 1e6, 1); /* far beyond the time of diffusion */
    assert_int_equal(c->status.failed, 0);
    check_relative(c->rate[0], -c->rate[1], SOLVED);
    const double rate = c->rate[0];
    if (conductance) *conductance = conductance_across(c, LONG / 2);
    cracks_free(c);
    solid_free(s);
    return rate;
}

/* Permeability of a sample before and after a crack: Darcy's flow alone, and beside the flow w^3/12 of a crack that
 * goes through. With a crack that ends inside it is less than if pressures were the same over each cross-section, with
 * struts up to three spacings beyond the tip. */
static void permeability(void **state) {
    (void)state;
    for (int dim = 2; dim <= 3; dim++) {
        const double h = SPACING, opening = 3e-5, width = dim == 3 ? WIDE * h : THICKNESS;
        const double length = (LONG - 2 * DEEP_END + 1) * h, tip = 0.4 * LONG * h, cracked = tip + (3.5 - DEEP_END) * h;
        const double whole = DROP / VISCOSITY * PERMEABILITY * HIGH * h * width,
                     through = whole + DROP / VISCOSITY * width * pow(opening, 3) / 12;
        double rates[2];
        check_relative(rate_along(dim, 0, 0, &rates[0]), whole / length, SOLVED);
        check_relative(rate_along(dim, opening, (LONG + 1) * h, &rates[1]), through / length, SOLVED);
        check_relative(rates[0], whole / DROP / h, 1e-10);
        check_relative(rates[1], through / DROP / h, 1e-10);
        const double most = 1 / (cracked / through + (length - cracked) / whole);
        check_between(rate_along(dim, opening, tip, NULL), whole / length + 0.5 * (most - whole / length), most);
    }
}

/* A cracked, porous plate between a held end and one that is driven: over each step its momentum changes by the
 * impulse of the supports, although pressures push held particles too. */
static void supports(void **state) {
    (void)state;
    enum { SITES = 20, GRIP = 3, EVERY = 3 };
    const double h = SPACING, x = SITES * h, y = 0.4 * x, dt = 0.5 * porous_dt(),
                 line[2][3] = {{0, y, 0}, {0.6 * x, y, 0}};
    const struct solid_cut flat = {2, line};
    const struct solid_constraint grip[2] = {
        {.high = {GRIP * h, 1, 1}, .direction = {1, 1, 1}},
        {.low = {x - GRIP * h, 0, 0}, .high = {1, 1, 1}, .direction = {1, 0, 0}, .velocity = {0.05, 0, 0}}};
    const struct cracks_injection in = {.low = {0, y - 2 * h, 0}, .high = {4 * h, y + 2 * h, 1}, .value = 2e-3};
    const struct cracks_input input = {.viscosity = VISCOSITY,
                                       .least_aperture = 1e-8,
                                       .least_pressure = -1e9,
                                       .porous = 1,
                                       .pores = {1e-12, 0.7, 2 * YOUNG},
                                       .injections = 1,
                                       .injection = &in};
    struct solid *s =
        make((struct make){.sites = {SITES, SITES, 0}, .cuts = 1, .cut = &flat, .constraints = 2, .constraint = grip});
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET};
    struct cracks *c = cracks_new(&input, s);
    cracks_begin(c, 1);
    solid_reactions_new(s);
    double before[2] = {0}, most = 0;
    for (int step = 0; step < 20; step++) {
        struct solid_reaction r[2];
        double after[2] = {0}, size = 0;
        solid_reactions_begin(s);
        solid_integrate(s, dt, EVERY);
        solid_reactions_measure(s, r);
        for (int i = 0; i < s->n; i++)
            for (int k = 0; k < 2; k++) after[k] += DENSITY * s->volume[i] * s->v[k][i];
        par_sum_array(after, 2);
        for (int k = 0; k < 2; k++) size += EVERY * dt * (fabs(r[0].force[k]) + fabs(r[1].force[k])) + fabs(after[k]);
        for (int k = 0; k < 2 && step > 0; k++)
            check_close(after[k] - before[k], EVERY * dt * (r[0].force[k] + r[1].force[k]), 1e-12 * size);
        memcpy(before, after, sizeof before);
        most = fmax(most, fabs(r[0].force[1]));
    }
    assert_int_equal(c->status.failed, 0);
    check_above(most, 1);
    cracks_free(c);
    solid_free(s);
}

/* A plate whose halves are driven apart while the pressure in it rises: what the supports give, and the pressures, is
 * in the bonds. Its rate of strain is constant, so that the trapezoidal rule is exact but for the bonds' turning. */
static void supports_work(void **state) {
    (void)state;
    enum { SITES = 12, STEPS_OF_IT = 20 };
    const double h = SPACING, x = SITES * h, dt = porous_dt(), ramp[2] = {0, STEPS_OF_IT * dt}, factor[2] = {0, 1};
    const struct solid_constraint grip[2] = {
        {.high = {1, 1, 1}, .direction = {1, 1, 1}},
        {.low = {0.5 * x, 0, 0}, .high = {1, 1, 1}, .direction = {1, 1, 1}, .velocity = {0.05, 0, 0}}};
    const struct cracks_injection in = {
        .high = {1, 1, 1}, .is_pressure = 1, .value = 2e7, .time = {2, ramp, factor, 0}};
    const struct cracks_input input = {.viscosity = VISCOSITY,
                                       .least_aperture = 1e-8,
                                       .porous = 1,
                                       .pores = {1e-12, 0.7, 2 * YOUNG},
                                       .injections = 1,
                                       .injection = &in};
    struct solid *s = make((struct make){.sites = {SITES, SITES, 0}, .constraints = 2, .constraint = grip});
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET};
    struct cracks *c = cracks_new(&input, s);
    cracks_begin(c, 1);
    solid_integrate(s, dt, STEPS_OF_IT);
    const double load = par_sum(s->work_load), supported = par_sum(s->e_constraint);
    check_above(fabs(load), 0.1 * solid_energy_measure(s).strain);
    check_close(load + supported, solid_energy_measure(s).strain, 1e-4 * fabs(load));
    cracks_free(c);
    solid_free(s);
}

/* A sealed column under a load: far from its ends the strain e and the pressure p fulfil
 *     K e + alpha p = -load ,  alpha e + p/M = 0 ,
 * with the lattice's modulus K of confined compression. */
static void undrained(void **state) {
    (void)state;
    const double load = 3e4, biot = 0.7, modulus = 1.5 * YOUNG;
    const int n = 40;
    struct solid *s = porous_column(n, load, 3);
    const struct cracks_input input = {
        .viscosity = 1e-3, .least_aperture = 1e-8, .least_pressure = -1e9, .porous = 1, .pores = {0, biot, modulus}};
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .damping_absolute = porous_damping(n)};
    struct cracks *c = cracks_new(&input, s);
    cracks_begin(c, 1);
    const double K = porous_confined(s), expected = load * biot / K / (1 / modulus + biot * biot / K);
    check_relative(K / (1.2 * YOUNG), lattice_sums(2, 3, 400).confined, 1e-6); /* 1.0220 */
    solid_integrate(s, porous_dt(), 1600);
    assert_int_equal(c->status.failed, 0);
    check_relative(porous_pressure(c, n / 2), expected, 1e-6);
    cracks_free(c);
    solid_free(s);
}

/* A crack at rest, filled at a constant rate: its volume is what was injected less 4 C A sqrt(t). */
static void carter(void **state) {
    (void)state;
    const double mid = 12 * SPACING, half = 4 * SPACING, rate = 4e-6, coefficient = 4e-6;
    const double line[2][3] = {{mid - half, mid, 0}, {mid + half, mid, 0}};
    const struct solid_cut flat = {2, line};
    double missed[2];
    for (int fine = 0; fine < 2; fine++) {
        const double dt = porous_dt() / (fine ? 4 : 1);
        struct solid *s = make((struct make){.sites = {24, 24, 0}, .cuts = 1, .cut = &flat});
        const struct cracks_injection in = {.low = {mid - half, 0, 0}, .high = {mid + half, 1, 0}, .value = rate};
        const struct cracks_input input = {.viscosity = 1e-7, /* no particle runs dry */
                                           .least_aperture = 1e-8,
                                           .least_pressure = -1e9, /* all of it is full at once */
                                           .leak_off = coefficient,
                                           .injections = 1,
                                           .injection = &in};
        s->stage = (struct solid_stage){.integrator = SOLID_VERLET};
        struct cracks *c = cracks_new(&input, s);
        cracks_begin(c, 1);
        solid_integrate(s, dt, fine ? 400 : 100);
        const struct cracks_values v = cracks_measure(c);
        const double leaked = 4 * coefficient * v.area * sqrt(s->t);
        check_above(leaked, 0.01 * v.injected);
        missed[fine] = fabs(v.volume - (rate * s->t - leaked)) / leaked;
        check_below(missed[fine], 0.51 * dt / s->t); /* wet from the end of the first substep on: sqrt(t - dt) */
        cracks_free(c);
        solid_free(s);
    }
    check_between(missed[0] / missed[1], 3.5, 4.5);
}

/* Faces that take much more than there is: what has leaked is less than what was injected, and no void is larger than
 * the crack. */
static void no_more_than_there_is(void **state) {
    (void)state;
    const double mid = 12 * SPACING, half = 4 * SPACING;
    const double line[2][3] = {{mid - half, mid, 0}, {mid + half, mid, 0}};
    const struct solid_cut flat = {2, line};
    struct solid *s = make((struct make){.sites = {24, 24, 0}, .cuts = 1, .cut = &flat});
    const struct cracks_injection in = {.low = {mid - SPACING, 0, 0}, .high = {mid + SPACING, 1, 0}, .value = 1e-4};
    const struct cracks_input input = {
        .viscosity = 1e-3, .least_aperture = 1e-7, .leak_off = 0.1, .injections = 1, .injection = &in};
    s->stage = (struct solid_stage){.integrator = SOLID_VERLET};
    struct cracks *c = cracks_new(&input, s);
    cracks_begin(c, 1);
    solid_integrate(s, porous_dt(), 100);
    const struct cracks_values v = cracks_measure(c);
    check_above(v.leaked, 0.5 * v.injected);
    check_below(v.leaked, v.injected * (1 + 1e-12));
    check_below(v.cavity, v.volume + 1e-12 * v.injected);
    check_below(fabs(v.residual), 1e-12 * v.injected);
    cracks_free(c);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(balance),       cmocka_unit_test(darcy),
                                       cmocka_unit_test(permeability),  cmocka_unit_test(supports),
                                       cmocka_unit_test(supports_work), cmocka_unit_test(undrained),
                                       cmocka_unit_test(carter),        cmocka_unit_test(no_more_than_there_is)};
    const struct CMUnitTest quick[] = {cmocka_unit_test(balance), cmocka_unit_test(darcy), cmocka_unit_test(supports)};
    const int failed =
        par_size() > 2 ? cmocka_run_group_tests(quick, NULL, NULL) : cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
