/* Each function of vec and vec4 against a loop over the lanes. */
#include "base/vec4.h"
#include "base/vec_shuffle.h"
#include "tests/check.h"

static const double a_of[8] = {1.5, -2, 0, 3e300, -0.125, 7, -1e-300, 4}, b_of[8] = {1, -3, -0.5, 2e300, 0.25, 7, 0, 9};

static vec a(void) { return vec_load(a_of); }
static vec b(void) { return vec_load(b_of); }

static void lanes_are_loaded_and_stored(void **state) {
    (void)state;
    double store[9] = {0}, stream[8] __attribute__((aligned(64)));
    vec_store(store + 1, vec_load(a_of)); /* no alignment is needed */
    vec_stream(stream, a());
    for (int k = 0; k < VEC_LANES; k++) {
        check_equal(store[1 + k], a_of[k]);
        check_equal(stream[k], a_of[k]);
        check_equal(vec_set(-2.5)[k], -2.5);
    }
    double four[6] = {0};
    vec4_store(four + 1, vec4_load(a_of + 1));
    for (int k = 0; k < VEC4_LANES; k++) check_equal(four[1 + k], a_of[1 + k]);
    check_equal(four[0], 0);
    check_equal(four[1 + VEC4_LANES], 0);
    vec4_store(four, vec4_set(6));
    for (int k = 0; k < VEC4_LANES; k++) check_equal(four[k], 6);
}

static void functions_of_each_lane(void **state) {
    (void)state;
    const vec root = vec_sqrt(a() * a()), quarters = a() / 4;
    for (int k = 0; k < VEC_LANES; k++) {
        check_equal(vec_max(a(), b())[k], fmax(a_of[k], b_of[k]));
        check_equal(vec_min(a(), b())[k], fmin(a_of[k], b_of[k]));
        check_equal(vec_absmax(a(), b())[k], fmax(fabs(a_of[k]), fabs(b_of[k])));
        check_equal(root[k], sqrt(a_of[k] * a_of[k]));
        check_relative(vec_less_product(a(), b(), vec_set(k + 1.25))[k], a_of[k] - b_of[k] * (k + 1.25), 1e-14);
        check_equal(vec_floor(quarters)[k], floor(a_of[k] / 4));
        check_equal((double)vec_whole(vec_set(1e6 * (3 - k)))[k], 1e6 * (3 - k));
        check_equal(vec_before(b(), a())[k], k ? a_of[k - 1] : b_of[VEC_LANES - 1]);
        check_equal(vec_shuffle_after(a(), b())[k], k < VEC_LANES - 1 ? a_of[k + 1] : b_of[0]);
        const double number = (k % 2 ? -1 : 1) * (k + 0.3) * pow(10, 20 * k - 70);
        check_relative(vec_reciprocal(vec_set(number))[0], 1 / number, 5e-16); /* two units in the last place */
    }
}

static void functions_of_each_lane_of_four(void **state) {
    (void)state;
    for (int first = 0; first < 8; first += VEC4_LANES) {
        const vec4 x = vec4_load(a_of + first), y = vec4_load(b_of + first);
        double most[4], least[4], root[4], high = -INFINITY, low = INFINITY, sum = 0;
        vec4_store(most, vec4_max(x, y));
        vec4_store(least, vec4_min(x, y));
        vec4_store(root, vec4_sqrt(vec4_max(x, vec4_set(0))));
        for (int k = 0; k < VEC4_LANES; k++) {
            const double p = a_of[first + k], q = b_of[first + k];
            check_equal(most[k], fmax(p, q));
            check_equal(least[k], fmin(p, q));
            check_equal(root[k], sqrt(fmax(p, 0)));
            high = fmax(high, p);
            low = fmin(low, p);
            sum += k + 1;
        }
        check_equal(vec4_highest(x), high);
        check_equal(vec4_lowest(x), low);
        check_equal(vec4_sum(vec4_load((const double[4]){1, 2, 3, 4})), sum);
    }
}

static void all_lanes_to_one_number(void **state) {
    (void)state;
    const double whole[8] = {1, -2, 4, 8, -16, 32, 64, 128};
    double sum = 0;
    for (int k = 0; k < VEC_LANES; k++) sum += whole[k];
    check_equal(vec_sum(vec_load(whole)), sum);
    check_equal(vec_total(vec_load(whole)), sum);
    for (int k = 0; k < VEC_LANES; k++) { /* the extreme in each of the lanes */
        vec x = vec_set(1);
        x[k] = 5;
        check_equal(vec_highest(x), 5);
        check_equal(vec_lowest(x), 1);
        assert_true(vec_any_above(x, 4.9));
        assert_false(vec_any_above(x, 5));
        x[k] = -5;
        check_equal(vec_lowest(x), -5);
        assert_int_equal(vec_signs(x), 1u << k);
        x[k] = NAN;
        assert_true(vec_any_above(x, 1e308));
    }
    assert_int_equal(vec_signs(vec_set(-0.0)), VEC_ALL);
    for (int n = 0; n <= 10; n++) assert_int_equal(vec_first(n), n < VEC_LANES ? (1 << n) - 1 : VEC_ALL);
}

/* All patterns of eight bits. */
static void bits_select_lanes(void **state) {
    (void)state;
    for (unsigned bits = 0; bits < 256; bits++) {
        const vec where = vec_where(bits, a() + 10), expanded = vec_expand(bits, b_of);
        const vec_mask mask = vec_mask_of_bits(bits);
        const vec chosen = vec_choose(mask, a(), vec_set(NAN)), other = vec_choose(mask, vec_set(NAN), a());
        double compressed[9];
        int n = 0;
        for (int k = 0; k < 9; k++) compressed[k] = -99;
        vec_compress(bits, a(), compressed);
        for (int k = 0; k < VEC_LANES; k++) {
            const int on = bits >> k & 1;
            check_equal(where[k], on ? a_of[k] + 10 : 0);
            assert_true(mask[k] == (on ? -1 : 0));
            if (on) check_equal(chosen[k], a_of[k]);
            if (!on) check_equal(other[k], a_of[k]);
            assert_true(isnan(on ? other[k] : chosen[k]));
            check_equal(expanded[k], on ? b_of[n] : 0);
            if (on) check_equal(compressed[n++], a_of[k]);
        }
        for (; n < VEC_LANES + 1; n++) check_equal(compressed[n], -99); /* nothing more is written */
        double four[4];
        vec4_store(four, vec4_where(bits, vec4_load(a_of + 3)));
        for (int k = 0; k < VEC4_LANES; k++) check_equal(four[k], bits >> k & 1 ? a_of[3 + k] : 0);
    }
}

static void numbers_from_places(void **state) {
    (void)state;
    double p[200];
    float floats[9];
    for (int i = 0; i < 200; i++) p[i] = 3 * i + 0.5;
    for (int i = 0; i < 9; i++) floats[i] = (float)(0.1 * i - 0.35);
    const int at[8] = {17, 0, 5, 38, 2, 21, 5, 11};
    const int less[8] = {3, 31, 0, 38, 7, 12, 1, 9};
    vec two[2], four[4], between[4];
    vec_shuffle_gather2(p, at, two);
    vec_shuffle_gather4(p, 5, at, four);
    vec_shuffle_between4(p, 5, at, less, between);
    const vec wide = vec_load_floats(floats + 1);
    for (int k = 0; k < VEC_LANES; k++) {
        for (int c = 0; c < 2; c++) check_equal(two[c][k], p[at[k] + c]);
        for (int c = 0; c < 4; c++) check_equal(four[c][k], p[5 * at[k] + c]);
        for (int c = 0; c < 4; c++) check_equal(between[c][k], p[5 * at[k] + c] - p[5 * less[k] + c]);
        check_equal(wide[k], (double)floats[1 + k]);
        const int of_four[8] = {3, 0, 1, 3, 2, 2, 0, 1};
        check_equal(vec_shuffle_pick(p + 7, of_four)[k], p[7 + of_four[k]]);
    }
    for (int k = 0; k < 8; k++) {
        int other[8];
        memcpy(other, at, sizeof other);
        other[k]--;
        assert_int_equal(vec_differ(at, other), 1u << k);
    }
    assert_int_equal(vec_differ(at, at), 0);
}

static void rows_become_columns(void **state) {
    (void)state;
    vec v[VEC_LANES];
    for (int k = 0; k < VEC_LANES; k++)
        for (int l = 0; l < VEC_LANES; l++) v[k][l] = 10 * k + l;
    vec_shuffle_transpose(v);
    for (int k = 0; k < VEC_LANES; k++)
        for (int l = 0; l < VEC_LANES; l++) check_equal(v[k][l], 10 * l + k);
}

static void rows_of_numbers(void **state) {
    (void)state;
    vec v[4];
    double three[3 * VEC_LANES], four[4 * VEC_LANES];
    for (int c = 0; c < 4; c++)
        for (int k = 0; k < VEC_LANES; k++) v[c][k] = 10 * k + c;
    vec_shuffle_store3(three, v);
    vec_shuffle_store4(four, v);
    for (int k = 0; k < VEC_LANES; k++) {
        for (int c = 0; c < 3; c++) check_equal(three[3 * k + c], 10 * k + c);
        for (int c = 0; c < 4; c++) check_equal(four[4 * k + c], 10 * k + c);
    }
}

static void the_power_of_two_below(void **state) {
    (void)state;
    check_equal(vec_power_below(1), 1);
    check_equal(vec_power_below(nextafter(1, 0)), 0.5);
    check_equal(vec_power_below(1000), 512);
    check_equal(vec_power_below(0.3), 0.25);
    check_equal(vec_power_below(0), 0);
    check_equal(vec_power_below(NAN), INFINITY);
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(lanes_are_loaded_and_stored),
                                       cmocka_unit_test(functions_of_each_lane),
                                       cmocka_unit_test(functions_of_each_lane_of_four),
                                       cmocka_unit_test(all_lanes_to_one_number),
                                       cmocka_unit_test(bits_select_lanes),
                                       cmocka_unit_test(numbers_from_places),
                                       cmocka_unit_test(rows_become_columns),
                                       cmocka_unit_test(rows_of_numbers),
                                       cmocka_unit_test(the_power_of_two_below)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
