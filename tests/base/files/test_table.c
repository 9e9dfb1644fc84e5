/* The series table: rows as written, cut back on resume, read back. */
#include "base/files/table.h"
#include "base/files/table_rows.h"
#include "tests/check.h"
#include "tests/base/files/files.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

static char path[FOLDER_PATH];
static const char *const name[] = {"t", "step", "dp"}, *const unit[] = {"s", "1", "Pa"};

static void rows(long from, long to, long resume_step, double dp) {
    struct table *t = table_new(path, 3, name, unit, resume_step);
    for (long step = from; step <= to; step++) table_row(t, (double[]){0.1 * (double)step, (double)step, dp});
    table_free(t);
    par_barrier();
}

static char *text(void) {
    static char all[4096];
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    all[fread(all, 1, sizeof all - 1, f)] = '\0';
    fclose(f);
    par_barrier();
    return all;
}

static void append(const char *what) {
    if (par_rank() == 0) {
        FILE *f = fopen(path, "a");
        fputs(what, f);
        fclose(f);
    }
    par_barrier();
}

static void rows_are_as_documented(void **state) {
    (void)state;
    rows(1, 3, -1, 1.0 / 3);
    assert_string_equal(text(), "t,step,dp\n#s,1,Pa\n0.1,1,0.333333333333333\n0.2,2,0.333333333333333\n"
                                "0.3,3,0.333333333333333\n");
    rows(5, 5, -1, NAN); /* a new table replaces the old one */
    assert_string_equal(text(), "t,step,dp\n#s,1,Pa\n0.5,5,nan\n");
}

static void a_row_is_on_its_way_at_once(void **state) {
    (void)state;
    struct table *t = table_new(path, 3, name, unit, -1);
    table_row(t, (double[]){0, 1, -INFINITY});
    par_barrier();
    assert_string_equal(text(), "t,step,dp\n#s,1,Pa\n0,1,-inf\n");
    table_free(t);
}

static void resume_cuts_back_to_the_step(void **state) {
    (void)state;
    rows(1, 9, -1, 7);
    append("1.0,10,7"); /* a row that a crash has cut off */
    rows(5, 6, 4, 8);
    assert_string_equal(text(), "t,step,dp\n#s,1,Pa\n0.1,1,7\n0.2,2,7\n0.3,3,7\n0.4,4,7\n0.5,5,8\n0.6,6,8\n");
    rows(7, 7, 6, 9);
    struct table_data *d = table_read(path, NULL);
    assert_int_equal(d->rows, 7);
    check_equal(d->value[6 * 3 + 2], 9);
    table_read_free(d);
    par_barrier();
    rows(1, 1, 0, 1); /* nothing is kept */
    assert_string_equal(text(), "t,step,dp\n#s,1,Pa\n0.1,1,1\n");
    if (par_rank() == 0) remove(path);
    par_barrier();
    rows(3, 3, 2, 1); /* a resume into a folder without a series begins one */
    assert_string_equal(text(), "t,step,dp\n#s,1,Pa\n0.3,3,1\n");
}

static void rows_of_a_checkpoint_are_told_from_others(void **state) {
    (void)state;
    char at_4[256], at_9[256];
    struct table *t = table_new(path, 3, name, unit, -1);
    for (int step = 1; step <= 9; step++) table_row(t, (double[]){0.1 * step, step, NAN});
    table_all_rows(4, at_4, sizeof at_4); /* rows of later steps are there already */
    table_all_rows(9, at_9, sizeof at_9);
    table_free(t);
    par_barrier();
    assert_string_not_equal(at_4, at_9);
    table_rows_set_expected(at_4);
    assert_null(table_rows_check(path, 4));
    table_rows_set_expected(at_9);
    assert_null(table_rows_check(path, 9));
    append("0.9,9,nan\n"); /* written again behind them: it is cut off */
    assert_null(table_rows_check(path, 9));
    rows(10, 10, 9, 1);
    struct table_data *d = table_read(path, NULL);
    assert_int_equal(d->rows, 10);
    table_read_free(d);
    par_barrier();
    rows(1, 9, -1, 7); /* as many others */
    assert_string_equal(table_rows_check(path, 9), "has other rows up to step 9 than were written");
    rows(1, 8, -1, NAN);
    assert_string_equal(table_rows_check(path, 9), "has 8 rows up to step 9, and 9 were written");
    table_rows_set_expected("");
    assert_null(table_rows_check(path, 9));
    par_barrier();
}

static void what_was_written_reads_back(void **state) {
    (void)state;
    const char *error = NULL;
    rows(1, 200, -1, 3.14159265358979);
    append("20.1,201");
    struct table_data *d = table_read(path, &error);
    assert_non_null(d);
    assert_int_equal(d->columns, 3);
    assert_int_equal(d->rows, 200);
    assert_string_equal(d->unit[2], "Pa");
    assert_int_equal(table_read_column(d, "dp"), 2);
    assert_int_equal(table_read_column(d, "Dp"), -1);
    for (long r = 0; r < d->rows; r++) {
        check_equal(d->value[3 * r + 1], (double)(r + 1));
        check_close(d->value[3 * r], 0.1 * (double)(r + 1), 1e-15 * 0.1 * (double)(r + 1) * 5); /* 15 digits */
    }
    table_read_free(d);
    par_barrier();
    append("\n"); /* now a whole row, of two numbers */
    assert_null(table_read(path, &error));
    assert_string_equal(error, "a row has not as many numbers as there are names");
    assert_null(table_read("/nowhere/series.csv", &error));
    assert_non_null(strstr(error, "No such file"));
    par_barrier();
}

static void no_table_is_told(void **state) {
    (void)state;
    const char *const bad[] = {"", "a,b\n", "a,b\n1,2\n", "a,b\n#s\n1,2\n", "#a,b\n#s,s\n", "a,b\n#s,s\n1,x\n"};
    for (int k = 0; k < 6; k++) {
        const char *error = NULL;
        if (par_rank() == 0) remove(path);
        par_barrier();
        append(bad[k]);
        assert_null(table_read(path, &error));
        assert_non_null(error);
        par_barrier();
    }
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder_path(path, files_folder("table"), "series.csv");
    const struct CMUnitTest tests[] = {cmocka_unit_test(rows_are_as_documented),
                                       cmocka_unit_test(a_row_is_on_its_way_at_once),
                                       cmocka_unit_test(resume_cuts_back_to_the_step),
                                       cmocka_unit_test(what_was_written_reads_back),
                                       cmocka_unit_test(no_table_is_told),
                                       cmocka_unit_test(rows_of_a_checkpoint_are_told_from_others)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
