/* What a line of the table says of its profile holds. The factors of the constants are checked in test_bond. */
#include "physics/micromodulus.h"
#include "tests/check.h"

static void the_table_describes_the_profiles(void **state) {
    (void)state;
    static const char *const name[PHYSICS_MICROMODULI] = {
        [PHYSICS_CONSTANT] = "constant", [PHYSICS_CONICAL] = "conical", [PHYSICS_EXPONENTIAL] = "exponential"};
    for (enum physics_micromodulus kind = 0; kind < PHYSICS_MICROMODULI; kind++) {
        const struct physics_micromodulus_law *law = physics_micromodulus_of(kind);
        assert_string_equal(law->name, name[kind]);
        check_equal(law->profile(0), 1);
        int is_constant = 1;
        for (int i = 0; i < 50; i++) { /* it is positive within the horizon and never rises */
            const double here = law->profile(i / 50.), next = law->profile((i + 1) / 50.);
            check_above(here, 0);
            check_at_most(next, here);
            is_constant &= here == next;
        }
        assert_int_equal(law->is_constant, is_constant);
        assert_int_equal(law->ends_at_horizon, law->profile(1) == 0);
    }
    check_close(physics_micromodulus_of(PHYSICS_CONICAL)->profile(0.25), 0.75, 0);
    check_close(physics_micromodulus_of(PHYSICS_EXPONENTIAL)->profile(1), 0.135335283236612692, 1e-16);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_table_describes_the_profiles)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
