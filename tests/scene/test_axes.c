/* The directions that a word of axes names, by the letters of the word. */
#include "scene/scene.h"
#include "tests/check.h"

static void the_letters_are_the_directions(void **state) {
    (void)state;
    static const char *const word[] = {[SCENE_XY] = "xy", [SCENE_XZ] = "xz", [SCENE_YZ] = "yz", [SCENE_XYZ] = "xyz"};
    for (enum scene_axes axes = SCENE_XY; axes <= SCENE_XYZ; axes++)
        for (int d = 0; d < 3; d++) assert_int_equal(scene_axes_has(axes, d), strchr(word[axes], "xyz"[d]) != NULL);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_letters_are_the_directions)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
