/* The order of a lattice's bonds for the sweep: every intact bond is in it once, and no other. */
#include "solid/bonds/lattice.h"
#include "solid/bonds/segments.h"
#include "tests/solid/make.h"
#include "tests/check.h"

#include <stdlib.h>

static struct solid *ball(int periodic) {
    const struct solid_body body = {.name = "ball",
                                    .shape = SOLID_SPHERE,
                                    .centre = {8 * SPACING, 8 * SPACING, 8 * SPACING},
                                    .radius = 5.2 * SPACING};
    const struct solid_body bar = {.name = "bar", .shape = SOLID_BOX, .high = {12 * SPACING, 4 * SPACING, 3 * SPACING}};
    const struct solid_material material = {YOUNG, DENSITY, INFINITY, 3, PHYSICS_CONSTANT, 0, 0};
    return solid_new(&(struct solid_input){.spacing = SPACING,
                                           .bodies = 1,
                                           .body = periodic ? &bar : &body,
                                           .materials = 1,
                                           .material = &material,
                                           .periodic = {periodic, periodic},
                                           .length = {12 * SPACING, 4 * SPACING, 1},
                                           .surface_correction = 1});
}

/* How often the entries hold each bond of each particle: count [n][offsets]. An even strip holds it for both ends. */
static void tally(const struct solid_lattice *t, int *count) {
    const struct solid_segments *all = t->segments;
    const int offsets = t->stencil->n;
    memset(count, 0, (size_t)t->n * (size_t)offsets * sizeof *count);
    for (int g = 0; g < all->n; g++) {
        long at = all->first[g];
        for (int strip = 0; strip < SOLID_STRIPS; strip++)
            for (int i = 0; i < all->count[g][strip]; i++, at++) {
                const int o = (int)(all->entry[at] >> 8);
                const long site = all->cell[g] + solid_segments_strip_site(strip);
                if (strip > 1) check_below(all->entry[at] & 0xffu, 16);
                check_equal(all->far[at], solid_lattice_place(t, site + t->offset[o].shift));
                if (strip % 2) check_at_least(g, all->inner);
                for (int k = 0; k < SOLID_ROW; k++) {
                    if (!(all->entry[at] >> k & 1)) continue;
                    const int h = t->local[site + k], l = t->local[site + k + t->offset[o].shift];
                    check_at_least(h, 0);
                    check_at_least(l, 0);
                    check_equal(all->segment_of[h - t->first], g);
                    count[(long)(h - t->first) * offsets + o]++;
                    if (strip % 2) continue;
                    check_equal(t->cell[l - t->first], site + k + t->offset[o].shift); /* owned, not an image */
                    check_at_least(o, offsets / 2);
                    count[(long)(l - t->first) * offsets + offsets - 1 - o]++;
                }
            }
        check_at_most(at, all->first[g + 1]);
    }
}

static void check_tally(const struct solid *s, const struct solid_lattice *t, int *count) {
    static struct solid_family_view view;
    tally(t, count);
    for (int h = 0; h < s->n; h++) {
        int b = 0;
        solid_family_view(s, h, &view);
        for (int o = 0; o < t->stencil->n; o++) {
            const int is_bond = t->local[t->cell[h] + t->offset[o].shift] >= 0;
            check_equal(count[(long)h * t->stencil->n + o], is_bond && view.intact[b]);
            b += is_bond;
        }
    }
}

/* In a ball, whose rows are ragged, and in a bar among its images; then again after bonds have broken. */
static void every_bond_once(void **state) {
    (void)state;
    static struct solid_family_view view;
    for (int periodic = 0; periodic < 2; periodic++) {
        struct solid *s = ball(periodic);
        struct solid_lattice *t = s->family->lattice[0];
        int *count = malloc((size_t)t->n * (size_t)t->stencil->n * sizeof *count), stale = 0;
        check_equal(t->n, s->n);
        check_tally(s, t, count);
        if (!periodic) check_equal(t->segments->inner, t->segments->n);
        for (int h = 0; h < s->n; h += 3) {
            solid_family_view(s, h, &view);
            for (int b = h % 5; b < view.n; b += 5) solid_family_break(s, h, b);
        }
        for (int g = 0; g < t->segments->n; g++) {
            stale += t->segments->stale[g];
            if (t->segments->stale[g]) solid_segments_pack(t, g);
            check_equal(t->segments->stale[g], 0);
        }
        check_above(stale, 10);
        check_tally(s, t, count);
        free(count);
        solid_free(s);
    }
}

/* A segment is marked as bulk if none of the bonds that it holds is corrected. */
static void bulk_segments(void **state) {
    (void)state;
    struct solid *s = make((struct make){.sites = {24, 18, 18}});
    const struct solid_lattice *t = s->family->lattice[0];
    int bulk = 0;
    for (int g = 0; g < t->segments->n; g++) {
        long at = t->segments->first[g];
        int corrected = 0;
        for (int strip = 0; strip < SOLID_STRIPS; strip++)
            for (int i = 0; i < t->segments->count[g][strip]; i++, at++)
                for (int k = 0; k < SOLID_ROW; k++) {
                    if (!(t->segments->entry[at] >> k & 1)) continue;
                    const long site = t->segments->cell[g] + solid_segments_strip_site(strip) + k;
                    const int h = t->local[site], l = t->local[site + t->offset[t->segments->entry[at] >> 8].shift];
                    const double full = t->stencil->full_volume * (1 - 1e-12);
                    corrected |= s->family_volume[h] < full || s->family_volume[l] < full;
                }
        check_equal(t->segments->bulk[g], !corrected);
        bulk += t->segments->bulk[g];
    }
    check_between(bulk, 10, t->segments->n / 2);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_bond_once), cmocka_unit_test(bulk_segments)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
