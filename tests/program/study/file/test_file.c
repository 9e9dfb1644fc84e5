/* A study's file: values read from good ones, and the sentence for each mistake. */
#include "program/study/file/file.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#define SCENE "scene: " FRANA_SOURCE_DIR "/cases/bar/scene.yaml\n"
#define QUANTITY "quantity: {column: e_strain}\nreference: {value: 2}\n"
#define VARIED "methods: [{name: a}]\nlevels: [{name: x}]\n"

static struct study *parse(const char *text, struct scene_problems *problems) {
    *problems = (struct scene_problems){0};
    return study_file_parse("some/where/bar.study.yaml", text, strlen(text), problems);
}

static struct study *good(const char *text) {
    struct scene_problems problems;
    struct study *s = parse(text, &problems);
    if (!s) fail_msg("%s", problems.text[0]);
    scene_problem_free(&problems);
    return s;
}

static void ensemble(void **state) {
    (void)state;
    struct study *s =
        good(SCENE "ensemble: {key: \"solid.bodies[0].arrangement.seed\", values: [4, 5, 9]}\n" QUANTITY VARIED);
    assert_int_equal(s->repeats, 3);
    assert_int_equal(s->members.n, 3);
    assert_string_equal(s->members.text[2], "solid.bodies[0].arrangement.seed=9");
}

static void sweep(void **state) {
    (void)state;
    struct study *s = good(SCENE "sweep: {key: fluid.viscosity, values: [1e-3, 0.1, 5], unit: Pa s}\n"
                                 "quantity: {column: e_strain}\n");
    assert_true(s->is_sweep);
    assert_int_equal(s->repeats, 1);
    assert_int_equal(s->methods.n, 1);
    assert_int_equal(s->levels.n, 3);
    assert_string_equal(s->levels.variant[2].name, "5");
    assert_string_equal(s->levels.variant[0].sets.text[0], "fluid.viscosity=1e-3");
    check_equal(s->levels.variant[1].at, 0.1);
    assert_true(isnan(s->levels.variant[1].size));
    assert_string_equal(s->axis, "viscosity  [Pa s]");
    s = good(SCENE "sweep: {name: Re, points: [{at: -2, set: {a: 1, b: [2]}}, {at: 2, ranks: 3, set: {a: 3}}]}\n"
                   "quantity: {column: e_strain}\nensemble: {key: k, values: [7, 8]}\nmethods: [{name: m}]\n");
    assert_int_equal(s->levels.n, 2);
    assert_string_equal(s->levels.variant[0].sets.text[1], "b=[2]");
    assert_int_equal(s->levels.variant[1].ranks, 3);
    assert_string_equal(s->axis, "Re");
    assert_string_equal(s->methods.variant[0].name, "m");
    assert_int_equal(s->repeats, 2);
    s = good(SCENE "title: t\nensemble: {key: k, values: [7, 8]}\nquantity: {column: e_strain}\n");
    assert_int_equal(s->levels.variant[0].line, 3);
    s = good(SCENE "ensemble: {key: k, values: [7, 8]}\nquantity: {column: e_strain}\n"); /* seeds alone */
    assert_true(s->is_sweep && !s->axis);
    assert_int_equal(s->levels.n, 1);
}

static void whole(void **state) {
    (void)state;
    struct study *s =
        good("title: A bar\n" SCENE "ranks: 2\nrepeats: 7\nlauncher: srun -n {ranks} --exact\n"
             "set: {output.fields_every: 0}\n"
             "quantities:\n"
             "  - {column: e_strain, at: mean, after: 0.5, before: 1.5, factor: 1e3, unit: mJ}\n"
             "  - {name: broken, column: bonds_broken, at: time, above: 0, reference: {value: 3, "
             "uncertainty: 0.1, "
             "source: a book}}\n"
             "  - {name: stress, file: post/summary.csv, quantity: \"largest, stress\"}\n"
             "  - {name: norm, command: \"./norm.sh | tail -1\", reference: {value: 0, scale: 5}}\n"
             "reference: {finest: true, method: b, order: 2}\n"
             "methods:\n  - {name: a}\n  - {name: b, ranks: 4, set: {stages.pull.integrator: rk3, title: 'x: "
             "\"y\"'}}\n"
             "levels:\n"
             "  - {name: 16, size: 0.0625, set: {domain.cells: [16, 16, 16], solid.bodies: [{name: p, q: [1, "
             "2]}]}}\n"
             "  - {name: 32, size: 0.03125}\n");
    assert_string_equal(s->title, "A bar");
    assert_string_equal(s->folder, "some/where");
    assert_string_equal(s->name, "bar.study");
    assert_string_equal(s->launcher, "srun -n {ranks} --exact");
    assert_int_equal(s->ranks, 2);
    assert_int_equal(s->repeats, 7);
    assert_int_equal(s->sets.n, 1);
    assert_string_equal(s->sets.text[0], "output.fields_every=0");
    assert_int_equal(s->methods.n, 2);
    assert_int_equal(s->methods.variant[0].ranks, 0);
    assert_int_equal(s->methods.variant[1].ranks, 4);
    assert_string_equal(s->methods.variant[1].sets.text[0], "stages.pull.integrator=rk3");
    assert_string_equal(s->methods.variant[1].sets.text[1], "title=\"x: \\\"y\\\"\"");
    assert_string_equal(s->levels.variant[0].name, "16");
    check_equal(s->levels.variant[0].size, 0.0625);
    assert_string_equal(s->levels.variant[0].sets.text[0], "domain.cells=[16, 16, 16]");
    assert_string_equal(s->levels.variant[0].sets.text[1], "solid.bodies=[{\"name\": p, \"q\": [1, 2]}]");
    assert_int_equal(s->quantities, 4);
    const struct study_quantity *q = s->quantity;
    assert_string_equal(q[0].name, "e_strain");
    assert_int_equal(q[0].at, STUDY_MEAN);
    check_equal(q[0].after, 0.5);
    check_equal(q[0].before, 1.5);
    check_equal(q[0].factor, 1000);
    assert_int_equal(q[0].reference.kind, STUDY_REFERENCE_FINEST);
    assert_string_equal(q[0].reference.method, "b");
    check_equal(q[0].reference.order, 2);
    assert_int_equal(q[1].at, STUDY_TIME);
    check_equal(q[1].above, 0);
    check_equal(q[1].reference.value, 3);
    check_equal(q[1].reference.uncertainty, 0.1);
    assert_string_equal(q[1].reference.source, "a book");
    assert_string_equal(q[2].row, "largest, stress");
    assert_string_equal(q[3].command, "./norm.sh | tail -1");
    check_equal(q[3].reference.scale, 5);
}

static void defaults(void **state) {
    (void)state;
    struct study *s = good(SCENE QUANTITY VARIED);
    assert_string_equal(s->title, "bar.study");
    assert_string_equal(s->launcher, "mpiexec -n {ranks}");
    check_equal(s->ranks, 1);
    check_equal(s->repeats, 5);
    assert_true(isnan(s->levels.variant[0].size));
    assert_int_equal(s->quantity[0].at, STUDY_LAST);
    check_equal(s->quantity[0].factor, 1);
    assert_true(isnan(s->quantity[0].reference.scale));
}

static void products(void **state) {
    (void)state;
    struct study *s = good(
        SCENE QUANTITY "methods:\n  product:\n    - [{name: rk3, set: {i: rk3}}, {name: verlet, set: {i: verlet}}]\n"
                       "    - [{name: n2, set: {n: 2}}, {name: n4, ranks: 3, set: {n: 4}}, {name: n8}]\n"
                       "levels:\n  product:\n    - [{name: only, set: {k: 1}}]\n"
                       "    - [{name: coarse, size: 2}, {name: fine, size: 1}]\n");
    assert_int_equal(s->methods.n, 6);
    assert_string_equal(s->methods.variant[0].name, "rk3 n2");
    assert_string_equal(s->methods.variant[4].name, "verlet n4");
    assert_int_equal(s->methods.variant[4].ranks, 3);
    assert_int_equal(s->methods.variant[4].sets.n, 2);
    assert_string_equal(s->methods.variant[4].sets.text[0], "i=verlet");
    assert_string_equal(s->methods.variant[4].sets.text[1], "n=4");
    assert_int_equal(s->levels.n, 2);
    assert_string_equal(s->levels.variant[1].name, "only fine");
    check_equal(s->levels.variant[1].size, 1);
}

/* Each has one mistake, and its sentence begins so. */
static void broken(void **state) {
    (void)state;
    static const struct {
        const char *text, *says;
    } mistake[] = {
        {"", ": the study is empty"},
        {"- a\n", ":1: a study must be a mapping (scene: "},
        {"title: [\n", ":2: not valid YAML"},
        {QUANTITY VARIED, ":1: scene: is missing"},
        {"scene: none.yaml\n" QUANTITY VARIED, ":1: scene = none.yaml: cannot be read"},
        {SCENE "repeat: 3\n" QUANTITY VARIED, ":2: repeat = 3: unknown key; did you mean repeats?"},
        {SCENE "title: \"a\\u202eb\"\n" QUANTITY VARIED,
         ":2: title = \"a\342\200\256b\": must be one line without control"},
        {SCENE "repeats: 0\n" QUANTITY VARIED, ":2: repeats = 0: must be a whole number, 1 to 1000"},
        {SCENE "repeats: 2\nensemble: {key: a, values: [1]}\n" QUANTITY VARIED,
         ":3: ensemble: not together with repeats: each value is run once"},
        {SCENE QUANTITY "methods: [{name: a}]\n", ":1: levels: is missing"},
        {SCENE "sweep: {key: a, values: [1]}\n" QUANTITY, ":4: reference: goes with levels"},
        {SCENE "sweep: {key: a, values: [1]}\nquantity: {column: a, reference: {value: 1}}\n",
         ":3: quantity: reference goes with levels"},
        {SCENE "sweep: {key: a, values: [1]}\nquantity: {column: a}\n" VARIED, ":2: sweep: not together with levels"},
        {SCENE "sweep: {key: a}\nquantity: {column: a}\n", ":2: sweep: needs key and values, or points"},
        {SCENE "sweep: {key: a, values: [1], points: [1]}\nquantity: {column: a}\n", ":2: sweep: needs key and values"},
        {SCENE "sweep: {key: a, values: []}\nquantity: {column: a}\n", ":2: sweep.values = []: must be a list"},
        {SCENE "sweep: {key: a, values: [wall]}\nquantity: {column: a}\n",
         ":2: sweep.values[0] = wall: must be a number; words are methods"},
        {SCENE "sweep: {key: a, values: [1, 1]}\nquantity: {column: a}\n",
         ":2: sweep: must go from small to large: 1 follows 1"},
        {SCENE "sweep: {points: [{at: 1}]}\nquantity: {column: a}\n", ":2: sweep.points[0].set: is missing"},
        {SCENE "sweep: {points: [{set: {a: 1}}]}\nquantity: {column: a}\n", ":2: sweep.points[0].at: is missing"},
        {SCENE "ensemble: {key: a}\n" QUANTITY VARIED, ":2: ensemble.values: is missing"},
        {SCENE "ensemble:\n  key: a\n  values:\n    - 1\n    - 2\n    - 1\n" QUANTITY VARIED,
         ":7: ensemble.values[2] = 1: is there twice"},
        {SCENE "repeats: 2.5\n" QUANTITY VARIED, ":2: repeats = 2.5: must be a whole number"},
        {SCENE "ranks: two\n" QUANTITY VARIED, ":2: ranks = two: must be a whole number"},
        {SCENE "ranks: 1\nranks: 2\n" QUANTITY VARIED, ":3: ranks = 2: is there twice"},
        {SCENE "launcher: mpirun\n" QUANTITY VARIED, ":2: launcher = mpirun: must say where {ranks} go"},
        {SCENE "set: [1]\n" QUANTITY VARIED, ":2: set = [1]: must be a mapping"},
        {SCENE VARIED, ":1: quantity: give quantity, or a list quantities, and not both"},
        {SCENE "quantities: [{column: a}]\n" QUANTITY VARIED, ":3: quantity: give quantity, or a list"},
        {SCENE "quantities: []\n" VARIED, ":2: quantities = []: must be a list that is not empty"},
        {SCENE "quantity: {column: a}\n" VARIED, ":2: reference: a has no reference"},
        {SCENE "quantity: {at: last}\nreference: {value: 1}\n" VARIED, ":2: quantity: needs one of column, file and"},
        {SCENE "quantity: {column: a, command: b}\nreference: {value: 1}\n" VARIED, ":2: quantity: needs one of"},
        {SCENE "quantity: {column: a, at: lst}\nreference: {value: 1}\n" VARIED,
         ":2: quantity.at = lst: must be one of last, first, max, min, mean, time"},
        {SCENE "quantity: {column: a, at: time}\nreference: {value: 1}\n" VARIED,
         ":2: quantity: above goes with at: time"},
        {SCENE "quantity: {column: a, above: 1}\nreference: {value: 1}\n" VARIED, ":2: quantity: above goes with"},
        {SCENE "quantity: {column: a, after: 2, before: 1}\nreference: {value: 1}\n" VARIED,
         ":2: quantity: after 2 and before 1"},
        {SCENE "quantity: {file: a}\nreference: {value: 1}\n" VARIED, ":2: quantity: quantity is missing"},
        {SCENE "quantity: {command: a, after: 1}\nreference: {value: 1}\n" VARIED,
         ":2: quantity: after goes with column only"},
        {SCENE "quantity: {column: a, factor: nan}\nreference: {value: 1}\n" VARIED,
         ":2: quantity.factor = nan: must be a number"},
        {SCENE "quantity: {column: a}\nreference: {source: b}\n" VARIED, ":3: reference: needs value, or finest: true"},
        {SCENE "quantity: {column: a}\nreference: {value: 1, finest: true}\n" VARIED, ":3: reference: needs value, or"},
        {SCENE "quantity: {column: a}\nreference: {value: 1, order: 2}\n" VARIED, ":3: reference: method and order go"},
        {SCENE "quantity: {column: a}\nreference: {finest: true, order: 1, formal_order: 2}\n" VARIED,
         ":3: reference: order is given, so formal_order"},
        {SCENE "quantity: {column: a}\nreference: {finest: true, source: b}\n" VARIED,
         ":3: reference: uncertainty and"},
        {SCENE "quantity: {column: a}\nreference: {value: 1, uncertainty: -1}\n" VARIED,
         ":3: reference.uncertainty = -1: must be a number, at least 0"},
        {SCENE "quantity: {column: a}\nreference: {finest: true, method: c}\n" VARIED,
         ":2: reference.method: there is no method c"},
        {SCENE "quantities: [{column: a}, {column: b}]\nreference: {value: 1}\n" VARIED,
         ":3: reference: has one value for 2 quantities"},
        {SCENE "quantities: [{column: a}, {column: a}]\nreference: {finest: true}\n" VARIED,
         ":2: quantities[1]: two are called a"},
        {SCENE QUANTITY "levels: [{name: x}]\n", ":1: methods: is missing"},
        {SCENE QUANTITY "methods: []\nlevels: [{name: x}]\n", ":4: methods = []: must be a list that is not empty"},
        {SCENE QUANTITY "methods: [a]\nlevels: [{name: x}]\n", ":4: methods[0] = a: must be a mapping"},
        {SCENE QUANTITY "methods: [{set: {a: 1}}]\nlevels: [{name: x}]\n", ":4: methods[0].name: is missing"},
        {SCENE QUANTITY "methods: [{name: a, size: 1}]\nlevels: [{name: x}]\n", ":4: methods[0].size = 1: unknown key"},
        {SCENE QUANTITY "methods:\n  - {name: a}\n  - {name: a}\nlevels: [{name: x}]\n",
         ":6: methods: two are called a"},
        {SCENE QUANTITY "methods: [{name: a}]\nlevels:\n  - {name: x, size: 0}\n",
         ":6: levels[0].size = 0: must be a number, greater than 0"},
        {SCENE QUANTITY "methods: [{name: a}]\nlevels:\n  - {name: x, size: 1}\n  - {name: y}\n",
         ":5: levels: give size for all or for none"},
        {SCENE QUANTITY "methods: [{name: a}]\nlevels:\n  - {name: x, size: 1}\n  - {name: y, size: 2}\n",
         ":7: levels: must go from coarse to fine: size 2 follows 1"},
        {SCENE QUANTITY "methods: {products: []}\nlevels: [{name: x}]\n", ":4: methods.products = []: unknown key"},
        {SCENE QUANTITY "methods: {product: [{name: a}]}\nlevels: [{name: x}]\n",
         ":4: methods.product[0]: must be a list"},
        {"domain: {size: [1, 1]}\nstages: []\n", ": is a scene and not a study: frana run runs it"},
        {SCENE QUANTITY "methods: [{name: a}]\nlevels: {product: [[{name: x, size: 1}], [{name: y, size: 1}]]}\n",
         ":5: levels: size is given in two lists of the product"},
    };
    for (size_t k = 0; k < sizeof mistake / sizeof *mistake; k++) {
        struct scene_problems problems;
        assert_null(parse(mistake[k].text, &problems));
        const char *says = problems.text[0] + strlen("some/where/bar.study.yaml");
        if (strncmp(says, mistake[k].says, strlen(mistake[k].says)))
            fail_msg("says \"%s\", not \"%s\", of\n%s", says, mistake[k].says, mistake[k].text);
        const int also = strstr(mistake[k].text, "products") != NULL; /* which leaves product missing */
        if (problems.n != 1 + also) fail_msg("%d sentences, the second \"%s\"", problems.n, problems.text[1]);
        scene_problem_free(&problems);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(ensemble), cmocka_unit_test(sweep),
                                       cmocka_unit_test(whole),    cmocka_unit_test(defaults),
                                       cmocka_unit_test(products), cmocka_unit_test(broken)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
