/* STL: boxes, whose faces pass through centres of voxels, and a turned cube, against their definitions; text and
 * binary, axes, voids; surfaces that are open, overlap or are inside out. */
#include "tests/base/files/image.h"

#include <math.h>

static const char *folder;

enum { MOST = 64 };
struct surface {
    int n;
    double x[MOST][3][3];
};

static void add(struct surface *s, const double a[3], const double b[3], const double c[3], int inward) {
    const double *corner[3] = {a, inward ? c : b, inward ? b : c};
    for (int q = 0; q < 3; q++) memcpy(s->x[s->n][q], corner[q], sizeof s->x[0][0]);
    s->n++;
}

/* The 12 triangles of a box, turned about its low corner by the unit vectors u. */
static void add_box(struct surface *s, const double low[3], const double high[3], const double u[3][3], int inward) {
    double corner[8][3];
    for (int k = 0; k < 8; k++)
        for (int c = 0; c < 3; c++) {
            corner[k][c] = low[c];
            for (int a = 0; a < 3; a++) corner[k][c] += (k >> a & 1) * (high[a] - low[a]) * (u ? u[a][c] : a == c);
        }
    for (int a = 0; a < 3; a++)
        for (int side = 0; side < 2; side++) {
            const int b = 1 << (a + 1) % 3, c = 1 << (a + 2) % 3, from = side << a;
            add(s, corner[from], corner[from + b], corner[from + b + c], inward ^ !side);
            add(s, corner[from], corner[from + b + c], corner[from + c], inward ^ !side);
        }
}

static const char *binary(const char *name, const struct surface *s) {
    unsigned char bytes[84 + 50 * MOST] = "solid that is none: a title may say anything";
    memcpy(bytes + 80, &(uint32_t){(uint32_t)s->n}, 4);
    for (int t = 0; t < s->n; t++)
        for (int q = 0; q < 9; q++) {
            const float value = (float)s->x[t][q / 3][q % 3];
            memcpy(bytes + 84 + 50 * t + 12 + 4 * q, &value, 4);
        }
    const char *path = image_path(folder, name);
    image_write(path, "", 0, bytes, 84 + 50 * (size_t)s->n);
    return path;
}

static const char *text(const char *name, const struct surface *s) {
    const char *path = image_path(folder, name);
    FILE *file = fopen(path, "w");
    fprintf(file, "solid box\n");
    for (int t = 0; t < s->n; t++) {
        fprintf(file, "facet normal 0 0 0\n outer loop\n");
        for (int q = 0; q < 3; q++)
            fprintf(file, "  vertex %.9e %.9e %.9e\n", s->x[t][q][0], s->x[t][q][1], s->x[t][q][2]);
        fprintf(file, " endloop\nendfacet\n");
    }
    fprintf(file, "endsolid box\n");
    fclose(file);
    return path;
}

/* The voxels of a file with cubes of so large an edge. */
static int *voxels_of(const char *path, const double edge[3], const char *axes, long n[3]) {
    char problem[800];
    struct files_image_input input = {.file = path, .edge = {edge[0], edge[1], edge[2]}};
    snprintf(input.axes, sizeof input.axes, "%s", axes);
    struct files_image *image = image_opened(&input);
    check_equal(files_image_format_of(image), FILES_IMAGE_STL);
    memcpy(n, files_image_size(image), 3 * sizeof *n);
    int *value = calloc((size_t)(n[0] * n[1] * n[2]), sizeof *value);
    if (files_image_read(image, (long[3]){0}, n, value, problem, sizeof problem)) fail_msg("%s", problem);
    /* a part of it is the same */
    const long low[3] = {n[0] / 2, n[1] / 3, n[2] / 2}, across = n[0] - low[0], deep = n[1] - low[1];
    int *part = calloc((size_t)(across * deep * (n[2] - low[2])), sizeof *part);
    if (files_image_read(image, low, n, part, problem, sizeof problem)) fail_msg("%s", problem);
    for (long q = 0; q < across * deep * (n[2] - low[2]); q++)
        check_equal(
            part[q],
            value[((low[2] + q / across / deep) * n[1] + low[1] + q / across % deep) * n[0] + low[0] + q % across]);
    free(part);
    files_image_close(image);
    return value;
}

/* A box of 6 x 4 x 3 with a void from 1.5 to 4.5, 0.5 to 3.5, 1 to 2: its faces pass through centres. */
static int in_hollow(double x, double y, double z) {
    return !(x > 1.5 && x <= 4.5 && y > 0.5 && y <= 3.5 && z > 1 && z <= 2);
}

static void hollow_boxes(void **state) {
    (void)state;
    struct surface s = {0};
    add_box(&s, (const double[]){0, 0, 0}, (const double[]){6, 4, 3}, NULL, 0);
    add_box(&s, (const double[]){1.5, 0.5, 1}, (const double[]){4.5, 3.5, 2}, NULL, 1);
    const char *path[] = {binary("hollow.stl", &s), text("hollow_text.stl", &s)};
    for (int p = 0; p < 2; p++)
        for (int finer = 1; finer <= 3; finer++) {
            long n[3];
            const double edge[3] = {1.0 / finer, 1.0 / finer, 1.0};
            int *value = voxels_of(path[p], edge, "xyz", n);
            check_equal(n[0] * 100 + n[1] * 10 + n[2], 600 * finer + 40 * finer + 3);
            for (long q = 0; q < n[0] * n[1] * n[2]; q++)
                check_equal(value[q],
                            in_hollow(((double)(q % n[0]) + 0.5) / finer, ((double)(q / n[0] % n[1]) + 0.5) / finer,
                                      (double)(q / n[0] / n[1]) + 0.5));
            free(value);
        }
    long n[3];
    int *value = voxels_of(path[0], (const double[]){1, 1, 1}, "zyx", n); /* x of the file is z */
    check_equal(n[0] * 100 + n[1] * 10 + n[2], 346);
    for (long q = 0; q < n[0] * n[1] * n[2]; q++)
        check_equal(value[q], in_hollow((double)(q / n[0] / n[1]) + 0.5, (double)(q / n[0] % n[1]) + 0.5,
                                        (double)(q % n[0]) + 0.5));
    free(value);
}

/* A cube turned about (1, 1, 1), whose edges and corners lines of centres may meet. */
static void a_turned_cube(void **state) {
    (void)state;
    static const double u[3][3] = {
        {2.0 / 3, -1.0 / 3, 2.0 / 3}, {2.0 / 3, 2.0 / 3, -1.0 / 3}, {-1.0 / 3, 2.0 / 3, 2.0 / 3}};
    struct surface s = {0};
    long n[3], inside = 0;
    add_box(&s, (const double[]){1, 2, 3}, (const double[]){7, 8, 9}, u, 0);
    const char *path = binary("turned.stl", &s);
    double low[3] = {1, 2, 3};
    for (int t = 0; t < s.n; t++)
        for (int q = 0; q < 9; q++) low[q % 3] = fmin(low[q % 3], s.x[t][q / 3][q % 3]);
    int *value = voxels_of(path, (const double[]){0.25, 0.25, 0.25}, "xyz", n);
    for (long q = 0; q < n[0] * n[1] * n[2]; q++) {
        const double x[3] = {low[0] + 0.25 * ((double)(q % n[0]) + 0.5) - 1,
                             low[1] + 0.25 * ((double)(q / n[0] % n[1]) + 0.5) - 2,
                             low[2] + 0.25 * ((double)(q / n[0] / n[1]) + 0.5) - 3};
        double depth = 1e9;
        for (int a = 0; a < 3; a++) {
            const double d = x[0] * u[a][0] + x[1] * u[a][1] + x[2] * u[a][2];
            depth = fmin(depth, fmin(d, 6 - d));
        }
        if (fabs(depth) > 1e-5) check_equal(value[q], depth > 0); /* corners are floats */
        inside += value[q];
    }
    check_close((double)inside / 64, 216, 2);
    free(value);
}

static void odd_surfaces_are_refused(void **state) {
    (void)state;
    const double zero[3] = {0, 0, 0}, one[3] = {1, 1, 1}, half[3] = {0.5, 0.5, 0.5}, two[3] = {2, 2, 2};
    struct surface s = {0};
    add_box(&s, zero, two, NULL, 0);
    struct files_image_input input = {.file = binary("odd.stl", &s), .edge = {0.25, 0.25, 0.25}};
    const struct files_image_input unitless = {.file = input.file};
    check_refused(&unitless, "an STL has no unit: the key unit is needed, 1.0e-3 where it is in mm");
    const struct files_image_input coarse = {.file = input.file, .edge = {3, 3, 3}};
    check_refused(&coarse, "it is 2 x 2 x 2 in its unit, less than a voxel");
    s.n--;
    binary("odd.stl", &s);
    check_refused(&input,
                  "its surface is not closed: it has 3 open edges, that is such as are not shared by two triangles "
                  "of the same turn: repair it");
    s.n++;
    memcpy(s.x[0][0], s.x[0][1], sizeof s.x[0][0]); /* a triangle without an area */
    binary("odd.stl", &s);
    check_refused(&input,
                  "its surface is not closed: it has 3 open edges, that is such as are not shared by two triangles "
                  "of the same turn: repair it");
    s.n = 0;
    add_box(&s, zero, two, NULL, 0);
    add_box(&s, half, one, NULL, 0);
    binary("odd.stl", &s);
    check_refused(&input,
                  "parts of its surface overlap, or are inside out, near 0.3125, 0.3125, 0.3125 of its bounding "
                  "box: join them in the program that made it");
    s.n = 0;
    add_box(&s, zero, one, NULL, 0);
    binary("odd.stl", &s);
    s.n--;
    image_write(input.file, "solid x\nvertex 1 2 3\nvertex 1 2\n", 31, "", 0);
    check_refused(&input, "its vertex 2 has no three numbers");
    image_write(input.file, "solid x\nvertex 1 2 3\nvertex 1 2 nan\nvertex 0 0 0\n", 49, "", 0);
    check_refused(&input, "triangle 1 has a corner with a coordinate that is not finite");
    image_write(input.file, "solid x\nendsolid\n", 17, "", 0);
    check_refused(&input, "it has no triangles");
    const struct files_image_input raw = {.file = input.file,
                                          .format = FILES_IMAGE_RAW,
                                          .size = {17, 1, 1},
                                          .type = FILES_IMAGE_UINT8,
                                          .edge = {1, 1, 1}};
    check_refused(&raw, "a unit is given, and it is not an STL (raw)");
}

/* All triangles the other way round: as a whole it is not inside out. */
static void the_turn_does_not_matter(void **state) {
    (void)state;
    struct surface s = {0};
    long n[3], inside = 0;
    add_box(&s, (const double[]){0, 0, 0}, (const double[]){2, 2, 2}, NULL, 1);
    int *value = voxels_of(binary("inward.stl", &s), (const double[]){0.5, 0.5, 0.5}, "xyz", n);
    for (long q = 0; q < n[0] * n[1] * n[2]; q++) inside += value[q];
    check_equal(inside, 64);
    free(value);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("image_stl");
    const struct CMUnitTest tests[] = {cmocka_unit_test(hollow_boxes), cmocka_unit_test(a_turned_cube),
                                       cmocka_unit_test(odd_surfaces_are_refused),
                                       cmocka_unit_test(the_turn_does_not_matter)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
