/* Where particles are farther apart than cells are wide, or nearer, a sentence says what that does to the flow. */
#include "coupling/interface/ratio.h"
#include "coupling/run.h"
#include "tests/check.h"
#include "tests/coupling/scene_of.h"

#include <stdio.h>
#include <string.h>

#define SIDES                                                                                                          \
    "{x_low: {type: periodic}, x_high: {type: periodic}, y_low: {type: periodic}, y_high: {type: periodic}, z_low: "   \
    "{type: wall}, z_high: {type: wall}}"

static void said(void **state) {
    static const struct {
        const char *spacing, *word; /* NULL: nothing is said */
    } table[] = {{"1", NULL},         {"0.8", NULL},           {"1.2", NULL},
                 {"2", "is 2 cells"}, {"1.5", "is 1.5 cells"}, {"0.5", "stand out"}};
    (void)state;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++) {
        char text[1024], sentence[RATIO_SENTENCE] = "";
        snprintf(text, sizeof text,
                 "title: test\n"
                 "domain: {size: [24, 24, 24], cells: [24, 24, 24]}\n"
                 "fluid: {density: 1, viscosity: 1, sides: " SIDES "}\n"
                 "solid: {spacing: %s, materials: [{name: m, youngs_modulus: 1, density: 1}], bodies: [{shape: sphere, "
                 "centre: [12, 12, 12], radius: 6.1}]}\n",
                 table[i].spacing);
        struct scene *scene = scene_of(text, "stages: [{name: go, steps: 1, solid: rigid}]\n", 0, NULL);
        struct run *r = run_new(scene);
        check_equal(ratio_of(r, sentence), table[i].word != NULL);
        if (table[i].word) assert_non_null(strstr(sentence, table[i].word));
        run_free(r);
        scene_free(scene);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(said)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
