/* Lines of gates: what passes at the limit and beyond it, and how numbers and texts are written. */
#include "program/study/gates/parts.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>

static void expect(const struct study_gates_gate *g, int held, const char *line) {
    char *text = NULL;
    size_t bytes = 0;
    FILE *f = open_memstream(&text, &bytes);
    const int is = study_gates_verdict_put(f, g);
    fclose(f);
    assert_string_equal(text, line);
    assert_int_equal(is, held);
    free(text);
}

#define GATE(ours, reference, rule, limit, high)                                                                       \
    &(struct study_gates_gate) { "q", "m", ours, reference, "s", rule, limit, high, 4 }

static void limits(void **state) {
    (void)state;
    expect(GATE("1.01", "1", STUDY_GATES_RELATIVE, "1.0e-2", NULL), 0, "q,m,1.01,1,s,0.01 relative,no\n");
    expect(GATE("1.0625", "1", STUDY_GATES_RELATIVE, "0.0625", NULL), 1, "q,m,1.062,1,s,0.0625 relative,yes\n");
    expect(GATE("-2", "-2.00004", STUDY_GATES_RELATIVE, "1e-4", NULL), 1, "q,m,-2,-2,s,0.0001 relative,yes\n");
    expect(GATE("2", "any", STUDY_GATES_BETWEEN, "2", "3.0"), 1, "q,m,2,any,s,2 to 3.0,yes\n");
    expect(GATE("3.1", "any", STUDY_GATES_BETWEEN, "2", "3.0"), 0, "q,m,3.1,any,s,2 to 3.0,no\n");
    expect(GATE("1.99", "", STUDY_GATES_AT_LEAST, "2", NULL), 0, "q,m,1.99,,s,>= 2,no\n");
    expect(GATE("-1e-9", "0", STUDY_GATES_AT_MOST, "1e-8", NULL), 1, "q,m,-1e-09,0,s,at most 1e-8,yes\n");
    expect(GATE("-1e-7", "0", STUDY_GATES_AT_MOST, "1e-8", NULL), 0, "q,m,-1e-07,0,s,at most 1e-8,no\n");
    expect(GATE("0.10", "0.10", STUDY_GATES_SAME, NULL, NULL), 1, "q,m,0.1,0.10,s,the same,yes\n");
    expect(GATE("0.1", "0.10", STUDY_GATES_SAME, NULL, NULL), 0, "q,m,0.1,0.10,s,the same,no\n");
    expect(GATE("7", "", STUDY_GATES_SHOWN, NULL, NULL), 1, "q,m,7,,s\n");
}

/* What is not a number is in no range. */
static void no_number(void **state) {
    (void)state;
    expect(GATE("", "1", STUDY_GATES_RELATIVE, "1", NULL), 0, "q,m,,1,s,1 relative,no\n");
    expect(GATE("nan", "0", STUDY_GATES_AT_MOST, "1", NULL), 0, "q,m,nan,0,s,at most 1,no\n");
    expect(GATE("inf", "0", STUDY_GATES_AT_LEAST, "1", NULL), 0, "q,m,inf,0,s,>= 1,no\n");
    expect(GATE("none", "0", STUDY_GATES_BETWEEN, "-1", "1"), 0, "q,m,none,0,s,-1 to 1,no\n");
}

static void quotes(void **state) {
    (void)state;
    expect(&(struct study_gates_gate){"a, b", "1", "1.23456", "1.23456", "\"x\"", STUDY_GATES_RELATIVE, "1", NULL, 0},
           1, "\"a, b\",1,1.23456,1.23456,\"\"\"x\"\"\",1 relative,yes\n");
}

/* A known miss is held in its range; one without a number stays without; what the table does not have is not held. */
static void misses(void **state) {
    (void)state;
    static const char *const table = "quantity,low,high,tested,reason\n\"a, b\",0.9,1.2,yes,\"x, y\"\nc,,,no,z\n"
                                     "d,0.3,inf,part,w\n";
    assert_true(study_gates_misses_hold(table, "\"a, b\",1,1.2,1,s,0.1 relative,no"));
    assert_false(study_gates_misses_hold(table, "\"a, b\",1,1.21,1,s,0.1 relative,no"));
    assert_false(study_gates_misses_hold(table, "\"a, b\",1,0.8,1,s,0.1 relative,no"));
    assert_false(study_gates_misses_hold(table, "\"a, b\",1,nan,1,s,0.1 relative,no"));
    assert_false(study_gates_misses_hold(table, "\"a, b\",1,,1,s,0.1 relative,no"));
    assert_true(study_gates_misses_hold(table, "c,1,,1,s,0.1 relative,no"));
    assert_false(study_gates_misses_hold(table, "c,1,7,1,s,0.1 relative,no"));
    assert_true(study_gates_misses_hold(table, "d,1,0.5,1,s,>= 1,no"));
    assert_false(study_gates_misses_hold(table, "d,1,0.2,1,s,>= 1,no"));
    assert_false(study_gates_misses_hold(table, "e,1,1,1,s,the same,no"));
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(limits), cmocka_unit_test(no_number), cmocka_unit_test(quotes),
                                       cmocka_unit_test(misses)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
