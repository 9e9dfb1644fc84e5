/* Unions, holes, lists and images across periodic sides: who is inside, by brute force; volumes of arrays of spheres;
 * the work to cut a long list. */
#include "base/par.h"
#include "solid/body/sites.h"
#include "solid/geometry/compound.h"
#include "solid/geometry/on_surface.h"
#include "tests/check.h"

#include <stdlib.h>

enum { SITES = 24 }; /* of the period */

static const struct solid_material material = {1e8, 3000, INFINITY, 2, PHYSICS_CONSTANT, 0, 0};

/* A cubic domain with a period of SITES spacings of h. */
static struct solid_input input(const struct solid_body *body, double h, int periodic) {
    const double length = SITES * h;
    return (struct solid_input){.spacing = h,
                                .periodic = {periodic, periodic, periodic},
                                .length = {length, length, length},
                                .bodies = 1,
                                .body = body,
                                .materials = 1,
                                .material = &material};
}

static double uniform(double from, double to) { return from + (to - from) * rand() / RAND_MAX; }

/* Depth below an entry that is a sphere, at its nearest image, by hand. */
static double ball_depth(const double entry[6], const double x[3], double period) {
    double r2 = 0;
    for (int c = 0; c < 3; c++) {
        double d = x[c] - entry[c]; /* less than a period */
        if (period > 0) d = d < -0.5 * period ? d + period : d > 0.5 * period ? d - period : d;
        r2 += d * d;
    }
    return entry[3] - sqrt(r2);
}

static double list_depth(const double (*entry)[6], long n, const double x[3], double period) {
    double deepest = -INFINITY;
    for (long k = 0; k < n; k++) {
        const double depth = ball_depth(entry[k], x, period);
        if (depth > deepest) deepest = depth;
    }
    return deepest;
}

static void place(const struct solid_input *in, const int site[3], double x[3]) {
    for (int c = 0; c < 3; c++) x[c] = in->origin[c] + (site[c] + 0.5) * in->spacing;
}

static void fill_random(double (*entry)[6], long n, double low, double high, double from, double to) {
    for (long k = 0; k < n; k++) {
        for (int c = 0; c < 3; c++) entry[k][c] = uniform(low, high);
        entry[k][3] = entry[k][4] = entry[k][5] = uniform(from, to);
    }
}

/* A list is the union of its spheres, and as many pieces of a body are the same. */
static void list_and_pieces(void **state) {
    (void)state;
    enum { N = 40 };
    static double entry[N][6];
    static struct solid_body part[N];
    srand(11);
    fill_random(entry, N, 0, SITES, 1, 4);
    for (int k = 0; k < N; k++) {
        part[k] = (struct solid_body){.shape = SOLID_SPHERE, .radius = entry[k][3]};
        memcpy(part[k].centre, entry[k], sizeof part[k].centre);
    }
    const struct solid_body list = {
        .name = "list", .shape = SOLID_SPHERES, .entries = N, .entry = (const double(*)[6])entry};
    struct solid_body pieces = part[0];
    pieces.parts = N - 1;
    pieces.part = part + 1;
    const struct solid_input in = input(&list, 1, 0);
    struct solid_sites *one = solid_sites_new(&in, &list, 0, 2), *other = solid_sites_new(&in, &pieces, 0, 2);
    long inside = 0;
    for (int q = 0; q < 40 * 40 * 40; q++) {
        const int site[3] = {q % 40 - 8, q / 40 % 40 - 8, q / 1600 - 8};
        double x[3];
        place(&in, site, x);
        const int is_in = list_depth((const double(*)[6])entry, N, x, 0) >= 0;
        inside += is_in;
        check_equal(solid_sites_id(one, site) >= 0, is_in);
        check_equal(solid_sites_id(other, site), solid_sites_id(one, site));
    }
    check_equal(one->count, inside);
    check_above(inside, 2000);
    solid_sites_free(one);
    solid_sites_free(other);
}

/* Spheres that stick out of periodic sides come in at the others; a shift by a part of the period shifts the sites. */
static void wrapped(void **state) {
    (void)state;
    enum { N = 30 };
    static double entry[N][6], moved[N][6];
    srand(12);
    fill_random(entry, N, 0, SITES, 1, 5);
    memcpy(moved, entry, sizeof moved);
    const int by[3] = {5, 11, 17};
    for (int k = 0; k < N; k++)
        for (int c = 0; c < 3; c++) moved[k][c] = fmod(entry[k][c] + by[c], SITES);
    struct solid_body body = {.name = "list", .shape = SOLID_SPHERES, .entries = N, .entry = (const double(*)[6])entry},
                      shifted = body;
    shifted.entry = (const double(*)[6])moved;
    const struct solid_input in = input(&body, 1, 1);
    struct solid_sites *one = solid_sites_new(&in, &body, 0, 2), *other = solid_sites_new(&in, &shifted, 0, 2);
    long inside = 0;
    for (int q = 0; q < SITES * SITES * SITES; q++) {
        const int site[3] = {q % SITES, q / SITES % SITES, q / SITES / SITES},
                  image[3] = {site[0] + by[0], site[1] + by[1], site[2] + by[2] - SITES};
        double x[3];
        place(&in, site, x);
        const int is_in = list_depth((const double(*)[6])entry, N, x, SITES) >= 0;
        inside += is_in;
        check_equal(solid_sites_id(one, site) >= 0, is_in);
        check_equal(solid_sites_id(other, image) >= 0, is_in);
    }
    check_equal(one->count, inside);
    check_equal(other->count, inside);
    check_between(inside, 2000, SITES * SITES * SITES);
    solid_sites_free(one);
    solid_sites_free(other);
}

/* Single shapes across a corner of the domain have as many particles as in its middle; a rod that is longer than the
 * period is one through it. */
static void wrapped_shapes(void **state) {
    (void)state;
    const struct solid_body middle[4] = {
        {.name = "box", .shape = SOLID_BOX, .low = {7, 9, 8}, .high = {15, 16, 21}},
        {.name = "ball", .shape = SOLID_SPHERE, .centre = {12.3, 12.1, 12.4}, .radius = 8.2},
        {.name = "rod", .shape = SOLID_CYLINDER, .centre = {12.3, 12.1, 12.4}, .radius = 5.7, .axis = 1, .length = 11},
        {.name = "egg",
         .shape = SOLID_ELLIPSOID,
         .centre = {12, 12, 12},
         .radii = {9, 6, 4},
         .cavity_period = 5,
         .cavity_radius = 1.9}};
    for (int k = 0; k < 4; k++) {
        struct solid_body corner = middle[k];
        for (int c = 0; c < 3; c++) {
            corner.low[c] -= 12, corner.high[c] -= 12, corner.centre[c] -= 12, corner.cavity_centre[c] -= 12;
        }
        const struct solid_input in = input(&corner, 1, 1);
        struct solid_sites *here = solid_sites_new(&in, &middle[k], 0, 2), *there = solid_sites_new(&in, &corner, 0, 2);
        check_above(here->count, 300);
        check_equal(there->count, here->count);
        check_equal(there->on_surface, here->on_surface);
        check_equal(there->gap, here->gap);
        for (int q = 0; q < SITES * SITES * SITES; q++) {
            const int site[3] = {q % SITES, q / SITES % SITES, q / SITES / SITES},
                      image[3] = {site[0] - 12, site[1] + 12, site[2] - 12};
            check_equal(solid_sites_id(here, site) >= 0, solid_sites_id(there, image) >= 0);
        }
        for (int c = 0; c < 3; c++) check_at_least(there->base[c], 0);
        solid_sites_free(here);
        solid_sites_free(there);
    }
    struct solid_body rod = middle[2];
    struct solid_input in = input(&rod, 1, 1);
    rod.length = 40;
    struct solid_sites *through = solid_sites_new(&in, &rod, 0, 2);
    rod.centre[1] = SITES / 2.;
    rod.length = SITES;
    struct solid_sites *exact = solid_sites_new(&in, &rod, 0, 2);
    check_equal(through->count, exact->count);
    check_equal(exact->count % SITES, 0);
    solid_sites_free(through);
    solid_sites_free(exact);
}

/* A block minus a ball, a rod and a list, in which a ball of the body's own stands, is minus all of them: holes are
 * taken from all pieces. */
static void holes(void **state) {
    (void)state;
    static const double pore[3][6] = {{4, 4, 4, 3, 3, 3}, {20, 20, 6, 5, 2, 3}, {23, 3, 20, 4, 4, 4}};
    const struct solid_body part[4] = {
        {.shape = SOLID_SPHERE, .centre = {12, 12, 24}, .radius = 6.3},
        {.shape = SOLID_SPHERE, .centre = {12, 12, 12}, .radius = 5.2, .is_hole = 1},
        {.shape = SOLID_CYLINDER, .centre = {18, 6, 12}, .radius = 2.6, .axis = 2, .length = 100, .is_hole = 1},
        {.shape = SOLID_SPHERES, .entries = 3, .entry = pore, .is_hole = 1}};
    struct solid_body body = {.name = "block", .shape = SOLID_BOX, .high = {24, 24, 24}, .parts = 4, .part = part};
    const struct solid_input in = input(&body, 1, 0);
    struct solid_sites *t = solid_sites_new(&in, &body, 0, 2);
    long inside = 0;
    for (int q = 0; q < 32 * 32 * 40; q++) {
        const int site[3] = {q % 32 - 4, q / 32 % 32 - 4, q / 1024 - 4};
        double x[3], in_egg = 0;
        place(&in, site, x);
        const double top[6] = {12, 12, 24, 6.3}, ball[6] = {12, 12, 12, 5.2};
        for (int c = 0; c < 3; c++) in_egg += pow((x[c] - pore[1][c]) / pore[1][3 + c], 2);
        int is_in = ball_depth(top, x, 0) >= 0;
        is_in |= x[0] > 0 && x[1] > 0 && x[2] > 0 && x[0] < 24 && x[1] < 24 && x[2] < 24;
        is_in &= ball_depth(ball, x, 0) <= 0 && hypot(x[0] - 18, x[1] - 6) >= 2.6 && ball_depth(pore[0], x, 0) <= 0 &&
                 in_egg >= 1 && ball_depth(pore[2], x, 0) <= 0;
        inside += is_in;
        check_equal(solid_sites_id(t, site) >= 0, is_in);
    }
    check_equal(t->count, inside);
    check_between(inside, 5000, 24 * 24 * 24);
    solid_sites_free(t);
}

/* A hole in a block that fills the period comes in at the other sides as well. */
static void wrapped_hole(void **state) {
    (void)state;
    const struct solid_body part = {.shape = SOLID_SPHERE, .centre = {1.2, 2.1, 23.3}, .radius = 5.3, .is_hole = 1};
    const struct solid_body body = {
        .name = "block", .shape = SOLID_BOX, .high = {SITES, SITES, SITES}, .parts = 1, .part = &part};
    const double ball[6] = {1.2, 2.1, 23.3, 5.3};
    const struct solid_input in = input(&body, 1, 1);
    struct solid_sites *t = solid_sites_new(&in, &body, 0, 2);
    long inside = 0;
    for (int q = 0; q < SITES * SITES * SITES; q++) {
        const int site[3] = {q % SITES, q / SITES % SITES, q / SITES / SITES};
        double x[3];
        place(&in, site, x);
        const int is_in = ball_depth(ball, x, SITES) <= 0;
        inside += is_in;
        check_equal(solid_sites_id(t, site) >= 0, is_in);
    }
    check_equal(t->count, inside);
    check_below(inside, SITES * SITES * SITES - 500);
    solid_sites_free(t);
}

/* What lies on a surface is inside, at every scale: a ball whose surface passes through sites, at a corner of the
 * period, a box whose face does, and a hole. */
static void on_surfaces(void **state) {
    (void)state;
    static const double scale[] = {1, 0.1, 1e-3 / 3, 7.3e4};
    for (int k = 0; k < 4; k++) {
        const double h = scale[k];
        const struct solid_body part[2] = {
            {.shape = SOLID_SPHERE, .centre = {10.5 * h, 10.5 * h, 10.5 * h}, .radius = 3 * h, .is_hole = 1},
            {.shape = SOLID_SPHERE, .centre = {0.5 * h, 0.5 * h, 0.5 * h}, .radius = 5 * h}};
        const struct solid_body body = {.name = "both",
                                        .shape = SOLID_BOX,
                                        .low = {6.5 * h, 6.5 * h, 6.5 * h},
                                        .high = {14.5 * h, 14.5 * h, 14.5 * h},
                                        .parts = 2,
                                        .part = part};
        const struct solid_input in = input(&body, h, 1);
        struct solid_sites *t = solid_sites_new(&in, &body, 0, 2);
        long inside = 0, on = 0;
        for (int q = 0; q < SITES * SITES * SITES; q++) {
            const int site[3] = {q % SITES, q / SITES % SITES, q / SITES / SITES};
            int r2 = 0, hole2 = 0, in_box = 1;
            for (int c = 0; c < 3; c++) {
                const int d = site[c] > SITES / 2 ? site[c] - SITES : site[c];
                r2 += d * d;
                hole2 += (site[c] - 10) * (site[c] - 10);
                in_box &= site[c] >= 6 && site[c] <= 14;
            }
            const int is_in = r2 <= 25 || (in_box && hole2 >= 9);
            inside += is_in;
            on += r2 == 25 || (in_box && hole2 == 9);
            check_equal(solid_sites_id(t, site) >= 0, is_in);
        }
        check_equal(t->count, inside);
        check_equal(t->on_surface, on + 9 * 9 * 9 - 7 * 7 * 7);
        solid_sites_free(t);
    }
}

/* Particles' volume of simple, body-centred and face-centred cubic arrays at several fractions, against 4/3 pi a^3 a
 * sphere: they are whole numbers of sites, so single lattices scatter by some per cent and their mean over places does
 * not. */
static void arrays(void **state) {
    (void)state;
    static const double site[4][3] = {{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}, centre[3] = {.5, .5, .5};
    static const double fraction[] = {0.125, 0.343, 0.45};
    for (int kind = 0; kind < 3; kind++)
        for (int f = 0; f < 3; f++) {
            const int n = kind == 0 ? 1 : kind == 1 ? 2 : 4;
            const double a = SITES * cbrt(fraction[f] / n * 3 / (4 * M_PI));
            double mean = 0, entry[4][6];
            enum { PLACES = 40 };
            srand(4);
            for (int q = 0; q < PLACES; q++) {
                const double at[3] = {uniform(0, 1), uniform(0, 1), uniform(0, 1)};
                for (int k = 0; k < n; k++)
                    for (int c = 0; c < 3; c++) {
                        entry[k][c] = at[c] + SITES * (kind == 1 && k == 1 ? centre[c] : site[k][c]);
                        entry[k][3 + c] = a;
                    }
                const struct solid_body body = {
                    .name = "array", .shape = SOLID_SPHERES, .entries = n, .entry = (const double(*)[6])entry};
                const struct solid_input in = input(&body, 1, 1);
                struct solid_sites *t = solid_sites_new(&in, &body, 0, 2);
                const double ours = (double)t->count / (SITES * SITES * SITES);
                check_relative(ours, fraction[f], 0.05);
                mean += ours / PLACES;
                solid_sites_free(t);
            }
            print_message("%s, c = %g: %.5f\n", kind == 0 ? "SC" : kind == 1 ? "BCC" : "FCC", fraction[f], mean);
            check_relative(mean, fraction[f], 0.005);
        }
}

/* Eight times the spheres in eight times the volume: eight times the work, to the share of the border. */
static void long_list(void **state) {
    (void)state;
    double work[2];
    for (int run = 0; run < 2; run++) {
        const long n = run ? 5000 : 625;
        const double side = run ? 100 : 50;
        double(*entry)[6] = malloc((size_t)n * sizeof *entry);
        srand(9);
        fill_random(entry, n, 0, side, 2, 4);
        const struct solid_body body = {
            .name = "list", .shape = SOLID_SPHERES, .entries = n, .entry = (const double(*)[6])entry};
        struct solid_input in = input(&body, 1, 1);
        for (int c = 0; c < 3; c++) in.length[c] = side;
        struct solid_sites *t = solid_sites_new(&in, &body, 0, 2);
        work[run] = (double)t->tested;
        print_message("%ld spheres: %ld particles, %ld depths\n", n, t->count, t->tested);
        check_above(t->count, 0.3 * side * side * side);
        solid_sites_free(t);
        free(entry);
    }
    check_between(work[1] / work[0], 7.5, 8.5);
}

/* Members of a twenty-fifth of the spacing: each is in a few cells, however many there are. */
static void small_members(void **state) {
    (void)state;
    enum { N = 20000 };
    double(*entry)[6] = malloc(N * sizeof *entry);
    srand(5);
    fill_random(entry, N, 4, 8, 0.04, 0.04);
    const struct solid_body body = {
        .name = "dust", .shape = SOLID_SPHERES, .entries = N, .entry = (const double(*)[6])entry};
    const struct solid_input in = input(&body, 1, 0);
    struct solid_compound *c = solid_compound_new(&in, &body);
    const long cells = (long)c->cells[0] * c->cells[1] * c->cells[2];
    print_message("%d members in %ld cells: %ld entries\n", (int)N, cells, c->start[cells]);
    check_between(c->start[cells], N, 16L * N);
    check_close(solid_compound_depth(c, entry[7]), 0.04, 1e-12);
    solid_compound_free(c);
    free(entry);
}

/* Small members make a body as large ones do: with one of each, particles are where a sum over all says so, and few
 * depths are computed. What a depth cannot see is no nearer than the gap. */
static void small_sites(void **state) {
    (void)state;
    enum { N = 4000 };
    double(*entry)[6] = malloc(N * sizeof *entry);
    const struct solid_body body = {
        .name = "dust", .shape = SOLID_SPHERES, .entries = N, .entry = (const double(*)[6])entry};
    const struct solid_input in = input(&body, 1, 1);
    for (int run = 0; run < 2; run++) {
        long inside = 0;
        double gap = INFINITY;
        srand(6);
        fill_random(entry, N, 0, SITES, 0.04, 0.42);
        if (run == 1) entry[N / 2][3] = entry[N / 2][4] = entry[N / 2][5] = 3;
        struct solid_sites *t = solid_sites_new(&in, &body, 0, 2);
        for (int q = 0; q < SITES * SITES * SITES; q++) {
            const int site[3] = {q % SITES, q / SITES % SITES, q / SITES / SITES};
            double x[3];
            place(&in, site, x);
            const double depth = list_depth((const double(*)[6])entry, N, x, SITES);
            gap = fmin(gap, fabs(depth));
            inside += depth >= 0;
            check_equal(solid_sites_id(t, site) >= 0, depth >= 0);
        }
        print_message("%d members: %ld particles, %ld depths\n", (int)N, t->count, t->tested);
        check_equal(t->count, inside);
        check_above(inside, 250);
        check_close(t->gap, gap, 1e-12);
        check_below(t->tested, 4L * N);
        solid_sites_free(t);
    }
    free(entry);
    static const double alone[1][6] = {{12.4, 12.5, 12.5, 0.1, 0.1, 0.1}};
    const struct solid_body speck = {.name = "speck", .shape = SOLID_SPHERES, .entries = 1, .entry = alone};
    const struct solid_input around = input(&speck, 1, 0);
    struct solid_sites *t = solid_sites_new(&around, &speck, 0, 2);
    check_equal(t->count, 1);
    check_equal(t->on_surface, 1);
    check_between(t->gap, 0.4, 0.8);
    solid_sites_free(t);
}

/* The shape that a place is deepest in; of equals the first, also across a periodic side. */
static void names(void **state) {
    (void)state;
    static const double entry[3][6] = {{4, 12, 12, 5, 5, 5}, {12, 12, 12, 5, 5, 5}, {20, 12, 12, 5, 5, 5}};
    const struct solid_body body = {.name = "row", .shape = SOLID_SPHERES, .entries = 3, .entry = entry};
    const struct solid_input in = input(&body, 1, 1);
    struct solid_compound *c = solid_compound_new(&in, &body);
    check_equal(c->shapes, 3);
    check_equal(c->is_wrapped[0], 1);
    check_equal(c->is_wrapped[1], 0);
    check_equal(solid_compound_shape(c, (double[]){7.9, 12, 12}), 0);
    check_equal(solid_compound_shape(c, (double[]){8, 12, 12}), 0);
    check_equal(solid_compound_shape(c, (double[]){8 + 1e-9, 12, 12}), 0);
    check_equal(solid_compound_shape(c, (double[]){8.1, 12, 12}), 1);
    check_equal(solid_compound_shape(c, (double[]){16.1, 12, 12}), 2);
    check_equal(solid_compound_shape(c, (double[]){0, 12, 12}), 0);
    check_equal(solid_compound_shape(c, (double[]){0.4, 12, 12}), 0);
    check_equal(solid_compound_shape(c, (double[]){23.9, 12, 12}), 2);
    check_equal(solid_compound_shape(c, (double[]){12, 12, 17.5}), -1);
    solid_compound_free(c);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(list_and_pieces), cmocka_unit_test(wrapped),       cmocka_unit_test(wrapped_shapes),
        cmocka_unit_test(holes),           cmocka_unit_test(arrays),        cmocka_unit_test(on_surfaces),
        cmocka_unit_test(long_list),       cmocka_unit_test(small_members), cmocka_unit_test(small_sites),
        cmocka_unit_test(names),           cmocka_unit_test(wrapped_hole)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
