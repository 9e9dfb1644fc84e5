/* The scenes of a calibration are scenes, lie on the lattice as they should, and their tables are read right. */
#include "base/par.h"
#include "base/files/folder.h"
#include "program/calibrate/measure.h"
#include "program/calibrate/scenes.h"
#include "tests/check.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

static const char work[] = FRANA_BINARY_DIR "/tests/program/calibrate_tables";

static struct calibrate_sample sample_of(enum physics_model model, double m, double length) {
    return (struct calibrate_sample){.model = model, .m = m, .length = length, .correction = SOLID_CORRECTION_ENERGY};
}

static struct scene *scene_of(const struct calibrate_scene *c) {
    char path[FOLDER_PATH];
    folder_path(path, work, "scene.yaml");
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    calibrate_scenes_write(f, c);
    fclose(f);
    return scene_new(path, 0, NULL); /* dies on a mistake */
}

/* Every kind in every model: the bonds are the sample's, and so are the regions. */
static void each_scene_is_one(void **state) {
    (void)state;
    const enum physics_model model[] = {PHYSICS_3D, PHYSICS_PLANE_STRESS, PHYSICS_PLANE_STRAIN};
    for (int k = 0; k < 3; k++)
        for (int soft = 0; soft < 2; soft++)
            for (int kind = CALIBRATE_RUNNING; kind <= CALIBRATE_BAR; kind++)
                for (int turned = 0; turned < (kind <= CALIBRATE_CREEPING ? 3 : 1); turned++) {
                    const struct calibrate_sample sample = sample_of(model[k], 2.5, soft * 6.);
                    const struct calibrate_scene c = {&sample, (enum calibrate_kind)kind,
                                                      (const double[]){0, 20, 45}[turned], 1};
                    struct scene *s = scene_of(&c);
                    const struct scene_material *material = &s->solid->material[0];
                    assert_int_equal(s->solid->model, model[k]);
                    assert_int_equal(material->breakage, soft ? SCENE_BILINEAR : SCENE_BRITTLE);
                    check_equal(material->horizon_ratio, 2.5);
                    check_close(material->fracture_energy, calibrate_sample_g0(&sample), 1e-11 * 1e-5);
                    if (soft) check_close(material->fracture_energy / pow(material->tensile_strength, 2), 6, 1e-9);
                    assert_true(s->solid->constraints >= 2 && s->solid->unbreakables >= 2);
                    assert_int_equal(s->solid->cracks, kind != CALIBRATE_BAR);
                    scene_free(s);
                }
}

/* A strip that is strained by its clamps holds what is asked for: G0 = stiffness e^2/2 times its free height. */
static void a_strip_holds_what_is_asked(void **state) {
    (void)state;
    const double stiffness[] = {1.2, 9. / 8, 1.2}; /* C11, in plane stress E/(1 - nu^2), nu = 1/3 */
    for (int model = PHYSICS_3D; model < PHYSICS_MODELS; model++) {
        const struct calibrate_sample sample = sample_of((enum physics_model)model, 3, 0);
        const struct calibrate_scene c = {&sample, CALIBRATE_RUNNING, 0, 1.5};
        const struct calibrate_sizes z = calibrate_sample_sizes(&c);
        const double height = z.height - 2 * z.clamp, strain = 2 * z.half_opening / height;
        check_close(0.5 * stiffness[model] * strain * strain * height / calibrate_sample_g0(&sample), 1.5, 1e-12);
    }
}

/* Along the strip and back; the middle line runs between two rows of the lattice along [100] and [110]. */
static void a_strip_lies_between_rows(void **state) {
    (void)state;
    const struct calibrate_sample sample = sample_of(PHYSICS_PLANE_STRESS, 3, 0);
    for (int k = 0; k < 4; k++) {
        const double degrees[] = {0, 15, 30, 45};
        const struct calibrate_scene c = {&sample, CALIBRATE_RUNNING, degrees[k], 1};
        const struct calibrate_frame w = calibrate_scenes_frame(&c);
        double along, across, least = INFINITY;
        calibrate_scenes_local(&w, w.centre, &along, &across);
        check_close(along, 0.5 * w.length, 1e-12);
        check_close(across, 0, 1e-12);
        calibrate_scenes_local(&w, (const double[]){w.centre[0] + 3 * w.cos, w.centre[1] + 3 * w.sin}, &along, &across);
        check_close(along, 0.5 * w.length + 3, 1e-12);
        check_close(across, 0, 1e-12);
        for (int i = 0; i < 60; i++)
            for (int j = 0; j < 160; j++) {
                calibrate_scenes_local(&w, (const double[]){i + 0.5, j + 0.5}, &along, &across);
                least = fmin(least, fabs(across));
            }
        if (k == 0) check_close(least, 0.5, 1e-9);
        if (k == 3) check_close(least, 0.5 / sqrt(2), 1e-9);
    }
}

static void table(const char *name, const char *head, int rows, const char *format, double (*row)(int, int)) {
    char path[FOLDER_PATH];
    folder_path(path, work, name);
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fprintf(f, "%s", head);
    for (int i = 0; i < rows; i++) fprintf(f, format, row(i, 0), row(i, 1), row(i, 2), row(i, 3), row(i, 4));
    fclose(f);
}

/* A tip that goes 1 a row at 45 degrees, 3 to the left of the cut for each 100 of way; 1.25 G0 of the energy are lost,
 * 0.25 of them damped, bonds take 1.5. */
static struct calibrate_frame frame;
static double unit, from;
static double energies(int i, int c) {
    const double way = from - 10 + i;
    return c == 0   ? 5 * (i + 1)
           : c == 1 ? -1.25 * unit * way + 7
           : c == 2 ? 0.25 * unit * way
           : c == 3 ? 1.5 * unit * way
                    : 0;
}
static double tips(int i, int c) {
    const double along = from - 10 + i - 0.5 * frame.length, across = 0.03 * i;
    if (c == 0) return 5 * (i + 1);
    if (c == 1) return frame.centre[0] + frame.cos * along - frame.sin * across;
    return c == 2 ? frame.centre[1] + frame.sin * along + frame.cos * across : 0;
}
static void energies_over_the_way(void **state) {
    (void)state;
    const struct calibrate_sample sample = sample_of(PHYSICS_PLANE_STRESS, 3, 0);
    const struct calibrate_scene c = {&sample, CALIBRATE_RUNNING, 45, 1.5};
    const struct calibrate_sizes z = calibrate_sample_sizes(&c);
    frame = calibrate_scenes_frame(&c);
    unit = calibrate_sample_g0(&sample);
    from = z.from;
    table("series.csv", "step,e_strain,e_damped,e_fracture,e_constraint\n#1,J,J,J,J\n", 40,
          "%.17g,%.17g,%.17g,%.17g,%.17g\n", energies);
    table("crack.csv", "step,tip_x,tip_y,a,b\n#1,m,m,1,1\n", 40, "%.17g,%.17g,%.17g,%.17g,%.17g\n", tips);
    const struct calibrate_measure_crack found = calibrate_measure_crack(work, &c);
    check_close(found.balance, 1, 1e-9);
    check_close(found.bonds, 1.5, 1e-9);
    check_close(found.deflection, atan(0.03) * 180 / M_PI, 1e-9);
    check_close(found.reached, from + 29, 1e-9);
    assert_int_equal(found.samples, 30); /* from + 0 ... from + 29: all within the window */
}

/* Two clamps press with 2 and 4 times the row; the first bond breaks in the fourth row, the notch runs in the sixth. */
static double forces(int i, int c) {
    return c == 0 ? i / 2 + 1 : c == 1 ? i % 2 : c == 2 ? (i % 2 ? 4 : -2) * (i / 2 + 1) : 0;
}
static double broken(int i, int c) { return c == 0 ? i + 1 : c == 1 ? (i >= 3 ? 12 : 10) : 0; }
static double ran(int i, int c) { return c == 0 ? i + 1 : c == 1 ? (i >= 5 ? 40 : 11.5) : 0; }
static void loads_of_a_notch(void **state) {
    (void)state;
    const struct calibrate_sample sample = sample_of(PHYSICS_PLANE_STRESS, 3, 0);
    const struct calibrate_scene c = {&sample, CALIBRATE_NOTCHED, 0, 1}, bar = {&sample, CALIBRATE_BAR, 0, 1};
    table("series.csv", "step,bonds_broken,e_fracture,a,b\n#1,1,J,1,1\n", 9, "%g,%g,%g,%g,%g\n", broken);
    table("crack.csv", "step,tip_x,a,b,c\n#1,m,1,1,1\n", 9, "%g,%g,%g,%g,%g\n", ran);
    table("reactions.csv", "step,index,force_y,a,b\n#1,1,N,1,1\n", 18, "%g,%g,%g,%g,%g\n", forces);
    const struct calibrate_measure_notch found = calibrate_measure_notch(work, &c, 6);
    check_close(found.first, 3 * 4 / 6., 1e-12);
    check_close(found.largest, 3 * 5 / 6., 1e-12);
    table("reactions.csv", "step,index,force_x,a,b\n#1,1,N,1,1\n", 18, "%g,%g,%g,%g,%g\n", forces);
    check_close(calibrate_measure_strength(work, &bar), 3 * 9 / 24., 1e-12);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_scene_is_one),
                                       cmocka_unit_test(a_strip_holds_what_is_asked),
                                       cmocka_unit_test(a_strip_lies_between_rows),
                                       cmocka_unit_test(energies_over_the_way), cmocka_unit_test(loads_of_a_notch)};
    par_begin(&argc, &argv);
    if (folder_make_path(work) != 0) return 1;
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
