/* The record of broken-bond pairs: every bond that broke, once; and the list of those near each other. */
#include "solid/bonds/ghosts.h"
#include "solid/contact/contact.h"
#include "solid/contact/list.h"
#include "solid/law/material.h"
#include "solid/solid.h"
#include "solid/surface/surface.h"
#include "tests/solid/test_surface_bodies.h"
#include "tests/check.h"

static struct solid *block(int general) {
    const struct solid_body body = bodies_box(0, 0, 0, 6, 5, 5);
    struct solid_input in = bodies_input(1, &body);
    struct solid_material brittle = bodies_material;
    brittle.fracture_energy = 1;
    in.material = &brittle;
    in.contact = 1;
    in.general_bonds = general;
    struct solid *s = solid_new(&in);
    s->stage.breakage = 1;
    return s;
}

/* The record holds each broken bond once, as h < l. */
static void check_record(const struct solid *s) {
    static struct solid_family_view view;
    const struct solid_contact *c = s->contact;
    uint8_t *times = calloc((size_t)s->n * (size_t)s->n, 1);
    for (int k = 0; k < c->broken; k++) {
        check_below(c->broken_h[k], c->broken_l[k]);
        times[c->broken_h[k] * s->n + c->broken_l[k]]++;
    }
    for (int h = 0; h < s->n; h++) {
        solid_family_view(s, h, &view);
        for (int b = 0; b < view.n; b++)
            if (view.l[b] > h) check_equal(times[h * s->n + view.l[b]], !view.intact[b]);
    }
    free(times);
}

/* The owned pairs listed are those of the record nearer than reach. */
static void check_list(const struct solid *s, double reach) {
    const struct solid_contact *c = s->contact;
    const struct solid_contact_pairs *p = &c->pairs[SOLID_CONTACT_OWNED];
    int near = 0;
    for (int k = 0; k < c->broken; k++) {
        double x[3], r2 = 0;
        solid_relative(s, c->broken_h[k], c->broken_l[k], x);
        for (int i = 0; i < 3; i++) r2 += x[i] * x[i];
        near += r2 < reach * reach;
    }
    check_equal(p->n, near);
    for (int k = 0; k < p->n; k++)
        for (int i = 0; i < 3; i++) check_close(p->xi[i][k], s->x0[i][p->h[k]] - s->x0[i][p->l[k]], 1e-9 * SPACING);
}

/* A cut before contact exists is scanned; later breaks are news; a search without news adds nothing. */
static void recorded_once(void **state) {
    (void)state;
    for (int general = 0; general < 2; general++) {
        struct solid *s = block(general);
        struct solid_surface *surface = solid_surface_new(s);
        static struct solid_family_view view;
        bodies_cut_short(s, 0, 3, 1.5 * SPACING);
        solid_contact_update(s);
        assert_non_null(s->contact);
        struct solid_contact *c = s->contact;
        const int first = c->broken;
        check_above(first, 50);
        check_record(s);
        check_list(s, c->radius + c->skin);
        const long record = c->record;
        solid_contact_broken_update(s, c, 0);
        check_equal(c->broken, first);
        check_equal(c->record, record);
        for (int h = 0; h < s->n; h += 11) {
            solid_family_view(s, h, &view);
            if (view.intact[h % view.n]) solid_family_break(s, h, h % view.n);
        }
        solid_contact_broken_update(s, c, 0);
        check_above(c->broken, first + 5);
        check_above(c->record, record);
        check_record(s);
        check_list(s, c->radius + c->skin);
        solid_surface_free(surface);
        solid_contact_free(s);
        solid_free(s);
    }
}

/* Once the halves have moved apart, the record stays and nothing is near. */
static void listed_if_near(void **state) {
    (void)state;
    struct solid *s = block(0);
    struct solid_surface *surface = solid_surface_new(s);
    bodies_cut(s, 0, 3);
    solid_contact_update(s);
    struct solid_contact *c = s->contact;
    struct solid_contact_pairs *p = &c->pairs[SOLID_CONTACT_OWNED];
    const int broken = c->broken;
    check_above(p->n, 0);
    for (int way = 0; way < 2; way++) {
        bodies_open(s, 0, 3, (way ? 0.1 : 2) * SPACING);
        solid_ghosts_update(s);
        p->n = 0;
        solid_contact_broken_list(s, c);
        if (way) check_above(p->n, 20);
        check_list(s, c->radius + c->skin);
        check_equal(c->broken, broken);
        check_record(s);
    }
    solid_surface_free(surface);
    solid_contact_free(s);
    solid_free(s);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(recorded_once), cmocka_unit_test(listed_if_near)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
