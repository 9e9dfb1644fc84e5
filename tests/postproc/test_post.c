/* frana post on made-up run folders: parts of a run, incomplete, damaged, several at once. */
#include "postproc/data/body.h"
#include "tests/postproc/posted.h"

#include <unistd.h>

/* Of a run that was evaluated without gnuplot: a plot's script, and what cairo draws. */
static void check_without_gnuplot(void) {
    assert_int_equal(size_of(folder, "post/plots/pressure_drop.png"), -1);
    check_above(size_of(folder, "post/plots/pressure_drop.gp"), 500);
    static const char *const picture[] = {"png", "svg", "pdf"};
    for (int k = 0; k < 3; k++) {
        char file[64];
        snprintf(file, sizeof file, "post/pictures/damage_back.%s", picture[k]);
        check_above(size_of(folder, file), 1000);
    }
    assert_true(holds(folder, "post/report.md", "gnuplot was not found"));
}

/* Which strain or stress told beforehand what broke: the made-up ones grow towards the back, where the damage is, and
 * are multiples of each other, so they tell equally well. A run that was resumed in another folder has no state before
 * its stage; with the earlier run it has the same numbers. */
static void what_told_beforehand(void **state) {
    (void)state;
    static const char *const word[] = {"Largest principal strain", "Largest principal stress", "Von Mises stress",
                                       "Equivalent tension by Griffith"};
    char quantity[96], earlier[FOLDER_PATH], path[FOLDER_PATH], file[64];
    double area = 0;
    make_run(&(struct make_run){.folder = named("whole_too"), .cells = 16, .stop = 3 * MAKE_STEPS});
    assert_int_equal(post_without_gnuplot(NULL), EXIT_CODE_DONE);
    check_without_gnuplot();
    for (int k = 0; k < 4; k++) {
        snprintf(quantity, sizeof quantity, "%s, area under hits over false alarms, end", word[k]);
        if (k == 0) area = summary(folder, quantity);
        check_between(area, 0.8, 0.999);
        check_close(summary(folder, quantity), area, 1e-6);
        snprintf(quantity, sizeof quantity, "%s, hits at it, end", word[k]);
        check_close(summary(folder, quantity), 1, 1e-12); /* what breaks is 30 mm about one place at the back */
    }
    check_close(summary(folder, "Von Mises stress, best threshold, end"),
                sqrt(7.75) * summary(folder, "Largest principal stress, best threshold, end"), 1);
    assert_true(holds(folder, "post/criteria.csv", "Largest principal strain,first,"));
    snprintf(earlier, sizeof earlier, "%s", folder);
    make_run(&(struct make_run){.folder = named("resumed"), .cells = 16, .stop = 3 * MAKE_STEPS});
    for (long step = 150; step <= 200; step += 50) {
        snprintf(file, sizeof file, "fields/solid_%08ld.hdf", step);
        assert_int_equal(unlink(folder_path(path, folder, file)), 0);
    }
    assert_int_equal(post_without_gnuplot(NULL), EXIT_CODE_DONE);
    assert_int_equal(size_of(folder, "post/criteria.csv"), -1);
    check_equal(integral(folder, "post/pdf_strain.csv", "before"), 0);
    check_close(integral(folder, "post/pdf_strain.csv", "after"), 1, 1e-6);
    assert_int_equal(post_without_gnuplot(&(struct postproc_options){.before = earlier}), EXIT_CODE_DONE);
    check_close(integral(folder, "post/pdf_strain.csv", "before"), 1, 1e-6);
    check_close(summary(folder, "Largest principal strain, area under hits over false alarms, end"), area, 1e-12);
    assert_int_equal(post_without_gnuplot(&(struct postproc_options){.before = "/nowhere"}), EXIT_CODE_FILE);
}

/* Slices of 75 x 100 x 100 mm before the last stage and at its end, and sub-volumes at its end. */
static void texture_of_the_medium(void **state) {
    (void)state;
    make_run(&(struct make_run){.folder = named("texture"), .cells = 16, .stop = 300, .no_fields = 1});
    assert_int_equal(post_without_gnuplot(NULL), EXIT_CODE_DONE);
    static const char *const porosity[] = {"place of the slice  [mm]",
                                           "across z, t/t0 = 0'",
                                           "across z, t/t0 = 0.0034'",
                                           "6.25 0.53",
                                           "93.75 0.85",
                                           "93.75 0.88"};
    for (size_t k = 0; k < sizeof porosity / sizeof *porosity; k++)
        assert_true(holds(folder, "post/plots/slices_porosity.gp", porosity[k]));
    /* solid of 100 x 100 mm */
    static const char *const solid[] = {"slices across x", "solid area  [mm^2]", "31.25 5000", "31.25 4700",
                                        "93.75 2200"};
    for (size_t k = 0; k < sizeof solid / sizeof *solid; k++)
        assert_true(holds(folder, "post/plots/slices_solid.gp", solid[k]));
    static const char *const rev[] = {"edge of a sub-volume  [mm]", "12.5 0.625", "50 0.725", "50 0.525", "'least'"};
    for (size_t k = 0; k < sizeof rev / sizeof *rev; k++)
        assert_true(holds(folder, "post/plots/rev_porosity.gp", rev[k]));
    assert_false(holds(folder, "post/plots/rev_porosity.gp", "'deviation'"));
    assert_true(holds(folder, "post/plots/rev_porosity_deviation.gp", "12.5 0.15"));
    assert_false(holds(folder, "post/plots/rev_permeability_deviation.gp", "set logscale y"));
    /* the smallest have no permeability; that of the box is the series', 7.8e-6 m2 */
    assert_true(holds(folder, "post/plots/rev_permeability.gp", "50 4.4e-06"));
    assert_true(holds(folder, "post/plots/rev_permeability.gp", "25 7.8e-06"));
    assert_true(holds(folder, "post/plots/rev_permeability.gp", "set logscale y"));
    assert_false(holds(folder, "post/plots/rev_permeability.gp", "12.5 "));
    /* one sample: no times */
    make_run(&(struct make_run){.folder = named("texture"), .cells = 16, .stop = 160, .no_fields = 1});
    assert_int_equal(post_without_gnuplot(NULL), EXIT_CODE_DONE);
    assert_true(holds(folder, "post/plots/slices_porosity.gp", "'across z'"));
    assert_false(holds(folder, "post/plots/slices_porosity.gp", "t/t0"));
    /* a table of something else, and no table */
    static const char *const file[] = {"slices.csv", "rev.csv"}, *const other[] = {"step,t\n#1,s\n1,0.1\n", "no table"};
    char path[FOLDER_PATH];
    for (int k = 0; k < 2; k++) {
        FILE *f = fopen(folder_path(path, folder, file[k]), "w");
        fputs(other[k], f);
        fclose(f);
    }
    unlink(folder_path(path, folder, "post/plots/slices_porosity.gp"));
    unlink(folder_path(path, folder, "post/plots/rev_porosity.gp"));
    assert_int_equal(post_without_gnuplot(NULL), EXIT_CODE_DONE);
    assert_int_equal(size_of(folder, "post/plots/slices_porosity.gp"), -1);
    assert_int_equal(size_of(folder, "post/plots/rev_porosity.gp"), -1);
}

/* A stage that has ended before all its steps: the next one began earlier than the scene's steps say. */
static void a_stage_may_end_early(void **state) {
    (void)state;
    static const struct {
        const char *record, *stage;
        long step;
    } known[] = {
        {"{\"stage\": \"fracture\", \"stage_step\": 113, \"steps\": 263, \"stage_began\": 0.0357}", "fracture", 150},
        {"{\"stage\": \"settle\", \"stage_step\": 93, \"steps\": 133, \"stage_began\": 0.0136}", "fracture", 140},
        {"{\"stage\": \"settle\", \"stage_step\": 63, \"steps\": 263, \"stage_began\": 0.0374}", "settle", 200},
        {"{\"stage\": \"settle\", \"steps\": 263}", "fracture", 200},
    };
    char error[512], path[FOLDER_PATH];
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        make_run(&(struct make_run){.folder = named("early"), .cells = 16, .stop = 263, .no_fields = 1});
        FILE *f = fopen(folder_path(path, folder, "run.json"), "w");
        fputs(known[k].record, f);
        fclose(f);
        struct postproc_history *h = postproc_history_new(folder, error, sizeof error);
        assert_non_null(h);
        assert_string_equal(h->stage, known[k].stage);
        assert_int_equal(h->origin_step, known[k].step);
        check_close(h->origin, make_time(known[k].step), 1e-12);
        postproc_history_free(h);
    }
}

/* s0 = sqrt(5 G0/(6 E delta)) of the scene with the period of 64 cells: 1.8856e-4 for S3 (001: table of chapter 6). */
static void scales_are_the_scenes(void **state) {
    (void)state;
    char error[512];
    make_run(&(struct make_run){.folder = named("scales"), .cells = 64, .stop = 3 * MAKE_STEPS, .no_fields = 1});
    struct postproc_history *h = postproc_history_new(folder, error, sizeof error);
    assert_non_null(h);
    check_close(h->s0, 1.8856e-4, 1e-8);
    check_close(h->sigma0, 18856, 1);
    check_close(h->spacing, 1.5625e-3, 1e-12);
    assert_string_equal(h->stage, "fracture");
    assert_int_equal(h->origin_step, 2 * MAKE_STEPS);
    check_close(postproc_history_when(h, make_time(300)), 100 * make_dt[2], 1e-12);
    check_close(postproc_history_value(h, "step", make_time(207)), 205, 0);
    check_close(postproc_history_mean(h, "step", make_time(200), make_time(210)), 207.5, 1e-9);
    assert_null(postproc_history_column(h, "no such column"));
    assert_true(isnan(postproc_history_value(h, "step", 0)));
    postproc_history_free(h);
}

/* A run on its way is in its second stage: the origin is that one's start, and nothing has broken. */
static void run_on_its_way(void **state) {
    (void)state;
    make_run(&(struct make_run){.folder = named("going"), .cells = 16, .stop = 160});
    char path[FOLDER_PATH];
    FILE *f = fopen(folder_path(path, folder, "series.csv"), "a");
    fputs("165,0.03", f); /* a row that is just being written */
    fclose(f);
    assert_int_equal(unlink(folder_path(path, folder, "run.json")), 0);
    assert_int_equal(post_without_gnuplot(NULL), EXIT_CODE_DONE);
    check_close(summary(folder, "start of the stage"), make_time(100), 1e-9);
    check_close(summary(folder, "end of the data"), make_time(160), 1e-9);
    check_close(summary(folder, "bonds broken"), 0, 0);
    assert_true(isnan(summary(folder, "first bond broken, t")));
    assert_true(isnan(summary(folder, "wall time")));
    check_above(size_of(folder, "post/pictures/damage_back.png"), 1000);
}

static void fluid_alone(void **state) {
    (void)state;
    make_run(&(struct make_run){.folder = named("fluid"), .cells = 16, .stop = 300, .no_solid = 1});
    assert_int_equal(postproc_post(folder, &(struct postproc_options){.width = 280}), EXIT_CODE_DONE);
    check_above(size_of(folder, "post/plots/pressure_drop.png"), 1000);
    check_above(size_of(folder, "post/pressure.csv"), 100);
    assert_int_equal(size_of(folder, "post/plots/porosity.png"), -1);
    assert_int_equal(size_of(folder, "post/pdf_strain.csv"), -1);
    assert_int_equal(size_of(folder, "post/pictures/damage_back.png"), -1);
    assert_int_equal(size_of(folder, "post/pictures/solid_back.png"), -1);
    check_above(size_of(folder, "post/pictures/flow_lines.png"), 1000);
    check_above(size_of(folder, "post/pictures/slice_z_speed.png"), 1000);
}

/* Nothing flows and nothing presses: no picture of the flow, and no arrow. */
static void fluid_at_rest(void **state) {
    (void)state;
    make_run(&(struct make_run){.folder = named("rest"), .cells = 16, .stop = 300, .at_rest = 1});
    assert_int_equal(post_without_gnuplot(&(struct postproc_options){.film = 1}), EXIT_CODE_DONE);
    check_above(size_of(folder, "post/film/damage_back_0004.png"), 1000); /* the film's other default */
    assert_int_equal(size_of(folder, "post/film/flow_lines_0001.png"), -1);
    check_above(size_of(folder, "post/pictures/damage_back.png"), 1000);
    assert_false(holds(folder, "post/pictures/damage_back.svg", ">flow<"));
    static const char *const none[] = {"flow_lines",    "flow_speed",       "flow_pressure",
                                       "slice_z_speed", "slice_z_pressure", "slice_z_vorticity"};
    for (size_t k = 0; k < sizeof none / sizeof *none; k++) {
        char file[128];
        snprintf(file, sizeof file, "post/pictures/%s.png", none[k]);
        if (size_of(folder, file) >= 0) fail_msg("%s is there, but nothing flows", file);
        snprintf(file, sizeof file, "post/pictures/%s.gp", none[k]); /* of a slice, which gnuplot draws */
        if (size_of(folder, file) >= 0) fail_msg("%s is there, but nothing flows", file);
    }
}

/* A picture of each field, of the flow. */
static void film_of_a_block(void **state) {
    (void)state;
    make_run(&(struct make_run){.folder = named("film"), .cells = 16, .stop = 300});
    assert_int_equal(post_without_gnuplot(&(struct postproc_options){.film = 1}), EXIT_CODE_DONE);
    char file[128];
    for (int k = 1; k <= 4; k++) { /* fields of steps 150, 200, 250, 300 */
        snprintf(file, sizeof file, "post/film/flow_lines_%04d.png", k);
        check_above(size_of(folder, file), 1000);
    }
    assert_int_equal(size_of(folder, "post/film/flow_lines_0005.png"), -1);
    assert_true(holds(folder, "post/report.html", "type=\"range\" min=\"0\" max=\"3\""));
}

/* The slice across y is where it is asked for, the others are in the middle; a place outside of the domain is refused.
 */
static void slice_at_a_place(void **state) {
    (void)state;
    make_run(&(struct make_run){.folder = named("sliced"), .cells = 16, .stop = 300});
    assert_int_equal(post_without_gnuplot(&(struct postproc_options){.sliced = {0, 1, 0}, .slice = {0, 0.03, 0}}),
                     EXIT_CODE_DONE);
    /* cells of 6.25 mm: the fifth's centre; the lower one of the two in the middle */
    assert_true(holds(folder, "post/pictures/slice_y_speed.gp", "y = 28.12 mm"));
    assert_true(holds(folder, "post/pictures/slice_z_speed.gp", "z = 46.88 mm"));
    assert_int_equal(postproc_post(folder, &(struct postproc_options){.sliced = {0, 1, 0}, .slice = {0, 0.11, 0}}),
                     EXIT_CODE_SCENE);
}

static void compared(void **state) {
    (void)state;
    char a[FOLDER_PATH], b[FOLDER_PATH], out[FOLDER_PATH];
    folder_path(a, base, "a");
    folder_path(b, base, "b/");
    make_run(&(struct make_run){.folder = a, .cells = 16, .stop = 300});
    make_run(&(struct make_run){.folder = b, .cells = 16, .stop = 200});
    const char *const both[2] = {a, b};
    assert_int_equal(postproc_compare(2, both, folder_path(out, base, "compared/ab")), EXIT_CODE_DONE);
    check_above(size_of(out, "plots/pressure_drop.png"), 1000);
    check_above(size_of(out, "plots/pdf_strain.svg"), 1000);
    assert_true(holds(out, "summary.csv", "quantity,unit,a,b"));
    assert_true(holds(out, "summary.csv", "\"bonds broken\",1,\"100000\",\"0\""));
    const char *const missing[2] = {a, "/nowhere"};
    assert_int_equal(postproc_compare(2, missing, out), EXIT_CODE_FILE);
}

static void refused(void **state) {
    (void)state;
    char path[FOLDER_PATH];
    assert_int_equal(postproc_post("/nowhere/at/all", NULL), EXIT_CODE_FILE);
    folder_make(named("empty"));
    folder_clear(folder);
    assert_int_equal(postproc_post(folder, NULL), EXIT_CODE_FILE);
    assert_int_equal(size_of(folder, "post/report.md"), -1);
    /* a scene, but nothing has run */
    make_run(&(struct make_run){.folder = named("unrun"), .cells = 16, .stop = 0, .no_fields = 1});
    assert_int_equal(unlink(folder_path(path, folder, "series.csv")), 0);
    assert_int_equal(postproc_post(folder, NULL), EXIT_CODE_FILE);
    /* series that is not a series: a row with a word, then one too short in the middle */
    static const char *const bad[3] = {"#no names\n", "step,t\n#1,s\n1,0.1\n2,word\n", "step,t\n#1,s\n1\n2,0.2\n"};
    for (int k = 0; k < 3; k++) {
        FILE *f = fopen(folder_path(path, folder, "series.csv"), "w");
        fputs(bad[k], f);
        fclose(f);
        assert_int_equal(postproc_post(folder, NULL), EXIT_CODE_FILE);
    }
    /* good enough: one row, a value that is not a number */
    FILE *f = fopen(folder_path(path, folder, "series.csv"), "w");
    fputs("step,t,dp\n#1,s,Pa\n1,0.1,nan\n", f);
    fclose(f);
    assert_int_equal(post_without_gnuplot(NULL), EXIT_CODE_DONE);
}

/* A field file cut off by a crash is left out with a sentence, and the one before it is taken. */
static void broken_field(void **state) {
    (void)state;
    make_run(&(struct make_run){.folder = named("broken"), .cells = 16, .stop = 300});
    char path[FOLDER_PATH];
    assert_int_equal(truncate(folder_path(path, folder, "fields/solid_00000300.hdf"), 1000), 0);
    assert_int_equal(post_without_gnuplot(NULL), EXIT_CODE_DONE);
    check_above(size_of(folder, "post/pictures/damage_back.png"), 1000);
    assert_true(holds(folder, "post/pdf_strain.csv", "before,0.0374"));
    assert_true(holds(folder, "post/pdf_strain.csv", "after,0.0391"));
    assert_false(holds(folder, "post/pdf_strain.csv", "after,0.0408"));
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_told_beforehand),
        cmocka_unit_test(texture_of_the_medium),
        cmocka_unit_test(a_stage_may_end_early),
        cmocka_unit_test(scales_are_the_scenes),
        cmocka_unit_test(run_on_its_way),
        cmocka_unit_test(fluid_alone),
        cmocka_unit_test(fluid_at_rest),
        cmocka_unit_test(film_of_a_block),
        cmocka_unit_test(slice_at_a_place),
        cmocka_unit_test(compared),
        cmocka_unit_test(refused),
        cmocka_unit_test(broken_field),
    };
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
