/* Bond lists of a plate of unequal points: mirror symmetry to the bit, both ends, ranks, renewal. */
/* Lists of a plate: points of unequal size and horizon, mirror images to the bit, both ends of a bond, any number of
 * ranks, and a body that is refined. */
#include "base/par_ghost.h"
#include "tests/solid/make.h"

#include "base/memory.h"
#include "base/sort.h"
#include "solid/bonds/list.h"
#include "solid/body/number.h"
#include "solid/bonds/ghosts.h"
#include "solid/force/force.h"
#include "solid/solid.h"
#include "tests/check.h"
#include "tests/one_rank.h"

#include <stdio.h>
#include <stdlib.h>

enum { HALF_X = 13, HALF_Y = 11, POINTS = 4 * HALF_X * HALF_Y };

/* A rectangle of points mirror-symmetric in x and y: moved from a lattice by up to a fifth of the spacing, in steps of
 * 2^-8, with volumes and horizons of their own, and a hole. */
struct plate {
    int n;
    double x[2][POINTS], volume[POINTS], horizon[POINTS];
};

static double random_in(double low, double high) { return low + (high - low) * rand() / RAND_MAX; }

static struct plate plate_of(double shift) {
    struct plate p = {0};
    srand(23);
    for (int j = 0; j < HALF_Y; j++)
        for (int i = 0; i < HALF_X; i++) {
            const double at[2] = {i + 0.5 + rint(random_in(-51, 51)) / 256, j + 0.5 + rint(random_in(-51, 51)) / 256};
            const double volume = random_in(0.6, 1.2), horizon = random_in(2.5, 3.5);
            if ((at[0] - 5) * (at[0] - 5) + at[1] * at[1] < 6) continue;
            for (int side = 0; side < 4; side++) {
                p.x[0][p.n] = shift + (side & 1 ? -at[0] : at[0]) * SPACING;
                p.x[1][p.n] = 0.7 * shift + (side & 2 ? -at[1] : at[1]) * SPACING;
                p.volume[p.n] = volume * SPACING * SPACING * 2e-3;
                p.horizon[p.n++] = horizon * SPACING;
            }
        }
    return p;
}

static struct solid *solid_of(const struct plate *p, enum solid_horizons horizons, double fracture_energy) {
    const struct solid_body body = {.name = "plate",
                                    .shape = SOLID_POINTS,
                                    .points = p->n,
                                    .point = {p->x[0], p->x[1]},
                                    .point_volume = p->volume,
                                    .point_horizon = p->horizon};
    const struct solid_material material = {YOUNG, DENSITY, fracture_energy, 3, PHYSICS_CONSTANT, 0, 0};
    const struct solid_input in = {.model = PHYSICS_PLANE_STRESS,
                                   .thickness = 2e-3,
                                   .horizons = horizons,
                                   .spacing = SPACING,
                                   .bodies = 1,
                                   .body = &body,
                                   .materials = 1,
                                   .material = &material,
                                   .surface_correction = 1};
    return solid_new(&in);
}

/* Position of a particle relative to the plate's middle, in 2^-20 of the spacing. */
static long steps(const struct solid *s, int h, int c, double shift) {
    return lrint((s->x0[c][h] - (c ? 0.7 : 1) * shift) / SPACING * 0x1p20);
}

/* A number in [-1, 1) by |x| and |y|, of component c with the sign of that coordinate. */
static double mirrored_noise(const struct solid *s, int h, int c, double shift, int seed) {
    uint64_t z = (uint64_t)(c + 3 * seed) + 1;
    for (int k = 0; k < 2; k++) {
        z = (z ^ (uint64_t)labs(steps(s, h, k, shift))) * 0x9e3779b97f4a7c15u;
        z ^= z >> 29;
    }
    z *= 0xbf58476d1ce4e5b9u;
    z ^= z >> 32;
    const double noise = (double)(z >> 11) * 0x1p-52 - 1;
    return steps(s, h, c, shift) < 0 ? -noise : noise;
}

static void shake(struct solid *s, double size, double shift) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 2; c++) {
            s->d[c][h] = size * SPACING * mirrored_noise(s, h, c, shift, 0);
            s->v[c][h] = 0.1 * mirrored_noise(s, h, c, shift, 1);
        }
    solid_ghosts_update(s);
}

/* Of a quarter of the plate by place, on every rank: accelerations with the signs of the quarter, and lost bonds. */
struct found {
    long key[2];
    double a[2], lost;
    int quarter;
};

static int by_key(const void *a, const void *b) {
    const struct found *x = a, *y = b;
    for (int c = 0; c < 2; c++)
        if (x->key[c] != y->key[c]) return x->key[c] < y->key[c] ? -1 : 1;
    return x->quarter - y->quarter;
}

static struct found *collect(const struct solid *s, double shift) {
    static struct solid_family_view view;
    struct found *mine = calloc((size_t)s->n + 1, sizeof *mine);
    for (int h = 0; h < s->n; h++) {
        struct found *f = &mine[h];
        for (int c = 0; c < 2; c++) {
            const long at = steps(s, h, c, shift);
            f->key[c] = labs(at);
            f->a[c] = at < 0 ? -s->a[c][h] : s->a[c][h];
            if (at < 0) f->quarter |= 1 << c;
        }
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++) f->lost += view.intact[b] ? 0 : 1;
    }
    size_t bytes;
    struct found *all = par_all_gather_any(mine, (size_t)s->n * sizeof *mine, &bytes);
    assert_int_equal(bytes / sizeof *all, s->n_global);
    qsort(all, (size_t)s->n_global, sizeof *all, by_key);
    free(mine);
    return all;
}

/* All four quarters get the same bits, in the elastic and in the damped kernel, with small and with large stretches,
 * while bonds break, at any position of the plate in the coordinates, and on any number of ranks. */
static void test_mirror(void **state) {
    (void)state;
    const double shifts[2] = {0, 1.37 * M_SQRT2};
    struct found *first[2][2] = {{NULL}};
    for (int far = 0; far < 2; far++)
        for (int large = 0; large < 2; large++)
            for (int damped = 0; damped < 2; damped++) {
                const struct plate p = plate_of(shifts[far]);
                struct solid *s = solid_of(&p, SOLID_DUAL_HORIZON, large ? 500 : 0.05);
                s->stage.damping_relative = damped ? 1e11 : 0;
                shake(s, large ? 5e-2 : 8e-4, shifts[far]);
                solid_force(s, 1);
                solid_family_count(s);
                check_between(s->bonds_broken, 20, s->bonds_total / 2);
                struct found *all = collect(s, shifts[far]);
                assert_int_equal(s->n_global % 4, 0);
                for (long i = 0; i < s->n_global; i += 4)
                    for (int k = 1; k < 4; k++) {
                        check_equal(all[i].key[0], all[i + k].key[0]);
                        check_equal(all[i].key[1], all[i + k].key[1]);
                        check_equal(all[i].a[0], all[i + k].a[0]);
                        check_equal(all[i].a[1], all[i + k].a[1]);
                        check_equal(all[i].lost, all[i + k].lost);
                    }
                if (!far) {
                    char name[64];
                    snprintf(name, sizeof name, "solid_test_plane_%d%d", large, damped);
                    const size_t bytes = (size_t)s->n_global * sizeof *all;
                    struct found *one = malloc(bytes);
                    one_rank_expects(name, all, bytes, one);
                    assert_memory_equal(all, one, bytes);
                    free(one);
                    first[large][damped] = all;
                } else {
                    for (long i = 0; i < s->n_global; i++)
                        for (int c = 0; c < 2; c++) check_equal(all[i].a[c], first[large][damped][i].a[c]);
                    free(all);
                    free(first[large][damped]);
                }
                solid_free(s);
            }
}

/* The acceleration of particle h from its bonds, with square roots and divisions  (001: eqs 3.20, 3.39). */
static void by_hand(const struct solid *s, int h, double damping, double a[2]) {
    static struct solid_family_view view;
    const struct solid_list *t = s->family->list[0];
    solid_family_view(s, h, &view);
    a[0] = a[1] = 0;
    for (int b = 0; b < view.n; b++) {
        if (!view.intact[b]) continue;
        double zeta[2], xi2 = 0, zeta2 = 0, closing = 0;
        for (int c = 0; c < 2; c++) {
            zeta[c] = view.xi[b][c] + (s->d[c][view.l[b]] - s->d[c][h]);
            xi2 += view.xi[b][c] * view.xi[b][c];
            zeta2 += zeta[c] * zeta[c];
            closing += (s->v[c][view.l[b]] - s->v[c][h]) * zeta[c];
        }
        const double kv = view.micro[b] * view.weight[b] / DENSITY;
        const double f =
            kv * (view.alpha[b] * (sqrt(zeta2 / xi2) - 1) / sqrt(zeta2) + damping / t->law.c * closing / zeta2);
        for (int c = 0; c < 2; c++) a[c] += f * zeta[c];
    }
}

/* The sweep against bonds one by one, in both couplings; and forces equal and opposite with dual horizons. zeta^2 by
 * hand loses digits to cancellation, 1e-16 of a bond's length in 1e-4 of it. */
static void test_by_hand(void **state) {
    (void)state;
    const struct plate p = plate_of(0);
    for (int coupling = SOLID_DUAL_HORIZON; coupling <= SOLID_ONE_SIDED; coupling++) {
        struct solid *s = solid_of(&p, (enum solid_horizons)coupling, INFINITY);
        for (int large = 0; large < 2; large++)
            for (int damped = 0; damped < 2; damped++) {
                double most[2] = {0}, total[3] = {0};
                s->stage.damping_relative = damped ? 1e11 : 0;
                shake(s, large ? 2e-2 : 1e-4, 0);
                for (int h = 0; h < s->n; h++) /* no mirror image: all forces together do not vanish by themselves */
                    for (int c = 0; c < 2; c++)
                        s->d[c][h] +=
                            (large ? 1e-2 : 5e-5) * SPACING * sin(2e3 * (s->x0[0][h] + 0.3 * s->x0[1][h]) + 1 + c);
                solid_ghosts_update(s);
                solid_force(s, 0);
                for (int h = 0; h < s->n; h++) {
                    double a[2];
                    by_hand(s, h, s->stage.damping_relative, a);
                    for (int c = 0; c < 2; c++) {
                        most[0] = fmax(most[0], fabs(a[c]));
                        most[1] = check_worst(most[1], a[c] - s->a[c][h]);
                        total[c] += s->a[c][h] * s->volume[h];
                        total[2] += fabs(s->a[c][h]) * s->volume[h];
                    }
                }
                par_max_array(most, 2);
                par_sum_array(total, 3);
                check_above(most[0], 100);
                check_close(most[1] / most[0], 0, large ? 1e-12 : 1e-11);
                for (int c = 0; c < 2; c++)
                    if (coupling == SOLID_DUAL_HORIZON)
                        check_close(total[c] / total[2], 0, 2e-14);
                    else
                        check_above(fabs(total[c]), 1e-6 * total[2]);
            }
        solid_free(s);
    }
}

/* Bonds of a list set up to the end, on this rank's share of the ids. */
static struct solid_list *finished(struct solid_list *list, const struct solid_cloud *cloud, const long *first) {
    const long from = first[par_rank()], to = first[par_rank() + 1];
    const long n = solid_list_wanted(list, from, to, NULL);
    long *id = calloc((size_t)n + 1, sizeof *id);
    solid_list_wanted(list, from, to, id);
    const int ghosts = (int)sort_unique(id, n);
    struct par_ghost *exchange = par_ghost_new(first, ghosts, id);
    const struct solid_numbering numbering = {from, to, ghosts, id};
    double *volume = calloc((size_t)(to - from + ghosts) + 1, sizeof *volume);
    solid_list_link(list, cloud, &numbering);
    solid_list_volumes(list, volume);
    solid_list_ratios(list, volume, volume);
    par_ghost_update(exchange, 1, &volume, (int)(to - from));
    solid_list_weights(list, volume);
    par_ghost_free(exchange);
    free(id);
    free(volume);
    return list;
}

/* The number in the cloud of the other end of bond j. */
static long number_of(const struct solid_list *t, long j) {
    const int record = solid_list_record(t, j);
    return record < t->n ? t->number + record : t->other_key[record - t->n] / SOLID_IMAGES - t->first_id;
}

enum { NX = 24, NY = 18, LATTICE = NX * NY, MOST = 4 * LATTICE };

struct cells {
    long n, first[64], was[MOST];
    double place[2][MOST], size[MOST], volume[MOST], horizon[MOST];
};

static void add(struct cells *k, double x, double y, double size, long was) {
    k->place[0][k->n] = x;
    k->place[1][k->n] = y;
    k->size[k->n] = size;
    k->volume[k->n] = size * size;
    k->horizon[k->n] = 3 * size;
    k->was[k->n++] = was;
}

/* A lattice in rows, divided among ranks. refined: particles in one region are smaller, and three more of their size
 * come after all others of the rank. */
static void cells_of(struct cells *k, int refined) {
    k->n = 0;
    for (int rank = 0; rank < par_size(); rank++) {
        const long from = LATTICE * rank / par_size(), to = LATTICE * (rank + 1) / par_size();
        k->first[rank] = k->n;
        for (int later = 0; later <= refined; later++)
            for (long p = from; p < to; p++) {
                const double x = (double)(p % NX) + 0.5, y = (double)(p / NX) + 0.5;
                const int is_small = refined && fabs(x - 9) < 3 && fabs(y - 9) < 4;
                if (!later) add(k, is_small ? x - 0.25 : x, is_small ? y - 0.25 : y, is_small ? 0.5 : 1, p);
                for (int q = 1; later && is_small && q < 4; q++)
                    add(k, x - 0.25 + 0.5 * (q & 1), y - 0.25 + 0.25 * (q & 2), 0.5, -1);
            }
    }
    k->first[par_size()] = k->n;
}

static struct solid_cloud *cloud_of(const struct cells *k, enum solid_horizons horizons) {
    const struct solid_material m = {YOUNG, DENSITY, 0.05, 3, PHYSICS_CONSTANT, 0, 0};
    const struct solid_input in = {
        .model = PHYSICS_PLANE_STRAIN, .thickness = 1, .spacing = SPACING, .horizons = horizons};
    return solid_cloud_new(&(struct solid_cloud_input){.name = "cells",
                                                       .n = k->n,
                                                       .spacing = SPACING,
                                                       .thickness = 1,
                                                       .period = {0, NY * SPACING},
                                                       .place = {k->place[0], k->place[1]},
                                                       .size = k->size,
                                                       .volume = k->volume,
                                                       .horizon = k->horizon,
                                                       .law = solid_pair_law(&in, &m)});
}

/* Whether the bond between two numbers of the lattice is broken; the same from both ends. */
static int is_cut(long a, long b) {
    const long low = a < b ? a : b, high = a + b - low;
    return (low * 7919 + high * 104729) % 7 == 0;
}

/* A list that is renewed near the changes of its cloud equals one that is made again; broken bonds stay broken. */
static void test_renew(void **state) {
    (void)state;
    static struct cells coarse, fine;
    cells_of(&coarse, 0);
    cells_of(&fine, 1);
    for (int horizons = SOLID_DUAL_HORIZON; horizons <= SOLID_ONE_SIDED; horizons++) {
        struct solid_cloud *before = cloud_of(&coarse, (enum solid_horizons)horizons),
                           *after = cloud_of(&fine, (enum solid_horizons)horizons);
        const long *first[2] = {coarse.first, fine.first};
        const int r = par_rank();
        struct solid_list *old =
            finished(solid_list_find_new(before, NULL, 0, first[0][r], first[0][r + 1], 0), before, first[0]);
        for (int i = 0; i < old->n; i++)
            for (long j = old->start[i]; j < old->end[i]; j++)
                if (is_cut(old->number + i, number_of(old, j))) solid_list_set(old, j, 0);
        struct solid_list *made =
            finished(solid_list_find_new(after, NULL, 0, first[1][r], first[1][r + 1], 0), after, first[1]);
        struct solid_list *begun = solid_list_renew(old, before, after, fine.was, first[1][r], first[1][r + 1], 0);
        long copied = 0, broken = 0;
        for (int i = 0; i < begun->n; i++) copied += begun->scaled[i];
        struct solid_list *renewed = finished(begun, after, first[1]);
        assert_int_equal(renewed->n, made->n);
        assert_int_equal(renewed->bonds, made->bonds);
        for (int i = 0; i < made->n; i++) {
            const long was = fine.was[made->number + i];
            check_equal(made->start[i], renewed->start[i]);
            check_equal(made->end[i], renewed->end[i]);
            check_equal(made->eps_limit[i], renewed->eps_limit[i]);
            check_equal(made->digit[i], renewed->digit[i]);
            check_equal(made->own_volume[i], renewed->own_volume[i]);
            for (long j = made->start[i]; j < made->end[i]; j++) {
                const long number = number_of(made, j), other = fine.was[number];
                assert_int_equal(number_of(renewed, j), number);
                for (int c = 0; c < 2; c++) check_equal(*solid_list_step(made, j, c), *solid_list_step(renewed, j, c));
                check_equal(fabs(renewed->stiffness[j]), made->stiffness[j]);
                int cut = 0; /* the pair had a bond, and it was broken */
                for (long q = was < 0 ? 0 : old->start[was - old->number]; was >= 0 && q < old->end[was - old->number];
                     q++)
                    cut |= number_of(old, q) == other && !solid_list_is_intact(old, q);
                assert_int_equal(solid_list_is_intact(renewed, j), !cut);
                broken += cut;
            }
        }
        const double count[2] = {par_sum((double)copied), par_sum((double)broken)};
        check_between(count[0], 0.2 * LATTICE, 0.8 * LATTICE);
        check_above(count[1], 500);
        solid_list_free(old);
        solid_list_free(made);
        solid_list_free(renewed);
        solid_cloud_free(before);
        solid_cloud_free(after);
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_mirror),
        cmocka_unit_test(test_by_hand),
        cmocka_unit_test(test_renew),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
