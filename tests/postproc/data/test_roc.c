/* Hits and false alarms of samples whose curve is known: told apart, the other way round, equal, and by hand. */
#include "base/par.h"
#include "postproc/data/roc.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>

static void told_apart(void **state) {
    (void)state;
    const double value[] = {4, 1, 3, 2, 6, 5};
    const uint8_t broke[] = {1, 0, 0, 0, 1, 1}, reversed[] = {0, 1, 1, 1, 0, 0};
    struct postproc_roc r = postproc_roc_new(6, value, broke);
    assert_int_equal(r.n, 6);
    assert_int_equal(r.become, 3);
    check_equal(r.area, 1);
    check_equal(r.threshold, 4);
    check_equal(r.hits, 1);
    check_equal(r.false_ones, 0);
    r = postproc_roc_new(6, value, reversed);
    check_equal(r.area, 0);
    check_close(r.hits - r.false_ones, 0, 1e-15); /* no better than a warning everywhere */
}

/* Equal values warn of all or of none: the area is that of chance, whatever the order of the samples. */
static void equal_values(void **state) {
    (void)state;
    const double value[] = {2, 2, 2, 2, 2};
    const uint8_t first[] = {1, 1, 0, 0, 0}, last[] = {0, 0, 0, 1, 1};
    check_equal(postproc_roc_new(5, value, first).area, 0.5);
    check_equal(postproc_roc_new(5, value, last).area, 0.5);
}

/* Of the 2 x 3 pairs of one that breaks and one that does not, 4 are in order and 1 is a tie: area 4.5/6. */
static void by_hand(void **state) {
    (void)state;
    const double value[] = {5, 2, 4, 2, 1, NAN};
    const uint8_t broke[] = {1, 1, 0, 0, 0, 1};
    const double pairs = 3 + 1.5; /* 5 is above 4, 2 and 1; 2 is above 1, and equal to 2, which counts a half */
    const struct postproc_roc r = postproc_roc_new(6, value, broke);
    assert_int_equal(r.n, 5);
    check_close(r.area, pairs / 6, 1e-15);
    check_equal(r.threshold, 5);
    check_equal(r.hits, 0.5);
    check_equal(r.false_ones, 0);
    double hits, false_ones;
    postproc_roc_at(6, value, broke, 2, &hits, &false_ones);
    check_equal(hits, 1);
    check_close(false_ones, 2. / 3, 1e-15);
}

static void nothing_to_tell(void **state) {
    (void)state;
    const double value[] = {1, 2};
    const uint8_t none[] = {0, 0}, all[] = {1, 1};
    assert_true(isnan(postproc_roc_new(2, value, none).area));
    assert_true(isnan(postproc_roc_new(2, value, all).hits));
    assert_int_equal(postproc_roc_new(0, value, all).n, 0);
    double hits, false_ones;
    postproc_roc_at(2, value, none, 0, &hits, &false_ones);
    assert_true(isnan(hits));
    check_equal(false_ones, 1);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(told_apart),
        cmocka_unit_test(equal_values),
        cmocka_unit_test(by_hand),
        cmocka_unit_test(nothing_to_tell),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
