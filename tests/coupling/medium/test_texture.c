/* Porosity and surface of slices and sub-volumes against sums by hand. */
#include "coupling/medium/texture.h"
#include "base/par.h"
#include "tests/check.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <cmocka.h>

enum { NX = 24, NY = 16, NZ = 16, MOST = NX * NY * NZ };
static const double d = 0.02;

static struct fluid *box(void) {
    struct fluid_input in = {
        .n = {NX, NY, NZ}, .length = {NX * d, NY * d, NZ * d}, .density = 1, .viscosity = 1, .immersed = 1};
    return fluid_new(&in);
}

static uint64_t seed;
static double uniform(void) {
    seed = seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(seed >> 11) * 0x1p-53;
}

static struct {
    int n;
    double x[3][MOST], volume[MOST];
    int solid[NZ][NY][NX];
} all;

/* Random cells are solid, more of them at high x; every rank has all particles and deposits some. */
static void fill(struct medium *m) {
    static double x[3][MOST], volume[MOST];
    int n = 0;
    seed = 7, all.n = 0;
    for (int k = 0; k < NZ; k++)
        for (int j = 0; j < NY; j++)
            for (int i = 0; i < NX; i++) {
                all.solid[k][j][i] = uniform() < 0.1 + 0.5 * i / NX;
                if (!all.solid[k][j][i]) continue;
                const double at[3] = {(i + 0.5) * d, (j + 0.5) * d, (k + 0.5) * d};
                for (int c = 0; c < 3; c++) all.x[c][all.n] = at[c];
                all.volume[all.n++] = d * d * d;
            }
    for (int h = par_rank(); h < all.n; h += par_size(), n++) {
        for (int c = 0; c < 3; c++) x[c][n] = all.x[c][h];
        volume[n] = all.volume[h];
    }
    const double *const place[3] = {x[0], x[1], x[2]};
    medium_deposit(m, n, place, volume);
}

static double solid_in(const int low[3], const int high[3]) {
    double sum = 0;
    for (int k = low[2]; k < high[2]; k++)
        for (int j = low[1]; j < high[1]; j++)
            for (int i = low[0]; i < high[0]; i++) sum += all.solid[k][j][i];
    return sum / ((high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]));
}

static void slices(void **state) {
    (void)state;
    struct fluid *f = box();
    const double low[3] = {4 * d, 0, 2.5 * d}, high[3] = {20 * d, NY * d, 15 * d};
    struct medium *m = medium_new(fluid_grid_of(f), low, high);
    fill(m);
    const int first[3] = {4, 0, 2}, count[3] = {16, 16, 13};
    for (int c = 0; c < 3; c++) {
        double at[NX], porosity[NX], mean = 0, volume = 0;
        assert_int_equal(medium_texture_slices(m, c), count[c]);
        medium_texture_slice(m, c, at, porosity);
        for (int q = 0; q < count[c]; q++) {
            const double width = c == 2 && q == 0 ? 0.5 : 1;
            check_close(at[q], (first[c] + q + (width < 1 ? 0.75 : 0.5)) * d, 1e-14);
            mean += width * porosity[q], volume += width;
        }
        check_relative(mean / volume, medium_measure_porosity(m), 1e-12);
        if (c == 2) check_relative(porosity[3], 1 - solid_in((int[]){4, 0, 5}, (int[]){20, 16, 6}), 1e-12);
    }
    medium_free(m);
    fluid_free(f);
}

static void sub_volumes(void **state) {
    (void)state;
    struct fluid *f = box();
    const double low[3] = {0, 0, 0}, high[3] = {16 * d, NY * d, 8 * d};
    struct medium *m = medium_new(fluid_grid_of(f), low, high);
    struct medium_texture_size size[MEDIUM_TEXTURE_SIZES];
    fill(m);
    enum { POINTS = 300 };
    double x[3][POINTS], area[POINTS], inside = 0, front = 0;
    int n = 0;
    for (int h = 0; h < POINTS; h++) { /* the same on every rank, which gives its share */
        double at[3];
        for (int c = 0; c < 3; c++) at[c] = uniform() * (double[]){NX, NY, NZ}[c] * d;
        const double a = uniform() * 1e-4;
        if (at[0] <= high[0] && at[2] <= high[2]) inside += a;
        if (at[0] < 4 * d && at[1] < 4 * d && at[2] < 4 * d) front += a;
        if (h % par_size() != par_rank()) continue;
        for (int c = 0; c < 3; c++) x[c][n] = at[c];
        area[n++] = a;
    }
    const double *const place[3] = {x[0], x[1], x[2]};
    const int sizes = medium_texture_sizes(m, n, place, area, size);
    assert_int_equal(sizes, 3);
    const int parts[3][3] = {{4, 4, 2}, {2, 2, 2}, {1, 1, 1}};
    for (int q = 0; q < sizes; q++) {
        double mean = 0, square = 0, least = 1, most = 0;
        int number = 0;
        for (int c = 0; c < 3; c++) assert_int_equal(size[q].parts[c], parts[q][c]);
        const int wide[3] = {16 / parts[q][0], 16 / parts[q][1], 8 / parts[q][2]};
        for (int k = 0; k < 8; k += wide[2])
            for (int j = 0; j < 16; j += wide[1])
                for (int i = 0; i < 16; i += wide[0]) {
                    const double phi = 1 - solid_in((int[]){i, j, k}, (int[]){i + wide[0], j + wide[1], k + wide[2]});
                    mean += phi, square += phi * phi, number++;
                    least = fmin(least, phi), most = fmax(most, phi);
                }
        mean /= number;
        check_relative(size[q].porosity[0], mean, 1e-12);
        check_close(size[q].porosity[1], sqrt(fmax(0, square / number - mean * mean)), 1e-7);
        check_relative(size[q].porosity[2], least, 1e-12);
        check_relative(size[q].porosity[3], most, 1e-12);
        check_relative(size[q].specific_surface[0], inside / (16 * 16 * 8 * d * d * d), 1e-12);
        check_relative(size[q].edge, cbrt(wide[0] * wide[1] * wide[2]) * d, 1e-12);
    }
    check_at_least(front / (64 * d * d * d), size[0].specific_surface[2] * (1 - 1e-12));
    check_at_least(size[0].specific_surface[3] * (1 + 1e-12), front / (64 * d * d * d));
    const double phi = size[2].porosity[0], S = size[2].specific_surface[0];
    check_relative(size[2].carman[0], phi * phi * phi / (5 * S * S), 1e-12);
    medium_free(m);
    fluid_free(f);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(slices), cmocka_unit_test(sub_volumes)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
