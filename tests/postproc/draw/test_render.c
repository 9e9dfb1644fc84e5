/* Rendering: silhouettes, hidden faces, shading; texts and the files of a picture. */
#include "base/par.h"
#include "postproc/draw/bar.h"
#include "postproc/draw/colour.h"
#include "postproc/draw/legend.h"
#include "postproc/draw/picture.h"
#include "postproc/draw/ray.h"
#include "postproc/draw/render.h"
#include "postproc/draw/voxels.h"
#include "postproc/gnuplot.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

enum { WIDTH = 400, HEIGHT = 300 };
static const double low[3] = {-1, -1, -1}, high[3] = {1, 1, 1};

static const float *pixel(const struct postproc_canvas *c, int i, int j) { return c->rgb + 3 * (j * c->width + i); }

static struct postproc_canvas *drawn(const double toward[3], struct postproc_cubes *cubes,
                                     struct postproc_camera *camera, long *faces) {
    const double window[4] = {0, 0, WIDTH, HEIGHT};
    struct postproc_canvas *c = postproc_canvas_new(WIDTH, HEIGHT);
    *camera = postproc_camera_new(toward, low, high, window);
    for (int k = 0; k < 3; k++) {
        cubes->low[k] = low[k];
        cubes->high[k] = high[k];
    }
    *faces = postproc_render_cubes(c, camera, cubes, 1);
    return c;
}

/* A cube of edge a seen along n covers a^2 (|nx| + |ny| + |nz|) of the picture's plane. */
static void silhouette(void **state) {
    (void)state;
    static const double views[4][3] = {{0, 0, 1}, {1, 0.5, 1.25}, {-1, 0.5, 1.25}, {0.3, -0.7, -0.6}};
    const double x[1][3] = {{0.1, -0.05, 0.2}};
    const float colour[1][3] = {{1, 1, 1}};
    for (int v = 0; v < 4; v++) {
        struct postproc_cubes cubes = {.n = 1, .x = x, .colour = colour, .size = 0.8};
        struct postproc_camera camera;
        long faces, covered = 0;
        struct postproc_canvas *c = drawn(views[v], &cubes, &camera, &faces);
        for (int i = 0; i < WIDTH * HEIGHT; i++) covered += c->rgb[3 * i] > 0.5f;
        double sum = 0;
        for (int k = 0; k < 3; k++) sum += fabs(camera.toward[k]);
        const double edge = camera.scale * cubes.size;
        /* pixels by their middles: the error is below the rim's length, about 6 edges x 1/4 pixel */
        check_close(covered, sum * edge * edge, 1.5 * edge);
        assert_int_equal(faces, v == 0 ? 1 : 3);
        postproc_canvas_free(c);
    }
}

static void front_hides_back(void **state) {
    (void)state;
    const double toward[3] = {0, 0, 1};
    const float colour[2][3] = {{1, 0, 0}, {0, 1, 0}};
    for (int order = 0; order < 2; order++) {
        double x[2][3] = {{0, 0, order ? -0.5 : 0.5}, {0, 0, order ? 0.5 : -0.5}};
        struct postproc_cubes cubes = {.n = 2, .x = (const double(*)[3])x, .colour = colour, .size = 0.4};
        struct postproc_camera camera;
        long faces;
        struct postproc_canvas *c = drawn(toward, &cubes, &camera, &faces);
        const float *middle = pixel(c, WIDTH / 2, HEIGHT / 2);
        check_equal(middle[0], order ? 0 : 1);
        check_equal(middle[1], order ? 1 : 0);
        check_close(c->depth[HEIGHT / 2 * WIDTH + WIDTH / 2], 0.7, 1e-6);
        postproc_canvas_free(c);
    }
}

/* Of a solid block of 4^3 only the outer faces towards the eye are drawn; one pushed out shows its neighbours' again.
 */
static void inner_faces_left_out(void **state) {
    (void)state;
    double x[64][3];
    float colour[64][3];
    for (int i = 0; i < 64; i++)
        for (int k = 0; k < 3; k++) {
            const int at = k == 0 ? i % 4 : k == 1 ? i / 4 % 4 : i / 16;
            x[i][k] = (at - 1.5) * 0.2;
            colour[i][k] = 1;
        }
    const double toward[3] = {1, 0.5, 1.25};
    struct postproc_cubes cubes = {
        .n = 64, .x = (const double(*)[3])x, .colour = (const float(*)[3])colour, .size = 0.2};
    struct postproc_camera camera;
    long faces;
    postproc_canvas_free(drawn(toward, &cubes, &camera, &faces));
    assert_int_equal(faces, 48);
    x[3 + 4 + 16][0] += 0.04; /* a particle of the face x = max, not on an edge: it no longer covers, nor is covered */
    postproc_canvas_free(drawn(toward, &cubes, &camera, &faces));
    check_above(faces, 48);
    check_at_most(faces, 54);
}

/* A particle that is nowhere, or far away, leaves the others as they are. */
static void strays_left_out(void **state) {
    (void)state;
    const double x[4][3] = {{0.1, 0.1, 0.1}, {NAN, 0, 0}, {1e300, 0, -1e9}, {0.3, 0.1, 0.1}};
    const float colour[4][3] = {{0}};
    const double toward[3] = {1, 0.5, 1.25};
    struct postproc_cubes cubes = {.n = 4, .x = x, .colour = colour, .size = 0.2};
    struct postproc_camera camera;
    long faces;
    postproc_canvas_free(drawn(toward, &cubes, &camera, &faces));
    assert_int_equal(faces, 5); /* three each, less the one between the two */
}

/* Rays through cells, from the middle of one: walls of the lattice at half-integers. */
static void ray_meets_cells(void **state) {
    (void)state;
    struct postproc_ray ray;
    postproc_ray_cast(&ray, (const double[3]){-1, 0, 0}, 3.6);
    assert_int_equal(ray.cells, 4);
    for (int i = 0; i < 4; i++) {
        assert_int_equal(ray.step[i][0], -(i + 1));
        check_close(ray.distance[i], i + 0.5, 1e-6);
    }
    /* slope 1/2: x crosses walls at x = 0.5, 1.5, 2.5, y at x = 1, 3, for which the way is x sqrt(5)/2 */
    static const int cell[5][2] = {{1, 0}, {1, 1}, {2, 1}, {3, 1}, {3, 2}};
    static const double at[5] = {0.5, 1, 1.5, 2.5, 3};
    postproc_ray_cast(&ray, (const double[3]){2 / sqrt(5), 1 / sqrt(5), 0}, 3.4);
    assert_int_equal(ray.cells, 5);
    for (int i = 0; i < 5; i++) {
        assert_int_equal(ray.step[i][0], cell[i][0]);
        assert_int_equal(ray.step[i][1], cell[i][1]);
        check_close(ray.distance[i], at[i] * sqrt(5) / 2, 1e-6);
    }
    /* a wall of particles three cells off, seen past an empty margin */
    const double x[2][3] = {{0.05, 0.05, 0.05}, {0.35, 0.05, 0.05}};
    struct postproc_voxels *v = postproc_voxels_new(2, x, 0.1, low, high);
    assert_int_equal(v->n[0], 4);
    postproc_ray_cast(&ray, (const double[3]){1, 0, 0}, 10);
    check_close(postproc_ray_hit(&ray, v, (const int[3]){0, 0, 0}), 2.5, 1e-6);
    check_close(postproc_ray_hit(&ray, v, (const int[3]){-2, 0, 0}), 1.5, 1e-6); /* comes in from outside */
    check_close(postproc_ray_hit(&ray, v, (const int[3]){3, 0, 0}), -1, 0);
    check_close(postproc_ray_hit(&ray, v, (const int[3]){0, 1, 0}), -1, 0);
    postproc_voxels_free(v);
}

/* Light: the same face in the open is brighter than at the bottom of a shaft. */
static void shade_in_a_shaft(void **state) {
    (void)state;
    enum { N = 9, MIDDLE = 4 };
    double(*x)[3] = malloc(N * N * N * sizeof *x);
    float(*colour)[3] = malloc(N * N * N * sizeof *colour);
    int n = 0;
    for (int k = 0; k < N; k++)
        for (int j = 0; j < N; j++)
            for (int i = 0; i < N; i++) {
                if (i == MIDDLE && j == MIDDLE && k > 1) continue; /* a shaft along z */
                const double q[3] = {i, j, k};
                for (int c = 0; c < 3; c++) {
                    x[n][c] = (q[c] - MIDDLE) * 0.1;
                    colour[n][c] = 1;
                }
                n++;
            }
    const double toward[3] = {0, 0, 1}, window[4] = {0, 0, WIDTH, HEIGHT};
    struct postproc_camera camera = postproc_camera_new(toward, low, high, window);
    struct postproc_cubes cubes = {.n = n,
                                   .x = (const double(*)[3])x,
                                   .colour = (const float(*)[3])colour,
                                   .size = 0.1,
                                   .low = {-1, -1, -1},
                                   .high = {1, 1, 1}};
    struct postproc_canvas *c = postproc_canvas_new(WIDTH, HEIGHT);
    postproc_render_cubes(c, &camera, &cubes, 0);
    const float bottom = pixel(c, WIDTH / 2, HEIGHT / 2)[1];
    const float open = pixel(c, WIDTH / 2 + (int)lround(0.2 * camera.scale), HEIGHT / 2)[1];
    check_between(bottom, 0, 0.4f * open);
    check_at_most(open, 1.3f);
    postproc_canvas_free(c);
    free(x);
    free(colour);
}

static const char folder[] = FRANA_BINARY_DIR "/tests/postproc";

/* A PNG that was written, as 0xrrggbb. */
static unsigned png_pixel(cairo_surface_t *s, int x, int y) {
    const unsigned char *row = cairo_image_surface_get_data(s) + y * cairo_image_surface_get_stride(s);
    uint32_t pixel;
    memcpy(&pixel, row + 4 * x, sizeof pixel);
    return pixel & 0xffffff;
}

static cairo_surface_t *png_read(const char *path, int width, int height) {
    cairo_surface_t *s = cairo_image_surface_create_from_png(path);
    assert_int_equal(cairo_surface_status(s), CAIRO_STATUS_SUCCESS);
    assert_int_equal(cairo_image_surface_get_width(s), width);
    assert_int_equal(cairo_image_surface_get_height(s), height);
    return s;
}

/* A file's first bytes; whether it has a text. */
static int begins_with(const char *path, const char *start) {
    char bytes[16] = "";
    FILE *f = fopen(path, "rb");
    assert_non_null(f);
    const size_t n = fread(bytes, 1, strlen(start), f);
    fclose(f);
    return n == strlen(start) && memcmp(bytes, start, n) == 0;
}

static int has_line(const char *path, const char *end) {
    char line[4096];
    int found = 0;
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    while (fgets(line, sizeof line, f)) found |= strstr(line, end) != NULL;
    fclose(f);
    return found;
}

/* Ink is where the text stands and nowhere else, in each alignment; in the SVG the text is text. */
static void text_leaves_ink(void **state) {
    (void)state;
    static const char text[] = "t/t0 = 0.17 < 1 & 2";
    for (int align = POSTPROC_LEFT; align <= POSTPROC_RIGHT; align++) {
        struct postproc_canvas *c = postproc_canvas_new(2 * WIDTH, 2 * HEIGHT);
        postproc_canvas_clear(c, 0xffffff, 0xffffff);
        struct postproc_figure *f = postproc_figure_new(c);
        const double wide = postproc_figure_text_width(f, 20, text);
        const double left = 200 - 0.5 * align * wide;
        check_between(wide, 150, 300);
        check_close(postproc_figure_text_width(f, 10, text), 0.5 * wide, 1e-9 * wide);
        postproc_figure_text(f, 200, 100, 20, 0x000000, (enum postproc_align)align, text);
        assert_int_equal(postproc_figure_write(f, folder, "text", 1), 0);
        cairo_surface_t *png = png_read(FRANA_BINARY_DIR "/tests/postproc/text.png", WIDTH, HEIGHT);
        long inside = 0, outside = 0;
        for (int j = 0; j < HEIGHT; j++)
            for (int i = 0; i < WIDTH; i++) {
                if ((png_pixel(png, i, j) & 255) > 188) continue;
                if (i >= left - 2 && i < left + wide + 2 && j >= 76 && j < 108)
                    inside++;
                else
                    outside++;
            }
        cairo_surface_destroy(png);
        if (left + wide < WIDTH) check_above(inside, 300);
        assert_int_equal(outside, 0);
        assert_true(has_line(FRANA_BINARY_DIR "/tests/postproc/text.svg", ">t/t0 = 0.17 &#60; 1 &#38; 2</text>"));
        assert_true(has_line(FRANA_BINARY_DIR "/tests/postproc/text.svg", "</svg>"));
        assert_true(begins_with(FRANA_BINARY_DIR "/tests/postproc/text.pdf", "%PDF-"));
    }
}

/* A bar's colours between its ends, by the map. */
static void bar_has_its_colours(void **state) {
    (void)state;
    struct postproc_canvas *c = postproc_canvas_new(2 * WIDTH, 2 * HEIGHT);
    postproc_canvas_clear(c, 0xffffff, 0xffffff);
    struct postproc_figure *f = postproc_figure_new(c);
    postproc_bar_draw(f, &(struct postproc_bar){.map = POSTPROC_VIRIDIS,
                                                .low = 0,
                                                .high = 1,
                                                .label = "",
                                                .x = 100,
                                                .width = 20,
                                                .y0 = 40,
                                                .y1 = 240,
                                                .text = 10});
    assert_int_equal(postproc_figure_write(f, folder, "bar", 0), 0);
    cairo_surface_t *png = png_read(FRANA_BINARY_DIR "/tests/postproc/bar.png", WIDTH, HEIGHT);
    for (int j = 45; j < 236; j += 10) {
        double srgb[3];
        const unsigned seen = png_pixel(png, 110, j);
        postproc_colour_map(POSTPROC_VIRIDIS, (240 - j - 0.5) / 200, srgb);
        for (int k = 0; k < 3; k++) check_close((double)(seen >> (16 - 8 * k) & 255), 255 * srgb[k], 3);
    }
    cairo_surface_destroy(png);
}

/* A whole picture, read back. */
static void picture_is_written(void **state) {
    (void)state;
    static const char path[] = FRANA_BINARY_DIR "/tests/postproc/picture.png";
    const double x[2][3] = {{0.05, 0.05, 0.05}, {0.15, 0.05, 0.05}}, value[2] = {0, 1};
    const struct postproc_picture p = {.folder = folder,
                                       .name = "picture",
                                       .all = 1,
                                       .title = "Two cubes",
                                       .subtitle = "damage 0 and 1",
                                       .label = "damage",
                                       .n = 2,
                                       .x = x,
                                       .value = value,
                                       .value_high = 1,
                                       .map = POSTPROC_MAGMA_REVERSED,
                                       .size = 0.04,
                                       .domain = {0.2, 0.1, 0.1},
                                       .toward = {0, 0, 1},
                                       .low = {0, 0, 0},
                                       .high = {0.2, 0.1, 0.1},
                                       .width = 700,
                                       .height = 450};
    assert_int_equal(postproc_picture_draw(&p), 0);
    cairo_surface_t *png = png_read(path, 700, 450);
    /* seen along z, x = 0.05 and 0.15 are at a quarter and three quarters of the window */
    const double window[2] = {0.04 * 700, 0.86 * 700};
    const int row = (int)(0.5 * (0.13 + 0.86) * 450), left = (int)(0.75 * window[0] + 0.25 * window[1]),
              right = (int)(0.25 * window[0] + 0.75 * window[1]);
    const unsigned light = png_pixel(png, left, row), dark = png_pixel(png, right, row);
    check_above(light >> 16, 180);
    check_above(light >> 8 & 255, 180);
    check_above(light & 255, 160);
    /* black under the sheen alone: at most 0.036 in linear light, 0.21 in sRGB */
    check_below(dark >> 16, 54);
    check_below(dark >> 8 & 255, 54);
    check_below(dark & 255, 58);
    cairo_surface_destroy(png);
    assert_true(has_line(FRANA_BINARY_DIR "/tests/postproc/picture.svg", ">Two cubes</text>"));
    assert_true(begins_with(FRANA_BINARY_DIR "/tests/postproc/picture.pdf", "%PDF-"));
    const struct postproc_picture nowhere = {.folder = "/nowhere",
                                             .name = "x",
                                             .title = "",
                                             .subtitle = "",
                                             .label = "",
                                             .x = x,
                                             .value = value,
                                             .value_high = 1,
                                             .size = 1,
                                             .domain = {1, 1, 1},
                                             .toward = {0, 0, 1},
                                             .width = 64,
                                             .height = 64};
    assert_int_equal(postproc_picture_draw(&nowhere), -1);
}

/* A plane across z, half of it left out: as many pixels as its cells cover; nearer things hide it. */
static void plane_is_painted(void **state) {
    (void)state;
    const double toward[3] = {0.3, 0.4, 1.2}, window[4] = {0, 0, WIDTH, HEIGHT}, value[4] = {0, NAN, 1, NAN};
    const struct postproc_camera camera = postproc_camera_new(toward, low, high, window);
    const struct postproc_plane plane = {.axis = 2, .place = 0.2, .n = {2, 2}, .d = {0.3, 0.2}, .value = value};
    struct postproc_canvas *c = postproc_canvas_new(WIDTH, HEIGHT);
    const long painted = postproc_render_plane(c, &camera, &plane, POSTPROC_VIRIDIS, 0, 1);
    const double area = 0.3 * 0.4 * camera.toward[2] * camera.scale * camera.scale;
    check_close(painted, area, 2 * 0.7 * camera.scale); /* its rim, to a pixel */
    const double middle[2][3] = {{0.15, 0.1, 0.2}, {0.15, 0.3, 0.2}}, empty[3] = {0.45, 0.1, 0.2};
    double p[3], srgb[3];
    for (int k = 0; k < 2; k++) {
        postproc_camera_see(&camera, middle[k], p);
        postproc_colour_map(POSTPROC_VIRIDIS, k, srgb);
        check_close(pixel(c, (int)p[0], (int)p[1])[0], postproc_colour_linear(srgb[0]), 1e-6);
        check_close(c->depth[(int)p[1] * WIDTH + (int)p[0]], p[2], 0.01);
    }
    postproc_camera_see(&camera, empty, p);
    assert_true(isinf(c->depth[(int)p[1] * WIDTH + (int)p[0]]));
    const struct postproc_plane behind = {.axis = 2, .place = 0.1, .n = {2, 2}, .d = {0.3, 0.2}, .value = value};
    check_below(postproc_render_plane(c, &camera, &behind, POSTPROC_VIRIDIS, 0, 1), painted);
    const struct postproc_camera aside = postproc_camera_new((double[3]){1, 0, 0}, low, high, window);
    assert_int_equal(postproc_render_plane(c, &aside, &plane, POSTPROC_VIRIDIS, 0, 1), 0);
    postproc_canvas_free(c);
}

/* A rod is 2 r wide and lit in its middle; laid over something nearer it shines through by the share asked for. */
static void tube_shines_through(void **state) {
    (void)state;
    struct postproc_canvas *c = postproc_canvas_new(WIDTH, HEIGHT), *over = postproc_canvas_new(WIDTH, HEIGHT);
    const double a[3] = {50, 100, 1}, b[3] = {250, 100, 1}, white[3] = {1, 1, 1};
    postproc_render_tube(over, a, b, 10, 1e-3, white);
    long covered = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) covered += over->depth[i] > 0;
    check_close(covered, 200 * 20 + M_PI * 100, 60);
    check_above(pixel(over, 150, 100)[0], 0.98f);
    check_below(pixel(over, 150, 91)[0], 0.8f);
    for (int i = 0; i < WIDTH * HEIGHT; i++) c->depth[i] = i % WIDTH < 150 ? 2 : 0; /* black; nearer on the left */
    postproc_canvas_overlay(c, over, 0.25);
    check_close(pixel(c, 100, 100)[0], 0.25 * (double)pixel(over, 100, 100)[0], 1e-6);
    check_close(pixel(c, 200, 100)[0], pixel(over, 200, 100)[0], 0);
    check_close(pixel(c, 200, 150)[0], 0, 0);
    check_equal(c->depth[100 * WIDTH + 100], 2);
    check_above(c->depth[100 * WIDTH + 200], 1);
    postproc_canvas_free(c);
    postproc_canvas_free(over);
}

/* Round numbers: of a bar's ticks, of a scale bar, of an axis's power of ten. */
static void round_numbers(void **state) {
    (void)state;
    const struct postproc_bar bar = {.low = -0.03, .high = 0.82, .y0 = 100, .y1 = 270};
    const struct postproc_bar_ticks ticks = postproc_bar_scale(&bar);
    assert_int_equal(ticks.n, 5);
    for (int i = 0; i < 5; i++) {
        check_close(ticks.value[i], 0.2 * i, 1e-12);
        check_close(ticks.y[i], 270 - (0.2 * i + 0.03) * 200, 1e-9);
    }
    assert_int_equal(postproc_bar_scale(&(struct postproc_bar){.low = 1, .high = 1}).n, 0);
    check_close(postproc_legend_round(4.99), 2, 1e-12);
    check_close(postproc_legend_round(5), 5, 1e-12);
    check_close(postproc_legend_round(0.00999), 0.005, 1e-12);
    static const struct {
        double metres;
        const char *text;
    } length[] = {{2000, "2 km"}, {1, "1 m"}, {0.05, "50 mm"}, {2e-5, "20 µm"}, {1e-6, "1 µm"}, {5e-9, "5 nm"}};
    for (size_t k = 0; k < sizeof length / sizeof *length; k++) {
        char text[32];
        postproc_legend_length(length[k].metres, text);
        assert_string_equal(text, length[k].text);
    }
    static const struct {
        double most;
        int power;
    } power[] = {{0, 0}, {1, 0}, {9999, 0}, {0.05, 0}, {1e5, 3}, {-3e6, 6}, {1e-3, -3}, {9.9e-4, -6}, {3.9e-6, -6}};
    for (size_t k = 0; k < sizeof power / sizeof *power; k++)
        assert_int_equal(postproc_gnuplot_power(power[k].most), power[k].power);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(silhouette),           cmocka_unit_test(front_hides_back),
        cmocka_unit_test(inner_faces_left_out), cmocka_unit_test(strays_left_out),
        cmocka_unit_test(ray_meets_cells),      cmocka_unit_test(shade_in_a_shaft),
        cmocka_unit_test(bar_has_its_colours),  cmocka_unit_test(text_leaves_ink),
        cmocka_unit_test(picture_is_written),   cmocka_unit_test(plane_is_painted),
        cmocka_unit_test(tube_shines_through),  cmocka_unit_test(round_numbers),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
