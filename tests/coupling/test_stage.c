/* The parts of a step, for every kind of stage that a scene can have. */
#include "base/par.h"
#include "coupling/stage.h"
#include "coupling/step.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <cmocka.h>

/* What a scene and its only stage say. */
struct kind {
    int fluid, implicit, automatic;
    int solid, elastic, reacts, refined, relaxed, raised, touches;
    int substeps; /* given; 0: automatic */
};

static unsigned needs_of(const struct kind *k) {
    struct scene_fluid fluid = {.diffusion = k->implicit ? SCENE_DIFFUSION_IMPLICIT : SCENE_DIFFUSION_EXPLICIT};
    struct scene_refinement refinement = {0};
    struct scene_solid solid = {.refinement = k->refined ? &refinement : NULL};
    struct scene_coupling coupling = {.load = k->reacts ? SCENE_LOAD_REACTION : SCENE_LOAD_PROBE};
    struct scene_stage stage = {.time_step = k->automatic ? 0 : 1e-3,
                                .solid = k->elastic ? SCENE_SOLID_ELASTIC : SCENE_SOLID_RIGID,
                                .relax = k->relaxed,
                                .increment = k->raised ? 0.1 : 0,
                                .substeps = k->substeps};
    const struct scene scene = {.fluid = k->fluid ? &fluid : NULL,
                                .solid = k->solid ? &solid : NULL,
                                .coupling = k->fluid && k->solid ? &coupling : NULL,
                                .stages = 1,
                                .stage = &stage};
    return stage_needs_of(&scene, 0, k->touches);
}

/* The names, with commas, as frana check prints them. */
static void parts_of(unsigned needs, char text[512]) {
    const struct step_part *part[RUN_PARTS_MAX];
    const int n = step_parts_of(needs, part);
    text[0] = '\0';
    for (int k = 0; k < n; k++) {
        assert_true(part[k]->run != NULL);
        snprintf(text + strlen(text), 512 - strlen(text), "%s%s", k ? ", " : "", part[k]->name);
    }
}

static void test_parts(void **state) {
    (void)state;
    static const struct {
        struct kind kind;
        const char *parts;
    } expected[] = {
        /* fluid alone */
        {{.fluid = 1}, "fluid"},
        {{.fluid = 1, .implicit = 1}, "fluid"},
        {{.fluid = 1, .automatic = 1}, "time step from the fluid's limits, fluid"},
        /* solid alone */
        {{.solid = 1, .elastic = 1}, "solid"},
        {{.solid = 1, .elastic = 1, .automatic = 1}, "solid"}, /* a step without a fluid is found once */
        {{.solid = 1, .elastic = 1, .touches = 1}, "contact, number of substeps, solid"},
        {{.solid = 1, .elastic = 1, .touches = 1, .substeps = 4}, "contact, solid"},
        {{.solid = 1, .elastic = 1, .refined = 1}, "refinement, solid"},
        {{.solid = 1, .elastic = 1, .refined = 1, .touches = 1}, "refinement, contact, number of substeps, solid"},
        {{.solid = 1, .elastic = 1, .relaxed = 1}, "relaxation"},
        {{.solid = 1, .elastic = 1, .relaxed = 1, .refined = 1, .touches = 1}, "relaxation"},
        {{.solid = 1, .elastic = 1, .relaxed = 1, .raised = 1, .touches = 1},
         "loads raised, relaxation and breakage in turn"},
        /* a rigid solid in the fluid: its markers are set once, before the first step */
        {{.fluid = 1, .solid = 1}, "fluid with forcing"},
        {{.fluid = 1, .solid = 1, .touches = 1}, "fluid with forcing"},
        {{.fluid = 1, .solid = 1, .automatic = 1}, "time step from the fluid's limits, fluid with forcing"},
        {{.fluid = 1, .solid = 1, .implicit = 1}, "fluid with forcing, implicit diffusion"},
        /* an elastic one, explicit scheme */
        {{.fluid = 1, .solid = 1, .elastic = 1},
         "markers, fluid with forcing, probe, solid, work of the loads, surface"},
        {{.fluid = 1, .solid = 1, .elastic = 1, .implicit = 1},
         "markers, fluid with forcing, implicit diffusion, probe, solid, work of the loads, surface"},
        {{.fluid = 1, .solid = 1, .elastic = 1, .touches = 1},
         "markers, fluid with forcing, probe, contact, number of substeps, solid, work of the loads, surface"},
        {{.fluid = 1, .solid = 1, .elastic = 1, .touches = 1, .substeps = 4},
         "markers, fluid with forcing, probe, contact, solid, work of the loads, surface"},
        {{.fluid = 1, .solid = 1, .elastic = 1, .automatic = 1},
         "time step from the fluid's limits, markers, fluid with forcing, probe, number of substeps, solid, work of "
         "the loads, surface"},
        {{.fluid = 1, .solid = 1, .elastic = 1, .automatic = 1, .touches = 1},
         "time step from the fluid's limits, markers, fluid with forcing, probe, contact, number of substeps, solid, "
         "work "
         "of the loads, surface"},
        /* the same, with the load by reaction */
        {{.fluid = 1, .solid = 1, .reacts = 1}, "fluid with forcing"},
        {{.fluid = 1, .solid = 1, .elastic = 1, .reacts = 1},
         "markers, fluid, forcing and solid, stage by stage, surface"},
        {{.fluid = 1, .solid = 1, .elastic = 1, .reacts = 1, .automatic = 1, .touches = 1},
         "time step from the fluid's limits, markers, contact, number of substeps, fluid, forcing and solid, stage by "
         "stage, surface"},
    };
    for (size_t k = 0; k < sizeof expected / sizeof *expected; k++) {
        char text[512];
        parts_of(needs_of(&expected[k].kind), text);
        assert_string_equal(text, expected[k].parts);
    }
}

/* The longest steps: of a stage of a given time in which cracks take fluid from the flow, and all comes to rest. */
static void test_longest(void **state) {
    (void)state;
    const unsigned needs = STAGE_FLUID | STAGE_AUTOMATIC_STEP | STAGE_ELASTIC | STAGE_IMMERSED | STAGE_CONTACT |
                           STAGE_AUTOMATIC_SUBSTEPS | STAGE_CRACK_FLUID | STAGE_SETTLING | STAGE_DURATION;
    char text[512];
    parts_of(needs, text);
    assert_string_equal(text, "time step from the fluid's limits, end of the duration, markers, volume given to "
                              "cracks, fluid with forcing, probe, mouths of cracks, contact, number of substeps, "
                              "damping, solid, work of the loads, cracks, surface");
}

/* How many of the names, NULL at the end, are parts. */
static int count(const struct step_part *const *part, int n, const char *const *name) {
    int found = 0;
    for (; *name; name++)
        for (int k = 0; k < n; k++) found += !strcmp(part[k]->name, *name);
    return found;
}

static void check_kind(const struct kind *k) {
    static const char *const fluid[] = {"fluid", "fluid with forcing", "fluid with forcing, implicit diffusion",
                                        "fluid, forcing and solid, stage by stage", NULL};
    static const char *const solid[] = {"relaxation", "solid", "fluid, forcing and solid, stage by stage", NULL};
    static const char *const load[] = {"probe", "fluid, forcing and solid, stage by stage", NULL};
    static const char *const length[] = {"time step from the fluid's limits", NULL};
    static const char *const surface[] = {"surface", NULL}, *const contact[] = {"contact", NULL};
    const struct step_part *part[RUN_PARTS_MAX];
    const int n = step_parts_of(needs_of(k), part), immersed = k->fluid && k->solid;
    assert_true(n > 0);
    for (int i = 0; i < n; i++)
        for (int j = 0; j < i; j++) assert_true(part[i] > part[j]); /* each once, in the box's order */
    assert_int_equal(count(part, n, fluid), k->fluid);
    assert_int_equal(count(part, n, solid), k->elastic);
    assert_int_equal(count(part, n, load), immersed && k->elastic);
    assert_int_equal(count(part, n, surface), immersed && k->elastic);
    assert_int_equal(count(part, n, contact), k->elastic && k->touches && !k->relaxed);
    assert_int_equal(count(part, n, length), k->fluid && k->automatic);
    if (immersed && k->elastic) assert_string_equal(part[n - 1]->name, "surface");
}

/* Every combination that the rules of a scene allow: what exists moves once, in the box's order. */
static void test_every_kind(void **state) {
    (void)state;
    int kinds = 0;
    for (int bits = 0; bits < 1 << 10; bits++) {
        const struct kind k = {.fluid = bits & 1,
                               .implicit = bits >> 1 & 1,
                               .automatic = bits >> 2 & 1,
                               .solid = bits >> 3 & 1,
                               .elastic = bits >> 4 & 1,
                               .refined = bits >> 5 & 1,
                               .relaxed = bits >> 6 & 1,
                               .touches = bits >> 7 & 1,
                               .substeps = bits >> 8 & 1,
                               .reacts = bits >> 9 & 1};
        const int immersed = k.fluid && k.solid, alone = k.solid && !k.fluid;
        if (!k.fluid && (!k.solid || k.implicit)) continue;
        if (alone && !k.elastic) continue; /* nothing would move */
        if (!k.solid && (k.elastic || k.touches || k.substeps)) continue;
        if (k.reacts && (!immersed || k.implicit)) continue;
        if ((k.refined || k.relaxed) && !alone) continue;
        check_kind(&k);
        kinds++;
    }
    assert_int_equal(kinds, 4 + 32 + 32 + 16); /* fluid alone; solid alone; loads by probes; by reaction */
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_parts), cmocka_unit_test(test_longest),
                                       cmocka_unit_test(test_every_kind)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
