/* Places in cells: what is periodic comes back in, to the last bit; what is outside is in no cell. Room for items
 * on their way. */
#include "base/memory.h"
#include "base/par.h"
#include "ibm/cell.h"
#include "ibm/state.h"
#include "tests/check.h"

static const struct fluid_grid grid = {.n = {10, 7, 5}, .d = {0.1, 0.3, 2}, .periodic = {1, 0, 1}};

static void periodic_places_come_back(void **state) {
    (void)state;
    const double x[] = {0, 0.25, 0.95, -0.05, 1.05, -3.65, 127.15}, s[] = {0, 2.5, 9.5, 9.5, 0.5, 3.5, 1.5};
    for (int k = 0; k < 7; k++) check_close(ibm_cell_wrap(&grid, 0, x[k]), s[k], 1e-11);
    const double hair[] = {-1e-17, -1e-300, -1e-15, 1 - 1e-16, 1, nextafter(1, 0), -1, 1e9 + 0.1};
    for (int k = 0; k < 8; k++) {
        const double at = ibm_cell_wrap(&grid, 0, hair[k]);
        check_at_least(at, 0);
        check_below(at, 10);
        check_at_least(ibm_cell(&grid, 0, at), 0);
    }
    check_close(ibm_cell_wrap(&grid, 1, -0.6), -2, 1e-14); /* not periodic: as it is */
    check_close(ibm_cell_wrap(&grid, 1, 300), 1000, 1e-10);
}

static void cells_and_ends(void **state) {
    (void)state;
    const double s[] = {0, 0.999, 1, 6.5, 7, 7.0000001, -1e-9, NAN, INFINITY};
    const int cell[] = {0, 0, 1, 6, 6, -1, -1, -1, -1};
    for (int k = 0; k < 9; k++) assert_int_equal(ibm_cell(&grid, 1, s[k]), cell[k]);
}

/* A new plan for another number only; capacity for as many items as asked for, and copies of each for all that may
 * share it. */
static void a_plan_has_the_capacity_asked_for(void **state) {
    (void)state;
    struct ibm_route route = {0};
    for (int n = 0; n < 400; n += 57) {
        assert_true(ibm_route_reserve(&route, n, IBM_ITEM)); /* no plan has been made */
        assert_int_equal(route.n, n);
        check_at_least(route.capacity, n);
        for (int h = 0; h < n; h++) {
            route.key[h] = h;
            for (int k = 0; k < IBM_SHARERS; k++) route.item[IBM_SHARERS * h + k] = route.dest[IBM_SHARERS * h + k] = h;
            for (int k = 0; k < IBM_ITEM; k++) route.mine[h * IBM_ITEM + k] = h;
        }
    }
    route.plan = par_exchange_renew(NULL, 0, route.item, route.dest);
    assert_false(ibm_route_reserve(&route, route.n, IBM_ITEM));
    assert_true(ibm_route_reserve(&route, route.n - 1, IBM_ITEM));
    ibm_route_free(&route);
    assert_null(route.plan);
    assert_int_equal(route.capacity, 0);
}

static void buffers_grow_and_stay(void **state) {
    (void)state;
    double *buffer = NULL;
    size_t size = 0;
    ibm_buffer_reserve(&buffer, &size, 100);
    check_at_least(size, 100);
    buffer[99] = 5;
    const double *before = buffer;
    ibm_buffer_reserve(&buffer, &size, 100);
    ibm_buffer_reserve(&buffer, &size, 3);
    assert_ptr_equal(buffer, before);
    check_equal(buffer[99], 5);
    ibm_buffer_reserve(&buffer, &size, 2 * size);
    check_at_least(size, 200);
    buffer[199] = 7;
    size_t none = 0;
    double *last = buffer;
    ibm_buffer_reserve(&last, &none, 0);
    assert_ptr_equal(last, buffer);
    memory_free(buffer);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(periodic_places_come_back), cmocka_unit_test(cells_and_ends),
                                       cmocka_unit_test(a_plan_has_the_capacity_asked_for),
                                       cmocka_unit_test(buffers_grow_and_stay)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
