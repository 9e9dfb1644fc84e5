/* A lattice's sweep against lists of bonds and against other numbers of ranks, on bodies of odd shapes. The sweep
 * begins with kernels that turn out to be the wrong ones: the body is at rest, then suddenly far beyond the limits of
 * its bonds or of the series. */
#include "tests/solid/make.h"
#include "solid/bonds/ghosts.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/segments.h"
#include "solid/force/force.h"
#include "solid/solid.h"
#include "base/threads.h"
#include "tests/check.h"
#include "tests/one_rank.h"

#include <stdio.h>

struct shape {
    const char *name;
    int sites[3], periodic[3];
    double horizon_ratio;
};

static const struct shape shapes[] = {
    {"particle", {1, 1, 1}, {0, 0, 0}, 3},
    {"line along x", {19, 1, 1}, {0, 0, 0}, 3},
    {"line along y", {1, 11, 1}, {0, 0, 0}, 3},
    {"line along z", {1, 1, 9}, {0, 0, 1}, 3},
    {"sheet among its images", {11, 4, 10}, {0, 1, 0}, 3},
    {"block of horizon 2", {13, 8, 7}, {0, 0, 1}, 2},
    {"block of horizon 3", {13, 8, 7}, {1, 0, 0}, 3},
    {"block of horizon 4", {13, 9, 9}, {0, 0, 0}, 4},
};
enum { SHAPES = sizeof shapes / sizeof shapes[0], SITES = 13 * 9 * 9, NUMBERS = 7 * SITES };

static struct solid *body(const struct shape *shape, int list, double fracture_energy) {
    struct solid_body block = {.name = "block", .shape = SOLID_BOX};
    const struct solid_material material = {YOUNG, DENSITY, fracture_energy, shape->horizon_ratio, PHYSICS_CONSTANT,
                                            0,     0};
    struct solid_input in = {.spacing = SPACING,
                             .bodies = 1,
                             .body = &block,
                             .materials = 1,
                             .material = &material,
                             .surface_correction = 1,
                             .general_bonds = list};
    for (int c = 0; c < 3; c++) {
        block.high[c] = in.length[c] = shape->sites[c] * SPACING;
        in.periodic[c] = shape->periodic[c];
    }
    return solid_new(&in);
}

/* By place in the lattice, on every rank: a, m/s2, which bonds are broken, the number of particles there. */
static void collect(const struct solid *s, const struct shape *shape, double *all) {
    static struct solid_family_view view;
    memset(all, 0, NUMBERS * sizeof *all);
    for (int h = 0; h < s->n; h++) {
        int at[3];
        for (int c = 0; c < 3; c++) at[c] = (int)floor(s->x0[c][h] / SPACING);
        double *here = all + 7 * ((at[2] * shape->sites[1] + at[1]) * shape->sites[0] + at[0]);
        for (int c = 0; c < 3; c++) here[c] = s->a[c][h];
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) {
            here[3] += view.intact[b] ? 0 : 1;
            here[4] += view.intact[b] ? 0 : b * b + 1;
        }
        here[6] = 1;
    }
    par_sum_array(all, NUMBERS);
}

/* The sweep has seen no large eps: it uses the series and tests no bond first. */
static void assert_unaware(const struct solid *s) {
    const struct solid_lattice *b = s->family->lattice[0];
    for (int g = 0; g < b->segments->n; g++) {
        check_equal(b->segments->high[g], 0);
        assert_int_equal(b->segments->large[g], 0);
    }
}

/* a and broken bonds after a jump of `size` spacings from rest, and of one more sweep there. */
static void jump(const struct shape *shape, int list, double fracture_energy, double size, double damping,
                 double *first, double *second) {
    struct solid *s = body(shape, list, fracture_energy);
    s->stage = (struct solid_stage){.breakage = 1, .damping_relative = damping};
    solid_ghosts_update(s);
    solid_force(s, 1);
    if (!list) assert_unaware(s);
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3; c++) {
            s->d[c][h] = size * SPACING * noise(s, h, c);
            s->v[c][h] = 0.1 * noise(s, h, c + 3);
        }
    solid_ghosts_begin(s);
    solid_force(s, 1);
    collect(s, shape, first);
    solid_force(s, 1);
    collect(s, shape, second);
    solid_free(s);
}

static double largest(const double *all) {
    double most = 0;
    for (int i = 0; i < SITES; i++)
        for (int c = 0; c < 3; c++) most = fmax(most, fabs(all[7 * i + c]));
    return most;
}

/* Bonds and particles to the bit; a to round-off of the forces that were taken back, of `scale` m/s2. */
static void compare(const double *all, const double *expected, double scale) {
    for (int i = 0; i < NUMBERS; i++) check_close(all[i], expected[i], i % 7 < 3 ? 1e-12 * scale : 0);
}

static void assert_balanced(const double *all, double scale) {
    for (int c = 0; c < 3; c++) {
        double sum = 0;
        for (int i = 0; i < SITES; i++) sum += all[7 * i + c];
        check_close(sum, 0, 1e-12 * sqrt(SITES) * scale);
    }
}

static void reference(const char *name, int kind, const double *all, double *expected) {
    char name_of_file[64];
    snprintf(name_of_file, sizeof name_of_file, "solid_test_sweep_%s_%d", name, kind);
    one_rank_expects(name_of_file, all, NUMBERS * sizeof *all, expected);
}

/* Bonds that break, within the series; bonds that break, far beyond it; bonds that do not break, far beyond it. */
static const struct {
    double fracture_energy, size, damping;
} kinds[] = {{0.05, 6e-4, 0}, {225, 0.04, 0}, {INFINITY, 0.02, 0}, {0.05, 6e-4, 1e13}, {225, 0.04, 1e13}};
enum { KINDS = sizeof kinds / sizeof kinds[0] };

static void test_jumps(void **state) {
    (void)state;
    static double all[NUMBERS], again[NUMBERS], list[NUMBERS], list_again[NUMBERS], expected[NUMBERS];
    for (int k = 0; k < SHAPES; k++)
        for (int kind = 0; kind < KINDS; kind++) {
            if (check_skips(KINDS * k + kind, threads_count() > 1 ? 4 : par_size() > 1 ? 3 : 1)) continue;
            const double energy = kinds[kind].fracture_energy, size = kinds[kind].size, damping = kinds[kind].damping;
            jump(&shapes[k], 0, INFINITY, size, damping, again, all); /* as if nothing broke */
            const double scale = largest(again) + 1e-300;
            jump(&shapes[k], 0, energy, size, damping, all, again);
            jump(&shapes[k], 1, energy, size, damping, list, list_again);
            double broken = 0, particles = 0;
            for (int i = 0; i < SITES; i++) broken += all[7 * i + 3], particles += all[7 * i + 6];
            assert_int_equal(particles, shapes[k].sites[0] * shapes[k].sites[1] * shapes[k].sites[2]);
            assert_true(particles == 1 || isinf(energy) ? broken == 0 : broken > particles / 4);
            compare(all, list, scale);
            compare(again, list_again, scale);
            compare(all, again, scale);
            assert_balanced(all, scale);
            reference(shapes[k].name, kind, all, expected);
            compare(all, expected, scale);
        }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_jumps)};
    int failed = 0;
    for (int threads = 1; threads <= (par_size() > 1 ? 1 : 3); threads += 2) {
        threads_set(threads);
        failed |= cmocka_run_group_tests(tests, NULL, NULL);
    }
    par_end();
    return failed;
}
