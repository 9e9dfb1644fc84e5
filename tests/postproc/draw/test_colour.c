/* Colour maps: their ends, their lightness, and sRGB to linear light and back. */
#include "postproc/draw/colour.h"
#include "tests/check.h"

static void colours_at_the_ends(void **state) {
    (void)state;
    double a[3], b[3];
    postproc_colour_map(POSTPROC_VIRIDIS, 0, a);
    check_close(a[0], 0x44 / 255.0, 1e-12);
    check_close(a[2], 0x54 / 255.0, 1e-12);
    postproc_colour_map(POSTPROC_VIRIDIS, 1, a);
    check_close(a[0], 0xfd / 255.0, 1e-12);
    postproc_colour_map(POSTPROC_VIRIDIS, 7, b);
    assert_memory_equal(a, b, sizeof a);
    postproc_colour_map(POSTPROC_MAGMA_REVERSED, 0, a);
    check_close(a[0], 0xf6 / 255.0, 1e-12);
    postproc_colour_map(POSTPROC_MAGMA_REVERSED, 1, a);
    check_close(a[2], 4 / 255.0, 1e-12);
    /* lightness (CIE L*) is monotone, in steps that are equal within a factor of two */
    for (int map = 0; map < 2; map++) {
        double last = 0;
        for (int i = 0; i <= 16; i++) {
            postproc_colour_map(map ? POSTPROC_VIRIDIS : POSTPROC_MAGMA_REVERSED, i / 16.0, a);
            const double y = 0.2126 * postproc_colour_linear(a[0]) + 0.7152 * postproc_colour_linear(a[1]) +
                             0.0722 * postproc_colour_linear(a[2]);
            const double l = y > 0.008856 ? 116 * cbrt(y) - 16 : 903.3 * y, step = fabs(l - last);
            if (i > 0) {
                check_between(step, map ? 3.3 : 3, map ? 7 : 9);
                check_equal(l > last, map);
            }
            last = l;
        }
    }
    /* the diverging map is lightest in the middle, and equally dark at both ends within a tenth of the whole range */
    double light[3];
    for (int i = 0; i <= 2; i++) {
        postproc_colour_map(POSTPROC_DIVERGING, 0.5 * i, a);
        const double y = 0.2126 * postproc_colour_linear(a[0]) + 0.7152 * postproc_colour_linear(a[1]) +
                         0.0722 * postproc_colour_linear(a[2]);
        light[i] = 116 * cbrt(y) - 16;
    }
    check_above(light[1], 96);
    check_close(light[0], light[2], 10);
    check_between(light[0], 10, 25);
    for (int i = 0; i <= 10; i++) check_close(postproc_colour_srgb(postproc_colour_linear(i / 10.0)), i / 10.0, 1e-6);
}

/* The two branches of the transfer function meet; no number is grey. */
static void transfer_function_and_grey(void **state) {
    (void)state;
    check_equal(postproc_colour_linear(0), 0);
    check_close(postproc_colour_linear(1), 1, 1e-15);
    check_close(postproc_colour_linear(0.5), 0.21404114048223255, 1e-14);
    check_close(postproc_colour_linear(0.04045), postproc_colour_linear(0.040451), 1e-6);
    check_close(postproc_colour_srgb(0.0031308), postproc_colour_srgb(0.0031309), 1e-5);
    double grey[3];
    postproc_colour_map(POSTPROC_VIRIDIS, NAN, grey);
    for (int c = 0; c < 3; c++) check_equal(grey[c], 0.5);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(colours_at_the_ends),
                                       cmocka_unit_test(transfer_function_and_grey)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
