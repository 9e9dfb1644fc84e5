/* Translation of a scene into the solid's input; plates, point files and lists of spheres that are refused. */
#include "base/die.h"
#include "base/par.h"
#include "coupling/setup/forecast.h"
#include "coupling/setup/setup.h"
#include "fluid/grid/side.h"
#include "physics/micromodulus.h"
#include "scene/check/check.h"
#include "scene/keys/key.h"
#include "solid/geometry/shape.h"
#include "tests/leaves.h"

#include <stdarg.h>
#include <stddef.h>
#include <setjmp.h>
#include <stdint.h>
#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SCENES FRANA_SOURCE_DIR "/tests/scene/scenes/"

static void test_a_plate(void **state) {
    (void)state;
    struct scene *s = scene_new(SCENES "plate.yaml", 0, NULL);
    struct solid_input *in = setup_solid(s);
    check_equal(in->model, PHYSICS_PLANE_STRESS);
    check_equal(in->thickness, 0.002);
    check_equal(in->partial, SOLID_PARTIAL_RAMP);
    check_equal(in->horizons, SOLID_ONE_SIDED);
    check_equal(in->origin[0], 0.25 * 0.001);
    check_equal(in->origin[1], -0.5 * 0.001);
    check_equal(in->origin[2], 0);
    check_equal(in->material[0].micromodulus, PHYSICS_CONICAL);
    check_equal(in->material[1].micromodulus, PHYSICS_CONSTANT);
    check_equal(in->cuts, 1);
    check_equal(in->cut[0].points, 3);
    check_equal(in->cut[0].point[2][1], 0.021);
    const struct solid_body *plate = &in->body[0];
    check_equal(plate->shape, SOLID_POLYGON);
    check_equal(plate->outlines, 4);
    check_equal(plate->outline[0].corners, 6);
    check_equal(plate->outline[0].turn[2], 1);
    check_equal(plate->outline[0].centre[2][0], 0.07);
    assert_false(plate->outline[1].is_hole);
    assert_true(plate->outline[2].is_hole);
    check_equal(plate->outline[3].turn[1], -1);
    check_equal(in->body[1].shape, SOLID_POLYGON);
    check_equal(in->body[1].outlines, 2); /* a disc with a hole */
    check_equal(in->body[2].shape, SOLID_POLYGON);
    check_equal(in->body[2].outlines, 1); /* a rectangle */
    const struct solid_body *grains = &in->body[3];
    check_equal(grains->shape, SOLID_POINTS);
    check_equal(grains->points, 2);
    check_equal(grains->outlines, 0);
    check_equal(grains->point[0][1], 0.0635);
    check_equal(grains->point[1][1], 0.0005);
    assert_false(grains->point[2]);
    check_equal(grains->point_volume[0], 1e-6);
    check_equal(grains->point_horizon[1], 3e-3);
    check_equal(in->constraint[0].direction[1], 1);
    check_equal(in->constraint[0].direction[0], 0);
    setup_solid_free(in);
    scene_free(s);
}

static void test_a_block(void **state) {
    (void)state;
    struct scene *s = scene_new(SCENES "block.yaml", 0, NULL);
    struct solid_input *in = setup_solid(s);
    check_equal(in->model, PHYSICS_3D);
    check_equal(in->origin[0], 0.5 * 0.001);
    check_equal(in->origin[2], 0);
    check_equal(in->partial, SOLID_PARTIAL_EXACT);
    check_equal(in->horizons, SOLID_DUAL_HORIZON);
    check_equal(in->body[0].shape, SOLID_BOX);
    check_equal(in->cuts, 1);
    check_equal(in->cut[0].points, 4);
    setup_solid_free(in);
    scene_free(s);
    const char *const moving[] = {"solid.bodies[0].velocity=[1, -2, 3]"};
    s = scene_new(SCENES "block.yaml", 1, moving);
    in = setup_solid(s);
    for (int c = 0; c < 3; c++) check_equal(in->body[0].velocity[c], (c == 1 ? -1 : 1) * (c + 1));
    setup_solid_free(in);
    scene_free(s);
    s = scene_new(SCENES "solid.yaml", 0, NULL); /* its points have no horizon */
    in = setup_solid(s);
    check_equal(in->body[0].points, 2);
    check_equal(in->body[0].point[2][0], 0.0005);
    assert_false(in->body[0].point_horizon);
    check_equal(in->body[0].point_volume[1], 1e-9);
    setup_solid_free(in);
    scene_free(s);
}

static const char *micromodulus_name(int kind) { return physics_micromodulus_of(kind)->name; }

static const char *side_name(int kind) { return fluid_side_kind_of((enum fluid_side_type)kind)->name; }

static const char *shape_name(int kind) {
    return solid_shape_of(&(struct solid_body){.shape = (enum solid_shape)kind})->name;
}

/* A scene's words are the names in the tables of laws, shapes and sides, one for each line. */
static void test_words(void **state) {
    (void)state;
    static const struct {
        const char *key;
        const char *(*name)(int kind);
        int lines;
    } table[] = {{"solid.materials[0].micromodulus", micromodulus_name, PHYSICS_MICROMODULI},
                 {"fluid.sides.x_low.type", side_name, FLUID_SIDE_TYPES},
                 {"solid.bodies[0].shape", shape_name, SOLID_SHAPES}};
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) {
        const struct scene_value *v = &scene_key_find(table[k].key, NULL)->value;
        int found = 0;
        for (int i = 0; i < v->most; i++) {
            const char *word = v->words[i].word, *name = table[k].name(v->words[i].value);
            if (strcmp(word, name) && strcmp(name, "polygon")) fail_msg("%s in a scene, %s in the table", word, name);
            found += !strcmp(word, name);
        }
        if (found != table[k].lines)
            fail_msg("%s: %d words in scene/keys for %d lines of the table", table[k].key, found, table[k].lines);
    }
}

/* Scene and solid know the same bounds of a shape. */
static void test_bounds(void **state) {
    (void)state;
    const char *const set[] = {
        "solid.bodies.ball={name: egg, material: glass, shape: ellipsoid, centre: [0.03, 0.01, 0.01], radii: [0.004, "
        "0.003, 0.005]}",
        "solid.bodies.rod={name: rods, material: glass, shape: spheres, spheres: [[0.005, 0.01, 0.01, 0.002], [0.006, "
        "0.012, 0.001, 0.003]]}"};
    struct scene *s = scene_new(SCENES "coupled.yaml", 2, set);
    struct solid_input *in = setup_solid(s);
    assert_true(in->body[1].shape == SOLID_ELLIPSOID && in->body[1].radii[1] == 0.003);
    assert_true(in->body[2].shape == SOLID_SPHERES && in->body[2].entries == 2);
    for (int b = 0; b < in->bodies; b++) {
        double low[3], high[3], low2[3], high2[3];
        assert_true(scene_check_body_bounds(&s->solid->body[b], low, high));
        solid_shape_of(&in->body[b])->bounds(&in->body[b], low2, high2);
        for (int c = 0; c < 3; c++) assert_true(low[c] == low2[c] && high[c] == high2[c]);
    }
    setup_solid_free(in);
    scene_free(s);
}

/* Turned shapes: the bounds of both, the same; edges from axis and angle or from two directions; the centre stays where
 * no point is given. Turned by a right angle a box is the box with its sides exchanged, to the bit. */
static void test_turned(void **state) {
    (void)state;
    const char *const set[] = {
        "solid.bodies[0]={name: block, material: glass, shape: box, low: [0.0078125, 0, 0.00390625], "
        "high: [0.015625, 0.015625, 0.01171875], "
        "rotation: {axis: [0, 0, -2], angle: 270}}",
        "solid.bodies.ball={name: egg, material: glass, shape: ellipsoid, centre: [0.03, 0.01, 0.01], radii: [0.004, "
        "0.003, 0.005], rotation: {axis: [1, 2, 3], angle: 40, about: [0.02, 0.01, 0.01]}}",
        "solid.bodies.rod={name: rod, material: glass, shape: cylinder, centre: [0.01, 0.01, 0.01], radius: 0.002, "
        "length: 0.01, axis: x, rotation: {axes: [[1, 1, 1], [-1, 1, 0]]}}",
        "solid.constraints[0].high=[0.04, 0.01, 0.02]", "solid.unbreakable[0].high=[0.04, 0.01, 0.02]"};
    struct scene *s = scene_new(SCENES "coupled.yaml", 5, set);
    struct solid_input *in = setup_solid(s);
    double low[3], high[3];
    for (int b = 0; b < 3; b++) {
        double low2[3], high2[3];
        assert_true(in->body[b].turn.is_turned);
        assert_true(scene_check_body_bounds(&s->solid->body[b], low, high));
        solid_shape_of(&in->body[b])->bounds(&in->body[b], low2, high2);
        for (int c = 0; c < 3; c++) {
            check_close(low[c], low2[c], 1e-15);
            check_close(high[c], high2[c], 1e-15);
        }
    }
    scene_check_body_bounds(&s->solid->body[0], low, high);
    check_equal(low[0], 0.01171875 - 0.0078125);
    check_equal(high[0], 0.01171875 + 0.0078125);
    check_equal(low[1], 0.0078125 - 0.00390625);
    check_equal(high[1], 0.0078125 + 0.00390625);
    check_equal(high[2], 0.01171875);
    check_equal(in->body[0].turn.edge[0][1], 1);
    for (int c = 0; c < 3; c++) check_close(in->body[2].turn.edge[0][c], 1 / sqrt(3), 1e-15);
    check_close(in->body[2].turn.edge[2][2], 2 / sqrt(6), 1e-15);
    check_equal(in->body[1].turn.about[0], 0.02);
    check_equal(in->body[2].turn.about[1], 0.01);
    setup_solid_free(in);
    scene_free(s);
    const char *const plate[] = {"solid.bodies.grains={name: g, material: glass, shape: rectangle, low: [0.01, 0.01], "
                                 "high: [0.02, 0.03], rotation: {angle: 90, about: [0.01, 0.01]}}",
                                 "solid.constraints[0].rotation={angle: 30}"};
    s = scene_new(SCENES "plate.yaml", 2, plate);
    in = setup_solid(s);
    check_equal(in->body[3].outline[0].corner[1][0], 0.01);
    check_equal(in->body[3].outline[0].corner[1][1], 0.02);
    check_close(in->constraint[0].turn.edge[0][1], 0.5, 1e-15);
    check_equal(in->constraint[0].turn.about[0], (in->constraint[0].low[0] + in->constraint[0].high[0]) / 2);
    setup_solid_free(in);
    scene_free(s);
}

/* Pieces and holes of a body in 3D, and lists from files; the bounds are those of the body with its pieces. */
static void test_parts(void **state) {
    (void)state;
    char path[] = "/tmp/spheres_XXXXXX", set[1024];
    FILE *out = fdopen(mkstemp(path), "w");
    fputs("# a list\n0.001 0.002 0.003 0.0004\n\n0.005,0.006,0.007, 0.001 0.002 0.003 # an ellipsoid\n", out);
    fclose(out);
    snprintf(
        set, sizeof set,
        "solid.bodies.ball={name: ball, material: glass, shape: sphere, centre: [0.03, 0.01, 0.01], radius: 0.004, "
        "pieces: [{shape: box, low: [0.02, 0, 0.001], high: [0.03, 0.01, 0.01]}], holes: [{shape: spheres, file: "
        "%s}, {shape: cylinder, centre: [0.03, 0.01, 0.01], radius: 0.001, length: 0.03, axis: y}, {shape: "
        "ellipsoid, centre: [0, 0, 0], radii: [1, 2, 3]}], contacts: broken}",
        path);
    struct scene *s = scene_new(SCENES "coupled.yaml", 1, (const char *const[]){set});
    struct solid_input *in = setup_solid(s);
    unlink(path);
    const struct solid_body *body = &in->body[1];
    check_equal(body->contacts_broken, 1);
    check_equal(in->body[0].contacts_broken, 0);
    check_equal(body->parts, 4);
    check_equal(body->part[0].shape, SOLID_BOX);
    check_equal(body->part[0].high[2], 0.01);
    check_equal(body->part[0].is_hole, 0);
    for (int p = 1; p < 4; p++) check_equal(body->part[p].is_hole, 1);
    check_equal(body->part[1].entries, 2);
    check_equal(body->part[1].entry[0][4], 0.0004);
    check_equal(body->part[1].entry[1][0], 0.005);
    check_equal(body->part[1].entry[1][5], 0.003);
    check_equal(body->part[2].axis, 1);
    check_equal(body->part[2].length, 0.03);
    check_equal(body->part[3].radii[1], 2);
    double low[3], high[3];
    assert_true(scene_check_body_bounds(&s->solid->body[1], low, high));
    check_equal(low[0], 0.02);
    check_equal(low[1], 0);
    check_equal(high[0], 0.03 + 0.004);
    setup_solid_free(in);
    scene_free(s);
}

static struct scene *checked(void *with) {
    const struct leaves_scene *r = with;
    struct scene *s = scene_new(r->path, r->n, r->set);
    setup_check(s);
    forecast_check(s);
    return s;
}

static void check_scene(void *with) { checked(with); }
static void make_solid(void *with) { setup_solid(checked(with)); }

static int leaves_with(const char *path, int n, const char *const *set, int whole, char *said, size_t size) {
    return leaves(whole ? make_solid : check_scene, &(struct leaves_scene){path, n, set}, said, size);
}

static void test_plates_that_bound_no_body(void **state) {
    (void)state;
    static const char *const fault[][2] = {
        {"solid.bodies.plate.outline=[[0, 0], [0.05, 0.04], [0.05, 0], [0, 0.04]]",
         "solid.bodies[0] (plate): outline 1 crosses or touches itself"},
        {"solid.bodies.ring.holes[0].high=[0.1, 0.032]", "solid.bodies[1] (ring): outlines 1 and 2 cross or touch"},
        {"solid.bodies.ring.holes=[{shape: disc, centre: [0.05, 0.01], radius: 0.001}]",
         "(outline 1 is the body's own, 2 its hole)"},
        {"solid.cracks.notch.points=[[0.065, 0.0325], [0.068, 0.0325]]",
         "solid.cracks[0]: no part of it lies in a body"}};
    char said[4096], sentence[4096];
    for (size_t i = 0; i < sizeof fault / sizeof *fault; i++) {
        /* without the points, whose shape is not known */
        const char *const set[] = {fault[i][0], "solid.bodies.grains={name: grains, material: glass, shape: "
                                                "disc, centre: [0.068, 0.037], radius: 0.001}"};
        const int code = leaves_with(SCENES "plate.yaml", 2, set, 0, said, sizeof said);
        snprintf(sentence, sizeof sentence, "%s", said);
        if (code != EXIT_CODE_SCENE || !strstr(said, fault[i][1]) || strchr(said, '\n') != strrchr(said, '\n'))
            fail_msg("%s: exit %d, \"%s\"", fault[i][0], code, sentence);
    }
    assert_int_equal(leaves_with(SCENES "plate.yaml", 0, NULL, 1, said, sizeof said), 0);
    assert_string_equal(said, "");
}

static void test_more_than_the_memory(void **state) {
    (void)state;
    static const char *const fault[][3] = {
        {SCENES "coupled.yaml", "domain.cells=[40000, 20000, 20000]",
         "domain.cells: 1.6e+13 cells take 1.02e+06 GB of"},
        {SCENES "plate.yaml", "solid.spacing=1e-9", "solid.bodies.plate: "}, /* a polygon with a piece and holes */
        {SCENES "plate.yaml", "solid.spacing=1e-9", "particles of spacing 1e-09 m take"}};
    char said[4096];
    for (size_t i = 0; i < sizeof fault / sizeof *fault; i++) {
        const int code = leaves_with(fault[i][0], 1, &fault[i][1], 0, said, sizeof said);
        if (code != EXIT_CODE_SCENE || !strstr(said, fault[i][2]) || strchr(said, '\n') != strrchr(said, '\n'))
            fail_msg("%s: exit %d, \"%s\"", fault[i][1], code, said);
    }
}

static void test_broken_point_files(void **state) {
    (void)state;
    static const char *const file[][2] = {
        {"", "holds no line x y area, or x y area horizon (as in 0.01 0.02 1e-6)"},
        {"0.06 0.03 1e-6\n0.07 0.03\n",
         "line 2 is not the numbers x y area, or x y area horizon (as in 0.01 0.02 1e-6)"},
        {"0.06 0.03 1e-6 1 1\n", "line 1 is not the numbers x y area, or x y area horizon (as in 0.01 0.02 1e-6)"},
        {"0.06 0.03 1e-6\n\n0.07 0.03 much\n",
         "line 3 is not the numbers x y area, or x y area horizon (as in 0.01 0.02 1e-6)"},
        {"0.06 0.03 1e-6 3e-3\n0.07 0.03 1e-6\n", "line 2 has no horizon, unlike those before it"},
        {"0.06 0.03 1e-6\n0.07 0.03 1e-6 3e-3\n", "line 2 has a horizon, unlike those before it"},
        {"0.06 0.03 0\n", "line 1: area and horizon must be greater than 0 and everything finite"},
        {"0.06 nan 1e-6\n", "line 1: area and horizon must be greater than 0 and everything finite"}};
    char path[] = "/tmp/points_XXXXXX", set[64], said[4096];
    close(mkstemp(path));
    snprintf(set, sizeof set, "solid.bodies.grains.file=%s", path);
    for (size_t i = 0; i < sizeof file / sizeof *file; i++) {
        FILE *out = fopen(path, "w");
        fputs(file[i][0], out);
        fclose(out);
        const int code = leaves_with(SCENES "plate.yaml", 1, (const char *const[]){set}, 1, said, sizeof said);
        if (code != EXIT_CODE_SCENE || strchr(said, '\n') != strrchr(said, '\n') || !strstr(said, file[i][1])) {
            unlink(path);
            fail_msg("%s: exit %d, \"%s\"", file[i][0], code, said);
        }
    }
    unlink(path);
}

static void test_broken_lists(void **state) {
    (void)state;
    static const char *const file[][2] = {
        {"", "holds no line x y z radius, or x y z and three radii"},
        {"# nothing\n\n", "holds no line x y z radius, or x y z and three radii"},
        {"0.03 0.01 0.01 0.001\n0.03 0.01 0.001\n",
         "line 2 is not the numbers x y z radius, or x y z and three radii (as in 0.01 0.02 0.03 0.004)"},
        {"0.03 0.01 0.01 0.001 0.001\n",
         "line 1 is not the numbers x y z radius, or x y z and three radii (as in 0.01 0.02 0.03 0.004)"},
        {"0.03 0.01 0.01 1 2 3 4\n",
         "line 1 is not the numbers x y z radius, or x y z and three radii (as in 0.01 0.02 0.03 0.004)"},
        {"1 2 3 4 5 6 7 8 9 10\n",
         "line 1 is not the numbers x y z radius, or x y z and three radii (as in 0.01 0.02 0.03 0.004)"},
        {"x y z r\n", "line 1 is not the numbers x y z radius, or x y z and three radii (as in 0.01 0.02 0.03 0.004)"},
        {"\n0.03 0.01 0.01 -0.001\n", "line 2: radii must be greater than 0 and everything finite"},
        {"0.03 0.01 0.01 0.001 0 0.001\n", "line 1: radii must be greater than 0 and everything finite"},
        {"0.03 nan 0.01 0.001\n", "line 1: radii must be greater than 0 and everything finite"},
        {"0.03 0.01 0.01 inf\n", "line 1: radii must be greater than 0 and everything finite"}};
    char path[] = "/tmp/spheres_XXXXXX", set[128], sentence[256], said[4096];
    close(mkstemp(path));
    snprintf(set, sizeof set, "solid.bodies.ball={name: ball, material: glass, shape: spheres, file: %s}", path);
    for (size_t i = 0; i < sizeof file / sizeof *file; i++) {
        FILE *out = fopen(path, "w");
        fputs(file[i][0], out);
        fclose(out);
        const int code = leaves_with(SCENES "coupled.yaml", 1, (const char *const[]){set}, 1, said, sizeof said);
        snprintf(sentence, sizeof sentence, "%s: %s\n", path, file[i][1]);
        if (code != EXIT_CODE_SCENE || !strstr(said, sentence) || strchr(said, '\n') != strrchr(said, '\n')) {
            unlink(path);
            fail_msg("%s: exit %d, \"%s\"", file[i][0], code, said);
        }
    }
    unlink(path);
    const int code = leaves_with(SCENES "coupled.yaml", 1, (const char *const[]){set}, 1, said, sizeof said);
    if (code != EXIT_CODE_SCENE || !strstr(said, "there is no such file")) fail_msg("exit %d, \"%s\"", code, said);
}

int main(int argc, char **argv) {
    /* forks: before MPI has begun, and on one rank */
    const char *of_open_mpi = getenv("OMPI_COMM_WORLD_SIZE"), *ranks = of_open_mpi ? of_open_mpi : getenv("PMI_SIZE");
    int failed = 0;
    if (!ranks || atoi(ranks) == 1) {
        const struct CMUnitTest leaving[] = {
            cmocka_unit_test(test_plates_that_bound_no_body), cmocka_unit_test(test_more_than_the_memory),
            cmocka_unit_test(test_broken_point_files), cmocka_unit_test(test_broken_lists)};
        failed = cmocka_run_group_tests(leaving, NULL, NULL);
    }
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_a_plate), cmocka_unit_test(test_a_block),
                                       cmocka_unit_test(test_words),   cmocka_unit_test(test_bounds),
                                       cmocka_unit_test(test_turned),  cmocka_unit_test(test_parts)};
    failed += cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
