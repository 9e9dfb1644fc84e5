/* Clocks: parts and their details add up to the time that passed, and waiting for a late rank is told from working. */
#include "base/clock.h"
#include "base/par.h"
#include "base/par_wait.h"
#include "tests/check.h"

#include <time.h>

static void sleep_ms(long ms) { nanosleep(&(struct timespec){ms / 1000, ms % 1000 * 1000000}, NULL); }

static double seconds_of_all(void) {
    double sum = 0;
    for (int p = 0; p < CLOCK_PARTS; p++) sum += clock_seconds((enum clock_part)p);
    return sum;
}

/* Nested clocks, time in no clock, and a change of what that time counts as. */
static void parts_add_up(void **state) {
    (void)state;
    const double first = par_seconds();
    clock_clear();
    const double begun = par_seconds();
    sleep_ms(3);
    clock_begin(CLOCK_SOLID);
    sleep_ms(2);
    clock_begin(CLOCK_CONTACT);
    sleep_ms(4);
    clock_end(CLOCK_CONTACT);
    clock_end(CLOCK_SOLID);
    clock_default(CLOCK_SETUP);
    sleep_ms(5);
    clock_begin(CLOCK_PROBE); /* still runs when it is read */
    sleep_ms(2);
    const double last = par_seconds();
    clock_count();
    const double ended = par_seconds();
    check_at_least(seconds_of_all(), last - begun);
    check_at_most(seconds_of_all(), ended - first + 1e-9);
    check_at_least(clock_seconds(CLOCK_OTHER), 3e-3 - 1e-5);
    check_at_least(clock_seconds(CLOCK_SOLID), 2e-3 - 1e-5);
    check_at_least(clock_seconds(CLOCK_CONTACT), 4e-3 - 1e-5);
    check_at_least(clock_seconds(CLOCK_SETUP), 5e-3 - 1e-5);
    check_at_least(clock_seconds(CLOCK_PROBE), 2e-3 - 1e-5);
    check_equal(clock_seconds(CLOCK_FORCING), 0);
    clock_end(CLOCK_PROBE);
}

/* A detail's time counts in its part; the part's clock within the detail is the detail's. */
static void details(void **state) {
    (void)state;
    clock_clear();
    clock_begin(CLOCK_SERIES);
    clock_begin(CLOCK_OUTPUT);
    sleep_ms(2);
    clock_end(CLOCK_OUTPUT);
    clock_begin(CLOCK_LOG); /* another detail of the same part */
    sleep_ms(1);
    clock_end(CLOCK_LOG);
    clock_end(CLOCK_SERIES);
    check_at_least(clock_seconds(CLOCK_SERIES), 2e-3 - 1e-5);
    check_at_least(clock_seconds(CLOCK_LOG), 1e-3 - 1e-5);
    check_close(clock_seconds(CLOCK_OUTPUT), clock_seconds(CLOCK_SERIES) + clock_seconds(CLOCK_LOG), 1e-12);
    for (int detail = CLOCK_PARTS; detail < CLOCK_ALL; detail++)
        assert_true(clock_owner((enum clock_part)detail) < CLOCK_PARTS);
}

/* Rank 0 is late at a reduction. The others wait at least from when they come to it until rank 0 does; both times are
 * of one machine's clock. A rank that the machine did not run meanwhile may come even later, so that the try is
 * repeated with a longer delay. */
static void a_late_rank(void **state) {
    (void)state;
    if (par_size() == 1) return;
    double came[2] = {0}, waited = 0;
    for (long late = 20; late < 10000; late *= 2) {
        par_barrier();
        clock_clear();
        clock_begin(CLOCK_FORCING);
        if (par_rank() == 0) sleep_ms(late);
        const double mine = par_seconds();
        par_sum(1);
        clock_end(CLOCK_FORCING);
        waited = clock_waiting(CLOCK_FORCING);
        check_at_least(waited, 0);
        check_at_most(waited, clock_seconds(CLOCK_FORCING));
        check_at_most(waited, par_seconds() - mine);
        if (par_rank() == 0) check_at_least(clock_seconds(CLOCK_FORCING) - waited, 1e-3 * (double)late - 1e-5);
        came[0] = mine;
        came[1] = mine;
        par_bcast(&came[0], sizeof *came, 0);
        if (par_min(par_rank() == 0 ? 1 : came[0] - came[1]) > 0.01) break;
    }
    if (par_rank() == 0) return;
    assert_true(came[0] - came[1] > 0.01);
    check_at_least(waited, came[0] - came[1]);
}

/* Waiting outside of all clocks belongs to what that time counts as, and waiting before a run to nothing. */
static void waiting_elsewhere(void **state) {
    (void)state;
    par_barrier();
    clock_clear();
    for (int p = 0; p < CLOCK_PARTS; p++) check_equal(clock_waiting((enum clock_part)p), 0);
    clock_default(CLOCK_SETUP);
    const double before = par_wait_seconds();
    par_barrier();
    par_sum(1);
    const double waited = par_wait_seconds() - before;
    clock_begin(CLOCK_SOLID);
    clock_end(CLOCK_SOLID);
    assert_true(waited > 0);
    check_close(clock_waiting(CLOCK_SETUP), waited, 1e-9);
    check_equal(clock_waiting(CLOCK_SOLID), 0);
}

static void phases(void **state) {
    (void)state;
    clock_clear();
    clock_phase(CLOCK_PHASE_FLUID);
    sleep_ms(2);
    assert_int_equal(clock_phase(CLOCK_PHASE_PLANS), CLOCK_PHASE_FLUID);
    sleep_ms(3);
    clock_phase(CLOCK_PHASE_STEPS);
    const double fluid = clock_phase_seconds(CLOCK_PHASE_FLUID), plans = clock_phase_seconds(CLOCK_PHASE_PLANS);
    check_at_least(fluid, 2e-3 - 1e-5);
    check_at_least(plans, 3e-3 - 1e-5);
    /* no phase of the beginning counts while steps run */
    assert_int_equal(clock_phase(CLOCK_PHASE_PLANS), CLOCK_PHASE_STEPS);
    sleep_ms(1);
    assert_int_equal(clock_phase(CLOCK_PHASE_FLUID), CLOCK_PHASE_STEPS);
    check_equal(clock_phase_seconds(CLOCK_PHASE_FLUID), fluid);
    check_equal(clock_phase_seconds(CLOCK_PHASE_PLANS), plans);
    clock_clear(); /* a second run */
    check_equal(clock_phase_seconds(CLOCK_PHASE_FLUID), 0);
    assert_int_equal(clock_phase(CLOCK_PHASE_FLUID), CLOCK_PHASE_SCENE);
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(parts_add_up), cmocka_unit_test(details),
                                       cmocka_unit_test(a_late_rank), cmocka_unit_test(waiting_elsewhere),
                                       cmocka_unit_test(phases)};
    par_begin(&argc, &argv);
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
