/* The cycle over blocks is symmetric and positive, and keeps the number of products small however wide the pores are.
 */
#include "base/memory.h"
#include "stokes/blocks.h"
#include "stokes/viscous.h"
#include "tests/stokes/make.h"

static double dot(const struct stokes *s, const float (*a)[3], const float (*b)[3]) {
    double sum = 0;
    for (int i = 0; i < s->cells->n; i++)
        for (int c = 0; c < 3; c++) sum += (double)a[i][c] * (double)b[i][c];
    return par_sum(sum);
}

static void fill(const struct stokes *s, float (*r)[3], unsigned seed) {
    for (int i = 0; i < s->cells->n; i++)
        for (int c = 0; c < 3; c++) {
            unsigned q = ((unsigned)(s->cells->first[par_rank()] + i) * 3 + (unsigned)c + seed) * 2654435761u;
            q = (q ^ q >> 15) * 2246822519u;
            r[i][c] = stokes_faces_is_open(s->faces, i, c) ? (float)((q ^ q >> 13) % 2001) / 1000 - 1 : 0;
        }
}

/* a.B b = b.B a, and a.B a > 0, to the round-off of floats. */
static void check_symmetric(const int n[3], double share, const struct stokes_input *in) {
    struct stokes *s = make_stokes(n, make_noise, &share, in);
    const size_t size = stokes_cells_size(s->cells);
    float(*v)[3] = memory_new(MEMORY_FLUID, 4 * size, sizeof *v);
    float(*a)[3] = v, (*b)[3] = v + size, (*of_a)[3] = v + 2 * size, (*of_b)[3] = v + 3 * size;
    struct stokes_blocks *blocks = stokes_blocks_new(s->cells, s->faces);
    fill(s, a, 1);
    fill(s, b, 7);
    stokes_blocks_cycle(blocks, (const float(*)[3])a, of_a);
    stokes_blocks_cycle(blocks, (const float(*)[3])b, of_b);
    const double scale = sqrt(dot(s, a, of_a) * dot(s, b, of_b));
    assert_true(dot(s, a, of_a) > 0 && dot(s, b, of_b) > 0);
    check_below(fabs(dot(s, a, of_b) - dot(s, b, of_a)), 1e-5 * scale);
    for (int i = 0; i < s->cells->n; i++)
        for (int c = 0; c < 3; c++)
            if (!stokes_faces_is_open(s->faces, i, c)) check_equal(of_a[i][c], 0);
    stokes_blocks_free(blocks);
    memory_free(v);
    stokes_free(s);
}

static void symmetric(void **state) {
    (void)state;
    const struct stokes_input free = {.tolerance = 1e-4},
                              held = {.side = {{STOKES_SIDE_WALL, STOKES_SIDE_SLIP},
                                               {0},
                                               {STOKES_SIDE_PRESSURE, STOKES_SIDE_PRESSURE}},
                                      .d = {1, 2, 0.5},
                                      .tolerance = 1e-4};
    const struct stokes_input flat = {.d = {1, 0.1, 4}, .tolerance = 1e-4};
    const int odd[3] = {13, 9, 17}, thin[3] = {2, 1, 30}, cube[3] = {16, 16, 16};
    check_symmetric(odd, 0.8, &free);
    check_symmetric(odd, 0.8, &held);
    check_symmetric(odd, 0.8, &flat);
    check_symmetric(thin, 0.9, &free);
    check_symmetric(cube, 0.7, &held);
}

/* A duct along z of so many cells across, in a box with a wall of one cell. */
static int is_duct(const int at[3], const void *width) {
    return at[0] < *(const int *)width && at[1] < *(const int *)width;
}

/* Products until the residual of A e = 1 is 1e-3, with eight layers a rank. Blocks do not cross ranks, so more of them
 * take more. */
static int products_of(int width, double long_edge) {
    const int n[3] = {width + 1, width + 1, 8 * par_size()};
    const struct stokes_input in = {.d = {1, long_edge, 1}, .tolerance = 1e-4};
    struct stokes *s = make_stokes(n, is_duct, &width, &in);
    struct stokes_viscous *v = s->viscous;
    for (int i = 0; i < s->cells->n; i++)
        for (int c = 0; c < 3; c++) v->r[i][c] = stokes_faces_is_open(s->faces, i, c);
    const long before = v->products;
    stokes_viscous_solve(v, 1e-3);
    const int products = (int)(v->products - before);
    stokes_free(s);
    return products;
}

static void few_products(void **state) {
    (void)state;
    for (int width = 8; width <= 64; width *= 2) check_at_most(products_of(width, 1), par_size() == 1 ? 8 : 16);
    for (int width = 8; width <= 32; width *= 2) check_at_most(products_of(width, 8), par_size() == 1 ? 9 : 20);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(symmetric), cmocka_unit_test(few_products)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
