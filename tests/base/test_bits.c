/* Counts of set bits, against a count bit by bit. */
#include "base/bits.h"
#include "tests/check.h"

/* Lengths up to three words, so that every remainder of the eight bytes of a word occurs, at odd addresses too. */
static void every_length_is_counted(void **state) {
    (void)state;
    enum { N = 25 };
    uint8_t bits[N + 3];
    unsigned random = 1;
    for (int i = 0; i < N + 3; i++) bits[i] = (uint8_t)((random = random * 1664525u + 1013904223u) >> 24);
    for (int first = 0; first < 3; first++)
        for (size_t n = 0; n <= N; n++) {
            long count = 0;
            for (size_t b = 0; b < 8 * n; b++) count += bits[(size_t)first + b / 8] >> b % 8 & 1;
            assert_int_equal(bits_count(bits + first, n), count);
        }
}

static void all_and_none(void **state) {
    (void)state;
    uint8_t bits[19];
    memset(bits, 0xff, sizeof bits);
    assert_int_equal(bits_count(bits, sizeof bits), 8 * 19);
    memset(bits, 0, sizeof bits);
    assert_int_equal(bits_count(bits, sizeof bits), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(every_length_is_counted), cmocka_unit_test(all_and_none)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
