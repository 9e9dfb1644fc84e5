/* A camera's axes are orthonormal, y is up, and the box fills the window. */
#include "postproc/draw/camera.h"
#include "tests/check.h"

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static const double low[3] = {-1, 2, 0}, high[3] = {3, 3, 0.5}, window[4] = {10, 20, 410, 220};

/* From the front: x to the right, y up, so that the picture is known by hand. */
static void from_the_front(void **state) {
    (void)state;
    const struct postproc_camera c = postproc_camera_new((double[]){0, 0, 7}, low, high, window);
    double pixel[3];
    check_close(c.scale, 100, 1e-12); /* 400 pixels for 4 m; the height would allow 200 */
    postproc_camera_see(&c, (double[]){-1, 3, 0.25}, pixel);
    check_close(pixel[0], 10, 1e-11);
    check_close(pixel[1], 120 - 50, 1e-11);
    check_close(pixel[2], 0, 1e-15);
    postproc_camera_see(&c, (double[]){3, 2, 0.5}, pixel);
    check_close(pixel[0], 410, 1e-11);
    check_close(pixel[1], 170, 1e-11);
    check_close(pixel[2], 0.25, 1e-15); /* nearer */
}

static void from_any_side(void **state) {
    (void)state;
    const double toward[][3] = {{1, 0, 0}, {-2, 1, 3}, {0.1, 5, -0.2}, {1, -1, 1}};
    for (int k = 0; k < 4; k++) {
        const struct postproc_camera c = postproc_camera_new(toward[k], low, high, window);
        const double *axis[3] = {c.right, c.up, c.toward};
        for (int a = 0; a < 3; a++)
            for (int b = 0; b < 3; b++) check_close(dot(axis[a], axis[b]), a == b, 1e-14);
        check_relative(dot(c.toward, toward[k]), sqrt(dot(toward[k], toward[k])), 1e-14);
        check_close(c.right[1], 0, 1e-15);
        check_above(c.up[1], 0);
        const double volume = c.right[0] * (c.up[1] * c.toward[2] - c.up[2] * c.toward[1]) +
                              c.right[1] * (c.up[2] * c.toward[0] - c.up[0] * c.toward[2]) +
                              c.right[2] * (c.up[0] * c.toward[1] - c.up[1] * c.toward[0]);
        check_close(volume, 1, 1e-14);                             /* not mirrored */
        double free[4] = {INFINITY, INFINITY, INFINITY, INFINITY}; /* between the box and the window's four sides */
        for (int corner = 0; corner < 8; corner++) {
            double pixel[3];
            const double x[3] = {corner & 1 ? high[0] : low[0], corner & 2 ? high[1] : low[1],
                                 corner & 4 ? high[2] : low[2]};
            postproc_camera_see(&c, x, pixel);
            for (int s = 0; s < 4; s++)
                free[s] = fmin(free[s], s < 2 ? pixel[s] - window[s] : window[s] - pixel[s - 2]);
        }
        check_close(free[0], free[2], 1e-10);
        check_close(free[1], free[3], 1e-10);
        check_close(fmin(free[0], free[1]), 0, 1e-10);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(from_the_front), cmocka_unit_test(from_any_side)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
