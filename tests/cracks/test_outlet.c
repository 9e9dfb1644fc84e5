/* Cracks that are open to a fluid outside: the balance of what enters, the pressure at rest, struts that are switched
 * off where a crack stands wide open, and the ranks. */
#include "base/par.h"
#include "cracks/resolved.h"
#include "cracks/measure.h"
#include "cracks/outlet.h"
#include "cracks/project.h"
#include "cracks/solve.h"
#include "cracks/struts.h"
#include "solid/step/integrate.h"
#include "tests/cracks/make.h"
#include "tests/cracks/struts_of.h"

#include <stdio.h>
#include <string.h>

enum { SITES = 20, SUBSTEPS = 4, STEPS = 40, NUMBERS = 7 };

struct run {
    struct solid *s;
    struct cracks *c;
    double dt; /* of a substep */
};

/* A plate with a crack that starts at its left side; length: in spacings. */
static struct run begin(double length, double fracture_energy, double viscosity) {
    const double middle = SITES / 2 * SPACING, line[2][3] = {{-SPACING, middle, 0}, {length * SPACING, middle, 0}};
    const struct solid_cut cut = {2, line};
    struct run r = {.s = make((struct make){
                        .sites = {SITES, SITES, 0}, .cuts = 1, .cut = &cut, .fracture_energy = fracture_energy})};
    const struct cracks_input input = {.viscosity = viscosity, .least_aperture = 1e-7, .outside = 1};
    r.s->stage = (struct solid_stage){.integrator = SOLID_VERLET, .breakage = fracture_energy > 0};
    r.c = cracks_new(&input, r.s);
    r.dt = 0.3 * SPACING / sqrt(YOUNG / DENSITY);
    cracks_begin(r.c, 1);
    return r;
}

static void end(struct run *r) {
    cracks_free(r->c);
    solid_free(r->s);
}

/* A step of a few substeps. The outlets are the wet particles of the first column. */
static void step(struct run *r, double pressure) {
    int h[SITES], n = 0;
    double flow[SITES], conductance[SITES];
    for (int k = 0; k < r->s->n; k++) {
        if (r->s->x0[0][k] > SPACING || !cracks_outlet_is_wet(r->c, k)) continue;
        h[n] = k;
        flow[n] = pressure;
        conductance[n++] = 1e-13;
    }
    cracks_outlet_set(r->c, n, h, flow, conductance);
    solid_integrate(r->s, r->dt, SUBSTEPS);
    assert_int_equal(r->c->status.failed, 0);
    cracks_outlet_end_step(r->c, SUBSTEPS * r->dt);
    cracks_project_end(r->c);
    cracks_resolved_update(r->c, 1);
}

/* The file of one rank's numbers is compared by more ranks. */
static void check_ranks(const char *name, const double *value, int n, const double *scale) {
    double expected[16];
    char path[512];
    snprintf(path, sizeof path, FRANA_BINARY_DIR "/cracks_test_mouth_%s.data", name);
    FILE *file = fopen(path, par_size() == 1 ? "wb" : "rb");
    if (!file) fail_msg("%s: run this test on one rank first", path);
    if (par_size() == 1) {
        assert_int_equal(fwrite(value, sizeof *value, (size_t)n, file), n);
    } else {
        assert_int_equal(fread(expected, sizeof *value, (size_t)n, file), n);
        for (int k = 0; k < n; k++) check_close(value[k], expected[k], 1e-8 * fmax(scale[k], fabs(expected[k])));
    }
    fclose(file);
}

static void numbers_of(const struct run *r, double value[NUMBERS]) {
    const struct cracks_values v = cracks_measure(r->c);
    const double values[NUMBERS] = {v.entered,         v.volume, v.cavity,  v.outlet_rate,
                                    v.outlet_pressure, v.area,   v.resolved};
    memcpy(value, values, sizeof values);
}

/* What enters is in the cracks, while they grow and while they do not; the file tells whether ranks agree. */
static void balance(void **state) {
    (void)state;
    for (int breaks = 0; breaks < 2; breaks++) {
        struct run r = begin(8, breaks ? 20 : 0, 1e-3);
        double value[NUMBERS] = {0}, momentum[3] = {0, 0, 0}, size = 0;
        for (int k = 0; k < STEPS; k++) {
            step(&r, breaks ? 6e7 : 1e7);
            const struct cracks_values v = cracks_measure(r.c);
            check_above(v.entered, 0);
            check_close(v.residual / v.volume, 0, 1e-12);
        }
        for (int h = 0; h < r.s->n; h++)
            for (int k = 0; k < r.s->dim; k++) {
                momentum[k] += DENSITY * r.s->volume[h] * r.s->v[k][h];
                size += fabs(DENSITY * r.s->volume[h] * r.s->v[k][h]);
            }
        par_sum_array(momentum, 3);
        for (int k = 0; k < 3; k++) check_close(momentum[k] / par_sum(size), 0, 1e-12);
        solid_family_count(r.s);
        if (breaks) check_above(r.c->renewals, 5);
        numbers_of(&r, value);
        if (!breaks) assert_int_equal(cracks_measure(r.c).outlets, 6);
        const double scale[NUMBERS] = {value[0], value[1], value[1], fabs(value[3]) + value[0] / (STEPS * r.dt),
                                       1e7,      value[5], value[1]};
        check_ranks(breaks ? "grows" : "stands", value, NUMBERS, scale);
        end(&r);
    }
}

/* At rest the whole crack has the pressure outside, whatever the outlets' conductance is, and nothing enters. */
static void rest(void **state) {
    (void)state;
    if (par_size() > 1) return; /* the ranks are compared by the other tests */
    const double pressure = 1e6;
    struct run r = begin(8, 0, 1e-9);
    r.s->stage.damping_absolute = 3e5;
    for (int k = 0; k < 600; k++) step(&r, pressure);
    for (int i = 0; i < r.c->struts.n; i++) check_relative(r.c->p[i], pressure, 1e-3);
    const struct cracks_values v = cracks_measure(r.c);
    check_close(v.outlet_rate * 600 * SUBSTEPS * r.dt / v.volume, 0, 2e-2);
    check_relative(v.entered, v.volume, 1e-12);
    end(&r);
}

/* Two halves part, meet again and part: the struts are off while the gap is wider than two spacings, then no pressure
 * acts and no volume is counted, and what was in them is in `resolved`. */
static void apart(void **state) {
    (void)state;
    struct run r = begin(SITES + 1, 0, 1e-3);
    const double speed = SPACING / (10 * SUBSTEPS * r.dt);
    double value[2 * NUMBERS], last = 0;
    for (int turn = 0; turn < 2; turn++) {
        const double sign = turn == 0 ? 1 : -1;
        for (int h = 0; h < r.s->n; h++)
            for (int k = 0; k < 2; k++)
                r.s->v[k][h] = k == 1 ? sign * speed * (r.s->x0[1][h] > SITES / 2 * SPACING ? 1 : -1) : 0;
        for (int k = 0; k < (turn == 0 ? 20 : 12); k++) {
            step(&r, 1e3);
            const struct cracks_values v = cracks_measure(r.c);
            check_close(v.residual / (v.volume + v.entered + fabs(v.resolved)), 0, 1e-12);
        }
        const struct cracks_values v = cracks_measure(r.c);
        numbers_of(&r, value + turn * NUMBERS);
        if (turn == 0) { /* 4 spacings apart */
            check_equal(v.volume, 0);
            check_equal(v.area, 0);
            check_equal(v.cavity, 0);
            check_relative(v.resolved, v.entered, 1e-12);
            last = v.resolved;
            for (int i = 0; i < r.c->struts.n; i++) check_equal(r.c->content[i], 0);
        } else { /* 1.6 spacings */
            check_above(v.volume, 0);
            check_above(last, v.resolved);
        }
    }
    const double scale[2 * NUMBERS] = {last, last, last, last / r.dt, 1e3, 1e-3, last,
                                       last, last, last, last / r.dt, 1e3, 1e-3, last};
    check_ranks("apart", value, 2 * NUMBERS, scale);
    end(&r);
}

static double struts_on(const struct cracks *c) {
    double sum = 0;
    for (int i = 0; i < c->struts.n; i++) sum += struts_of(c, i, NULL, NULL);
    return par_sum(sum);
}

/* Breaks the bond between a site of the upper half next to the cut and the one above it, from both ends. */
static void break_one(struct solid *s) {
    static struct solid_family_view view;
    const int low = SITES / 2;
    for (int h = 0; h < s->n; h++) {
        const long x = lrint(s->x0[0][h] / SPACING - 0.5), y = lrint(s->x0[1][h] / SPACING - 0.5);
        if (x != 6 || (y != low && y != low + 1)) continue;
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++)
            if (view.intact[b] && lrint(view.xi[b][0] / SPACING) == 0 &&
                lrint(view.xi[b][1] / SPACING) == (y == low ? 1 : -1))
                solid_family_break(s, h, b);
    }
}

static void part(struct run *r, double jump) {
    for (int h = 0; h < r->s->n; h++) r->s->d[1][h] = (r->s->x0[1][h] > SITES / 2 * SPACING ? 0.5 : -0.5) * jump;
    cracks_resolved_update(r->c, 0);
}

/* Struts stay off when their rows are read again, because a bond broke there or because a stage begins; a bond that
 * breaks then is a strut that is on. When the halves meet all are on. */
static void rows(void **state) {
    (void)state;
    struct run r = begin(SITES + 1, 0, 1e-3);
    cracks_project_end(r.c);
    const double all = struts_on(r.c), area = cracks_measure(r.c).area;
    check_above(all, 100);
    part(&r, 1.9 * SPACING);
    check_equal(struts_on(r.c), all);
    part(&r, 2.1 * SPACING);
    check_equal(struts_on(r.c), 0);
    check_equal(cracks_measure(r.c).area, 0);
    break_one(r.s);
    cracks_project_end(r.c);
    check_equal(struts_on(r.c), 2);
    const double one = cracks_measure(r.c).area;
    check_above(one, 0);
    cracks_begin(r.c, 0);
    cracks_begin(r.c, 1);
    cracks_project_end(r.c);
    check_equal(struts_on(r.c), 2);
    check_relative(cracks_measure(r.c).area, one, 1e-12);
    part(&r, 0);
    check_equal(struts_on(r.c), all + 2);
    check_relative(cracks_measure(r.c).area, area, 1e-12); /* one end of the new strut faces the crack, one does not */
    end(&r);
}

/* With next to no viscosity the bound is the conductance, and the diagonal is the sum of the bounded ones. */
static void bound(void **state) {
    (void)state;
    if (par_size() > 1) return; /* the ranks are compared by the other tests */
    struct run r = begin(8, 0, 1e-15);
    step(&r, 1e3);
    const struct cracks_struts *t = &r.c->struts;
    const struct cracks_rows *rows = &t->rows;
    const double factor = 100 * 100 * r.dt * 0.5 / (DENSITY * SPACING * SPACING * THICKNESS);
    long links = 0;
    for (int i = 0; i < t->n; i++) {
        const int row = t->slot[i] / CRACKS_LANES, lane = t->slot[i] % CRACKS_LANES;
        double sum = 0;
        for (long k = rows->link_start[row]; k < rows->link_start[row + 1]; k++) {
            const int at = rows->link[k].at + lane;
            if (!(rows->link[k].lanes >> lane & 1)) continue;
            const double a = t->area_size[i],
                         b = t->area_size[rows->index[rows->row_of[at / CRACKS_LANES]][at % CRACKS_LANES]];
            check_relative(r.c->work->conductance[CRACKS_LANES * k + lane], factor * (a * a + b * b), 1e-12);
            sum += r.c->work->conductance[CRACKS_LANES * k + lane];
            links++;
        }
        check_relative(r.c->work->outflow[t->slot[i]], sum, 1e-12);
    }
    check_above(links, t->n);
    end(&r);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(balance), cmocka_unit_test(rest), cmocka_unit_test(apart),
                                       cmocka_unit_test(rows), cmocka_unit_test(bound)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
