/* Lattice points that lie on a surface: every shape, cavities, regions and cracks are cut by the same rule at every
 * scale and place. Expected sets are counted in whole numbers. */
#include "base/par.h"
#include "solid/body/sites.h"
#include "solid/geometry/cut.h"
#include "solid/geometry/on_surface.h"
#include "solid/geometry/turn.h"
#include "tests/check.h"
#include "tests/solid/contains.h"

#include <stdlib.h>

/* Lattice points of the tests stand at whole numbers of spacings plus this, which no binary number holds. */
static const double PLACE = 0.3;
static const double scale[] = {1, 3, 0.01, 1. / 3, 1.5625e-3, 0.7}, shift[] = {0, 7, -1000, 10000};
enum { SCALES = sizeof scale / sizeof *scale, SHIFTS = sizeof shift / sizeof *shift, REACH = 12 };

static const struct solid_material material = {1e8, 3000, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};

/* A body, its lengths in spacings, its places relative to the lattice point 0, and who belongs to it. */
struct example {
    struct solid_body body;
    int (*is_in)(int i, int j, int k);
    int low, high; /* lattice points to look at, each way */
    long on;       /* how many lie on the surface; -1: not counted here */
};

static int in_box(int i, int j, int k) { return i >= -2 && i <= 3 && j >= 0 && j <= 4 && k >= -5 && k <= 1; }
static int in_ball(int i, int j, int k) { return i * i + j * j + k * k <= 25; }
static int in_rod(int i, int j, int k) { return i * i + k * k <= 25 && abs(j) <= 3; }
static int in_egg(int i, int j, int k) { return i * i + 4 * (j * j + k * k) <= 100; }

/* Away from the nearest cavity of period 16 about p, in hundredths of a spacing. */
static long away(int i, long p) {
    const long d = ((100L * i - p) % 1600 + 1600) % 1600;
    return d > 800 ? 1600 - d : d;
}

/* The porous block: cavities of radius 9.15 about (16.15, 0, 0), lattice points at halves. */
static int in_block(int i, int j, int k) {
    const long x = away(i, 1565), y = away(j, -50), z = away(k, -50);
    return i >= 16 && i < 64 && j >= -3 && j < 67 && k >= 0 && k < 64 && x * x + y * y + z * z >= 915L * 915;
}

static const struct example example[] = {
    {{.name = "box", .shape = SOLID_BOX, .low = {-2, 0, -5}, .high = {3, 4, 1}}, in_box, -REACH, REACH, 150},
    {{.name = "ball", .shape = SOLID_SPHERE, .radius = 5}, in_ball, -REACH, REACH, 30},
    {{.name = "rod", .shape = SOLID_CYLINDER, .radius = 5, .axis = 1, .length = 6}, in_rod, -REACH, REACH, 222},
    {{.name = "egg", .shape = SOLID_ELLIPSOID, .radii = {10, 5, 5}}, in_egg, -REACH, REACH, -1},
    {{.name = "block",
      .shape = SOLID_BOX,
      .low = {15.5, -3.5, -0.5},
      .high = {63.5, 66.5, 63.5},
      .cavity_period = 16,
      .cavity_radius = 9.15,
      .cavity_centre = {15.65, -0.5, -0.5}},
     in_block,
     -5,
     70,
     384},
};
enum { EXAMPLES = sizeof example / sizeof *example };

/* The body with the spacing h, moved by so many spacings. */
static struct solid_body moved(const struct solid_body *from, double h, double by) {
    struct solid_body body = *from;
    for (int c = 0; c < 3; c++) {
        const double to = PLACE + by;
        body.low[c] = (from->low[c] + to) * h;
        body.high[c] = (from->high[c] + to) * h;
        body.centre[c] = (from->centre[c] + to) * h;
        body.cavity_centre[c] = (from->cavity_centre[c] + to) * h;
        body.radii[c] = from->radii[c] * h;
    }
    body.radius *= h;
    body.length *= h;
    body.cavity_period *= h;
    body.cavity_radius *= h;
    return body;
}

static struct solid_input input(const struct solid_body *body, double h) {
    const double origin = (PLACE - 0.5) * h;
    return (struct solid_input){.spacing = h,
                                .origin = {origin, origin, origin},
                                .bodies = 1,
                                .body = body,
                                .materials = 1,
                                .material = &material};
}

static void shapes(void **state) {
    (void)state;
    for (int e = 0; e < EXAMPLES; e++)
        for (int run = 0; run < SCALES * SHIFTS; run++) {
            const double h = scale[run / SHIFTS], by = shift[run % SHIFTS];
            const struct solid_body body = moved(&example[e].body, h, by);
            const struct solid_input in = input(&body, h);
            struct solid_sites *t = solid_sites_new(&in, &body, 0, 3);
            long inside = 0, wrong = 0;
            for (int k = example[e].low; k < example[e].high; k++)
                for (int j = example[e].low; j < example[e].high; j++)
                    for (int i = example[e].low; i < example[e].high; i++) {
                        const int site[3] = {i + (int)by, j + (int)by, k + (int)by}, is_in = example[e].is_in(i, j, k);
                        inside += is_in;
                        wrong += (solid_sites_id(t, site) >= 0) != is_in;
                    }
            if (wrong || t->count != inside)
                fail_msg("%s, spacing %g, moved by %g: %ld particles, not %ld; %ld sites are wrong", body.name, h, by,
                         t->count, inside, wrong);
            check_above(inside, 100);
            if (example[e].on >= 0) check_equal(t->on_surface, example[e].on);
            check_above(t->on_surface, 0);
            check_above(t->gap, 0.005 * h);
            solid_sites_free(t);
        }
}

/* All whole cavities of the block have the same number of sites, and are mirror images in y and in z. */
static void cavities(void **state) {
    (void)state;
    for (int s = 0; s < SCALES; s++) {
        const struct solid_body body = moved(&example[EXAMPLES - 1].body, scale[s], 0);
        const struct solid_input in = input(&body, scale[s]);
        struct solid_sites *t = solid_sites_new(&in, &body, 0, 3);
        long first = 0;
        for (int cavity = 0; cavity < 2 * 3 * 3; cavity++) {
            const int corner[3] = {24 + 16 * (cavity % 2), 8 + 16 * (cavity / 2 % 3), 8 + 16 * (cavity / 6)};
            long empty = 0;
            for (int q = 0; q < 16 * 16 * 16; q++) {
                const int at[3] = {q % 16, q / 16 % 16, q / 256};
                const int site[3] = {corner[0] + at[0], corner[1] + at[1], corner[2] + at[2]};
                const int image[3] = {site[0], corner[1] + 15 - at[1], corner[2] + 15 - at[2]};
                empty += solid_sites_id(t, site) < 0;
                check_equal(solid_sites_id(t, site) < 0, solid_sites_id(t, image) < 0);
            }
            if (cavity == 0) first = empty;
            check_equal(empty, first);
        }
        check_above(first, 1000);
        solid_sites_free(t);
    }
}

/* The cells of a polygon, in one number each. */
static int in_plate(const struct solid_sites *t, int i, int j) {
    for (long p = 0; p < t->count; p++)
        if (t->cell[p][0] == i && t->cell[p][1] == j) return 1;
    return 0;
}

/* A disc of radius 5 with a triangular hole whose sides pass through lattice points: on both the point is inside. */
static int in_disc(int i, int j) { return i * i + j * j <= 25 && !(j > 0 && 3 * i + 2 * j < 6 && 3 * i - j > -3); }

static void polygon(void **state) {
    (void)state;
    for (int run = 0; run < SCALES * SHIFTS; run++) {
        const double h = scale[run / SHIFTS], by = shift[run % SHIFTS], to = PLACE + by;
        double disc[2][2] = {{-5, 0}, {5, 0}}, hole[3][2] = {{-1, 0}, {2, 0}, {0, 3}}, centre[3][2] = {{0}};
        for (int c = 0; c < 2; c++) {
            for (int k = 0; k < 2; k++) disc[k][c] = (disc[k][c] + to) * h;
            for (int k = 0; k < 3; k++) {
                hole[k][c] = (hole[k][c] + to) * h;
                centre[k][c] = to * h;
            }
        }
        const signed char turn[3] = {1, 1, 0}, straight[3] = {0};
        const struct solid_outline outline[2] = {{0, 2, disc, centre, turn}, {1, 3, hole, centre, straight}};
        const struct solid_body body = {.name = "disc", .shape = SOLID_POLYGON, .outlines = 2, .outline = outline};
        struct solid_input in = input(&body, h);
        in.model = PHYSICS_PLANE_STRESS;
        in.thickness = h;
        struct solid_sites *t = solid_sites_new(&in, &body, 0, 3);
        long inside = 0;
        for (int j = -REACH; j < REACH; j++)
            for (int i = -REACH; i < REACH; i++) {
                inside += in_disc(i, j);
                if (in_plate(t, i + (int)by, j + (int)by) != in_disc(i, j))
                    fail_msg("spacing %g, moved by %g: point (%d, %d)", h, by, i, j);
            }
        check_equal(t->count, inside);
        check_equal(t->on_surface, 12 + 5); /* 3-4-5 and the axes; the hole's corners and its low side */
        solid_sites_free(t);
    }
}

/* A region whose faces pass through lattice points holds them. */
static void regions(void **state) {
    (void)state;
    for (int run = 0; run < SCALES * SHIFTS; run++) {
        const double h = scale[run / SHIFTS], to = PLACE + shift[run % SHIFTS];
        const double low[3] = {(to - 1) * h, to * h, (to - 3) * h},
                     high[3] = {(to + 2) * h, (to + 2) * h, (to + 1) * h};
        int inside = 0, on = 0;
        for (int q = 0; q < 1000; q++) {
            const double x[3] = {(to - 5 + q % 10) * h, (to - 5 + q / 10 % 10) * h, (to - 5 + q / 100) * h};
            const double depth = solid_on_surface_depth(x, low, high, 3);
            inside += solid_on_surface_is_inside(depth, h);
            on += solid_on_surface_is_on(depth, h);
        }
        check_equal(inside, 4 * 3 * 5);
        check_equal(on, 4 * 3 * 5 - 2 * 1 * 3);
    }
}

/* What is nearer than the tolerance is on the surface, what is farther is not. */
static void tolerance(void **state) {
    (void)state;
    for (int s = 0; s < SCALES; s++) {
        const double h = scale[s], tiny = SOLID_ON_SURFACE * h;
        const struct solid_body ball = {.shape = SOLID_SPHERE, .radius = 5 * h};
        const struct solid_body porous = {
            .shape = SOLID_SPHERE, .radius = 9 * h, .cavity_period = 100 * h, .cavity_radius = 5 * h};
        check_equal(contains(&ball, (double[]){3 * h, 4 * h + 0.9 * tiny, 0}, h), 1);
        check_equal(contains(&ball, (double[]){3 * h, 4 * h + 1.5 * tiny, 0}, h), 0);
        check_equal(contains(&porous, (double[]){3 * h, 4 * h - 0.9 * tiny, 0}, h), 1);
        check_equal(contains(&porous, (double[]){3 * h, 4 * h - 1.5 * tiny, 0}, h), 0);
    }
}

/* Whether the bond from a to a + xi meets the square 0 <= x, y <= 3 of the plane z = 0; a in whole numbers, |xi_c| at
 * most 1. */
static int meets(const int a[3], const int xi[3]) {
    const int b[3] = {a[0] + xi[0], a[1] + xi[1], a[2] + xi[2]};
    const int *end[2] = {a, b};
    for (int e = 0; e < 2; e++)
        if (end[e][2] == 0 && end[e][0] >= 0 && end[e][0] <= 3 && end[e][1] >= 0 && end[e][1] <= 3) return 1;
    return 0;
}

/* A crack through lattice points breaks the bonds that end on it, and on its rim. */
static void cracks(void **state) {
    (void)state;
    for (int run = 0; run < SCALES * SHIFTS; run++) {
        const double h = scale[run / SHIFTS], to = PLACE + shift[run % SHIFTS];
        double corner[4][3] = {{0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}};
        for (int k = 0; k < 4; k++)
            for (int c = 0; c < 3; c++) corner[k][c] = (corner[k][c] + to) * h;
        int met = 0;
        for (int q = 0; q < 9 * 9 * 5 * 27; q++) {
            const int a[3] = {q % 9 - 3, q / 9 % 9 - 3, q / 81 % 5 - 2};
            const int n = q / 405, xi[3] = {n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1};
            double x[3], y[3];
            for (int c = 0; c < 3; c++) {
                x[c] = (a[c] + to) * h;
                y[c] = x[c] + xi[c] * h;
            }
            if (n == 13) continue;
            met += meets(a, xi);
            if (solid_cut_plane_crosses(corner, x, y, h) != meets(a, xi))
                fail_msg("spacing %g, place %g: bond from (%d, %d, %d) by (%d, %d, %d)", h, to, a[0], a[1], a[2], xi[0],
                         xi[1], xi[2]);
        }
        check_equal(met, 2 * 16 * 26 - 2 * (12 + 12 + 9 + 9)); /* of each corner all; those between two of them once */
        const double line[2][3] = {{to * h, to * h}, {(to + 3) * h, to * h}},
                     origin[2] = {(PLACE - 0.5) * h, (PLACE - 0.5) * h};
        const struct solid_cut cut = {2, line};
        struct solid_cut_line *made = solid_cut_line_new(&cut, origin, h);
        for (int i = -3; i < 7; i++) {
            const double a[2] = {to - PLACE + 0.5 + i, to - PLACE + 0.5}, b[2] = {a[0], a[1] + 1};
            check_equal(solid_cut_line_crosses(made, a, b), i >= 0 && i <= 3);
        }
        solid_cut_line_free(made);
    }
}

/* The box low ... high with its first two edges along a and b. */
static struct solid_turn along(const double a[3], const double b[3], const double about[3]) {
    struct solid_turn turn = {.is_turned = 1};
    double la = 0, lb = 0;
    for (int c = 0; c < 3; c++) la += a[c] * a[c], lb += b[c] * b[c];
    for (int c = 0; c < 3; c++) {
        turn.about[c] = about[c];
        turn.edge[0][c] = a[c] / sqrt(la);
        turn.edge[1][c] = b[c] / sqrt(lb);
    }
    for (int c = 0; c < 3; c++)
        turn.edge[2][c] = turn.edge[0][(c + 1) % 3] * turn.edge[1][(c + 2) % 3] -
                          turn.edge[0][(c + 2) % 3] * turn.edge[1][(c + 1) % 3];
    return turn;
}

/* A slab between two planes of lattice points along [110] or [111] holds both, as a body and as a region, at every
 * scale and place; moved by 1e-5 spacings outwards it holds the same, inwards it loses both. */
static void turned_slabs(void **state) {
    (void)state;
    static const double direction[2][2][3] = {{{1, 1, 0}, {-1, 1, 0}}, {{1, 1, 1}, {-1, 1, 0}}};

    for (int way = 0; way < 2; way++)
        for (int k = 0; k < SCALES; k++)
            for (int far = 0; far < 2; far++) {
                const double spacing = scale[k], layers = way ? 9 / sqrt(3) : 6 / sqrt(2);
                const int corner = far ? 5000 : 0;
                long count[3], inside[3];
                for (int moved = 0; moved < 3; moved++) {
                    struct solid_body slab = {.name = "slab", .shape = SOLID_BOX};
                    double about[3];
                    const double out = moved == 1 ? 1e-5 : moved == 2 ? -1e-5 : 0;
                    for (int c = 0; c < 3; c++) {
                        about[c] = (corner + 0.5) * spacing; /* a lattice point, in the first plane of the slab */
                        slab.low[c] = about[c] + (c == 0 ? -out : -5.3) * spacing;
                        slab.high[c] = about[c] + (c == 0 ? layers + out : 5.3) * spacing;
                    }
                    slab.turn = along(direction[way][0], direction[way][1], about);
                    const struct solid_input in = {.spacing = spacing};
                    struct solid_sites *sites = solid_sites_new(&in, &slab, 0, 3);
                    count[moved] = sites->count;
                    if (moved == 0) check_above(sites->on_surface, 20);
                    solid_sites_free(sites);
                    inside[moved] = 0;
                    for (int c = -20; c < 20; c++)
                        for (int b = -20; b < 20; b++)
                            for (int a = -20; a < 20; a++) {
                                const double x[3] = {about[0] + a * spacing, about[1] + b * spacing,
                                                     about[2] + c * spacing};
                                double own[3];
                                solid_turn_place_into(&slab.turn, x, own);
                                inside[moved] += solid_on_surface_is_inside(
                                    solid_on_surface_depth(own, slab.low, slab.high, 3), spacing);
                            }
                    check_equal(inside[moved], count[moved]);
                }
                check_equal(count[0], count[1]);
                check_at_least(count[0] - count[2], 40);
            }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(shapes),       cmocka_unit_test(cavities),
                                       cmocka_unit_test(polygon),      cmocka_unit_test(regions),
                                       cmocka_unit_test(turned_slabs), cmocka_unit_test(tolerance),
                                       cmocka_unit_test(cracks)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
