/* frana post on a made-up run that has everything: all its files, and the numbers in them. */
#include "tests/postproc/posted.h"

static const char *const files_of_whole_run[] = {"post/report.md",
                                                 "post/report.html",
                                                 "post/summary.csv",
                                                 "post/pdf_strain.csv",
                                                 "post/pdf_stress.csv",
                                                 "post/pdf_stress_middle.csv",
                                                 "post/pdf_stress_least.csv",
                                                 "post/pdf_von_mises.csv",
                                                 "post/pdf_griffith.csv",
                                                 "post/plots/pdf_von_mises.png",
                                                 "post/plots/reactions.svg",
                                                 "post/plots/slices_porosity.png",
                                                 "post/plots/slices_solid.svg",
                                                 "post/plots/rev_porosity.pdf",
                                                 "post/plots/rev_permeability.png",
                                                 "post/plots/load_displacement.png",
                                                 "post/plots/detached_mass.png",
                                                 "post/plots/events.png",
                                                 "post/plots/events.pdf",
                                                 "post/plots/events_count.svg",
                                                 "post/plots/events_energy.png",
                                                 "post/pressure.csv",
                                                 "post/plots/pressure_drop.png",
                                                 "post/plots/pressure_drop.svg",
                                                 "post/plots/porosity.png",
                                                 "post/plots/permeability.png",
                                                 "post/plots/bonds_broken.png",
                                                 "post/plots/fragments.png",
                                                 "post/plots/energy.png",
                                                 "post/plots/pdf_strain.png",
                                                 "post/plots/pdf_stress.svg",
                                                 "post/plots/pressure.png",
                                                 "post/pictures/damage_back.png",
                                                 "post/pictures/damage_front.png",
                                                 "post/pictures/damage_section.png",
                                                 "post/pictures/displacement_back.png",
                                                 "post/plots/pressure_drop.pdf",
                                                 "post/pictures/damage_back.svg",
                                                 "post/pictures/damage_back.pdf",
                                                 "post/pictures/flow_lines.png",
                                                 "post/pictures/flow_speed.png",
                                                 "post/pictures/flow_pressure.png",
                                                 "post/pictures/slice_x_speed.png",
                                                 "post/pictures/slice_y_pressure.svg",
                                                 "post/pictures/slice_z_vorticity.pdf"};
enum { FILES = sizeof files_of_whole_run / sizeof *files_of_whole_run };

/* Sets the folder to that of a whole run with its post/, made by whichever test is the first. */
static void whole(void) {
    static int made;
    const char *cells = getenv("FRANA_TEST_CELLS"); /* 64 to look at the pictures of the main case */
    named("whole");
    if (made) return;
    make_run(
        &(struct make_run){.folder = folder, .cells = cells ? atoi(cells) : 32, .stop = 3 * MAKE_STEPS, .events = 1});
    assert_int_equal(postproc_post(folder, &(struct postproc_options){.width = cells ? 0 : 280}), EXIT_CODE_DONE);
    made = 1;
}

static void whole_run(void **state) {
    (void)state;
    whole();
    for (int k = 0; k < FILES; k++)
        if (size_of(folder, files_of_whole_run[k]) < 100) fail_msg("%s is missing or empty", files_of_whole_run[k]);
    /* rho U^2 = 10 Pa; settled to 1900 Pa at step 200, half of it at the end; t0 = 0.1 m / 0.1 m/s */
    check_close(summary(folder, "p0 = rho_f U_b^2"), 10, 1e-9);
    check_close(summary(folder, "dp/(rho_f U_b^2), before"), 190 * (1 - exp(-10)), 1e-6);
    check_close(summary(folder, "dp/(rho_f U_b^2), after"), 95 * (1 - exp(-15)), 1e-6);
    check_close(summary(folder, "start of the stage"), make_time(200), 1e-9);
    check_close(summary(folder, "t0 = L_ref/U_b"), 1, 1e-9);
    check_close(summary(folder, "porosity, before"), 0.7, 1e-9);
    check_close(summary(folder, "porosity, after"), 0.72, 1e-9);
    const double box = 0.075 * 0.1 * 0.1, r = cbrt(0.3 * box * 3 / (4 * M_PI)); /* one piece, 40/m of wetted surface */
    check_close(summary(folder, "sphericity of the mean grain at the start"), 4 * M_PI * r * r / (40 * box), 1e-9);
    check_close(summary(folder, "permeability, after"), 7.8e-6, 1e-12);
    check_close(summary(folder, "bonds broken"), 1e5, 0);
    check_close(summary(folder, "fragments"), 51, 0);
    check_close(summary(folder, "events of fracture"), 100, 0);
    check_close(summary(folder, "first event, t"), make_time(255), 1e-9);
    check_close(summary(folder, "bonds broken in events"), 5050, 0);
    check_close(summary(folder, "energy released by events"), 338350, 0);
    check_close(summary(folder, "largest event, energy"), 1e4, 0);
    check_close(summary(folder, "largest event, t"), make_time(274), 1e-9);
    check_close(summary(folder, "largest event, y"), 0.0396, 1e-12);
    check_close(summary(folder, "wall time, momentum"), 20.25, 1e-9);
    check_close(summary(folder, "first bond broken, t"), make_time(255), 1e-9);
    /* only the last field is damaged; positions are stored in single precision */
    check_close(summary(folder, "first field with damage, x/L"), (make_onset_x - 0.025) / 0.075, 1e-5);
    check_between(make_onset_x, 0.08, 0.095);
    /* damaged within 30 mm of x = 95 mm at half the height: nothing before 65 mm, and the same above and below */
    check_equal(summary(folder, "first field with damage, share of it in the front third of the length"), 0);
    check_above(summary(folder, "first field with damage, share of it in the back third of the length"), 0.8);
    check_close(summary(folder, "first field with damage, share of it in the lowest third of the height"),
                summary(folder, "first field with damage, share of it in the highest third of the height"), 1e-9);
    assert_true(holds(folder, "post/report.md", "back (x/L"));
    assert_true(holds(folder, "post/report.md", "| set-up | flow | all |"));
    assert_true(holds(folder, "post/report.md", "| momentum | 0.25 | 20, 20 % waiting | 20.2, 20 % waiting |"));
    assert_true(holds(folder, "post/report.md", "pictures/damage_back.png"));
    /* the page needs no other file */
    assert_true(holds(folder, "post/report.html", "data:image/png;base64,iVBORw0KGgo"));
    assert_false(holds(folder, "post/report.html", "plots/pdf_strain.png"));
    check_above(size_of(folder, "post/report.html"), 4. / 3 * size_of(folder, "post/pictures/flow_lines.png"));
    /* nothing is left of what the pictures are made from */
    assert_int_equal(size_of(folder, "post/pictures/damage_back.rgb"), -1);
    assert_int_equal(size_of(folder, "post/pictures/damage_back.gp"), -1);
    assert_int_equal(size_of(folder, "post/pictures/solid_back.png"), -1); /* there is damage to be shown */
    assert_true(holds(folder, "post/plots/pdf_strain.gp", "s_0"));
}

/* What has broken in the made-up run: distributions that are multiples of each other, pieces, load against opening. */
static void broken_run(void **state) {
    (void)state;
    static const char *const pdf[] = {"post/pdf_strain.csv",        "post/pdf_stress.csv",
                                      "post/pdf_stress_middle.csv", "post/pdf_stress_least.csv",
                                      "post/pdf_von_mises.csv",     "post/pdf_griffith.csv"};
    whole();
    for (size_t k = 0; k < sizeof pdf / sizeof *pdf; k++) {
        check_close(integral(folder, pdf[k], "before"), 1, 1e-6); /* ten digits of each number */
        check_close(integral(folder, pdf[k], "after"), 1, 1e-6);
    }
    const double mean = summary(folder, "Largest principal stress, mean, after"),
                 most = summary(folder, "Largest principal stress, largest, after");
    check_relative(summary(folder, "Middle principal stress, mean, after"), 0.5 * mean, 1e-5);
    check_relative(summary(folder, "Least principal stress, mean, after"), -2 * mean, 1e-5);
    check_relative(summary(folder, "Least principal stress, smallest, after"), -2 * most, 1e-5);
    check_relative(summary(folder, "Von Mises stress, mean, after"), sqrt(7.75) * mean, 1e-5);
    check_relative(summary(folder, "Equivalent tension by Griffith, mean, after"), mean, 1e-5);
    check_relative(summary(folder, "Equivalent tension by Griffith, share above sigma0, before"),
                   summary(folder, "Largest principal stress, share above sigma0, before"), 1e-12);
    check_above(summary(folder, "Von Mises stress, share above sigma0, before"),
                summary(folder, "Largest principal stress, share above sigma0, before"));
    check_close(summary(folder, "area of crack by Griffith's balance, energy released over G0"), 1e-6 / 0.02, 1e-12);
    check_equal(summary(folder, "pieces that came off"), 1);
    check_close(summary(folder, "first piece came off, t"), make_time(260), 1e-9);
    check_close(summary(folder, "mass of the solid"), 2, 1e-12);
    check_close(summary(folder, "mass of the pieces that came off, share"), 0.1, 1e-12);
    check_close(summary(folder, "largest piece that came off, speed"), 3, 1e-12);
    /* the two ends move apart: 2e-6 m a step; the force is the upper one's */
    assert_true(holds(folder, "post/plots/load_displacement.gp", "Load against opening"));
    assert_true(holds(folder, "post/plots/load_displacement.gp", "0.6 1500"));
    assert_true(holds(folder, "post/plots/load_displacement.gp", "opening  [mm]"));
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(whole_run), cmocka_unit_test(broken_run)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
