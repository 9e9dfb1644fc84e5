/* Every line of the table of shapes: places against bounds, volumes, and pieces of the surface against places. */
#include "base/par.h"
#include "solid/geometry/shape.h"
#include "tests/check.h"
#include "tests/solid/shape_depth.h"

#include <stdlib.h>

static const double low[3] = {0.1, -0.7, 0.4}, high[3] = {0.9, 0.5, 1.3};

/* One body of each kind; a kind that is not named here has no size and fails the tests below. */
static struct solid_body body_of(int shape) {
    struct solid_body body = {.shape = (enum solid_shape)shape};
    memcpy(body.low, low, sizeof low);
    memcpy(body.high, high, sizeof high);
    for (int c = 0; c < 3; c++) {
        body.centre[c] = 0.2 - 0.3 * c;
        body.radii[c] = 0.9 - 0.25 * c;
    }
    body.radius = 0.8;
    body.axis = 1;
    body.length = 1.1;
    return body;
}

static double volume_of(const struct solid_body *body) {
    switch (body->shape) {
    case SOLID_BOX:
    case SOLID_IMAGE:
        return 0.8 * 1.2 * 0.9;
    case SOLID_SPHERE:
        return 4 * M_PI / 3 * 0.8 * 0.8 * 0.8;
    case SOLID_CYLINDER:
        return M_PI * 0.8 * 0.8 * 1.1;
    case SOLID_ELLIPSOID:
        return 4 * M_PI / 3 * 0.9 * 0.65 * 0.4;
    case SOLID_SPHERES: /* in tests/solid/geometry/test_compound.c, as it has no pieces of its own */
    case SOLID_POINTS:
    case SOLID_POLYGON:
    case SOLID_RECTANGLE:
    case SOLID_DISC:
        break;
    }
    return NAN;
}

static double uniform(double from, double to) { return from + (to - from) * rand() / RAND_MAX; }

/* Names differ; shapes on the lattice have bounds, and pieces or entries; the others none that is needed. */
static void table(void **state) {
    (void)state;
    int on_lattice = 0;
    for (int i = 0; i < SOLID_SHAPES; i++) {
        const struct solid_body body = body_of(i);
        const struct solid_shape_kind *kind = solid_shape_of(&body);
        assert_non_null(kind->name);
        for (int j = 0; j < i; j++) {
            const struct solid_body other = body_of(j);
            assert_string_not_equal(kind->name, solid_shape_of(&other)->name);
        }
        check_equal(solid_shape_is_on_lattice(&body), kind->places == SOLID_PLACES_LATTICE);
        if (kind->places != SOLID_PLACES_LATTICE) continue;
        assert_non_null(kind->bounds);
        assert_true((kind->pieces == NULL) == (kind->entry != NULL)); /* one shape, or a list of them */
        on_lattice++;
    }
    check_equal(on_lattice, SOLID_SHAPES - 2);
}

/* Nothing beyond the bounds is in the shape, but something within a hundredth of each of them; the places of a fine
 * lattice make up the volume. */
static void bounds_and_volume(void **state) {
    (void)state;
    enum { N = 64 };
    for (int i = 0; i < SOLID_SHAPES; i++) {
        const struct solid_body body = body_of(i);
        const struct solid_shape_kind *kind = solid_shape_of(&body);
        if (!kind->pieces) continue;
        const struct solid_shape_surface surface = solid_shape_surface(&body);
        double from[3], to[3], least[3] = {9, 9, 9}, most[3] = {-9, -9, -9};
        long inside = 0;
        kind->bounds(&body, from, to);
        const double step[3] = {(to[0] - from[0]) / N, (to[1] - from[1]) / N, (to[2] - from[2]) / N};
        for (int k = -4; k < N + 4; k++)
            for (int j = -4; j < N + 4; j++)
                for (int h = -4; h < N + 4; h++) {
                    const double x[3] = {from[0] + (h + 0.5) * step[0], from[1] + (j + 0.5) * step[1],
                                         from[2] + (k + 0.5) * step[2]};
                    if (shape_depth(&surface, x, 1e-2) < 0) continue;
                    inside++;
                    for (int c = 0; c < 3; c++) {
                        least[c] = fmin(least[c], x[c]);
                        most[c] = fmax(most[c], x[c]);
                    }
                }
        for (int c = 0; c < 3; c++) {
            check_between(least[c], from[c], from[c] + 1.1 * step[c]);
            check_between(most[c], to[c] - 1.1 * step[c], to[c]);
        }
        check_relative((double)inside * step[0] * step[1] * step[2], volume_of(&body), 5e-3);
    }
}

/* A place is in the shape where it is below all pieces. The normal is the direction in which the depth falls, by one a
 * metre. The depth below all pieces is the least of theirs near the surface, and has its sign elsewhere. */
static void pieces_bound_the_shape(void **state) {
    (void)state;
    srand(6);
    for (int i = 0; i < SOLID_SHAPES; i++) {
        const struct solid_body body = body_of(i);
        const struct solid_shape_kind *kind = solid_shape_of(&body);
        if (!kind->pieces) continue;
        struct solid_piece piece[SOLID_PIECES_MAX];
        const int n = kind->pieces(&body, piece);
        const struct solid_shape_surface surface = solid_shape_surface(&body);
        check_between(n, 0, SOLID_PIECES_MAX + 1);
        double from[3], to[3];
        int inside = 0;
        kind->bounds(&body, from, to);
        for (int trial = 0; trial < 2000; trial++) {
            double x[3], least = INFINITY;
            for (int c = 0; c < 3; c++) x[c] = uniform(1.2 * from[c] - 0.2 * to[c], 1.2 * to[c] - 0.2 * from[c]);
            for (int p = 0; p < n; p++) {
                double normal[3], other[3], falls[3], length = 0;
                const double depth = piece[p].depth(&piece[p], x, normal);
                least = fmin(least, depth);
                for (int c = 0; c < 3; c++) {
                    const double at = x[c], step = 1e-6;
                    x[c] = at + step;
                    const double up = piece[p].depth(&piece[p], x, other);
                    x[c] = at - step;
                    falls[c] = -(up - piece[p].depth(&piece[p], x, other)) / (2 * step);
                    x[c] = at;
                    length += normal[c] * normal[c];
                }
                check_close(length, 1, 1e-12);
                if (fabs(depth) > 0.1) continue; /* deeper there are edges in the depth, on the middle planes */
                for (int c = 0; c < 3; c++) check_close(falls[c], normal[c], 1e-6);
            }
            const double depth = shape_depth(&surface, x, 1e-2), all = shape_depth(&surface, x, 1e9);
            check_equal(all, least);
            check_equal(depth > 0, least > 0);
            check_between(fabs(depth), -1, fabs(least) * (1 + 1e-12));
            inside += least > 0;
        }
        check_between(inside, 200, 1900);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(table), cmocka_unit_test(bounds_and_volume),
                                       cmocka_unit_test(pieces_bound_the_shape)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
