/* Sites of an image: an image of a shape has the shape's numbers; refined voxels; one map for the ranks of a node. */
#include "base/memory.h"
#include "base/par.h"
#include "base/par_piece.h"
#include "solid/body/sites.h"
#include "solid/voxels/voxels.h"
#include "tests/check.h"
#include "tests/solid/contains.h"

enum { X = 70, Y = 30, Z = 28 };
static const double SPACING = 0.125; /* whole numbers of it are exact */
static const int corner[3] = {5, -5, 3};
static const struct solid_material material = {1e8, 3000, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};

static struct solid_input input(const struct solid_body *body) {
    return (struct solid_input){.spacing = SPACING, .bodies = 1, .body = body, .materials = 1, .material = &material};
}

/* Each rank sets voxels of some slices. */
static struct solid_voxels *image_of(int (*is_in)(int i, int j, int k), const int sites[3]) {
    struct solid_voxels *v = solid_voxels_new((int[]){X, Y, Z}, sites, corner);
    for (int k = par_piece_low(Z, par_size(), par_rank()); k < par_piece_low(Z, par_size(), par_rank() + 1); k++)
        for (int j = 0; j < Y; j++)
            for (int i = 0; i < X; i++)
                if (is_in(i, j, k)) solid_voxels_set(v, v->bits, i, j, k);
    par_shared_unite(v->shared_bits);
    return v;
}

static const struct solid_body ball = {.name = "ball",
                                       .shape = SOLID_ELLIPSOID,
                                       .centre = {40 * 0.125, 10 * 0.125, 17 * 0.125},
                                       .radii = {35 * 0.125, 15 * 0.125, 14 * 0.125}};
static int in_ball(int i, int j, int k) {
    return contains(
        &ball,
        (double[]){(corner[0] + i + 0.5) * SPACING, (corner[1] + j + 0.5) * SPACING, (corner[2] + k + 0.5) * SPACING},
        SPACING);
}
static int in_foam(int i, int j, int k) { return (unsigned)((k * Y + j) * X + i) * 2654435761u >> 31; }

/* As on nodes of so many ranks each, or of all. */
static void numbers_are_those_of_the_shape(void **state) {
    (void)state;
    const struct solid_input shaped = input(&ball);
    struct solid_sites *want = solid_sites_new(&shaped, &ball, 1000, 3);
    assert_null(want->map);
    for (int most = 0; most <= 2; most++) {
        par_shared_limit(most);
        struct solid_voxels *v = image_of(in_ball, NULL);
        const struct solid_body body = {.name = "image", .shape = SOLID_IMAGE, .voxels = v};
        const struct solid_input in = input(&body);
        const size_t before = memory_bytes(MEMORY_SOLID);
        struct solid_sites *t = solid_sites_new(&in, &body, 1000, 3);
        const long bytes = par_sum_long((long)(memory_bytes(MEMORY_SOLID) - before));
        check_equal(t->map->sharers, most == 1 ? 1 : v->shared_bits->sharers);
        check_equal(t->map->bytes, (size_t)t->bricks[0] * (size_t)t->bricks[1] * (size_t)t->bricks[2] * SOLID_BRICK);
        check_at_most(bytes, t->map->copies * (long)(t->map->bytes + t->numbers->bytes) + 1000L * par_size());
        check_equal(t->count, want->count);
        check_above(t->count, 10000);
        for (int c = 0; c < 3; c++) check_equal(t->base[c], want->base[c]);
        for (int k = -3; k < Z + 3; k++)
            for (int j = -3; j < Y + 3; j++)
                for (int i = -12; i < X + 12; i++) {
                    const int site[3] = {corner[0] + i, corner[1] + j, corner[2] + k};
                    check_equal(solid_sites_id(t, site), solid_sites_id(want, site));
                }
        solid_sites_free(t);
        check_equal(memory_bytes(MEMORY_SOLID), before);
        solid_voxels_free(v);
    }
    par_shared_limit(0);
    solid_sites_free(want);
}

/* Edges of a voxel that differ hold different numbers of sites. */
static void refined_voxels_of(const int m[3]) {
    struct solid_voxels *v = image_of(in_foam, m);
    const struct solid_body body = {.name = "foam", .shape = SOLID_IMAGE, .voxels = v};
    const struct solid_input in = input(&body);
    struct solid_sites *t = solid_sites_new(&in, &body, 0, 3);
    uint8_t *taken = memory_new(MEMORY_OUTPUT, (size_t)t->count, 1);
    long count = 0;
    for (int k = -2; k < m[2] * Z + 2; k++)
        for (int j = -2; j < m[1] * Y + 2; j++)
            for (int i = -10; i < m[0] * X + 10; i++) {
                const int site[3] = {corner[0] + i, corner[1] + j, corner[2] + k};
                const int is = i >= 0 && i < m[0] * X && j >= 0 && j < m[1] * Y && k >= 0 && k < m[2] * Z &&
                               in_foam(i / m[0], j / m[1], k / m[2]);
                const long id = solid_sites_id(t, site);
                check_equal(id >= 0, is);
                if (!is) continue;
                check_below(id, t->count);
                check_equal(taken[id]++, 0);
                count++;
            }
    check_equal(count, t->count);
    check_equal(count, m[0] * m[1] * m[2] * solid_voxels_count(v, v->bits));
    memory_free(taken);
    solid_sites_free(t);
    solid_voxels_free(v);
}

static void refined_voxels(void **state) {
    (void)state;
    refined_voxels_of((const int[]){2, 2, 2});
    refined_voxels_of((const int[]){1, 3, 2});
    refined_voxels_of((const int[]){5, 1, 1});
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(numbers_are_those_of_the_shape),
                                       cmocka_unit_test(refined_voxels)};
    par_begin(&argc, &argv);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
