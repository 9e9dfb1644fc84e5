/* The resolved scene reads back as the same scene. */
#include "base/par.h"
#include "base/text.h"
#include "tests/scene/scene_sample.h"
#include "tests/check.h"

/* Arrays are equal, or both NULL if empty. */
static void assert_same_array(const void *a, const void *b, int n, size_t size) {
    if (n > 0) assert_memory_equal(a, b, (size_t)n * size);
}

static void assert_same_time(const struct scene_time *a, const struct scene_time *b) {
    assert_int_equal(a->n, b->n);
    assert_same_array(a->point, b->point, a->n, sizeof *a->point);
    assert_same_array(a->t, b->t, a->n, sizeof *a->t);
    assert_same_array(a->factor, b->factor, a->n, sizeof *a->factor);
}

static void assert_same_corners(int n, const struct scene_corner *a, const struct scene_corner *b) {
    for (int i = 0; i < n; i++) {
        assert_memory_equal(a[i].at, b[i].at, sizeof a->at);
        assert_memory_equal(a[i].centre, b[i].centre, sizeof a->centre);
        assert_int_equal(a[i].turn, b[i].turn);
    }
}

static void assert_same_parts(int n, const struct scene_part *a, const struct scene_part *b) {
    for (int i = 0; i < n; i++) {
        assert_memory_equal(&a[i], &b[i], offsetof(struct scene_part, corner));
        assert_same_corners(a[i].corners, a[i].corner, b[i].corner);
    }
}

static void assert_same_body(const struct scene_body *a, const struct scene_body *b) {
    assert_memory_equal(a, b, offsetof(struct scene_body, own));
    assert_same_parts(1, &a->own, &b->own);
    assert_memory_equal(&a->image, &b->image, offsetof(struct scene_body, piece) - offsetof(struct scene_body, image));
    assert_same_parts(a->pieces, a->piece, b->piece);
    assert_same_parts(a->holes, a->hole, b->hole);
    assert_int_equal(a->outlines, b->outlines);
    for (int i = 0; i < a->outlines; i++) {
        check_equal(a->outline[i].corners, b->outline[i].corners);
        check_equal(a->outline[i].is_hole, b->outline[i].is_hole);
        assert_same_corners(a->outline[i].corners, a->outline[i].corner, b->outline[i].corner);
    }
}

static void assert_same_refinement(const struct scene_refinement *a, const struct scene_refinement *b) {
    assert_true(!a == !b);
    if (!a) return;
    assert_memory_equal(a, b, offsetof(struct scene_refinement, start));
    assert_same_array(a->start, b->start, a->starts, sizeof *a->start);
}

static void assert_same_element_free(const struct scene_element_free *a, const struct scene_element_free *b) {
    assert_true(!a == !b);
    if (!a) return;
    assert_memory_equal(a, b, offsetof(struct scene_element_free, growth));
    assert_true(!a->growth == !b->growth);
    if (a->growth) assert_memory_equal(a->growth, b->growth, sizeof *a->growth);
}

static void assert_same_solid(const struct scene_solid *s, const struct scene_solid *t) {
    assert_memory_equal(s, t, offsetof(struct scene_solid, element_free));
    assert_same_element_free(s->element_free, t->element_free);
    assert_memory_equal(&s->thickness, &t->thickness, /* numbers, and how many of each */
                        offsetof(struct scene_solid, material) - offsetof(struct scene_solid, thickness));
    assert_same_array(s->material, t->material, s->materials, sizeof *s->material);
    for (int b = 0; b < s->bodies; b++) assert_same_body(&s->body[b], &t->body[b]);
    for (int i = 0; i < s->cracks; i++) {
        assert_memory_equal(&s->crack[i], &t->crack[i], offsetof(struct scene_crack, point));
        assert_same_array(s->crack[i].point, t->crack[i].point, s->crack[i].points, sizeof *s->crack[i].point);
    }
    for (int i = 0; i < s->constraints; i++) {
        assert_memory_equal(&s->constraint[i], &t->constraint[i], offsetof(struct scene_constraint, time));
        assert_same_time(&s->constraint[i].time, &t->constraint[i].time);
    }
    assert_same_array(s->unbreakable, t->unbreakable, s->unbreakables, sizeof *s->unbreakable);
    for (int i = 0; i < s->loads; i++) {
        assert_memory_equal(&s->load[i], &t->load[i], offsetof(struct scene_load, time));
        assert_same_time(&s->load[i].time, &t->load[i].time);
    }
    assert_same_array(s->initial, t->initial, s->initials, sizeof *s->initial);
    assert_same_refinement(s->refinement, t->refinement);
    assert_memory_equal(s->body_force, t->body_force, sizeof s->body_force);
    check_equal(s->contact, t->contact);
    check_equal(s->contact_stiffness, t->contact_stiffness);
    check_equal(s->contact_exponent, t->contact_exponent);
    check_equal(s->contact_radius, t->contact_radius);
    check_equal(s->surface_correction, t->surface_correction);
    check_equal(s->precision, t->precision);
}

static void assert_same_output(const struct scene_output *a, const struct scene_output *b) {
    assert_memory_equal(a, b, offsetof(struct scene_output, crack));
    assert_true(!a->crack == !b->crack);
    if (a->crack) assert_memory_equal(a->crack, b->crack, sizeof *a->crack);
    assert_true(!a->probes == !b->probes);
    if (!a->probes) return;
    check_equal(a->probes->places, b->probes->places);
    check_equal(a->probes->every, b->probes->every);
    assert_same_array(a->probes->at, b->probes->at, a->probes->places, sizeof *a->probes->at);
}

/* The same numbers in all that both hold. */
static void assert_same(const struct scene *a, const struct scene *b) {
    assert_string_equal(a->resolved, b->resolved);
    assert_string_equal(a->title, b->title);
    assert_memory_equal(&a->domain, &b->domain, sizeof a->domain);
    assert_same_output(&a->output, &b->output);
    assert_int_equal(a->dimension, b->dimension);
    assert_true(!a->fluid == !b->fluid && !a->solid == !b->solid && !a->coupling == !b->coupling);
    if (a->fluid) assert_memory_equal(a->fluid, b->fluid, sizeof *a->fluid);
    if (a->coupling) assert_memory_equal(a->coupling, b->coupling, sizeof *a->coupling);
    assert_int_equal(a->stages, b->stages);
    assert_memory_equal(a->stage, b->stage, (size_t)a->stages * sizeof *a->stage);
    if (!a->solid) return;
    const struct scene_solid *s = a->solid, *t = b->solid;
    assert_same_solid(s, t);
}

static void test_resolved_says_the_same(void **state) {
    (void)state;
    const char *const name[] = {SCENES "coupled.yaml",
                                SCENES "fluid.yaml",
                                SCENES "solid.yaml",
                                SCENES "plate.yaml",
                                SCENES "growing.yaml",
                                SCENES "pulled.yaml",
                                SCENES "block.yaml",
                                FRANA_SOURCE_DIR "/cases/porous_channel/s1.yaml",
                                FRANA_SOURCE_DIR "/cases/channel/scene.yaml",
                                FRANA_SOURCE_DIR "/cases/bar/scene.yaml",
                                FRANA_SOURCE_DIR "/cases/sphere_array/scene.yaml"};
    for (size_t i = 0; i < sizeof name / sizeof *name; i++) {
        struct scene *s = scene_new(name[i], 0, NULL);
        struct scene_problems problems = {0};
        struct scene *again = scene_read("elsewhere.yaml", s->resolved, strlen(s->resolved), 0, NULL, 1, &problems);
        assert_int_equal(problems.n, 0);
        assert_same(s, again);
        scene_free(s);
        scene_free(again);
    }
}

static void test_texts_survive_the_resolved_scene(void **state) {
    (void)state;
    const char *const title[] = {"plain",          "'it''s: \"quoted\" # no remark'", "\"true\"", "\"12\"",
                                 "\"two: lines\"", "\"\\u0394x = \\u03bb\"",          "'- dash'", "\"  blanks  \""};
    const char *const is[] = {
        "plain",     "it's: \"quoted\" # no remark", "true", "12", "two: lines", "\u0394x = \u03bb", "- dash",
        "  blanks  "};
    char *sample = sample_text(SCENES "fluid.yaml");
    for (size_t i = 0; i < sizeof title / sizeof *title; i++) {
        char *text = text_new("title: %s\n%s", title[i], sample);
        struct scene_problems problems, none;
        struct scene *s = sample_read(text, 0, NULL, &problems);
        assert_non_null(s);
        assert_string_equal(s->title, is[i]);
        struct scene *again = sample_read(s->resolved, 0, NULL, &none);
        assert_non_null(again);
        assert_same(s, again);
        scene_free(s);
        scene_free(again);
        free(text);
    }
    free(sample);
}

/* Ranks above 0 read the resolved scene: all is there as in the file itself. */
static void test_plates_on_ranks(void **state) {
    (void)state;
    struct scene *s = scene_new(SCENES "plate.yaml", 0, NULL);
    char *text = sample_text(SCENES "plate.yaml");
    struct scene_problems problems;
    struct scene *here = sample_read(text, 0, NULL, &problems);
    assert_non_null(here);
    assert_same(here, s);
    scene_free(here);
    scene_free(s);
    free(text);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_resolved_says_the_same),
                                       cmocka_unit_test(test_texts_survive_the_resolved_scene),
                                       cmocka_unit_test(test_plates_on_ranks)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
