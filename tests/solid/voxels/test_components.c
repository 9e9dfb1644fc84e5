/* Connected pieces of random images against a search voxel by voxel: sizes, faces, periodic ends, boxes, loose pieces.
 */
#include "base/memory.h"
#include "base/par.h"
#include "solid/voxels/components.h"
#include "tests/check.h"

#include <stdlib.h>

struct reference {
    int *piece; /* [voxels] -1: another phase */
    long pieces, largest, through[3], floating_pieces, floating_voxels, floating_largest;
    uint8_t *loose; /* [voxels] */
};

static long at_of(const int n[3], const int p[3]) { return ((long)p[2] * n[1] + p[1]) * n[0] + p[0]; }

static struct solid_voxels *random_voxels(const int n[3], int percent) {
    struct solid_voxels *v = solid_voxels_new(n, NULL, (const int[3]){0, 0, 0});
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++)
                if (rand() % 100 < percent) solid_voxels_set(v, v->bits, i, j, k);
    return v;
}

/* Fills one piece from a voxel with a stack of voxels. */
static long fill(const struct solid_voxels *v, int phase, const int wraps[3], struct reference *r, long start, int name,
                 long *stack) {
    long top = 0, size = 0;
    stack[top++] = start;
    r->piece[start] = name;
    while (top > 0) {
        const long at = stack[--top];
        const int p[3] = {(int)(at % v->n[0]), (int)(at / v->n[0] % v->n[1]), (int)(at / v->n[0] / v->n[1])};
        size++;
        for (int d = 0; d < 3; d++)
            for (int s = -1; s <= 1; s += 2) {
                int q[3] = {p[0], p[1], p[2]};
                q[d] += s;
                if (wraps[d]) q[d] = (q[d] + v->n[d]) % v->n[d];
                if (q[d] < 0 || q[d] >= v->n[d] || solid_voxels_is(v, v->bits, q[0], q[1], q[2]) != phase) continue;
                const long to = at_of(v->n, q);
                if (r->piece[to] >= 0) continue;
                r->piece[to] = name;
                stack[top++] = to;
            }
    }
    return size;
}

static struct reference reference_of(const struct solid_voxels *v, int phase, const int wraps[3], int boxes,
                                     const int (*box)[2][3]) {
    const long all = (long)v->n[0] * v->n[1] * v->n[2];
    struct reference r = {.piece = malloc((size_t)all * sizeof(int)), .loose = calloc((size_t)all, 1)};
    long *stack = malloc((size_t)all * sizeof *stack), *size = malloc((size_t)all * sizeof *size), largest = -1;
    memset(r.piece, 0xff, (size_t)all * sizeof(int));
    for (long at = 0; at < all; at++) {
        const int p[3] = {(int)(at % v->n[0]), (int)(at / v->n[0] % v->n[1]), (int)(at / v->n[0] / v->n[1])};
        if (r.piece[at] >= 0 || solid_voxels_is(v, v->bits, p[0], p[1], p[2]) != phase) continue;
        size[r.pieces] = fill(v, phase, wraps, &r, at, (int)r.pieces, stack);
        if (largest < 0 || size[r.pieces] > size[largest]) largest = r.pieces;
        r.pieces++;
    }
    for (long name = 0; name < r.pieces; name++) {
        int low[3] = {0}, high[3] = {0}, boxed = 0;
        for (long at = 0; at < all; at++) {
            const int p[3] = {(int)(at % v->n[0]), (int)(at / v->n[0] % v->n[1]), (int)(at / v->n[0] / v->n[1])};
            if (r.piece[at] != name) continue;
            for (int d = 0; d < 3; d++) {
                low[d] |= p[d] == 0;
                high[d] |= p[d] == v->n[d] - 1;
            }
            for (int b = 0; b < boxes; b++) {
                int d = 0;
                while (d < 3 && p[d] >= box[b][0][d] && p[d] < box[b][1][d]) d++;
                boxed |= d == 3;
            }
        }
        for (int d = 0; d < 3; d++) r.through[d] += low[d] && high[d] ? size[name] : 0;
        if (name == largest || boxed) continue;
        r.floating_pieces++;
        r.floating_voxels += size[name];
        if (size[name] > r.floating_largest) r.floating_largest = size[name];
        for (long at = 0; at < all; at++) r.loose[at] |= r.piece[at] == name;
    }
    r.largest = largest < 0 ? 0 : size[largest];
    free(stack);
    free(size);
    return r;
}

static void compare(const int n[3], int percent, int phase, const int wraps[3], int boxes, const int (*box)[2][3]) {
    struct solid_voxels *v = random_voxels(n, percent);
    struct reference r = reference_of(v, phase, wraps, boxes, box);
    struct solid_components *c = solid_components_new(v, phase, wraps, boxes, box);
    uint64_t *loose = solid_voxels_array(v);
    const long all = (long)n[0] * n[1] * n[2], solid = solid_voxels_count(v, v->bits);
    check_equal(c->voxels, phase ? solid : all - solid);
    check_equal(c->pieces, r.pieces);
    check_equal(c->largest, r.largest);
    for (int d = 0; d < 3; d++) check_equal(c->through[d], r.through[d]);
    check_equal(c->floating_pieces, r.floating_pieces);
    check_equal(c->floating_voxels, r.floating_voxels);
    check_equal(c->floating_largest, r.floating_largest);
    solid_components_floating(c, v, loose);
    check_equal(solid_voxels_count(v, loose), r.floating_voxels);
    for (long at = 0; at < all; at++)
        check_equal(solid_voxels_is(v, loose, (int)(at % n[0]), (int)(at / n[0] % n[1]), (int)(at / n[0] / n[1])),
                    r.loose[at]);
    memory_free(loose);
    solid_components_free(c);
    solid_voxels_free(v);
    free(r.piece);
    free(r.loose);
}

/* Lines of less than a word, a word and more; near the threshold at which pieces become one. */
static void random_images(void **state) {
    (void)state;
    static const int size[][3] = {{9, 8, 7}, {64, 5, 6}, {65, 6, 4}, {130, 3, 5},
                                  {1, 9, 9}, {9, 1, 9},  {9, 9, 1},  {1, 1, 1}};
    static const int box[2][2][3] = {{{0, 0, 0}, {2, 3, 2}}, {{5, 1, 2}, {9, 2, 3}}};
    srand(7);
    for (size_t s = 0; s < sizeof size / sizeof *size; s++)
        for (int percent = 20; percent <= 80; percent += 12)
            for (int w = 0; w < 8; w++) {
                const int wraps[3] = {w & 1, w >> 1 & 1, w >> 2};
                compare(size[s], percent, w % 2, wraps, w % 3, box);
            }
}

/* A comb: pieces that meet only at the far end of the sweep. */
static void comb(void **state) {
    (void)state;
    const int n[3] = {67, 4, 9}, none[3] = {0};
    struct solid_voxels *v = solid_voxels_new(n, NULL, none);
    for (int k = 0; k < n[2]; k++)
        for (int i = 0; i < n[0]; i++)
            if (i % 2 == 0 || k == n[2] - 1) solid_voxels_set(v, v->bits, i, 2, k);
    struct solid_components *c = solid_components_new(v, 1, none, 0, NULL);
    check_equal(c->pieces, 1);
    check_equal(c->voxels, 34 * 9 + 33);
    check_equal(c->through[0], c->voxels);
    check_equal(c->through[1], 0);
    check_equal(c->labels, 34);
    solid_components_free(c);
    solid_voxels_free(v);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_images), cmocka_unit_test(comb)};
    par_begin(&argc, &argv);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
