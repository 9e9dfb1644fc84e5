/* A run's beginning tells other bodies, held and unbreakable particles, cracks and domains from its own, in one word
 * each, and knows its own whatever loads, materials and stages are. */
#include "coupling/setup/beginning.h"
#include "coupling/run.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <stdio.h>
#include <string.h>

static const char *const solid =
    "title: test\n"
    "domain: {size: [20, 6, 6]}\n"
    "solid:\n"
    "  spacing: 1\n"
    "  materials: [{name: m, youngs_modulus: %s, density: 1, horizon_ratio: %s}]\n"
    "  bodies: [{shape: box, low: [%s, 1, 1], high: [%s, 5, 5]}]\n"
    "  constraints: [{low: [0, 0, 0], high: [%s, 6, 6], directions: %s, velocity: [%s, 0, 0]}]\n"
    "  unbreakable: [{low: [8, 0, 0], high: [%s, 6, 6]}]\n"
    "  cracks: [{points: [[%s, 0, 0], [%s, 6, 0], [%s, 6, 6], [%s, 0, 6]]}]\n";
#define STAGES "stages: [{name: go, steps: 1, time_step: 0.1}]\n"

struct choice {
    const char *young, *horizon, *low, *high, *held, *directions, *velocity, *safe, *crack;
    const char *word; /* of the sentence about it; NULL: the same beginning */
};

static struct beginning beginning(const char *text) {
    struct scene *scene = scene_of(text, STAGES, 0, NULL);
    struct run *r = run_new(scene);
    const struct beginning b = r->beginning;
    run_free(r);
    scene_free(scene);
    return b;
}

static struct beginning of_choice(const struct choice *a) {
    char text[1536];
    snprintf(text, sizeof text, solid, a->young, a->horizon, a->low, a->high, a->held, a->directions, a->velocity,
             a->safe, a->crack, a->crack, a->crack, a->crack);
    return beginning(text);
}

static void compare(const struct beginning *was, const struct beginning *now, const char *word) {
    char text[1024], why[512] = "";
    beginning_write(was, text, sizeof text);
    check_equal(beginning_differs(now, text, why, sizeof why), word != NULL);
    if (word) assert_non_null(strstr(why, word));
}

static void solids(void **state) {
    static const struct choice choice[] = {
        {"1", "2", "1", "13", "3", "xyz", "0", "10", "6", NULL},
        {"3", "2", "1", "13", "3", "xyz", "1", "10", "6", NULL},
        {"1", "2", "2", "14", "3", "xyz", "0", "10", "6", "particles elsewhere"},
        {"1", "2", "1", "12", "3", "xyz", "0", "10", "6", "particles elsewhere"},
        {"1", "2", "1", "13", "4", "xyz", "0", "10", "6", "holds other particles"},
        {"1", "2", "1", "13", "3", "x", "0", "10", "6", "holds other particles"},
        {"1", "2", "1", "13", "3", "xyz", "0", "11", "6", "other unbreakable"},
        {"1", "2", "1", "13", "3", "xyz", "0", "10", "7", "other bonds"},
        {"1", "3", "1", "13", "3", "xyz", "0", "10", "6", "other bonds"},
    };
    (void)state;
    const struct beginning was = of_choice(&choice[0]);
    for (size_t k = 0; k < sizeof choice / sizeof choice[0]; k++) {
        const struct beginning now = of_choice(&choice[k]);
        compare(&was, &now, choice[k].word);
    }
}

static void domains(void **state) {
    static const char *const fluid =
        "title: test\n"
        "domain: {size: [%g, 1, 1], cells: [4, 4, 4]}\n"
        "fluid: {density: 1, viscosity: 1, sides: {x_low: {type: periodic}, x_high: {type: periodic}, y_low: {type: "
        "wall}, y_high: {type: wall}, z_low: {type: slip}, z_high: {type: slip}}}\n";
    char text[2][512];
    (void)state;
    for (int k = 0; k < 2; k++) snprintf(text[k], sizeof text[k], fluid, 1 + 1.0 * k);
    const struct beginning was = beginning(text[0]), now = beginning(text[1]);
    compare(&was, &was, NULL);
    compare(&was, &now, "a domain of 1 m along x, the scene of 2 m");
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(solids), cmocka_unit_test(domains)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
