/* A curve from a table: columns, arithmetic with them, the rows of a condition, and what is refused. */
#include "program/study/runs/curve.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#define FILE_OF FRANA_BINARY_DIR "/tests/program/study/curve.csv"
#define BARE FRANA_BINARY_DIR "/tests/program/study/curve_bare.csv"

static void put(const char *path, const char *text) {
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
}

static int make(void **state) {
    (void)state;
    put(FILE_OF, "step,t,probe,u,v\n#1,s,1,m,m\n0,0,0,1,2\n0,0,1,3,-4\n5,0.5,0,5,6\n5,0.5,1,7,8\n");
    put(BARE, "a,b\n#1,1\n2,3\n4,5\n");
    return 0;
}

static void holds(const char *path, const char *column, const char *where, long n, const double *t, const double *x) {
    struct study_curve c;
    char *why = NULL;
    int wrong = 0;
    if (!study_curve_read(&c, path, column, where, &why, &wrong)) fail_msg("%s", why);
    assert_int_equal(c.n, n);
    for (long i = 0; i < n; i++) {
        check_equal(c.t[i], t[i]);
        check_equal(c.x[i], x[i]);
    }
    study_curve_free(&c);
}

static void columns(void **state) {
    (void)state;
    holds(FILE_OF, "u", NULL, 4, (const double[]){0, 0, 0.5, 0.5}, (const double[]){1, 3, 5, 7});
    holds(FILE_OF, "u", "probe = 1", 2, (const double[]){0, 0.5}, (const double[]){3, 7});
    holds(FILE_OF, "u", "step=5", 2, (const double[]){0.5, 0.5}, (const double[]){5, 7});
    holds(FILE_OF, "u", "probe = 2", 0, NULL, NULL);
    holds(FILE_OF, "abs([v]) / [u] + 2 * [t]", "probe = 1", 2, (const double[]){0, 0.5},
          (const double[]){4. / 3, 8. / 7 + 1});
    holds(BARE, "b", NULL, 2, (const double[]){1, 2}, (const double[]){3, 5}); /* no time: the number of the row */
}

static void refused(const char *path, const char *column, const char *where, int is_wrong, const char *says) {
    struct study_curve c;
    char *why = NULL;
    int wrong = 0;
    assert_int_equal(study_curve_read(&c, path, column, where, &why, &wrong), 0);
    if (!why || !strstr(why, says)) fail_msg("says %s, not %s", why ? why : "nothing", says);
    assert_int_equal(wrong, is_wrong);
}

static void mistakes(void **state) {
    (void)state;
    refused(FILE_OF ".none", "u", NULL, 0, "curve.csv.none: ");
    refused(FILE_OF, "w", NULL, 1, "has no column w");
    refused(FILE_OF, "[u] + [prob]", NULL, 1, "has no column prob; did you mean probe?");
    refused(FILE_OF, "[u] +", NULL, 1, "[u] +: not a number");
    refused(FILE_OF, "u", "prob = 1", 1, "has no column prob; did you mean probe?");
    refused(FILE_OF, "u", "probe 1", 1, "where: probe 1: must be COLUMN = NUMBER");
    refused(FILE_OF, "u", "probe = one", 1, "must be COLUMN = NUMBER");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(columns), cmocka_unit_test(mistakes)};
    return cmocka_run_group_tests(tests, make, NULL);
}
