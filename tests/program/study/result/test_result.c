/* Errors, orders, medians and references from made-up runs of a study. */
/* The results of a study with artificial runs: errors, orders, medians, the finest run as reference. */
#include "program/study/report/report.h"
#include "program/study/result/result.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

enum { METHODS = 2, LEVELS = 3, REPEATS = 3, CASES = METHODS * LEVELS, RUNS = CASES * REPEATS };
#define TEXT(x) ((char *)(size_t)(x))

/* Method m at level l has the value 10 (1 + c h^p), with c and p of the method, and takes (1, 3, 2) 2^l (1 + m) s in
 * its repeats. */
struct made {
    struct study study;
    struct study_variant method[METHODS], level[LEVELS];
    struct study_quantity quantity;
    struct study_plan plan;
    struct study_case at[CASES];
    struct study_run run[RUNS];
    double value[RUNS];
};

static double value_of(int m, int l) {
    const double h = pow(0.5, l);
    return 10 * (1 + (m ? 0.04 * h * h * h : -0.08 * h * h));
}

static struct made *make(struct study_reference reference) {
    static const double wall[REPEATS] = {1, 3, 2};
    struct made *x = calloc(1, sizeof *x);
    for (int m = 0; m < METHODS; m++) x->method[m] = (struct study_variant){.name = TEXT(m ? "cubic" : "square")};
    for (int l = 0; l < LEVELS; l++)
        x->level[l] = (struct study_variant){.name = TEXT(l == 0   ? "one"
                                                          : l == 1 ? "half"
                                                                   : "quarter"),
                                             .size = pow(0.5, l)};
    x->quantity = (struct study_quantity){.name = TEXT("q"), .unit = TEXT(""), .reference = reference};
    x->study = (struct study){.name = TEXT("made"),
                              .title = TEXT("Made up"),
                              .repeats = REPEATS,
                              .methods = {METHODS, x->method},
                              .levels = {LEVELS, x->level},
                              .quantities = 1,
                              .quantity = &x->quantity};
    x->plan = (struct study_plan){&x->study, CASES, x->at, RUNS, x->run};
    for (int i = 0; i < CASES; i++)
        x->at[i] = (struct study_case){.method = i % METHODS, .level = i / METHODS, .ranks = 1};
    for (int i = 0; i < RUNS; i++) {
        const struct study_case *c = &x->at[i % CASES];
        x->value[i] = value_of(c->method, c->level);
        x->run[i] = (struct study_run){.at = i % CASES, .repeat = i / CASES, .value = &x->value[i]};
        x->run[i].outcome = (struct study_outcome){.state = STUDY_DONE,
                                                   .wall = wall[i / CASES] * (1 << c->level) * (1 + c->method),
                                                   .setup = 0.25,
                                                   .cell_step = NAN,
                                                   .bond_sweep = 0.5,
                                                   .memory = 2e6,
                                                   .steps = 100};
    }
    return x;
}

static const struct study_reference known = {.kind = STUDY_REFERENCE_VALUE,
                                             .value = 10,
                                             .scale = NAN,
                                             .order = NAN,
                                             .formal = 3},
                                    finest = {.kind = STUDY_REFERENCE_FINEST, .scale = NAN, .order = NAN, .formal = 3};

static void value(void **state) {
    (void)state;
    struct made *x = make(known);
    struct study_result *r = study_result_new(&x->plan);
    const struct study_table *t = &r->table[0];
    const struct study_point *p = study_result_point(r, t, 0, 1);
    check_close(p->error, 0.2, 1e-14);
    check_close(p->relative, 0.02, 1e-15);
    check_close(p->wall, 4, 0); /* 2, 6, 4 */
    check_close(p->wall_min, 2, 0);
    check_close(p->wall_iqr, 2, 0); /* 3 to 5 */
    check_close(p->setup, 0.25, 0);
    check_close(p->memory, 2e6, 0);
    check_close(p->order, 2, 1e-12);
    check_close(p->spread, 0, 0);
    assert_true(p->resolved);
    check_equal(p->repeats, REPEATS);
    check_equal(p->state, STUDY_DONE);
    assert_true(isnan(study_result_point(r, t, 0, 0)->order));
    check_close(study_result_point(r, t, 1, 2)->order, 3, 1e-10);
    check_close(study_result_point(r, t, 1, 2)->wall, 16, 0);
    check_close(t->curve[0].order, 2, 1e-12);
    check_close(t->curve[1].order, 3, 1e-10);
    check_close(t->curve[1].gain, -3, 1e-10);
    check_close(t->curve[0].richardson.extrapolated, 10, 1e-12);
    char *reference = study_report_reference(r, t);
    assert_string_equal(reference, "10");
    free(x);
}

static void advises(struct made *x, const char *wanted) {
    struct study_result *r = study_result_new(&x->plan);
    char *advice = study_advice_write(r, &r->table[0]);
    assert_string_equal(advice, wanted);
}

/* Errors are 8, 2, 0.5 % in 2, 4, 8 s, and 4, 0.5, 0.0625 % in 4, 8, 16 s. */
static void advice(void **state) {
    (void)state;
    struct made *x = make(known);
    advises(x, "3 % costs 4 s (square at half), 1 % 8 s (square at quarter), 0.1 % 16 s (cubic at quarter); "
               "at 0.1 % square does not get there");
    for (int i = 4; i < RUNS; i += CASES) x->value[i] = 10.9; /* the finest of square is worse: chance before */
    advises(x, "10 % costs 2 s (square at one), 1 % 8 s (cubic at half), 0.1 % 16 s (cubic at quarter); "
               "at 0.1 % square does not get there");
    x->quantity.reference.uncertainty = 0.02; /* no text on errors below 0.2 % */
    advises(x, "10 % costs 2 s (square at one), 1 % 8 s (cubic at half), 0.3 % 16 s (cubic at quarter); "
               "at 0.3 % square does not get there");
    for (int i = 0; i < RUNS; i++) x->value[i] = 30;
    advises(x, "");
    for (int i = 0; i < RUNS; i++) {
        x->value[i] = 10;
        x->run[i].outcome.wall *= 30;
    }
    x->quantity.reference.uncertainty = 0;
    advises(x, "round-off costs 60 s (square at one); at round-off cubic takes 2 times as long");
    free(x);
}

/* The run that is the reference is not reported as one without error. */
static void reference_apart(void **state) {
    (void)state;
    struct made *x = make(finest);
    for (int i = 4; i < RUNS; i += CASES) x->value[i] = 11; /* square at quarter: nothing to extrapolate */
    x->quantity.reference.scale = 10;
    advises(x, "30 % costs 2 s (square at one), 10 % 4 s (cubic at one); "
               "the reference, square at quarter, takes 8 s");
    free(x);
}

/* For many methods the number of those that reach an error is reported. */
static void many_methods(void **state) {
    (void)state;
    enum { N = 7 };
    static const double values[N] = {10.1, 10.2, 10.01, 10.005, 11, 10.001, 10.3}, walls[N] = {1, 2, 2, 3, 1, 8, 9};
    struct made *x = make(known);
    struct study_variant method[N];
    struct study_case at[N];
    struct study_run run[N];
    double value[N];
    for (int m = 0; m < N; m++) {
        method[m] = (struct study_variant){.name = TEXT(m == 0 ? "first" : m == 2 ? "third" : "another")};
        at[m] = (struct study_case){.method = m, .ranks = 1};
        value[m] = values[m];
        run[m] = (struct study_run){.at = m, .value = &value[m]};
        run[m].outcome = (struct study_outcome){.state = STUDY_DONE, .wall = walls[m]};
    }
    x->study.repeats = 1;
    x->study.methods = (struct study_variants){N, method};
    x->study.levels.n = 1;
    x->plan = (struct study_plan){&x->study, N, at, N, run};
    x->quantity.reference.uncertainty = 0.008; /* no text on errors below 0.08 % */
    advises(x, "1 % costs 1 s (first at one), 0.1 % 2 s (third at one); 2 of the 6 others get to 0.1 %, in 1.5 to 4 "
               "times the time");
    value[5] = 12;
    advises(x, "1 % costs 1 s (first at one), 0.1 % 2 s (third at one); 1 of the 6 others gets to 0.1 %, in "
               "1.5 times "
               "the time");
    value[3] = 12;
    advises(x, "1 % costs 1 s (first at one), 0.1 % 2 s (third at one); none of the 6 others gets to 0.1 %");
    free(x);
}

/* The first method's finest, extrapolated: exact, and its own finest level is within the index of it. */
static void extrapolated(void **state) {
    (void)state;
    struct made *x = make(finest);
    struct study_result *r = study_result_new(&x->plan);
    const struct study_table *t = &r->table[0];
    assert_true(t->extrapolated);
    check_equal(t->method, 0);
    check_close(t->reference, 10, 1e-12);
    check_close(t->uncertainty, 1.25 * 0.05, 1e-12); /* 1.25 |f1 - f| */
    assert_false(study_result_point(r, t, 0, 2)->resolved);
    assert_true(study_result_point(r, t, 0, 1)->resolved);

    x->quantity.reference.method = TEXT("cubic");
    r = study_result_new(&x->plan);
    assert_int_equal(r->table[0].method, 1);
    check_close(r->table[0].uncertainty, 1.25 * 0.4 / 64, 1e-12);

    x->quantity.reference.method = NULL; /* square, whose finest levels now do not converge */
    for (int i = 4; i < RUNS; i += CASES) x->value[i] = 11;
    r = study_result_new(&x->plan);
    assert_false(r->table[0].extrapolated);
    check_close(r->table[0].reference, 11, 0);
    check_close(r->table[0].uncertainty, 0.5 * (11 - 9.2), 1e-12);
    char *reference = study_report_reference(r, &r->table[0]);
    assert_non_null(strstr(reference, "as its finest levels do not converge"));
    free(x);
}

/* Runs that failed, repeats that differ, a reference of zero. */
static void uneven(void **state) {
    (void)state;
    struct made *x = make(known);
    char status[32];
    x->run[2].outcome.state = STUDY_FAILED; /* square at half: all repeats */
    x->run[2].outcome.exit_code = 3;
    x->run[2 + CASES].outcome.state = x->run[2 + 2 * CASES].outcome.state = STUDY_SKIPPED;
    x->value[1 + CASES] += 1; /* cubic at one: the second repeat */
    struct study_result *r = study_result_new(&x->plan);
    const struct study_table *t = &r->table[0];
    const struct study_point *p = study_result_point(r, t, 0, 1);
    assert_int_equal(p->state, STUDY_FAILED);
    assert_string_equal(study_report_status(p, status), "failed 3");
    assert_true(isnan(p->value) && isnan(p->wall) && isnan(p->order));
    check_close(study_result_point(r, t, 0, 2)->order, 2, 1e-12); /* across the gap */
    check_close(study_result_point(r, t, 1, 0)->spread, 1, 1e-14);
    check_close(study_result_point(r, t, 1, 0)->value, 10.4, 1e-14);

    x->quantity.reference.value = 0;
    r = study_result_new(&x->plan);
    assert_false(r->table[0].has_scale);
    check_close(study_result_point(r, &r->table[0], 1, 0)->relative, 10.4, 1e-14);
    x->quantity.reference.scale = 4;
    r = study_result_new(&x->plan);
    assert_true(r->table[0].has_scale);
    check_close(study_result_point(r, &r->table[0], 1, 0)->relative, 2.6, 1e-14);
    free(x);
}

/* 12 of 18 runs are done, each taking as long as it did with its set-up. */
static void time_left(void **state) {
    (void)state;
    struct made *x = make(known);
    for (int i = 12; i < RUNS; i++) x->run[i].outcome.state = STUDY_TODO;
    /* the second repeats: 3 (1 + 2 + 4) (1 + 2) + 6/4 */
    check_close(study_plan_left(&x->plan, 12), 64.5, 1e-12);
    check_close(study_plan_left(&x->plan, 17), 24.25, 1e-12);
    for (int i = 1; i < RUNS; i++) x->run[i].outcome.state = STUDY_TODO;
    check_close(study_plan_left(&x->plan, 1), 17 * 1.25, 1e-12);
    x->run[0].outcome.state = STUDY_FAILED;
    assert_true(isnan(study_plan_left(&x->plan, 1)));
    free(x);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(value),           cmocka_unit_test(advice),
                                       cmocka_unit_test(reference_apart), cmocka_unit_test(many_methods),
                                       cmocka_unit_test(extrapolated),    cmocka_unit_test(uneven),
                                       cmocka_unit_test(time_left)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
