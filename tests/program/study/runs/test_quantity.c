/* Measured quantities: windows of a series, tables, JSON, commands. */
#include "program/study/runs/child.h"
#include "program/study/runs/quantity.h"
#include "program/study/runs/window.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <cmocka.h>

#define FOLDER FRANA_BINARY_DIR "/tests/program/study/quantity"

static void window(void **state) {
    (void)state;
    /* columns t, x: unequal steps, a value that does not exist yet, one that is lost */
    const double rows[6][2] = {{0, NAN}, {1, 4}, {2, -2}, {4, 6}, {5, NAN}, {8, 2}};
    const struct study_samples s = {6, 2, &rows[0][0], &rows[0][1]};
    check_equal(study_window(&s, STUDY_LAST, -INFINITY, INFINITY, 0), 2);
    check_equal(study_window(&s, STUDY_LAST, -INFINITY, 5, 0), 6);
    check_equal(study_window(&s, STUDY_MAX, 5, INFINITY, 0), 2);
    check_equal(study_window(&s, STUDY_MAX, -INFINITY, INFINITY, 0), 6);
    check_equal(study_window(&s, STUDY_MIN, -INFINITY, INFINITY, 0), -2);
    /* by hand: (4 - 2)/2 * 1 + (-2 + 6)/2 * 2 + (6 + 2)/2 * 4 = 21, over 7 */
    check_close(study_window(&s, STUDY_MEAN, -INFINITY, INFINITY, 0), 3, 1e-15);
    check_equal(study_window(&s, STUDY_MEAN, 1, 2, 0), 1);
    check_equal(study_window(&s, STUDY_MEAN, 8, 9, 0), 2);
    check_equal(study_window(&s, STUDY_TIME, -INFINITY, INFINITY, 4), 4);
    check_equal(study_window(&s, STUDY_TIME, -INFINITY, INFINITY, 3.9), 1);
    assert_true(isnan(study_window(&s, STUDY_TIME, -INFINITY, INFINITY, 6)));
    assert_true(isnan(study_window(&s, STUDY_LAST, 9, INFINITY, 0)));
    assert_true(isnan(study_window(&s, STUDY_MEAN, 0, 0.5, 0)));
}

static void put(const char *name, const char *text) {
    char path[1024];
    snprintf(path, sizeof path, FOLDER "/%s", name);
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
}

static int make_folder(void **state) {
    (void)state;
    mkdir(FRANA_BINARY_DIR "/tests", 0777);
    mkdir(FRANA_BINARY_DIR "/tests/study", 0777);
    mkdir(FOLDER, 0777);
    put("series.csv", "step,t,speed\n#1,s,m\n1,0.5,10\n2,1,30\n");
    put("run.json", "{\"a\": {\"b\": 2.5, \"list\": [3, 4]}, \"word\": \"yes\"}\n");
    put("post.csv", "quantity,unit,value\n\"largest, of all\",Pa,7.5\nword,,text\n");
    put("case.csv", "# made by a command\nquantity,unit,ours,reference\nk,m2,4e-6,4.1e-6\n");
    study_child_begin();
    return 0;
}

static void near(struct study_quantity q, double value) {
    char *why;
    int wrong;
    q.before = INFINITY;
    q.after = -INFINITY;
    q.factor = q.factor ? q.factor : 1;
    q.name = (char *)(size_t) "some name";
    const double ours = study_quantity_value(&q, FOLDER, &why, &wrong);
    if (!(fabs(ours - value) <= 1e-14 * fabs(value))) fail_msg("%.15g, not %.15g: %s", ours, value, why ? why : "");
    assert_null(why);
}

static void none(struct study_quantity q, int is_wrong, const char *says) {
    char *why;
    int wrong;
    q.before = INFINITY;
    q.after = -INFINITY;
    q.factor = 1;
    q.name = (char *)(size_t) "some name";
    assert_true(isnan(study_quantity_value(&q, FOLDER, &why, &wrong)));
    assert_int_equal(wrong, is_wrong);
    if (!why || !strstr(why, says)) fail_msg("says \"%s\", not \"%s\"", why ? why : "nothing", says);
}

#define TEXT(x) ((char *)(size_t)(x))
#define QUANTITY(...) ((struct study_quantity){__VA_ARGS__})

static void sources(void **state) {
    (void)state;
    near(QUANTITY(.column = TEXT("speed"), .at = STUDY_MEAN, .factor = 3), 60);
    near(QUANTITY(.file = TEXT("run.json"), .row = TEXT("a.b")), 2.5);
    near(QUANTITY(.file = TEXT("run.json"), .row = TEXT("a.list[1]")), 4);
    near(QUANTITY(.file = TEXT("post.csv"), .row = TEXT("largest, of all")), 7.5);
    near(QUANTITY(.file = TEXT("case.csv"), .row = TEXT("k")), 4e-6);
    near(QUANTITY(.command = TEXT("echo 5; tail -1 series.csv | cut -d, -f3; echo loud >&2; echo")), 30);
    put("probes.csv", "step,t,probe,u\n#1,s,1,m\n0,0,0,1\n0,0,1,3\n5,2,0,5\n5,2,1,7\n");
    near(QUANTITY(.file = TEXT("probes.csv"), .column = TEXT("2 * [u]"), .where = TEXT("probe = 1"), .at = STUDY_MEAN),
         10);
    near(QUANTITY(.file = TEXT("probes.csv"), .column = TEXT("u"), .where = TEXT("probe = 0"), .at = STUDY_FIRST), 1);
    none(QUANTITY(.column = TEXT("sped")), 1, "has no column sped; did you mean speed?");
    none(QUANTITY(.column = TEXT("speed"), .at = STUDY_TIME, .above = 30), 0, "has no such value");
    none(QUANTITY(.file = TEXT("run.json"), .row = TEXT("a.c")), 0, "has no such number");
    none(QUANTITY(.file = TEXT("run.json"), .row = TEXT("word")), 0, "has no such number");
    none(QUANTITY(.file = TEXT("none.csv"), .row = TEXT("k")), 0, "cannot be read");
    none(QUANTITY(.file = TEXT("case.csv"), .row = TEXT("l")), 0, "has no quantity l");
    none(QUANTITY(.file = TEXT("post.csv"), .row = TEXT("word")), 0, "is not a number");
    none(QUANTITY(.file = TEXT("series.csv"), .row = TEXT("k")), 0, "names no columns quantity and value");
    none(QUANTITY(.command = TEXT("echo 5; exit 3")), 0, "exit code 3");
    none(QUANTITY(.command = TEXT("echo 5 m")), 0, "is not a number");
    none(QUANTITY(.command = TEXT("true")), 0, "is not a number");
    none(QUANTITY(.command = TEXT("kill -9 $$")), 0, "exit code 137");
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(window), cmocka_unit_test(sources)};
    return cmocka_run_group_tests(tests, make_folder, NULL);
}
