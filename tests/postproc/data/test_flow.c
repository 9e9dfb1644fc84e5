/* Planes and streamlines of field files with known velocities: rigid rotation, uniform flow, shear between walls. */
#include "base/par.h"
#include "postproc/data/flow_lines.h"
#include "postproc/data/slice.h"
#include "tests/check.h"
#include "tests/postproc/make_run.h"

#include <math.h>

static const char base[] = FRANA_BINARY_DIR "/tests/postproc/flows";
static char folder[FOLDER_PATH];
enum { CELLS = 16 }; /* over the height; 32 along x, of 0.2 x 0.1 x 0.1 m */
static const double cell = 0.1 / CELLS;

enum flow { ROTATION, UNIFORM, SHEAR };

/* Walls are at y = 0 and 0.1, periodic sides in z; solid is where x > 0.15 m if there is one. */
static void velocity_of(enum flow flow, const double x[3], double u[3]) {
    u[0] = u[1] = u[2] = 0;
    switch (flow) {
    case ROTATION:
        u[0] = -5 * (x[1] - 0.05);
        u[1] = 5 * (x[0] - 0.1);
        break;
    case UNIFORM:
        u[0] = 0.4;
        u[2] = 0.3;
        break;
    case SHEAR:
        u[0] = 8 * x[1] * (1 - x[1] / 0.1);
        break;
    }
}

static double pressure_of(const double x[3]) { return 3 * x[0] - 2 * x[1] + 7 * x[2]; }

static struct postproc_history *history_of(enum flow flow, int solid) {
    char error[512], path[FOLDER_PATH];
    make_run(&(struct make_run){.folder = folder_path(folder, base, solid ? "solid" : "fluid"),
                                .cells = CELLS,
                                .stop = 100,
                                .no_fields = 1,
                                .no_solid = !solid});
    const int n[3] = {2 * CELLS, CELLS, CELLS};
    const size_t all = (size_t)n[0] * (size_t)n[1] * (size_t)n[2];
    double(*u)[3] = memory_new(MEMORY_OUTPUT, all, sizeof *u), *p = memory_new(MEMORY_OUTPUT, all, sizeof *p);
    double *fraction = memory_new(MEMORY_OUTPUT, all, sizeof *fraction);
    for (size_t at = 0; at < all; at++) {
        const size_t row = (size_t)n[0], plane = row * (size_t)n[1];
        const double x[3] = {((double)(at % row) + 0.5) * cell, ((double)(at / row % (size_t)n[1]) + 0.5) * cell,
                             ((double)(at / plane) + 0.5) * cell};
        velocity_of(flow, x, u[at]);
        p[at] = pressure_of(x);
        fraction[at] = x[0] > 0.15;
    }
    struct vtkhdf *f =
        vtkhdf_image_begin(&(struct vtkhdf_image_input){.path = folder_path(path, folder, "fields/fluid_00000100.hdf"),
                                                        .time = 1,
                                                        .step = 100,
                                                        .n = {n[0], n[1], n[2]},
                                                        .origin = {0.5 * cell, 0.5 * cell, 0.5 * cell},
                                                        .spacing = {cell, cell, cell},
                                                        .m = {n[0], n[1], n[2]},
                                                        .wide = 1});
    vtkhdf_add(f, "velocity", 3, &u[0][0]);
    vtkhdf_add(f, "pressure", 1, p);
    if (solid) vtkhdf_add(f, "solid_fraction", 1, fraction);
    vtkhdf_end(f);
    vtkhdf_series_add(folder_path(path, folder, "fields/fluid.hdf.series"), "fluid_00000100.hdf", 1);
    memory_free(u);
    memory_free(p);
    memory_free(fraction);
    struct postproc_history *h = postproc_history_new(folder, error, sizeof error);
    assert_non_null(h);
    return h;
}

/* Every value of the three planes is the field's at that cell, bit for bit; NaN in the solid. */
static void slices_are_the_field(void **state) {
    (void)state;
    for (int solid = 0; solid < 2; solid++) {
        struct postproc_history *h = history_of(ROTATION, solid);
        for (int axis = 0; axis < 3; axis++) {
            struct postproc_slice *s = postproc_slice_new(h, 0, axis, axis == 1 ? 0.03 : NAN);
            assert_non_null(s);
            check_equal(s->index, axis == 1 ? 4 : axis == 0 ? 15 : 7);
            check_close(s->place, (s->index + 0.5) * cell, 1e-15);
            long masked = 0;
            for (int j = 0; j < s->n[1]; j++)
                for (int i = 0; i < s->n[0]; i++) {
                    const size_t at = (size_t)j * (size_t)s->n[0] + (size_t)i;
                    double x[3], u[3];
                    x[axis] = s->place;
                    x[s->across[0]] = (i + 0.5) * cell;
                    x[s->across[1]] = (j + 0.5) * cell;
                    velocity_of(ROTATION, x, u);
                    for (int c = 0; c < 2; c++) check_close(s->u[at][c], u[s->across[c]], 1e-15);
                    if (solid && x[0] > 0.15) {
                        masked++;
                        assert_true(s->solid[at] && isnan(s->speed[at]) && isnan(s->pressure[at]));
                        assert_true(isnan(s->vorticity[at]));
                        continue;
                    }
                    check_equal(s->solid[at], 0);
                    check_close(s->speed[at], hypot(u[0], u[1]), 1e-14);
                    check_close(s->pressure[at], pressure_of(x), 1e-14);
                    /* of a rigid rotation, twice its rate; the sides in x are open, those in y are walls at rest */
                    const int wall = x[1] < cell || x[1] > 0.1 - cell;
                    if (!wall) check_close(s->vorticity[at], 10, 1e-11);
                }
            check_equal(masked, solid && axis > 0 ? 8 * CELLS : 0);
            postproc_slice_free(s);
        }
        postproc_history_free(h);
    }
}

/* Central differences of a parabola are exact; beside a wall the velocity beyond it is mirrored. */
static void vorticity_at_walls(void **state) {
    (void)state;
    struct postproc_history *h = history_of(SHEAR, 0);
    struct postproc_slice *s = postproc_slice_new(h, 0, 2, NAN);
    for (int j = 0; j < CELLS; j++) {
        const double y = (j + 0.5) * cell;
        const double inner = fabs(8 * (1 - 20 * y)), first = 8 * 0.5 * cell * (1 - 5 * cell);
        const double next = 8 * 1.5 * cell * (1 - 15 * cell);
        const double wall = (next + first) / (2 * cell);
        check_close(s->vorticity[(size_t)j * 2 * CELLS + 3], j == 0 || j == CELLS - 1 ? wall : inner, 1e-11);
    }
    postproc_slice_free(s);
    postproc_history_free(h);
}

/* Lines in the plane of a rigid rotation are circles to 1e-6 of their radius, and in even spread. */
static void circles_in_a_plane(void **state) {
    (void)state;
    struct postproc_history *h = history_of(ROTATION, 0);
    struct postproc_slice *s = postproc_slice_new(h, 0, 2, NAN);
    struct postproc_stream lines = postproc_slice_lines(s, 20);
    check_above(lines.lines, 5);
    int whole = 0;
    for (int k = 0; k < lines.lines; k++) {
        double least = INFINITY, most = 0, length = 0;
        int inside = 1;
        for (long i = lines.first[k]; i < lines.first[k + 1]; i++) {
            const double r = hypot(lines.x[i][0] - 0.1, lines.x[i][1] - 0.05);
            inside = inside && lines.x[i][1] > cell && lines.x[i][1] < 0.1 - cell; /* where it is not mirrored */
            inside = inside && lines.x[i][0] > cell && lines.x[i][0] < 0.2 - cell;
            least = fmin(least, r);
            most = fmax(most, r);
            if (i > lines.first[k])
                length += hypot(lines.x[i][0] - lines.x[i - 1][0], lines.x[i][1] - lines.x[i - 1][1]);
            check_close(lines.speed[i], inside ? 5 * r : lines.speed[i], 1e-9);
        }
        if (!inside) continue;
        whole++;
        check_below(most - least, 1e-6 * most);
        check_below(length, 2 * M_PI * most * 1.5); /* about once round */
    }
    check_above(whole, 2);
    postproc_stream_free(&lines);
    postproc_slice_free(s);
    postproc_history_free(h);
}

/* Through space: straight lines across periodic sides to the outlet; with a solid in the way they end at it. */
static void lines_in_space(void **state) {
    (void)state;
    for (int solid = 0; solid < 2; solid++) {
        struct postproc_history *h = history_of(UNIFORM, solid);
        struct postproc_flow *f = postproc_flow_new(h, 0);
        assert_non_null(f);
        for (int c = 0; c < 2; c++) f->beyond[1][c] = POSTPROC_BEYOND_COPY; /* uniform up to the walls */
        check_close(f->mean[0], 0.4, 1e-7);
        check_close(f->mean[2], 0.3, 1e-7);
        check_close(f->fastest, 0.5, 1e-7);
        check_close(f->bound, 0.5, 1e-7);
        struct postproc_stream s = postproc_flow_lines_new(f, 25);
        check_equal(s.lines, 25);
        for (int k = 0; k < s.lines; k++) {
            const double *a = s.x[s.first[k]];
            for (long i = s.first[k]; i < s.first[k + 1]; i++) { /* velocity is kept as floats: 0.3 and 0.4 to 3e-8 */
                const double *b = s.x[i], along = b[0] - a[0];
                check_close(b[2] - a[2], 0.75 * along, 1e-6 * 0.2);
                check_close(b[1], a[1], 1e-12);
            }
            const double end = s.x[s.first[k + 1] - 1][0];
            if (solid) /* fraction one half is at the face between the cells */
                check_between(end, 0.15 - cell, 0.15);
            else
                check_between(end, 0.2 - cell, 0.2 + cell);
        }
        postproc_stream_free(&s);
        postproc_flow_free(f);
        postproc_history_free(h);
    }
}

/* A block of an image is that part of the whole. */
static void block_of_an_image(void **state) {
    (void)state;
    struct postproc_history *h = history_of(ROTATION, 1);
    struct vtkhdf_source *source = postproc_history_open(h, &h->fluid, 1);
    const int lo[3] = {3, 5, 2}, m[3] = {4, 2, 3};
    double *all = vtkhdf_read_double(source, "velocity"), *part = vtkhdf_read_block(source, "velocity", lo, m);
    for (int k = 0; k < m[2]; k++)
        for (int j = 0; j < m[1]; j++)
            for (int i = 0; i < m[0]; i++)
                for (int c = 0; c < 3; c++) {
                    const int whole = ((k + lo[2]) * CELLS + j + lo[1]) * 2 * CELLS + i + lo[0];
                    check_equal(part[3 * ((k * m[1] + j) * m[0] + i) + c], all[3 * whole + c]);
                }
    check_equal(vtkhdf_read_comps(source, "velocity"), 3);
    check_equal(vtkhdf_read_comps(source, "pressure"), 1);
    check_equal(vtkhdf_read_comps(source, "no such field"), 0);
    assert_null(vtkhdf_read_block(source, "no such field", lo, m));
    free(all);
    free(part);
    vtkhdf_read_close(source);
    postproc_history_free(h);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(slices_are_the_field), cmocka_unit_test(vorticity_at_walls),
                                       cmocka_unit_test(circles_in_a_plane), cmocka_unit_test(lines_in_space),
                                       cmocka_unit_test(block_of_an_image)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
