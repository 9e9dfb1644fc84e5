/* What one division over ranks writes, another reads; what is missing or of another kind is refused with a reason. */
#include "base/files/h5.h"
#include "tests/check.h"
#include "tests/base/files/files.h"

enum { ROWS = 11, COLUMNS = 3 };

static char path[FOLDER_PATH + 20];

/* This rank's rows; `empty`: as in files_split. */
static struct h5_block rows(int empty) {
    long first, count;
    files_split(ROWS, empty, &first, &count);
    return (struct h5_block){2, {ROWS, COLUMNS}, {(hsize_t)first, 0}, {(hsize_t)count, COLUMNS}};
}

static void arrays_attributes_and_texts(void **state) {
    (void)state;
    double value[ROWS][COLUMNS];
    const long numbers[2] = {-5, 1L << 40};
    const double size = 0.125;
    struct h5_block block = rows(0);
    for (int i = 0; i < (int)block.m[0]; i++)
        for (int c = 0; c < COLUMNS; c++) value[i][c] = 10 * ((int)block.lo[0] + i) + c;
    struct h5 f = {0};
    h5_begin(&f, path);
    h5_group(&f, "group");
    h5_write(&f, "group/value", H5T_NATIVE_DOUBLE, &block, value);
    h5_attribute(&f, "group", "numbers", H5T_NATIVE_LONG, 2, numbers);
    h5_attribute(&f, "group/value", "size", H5T_NATIVE_DOUBLE, -1, &size);
    h5_attribute_text(&f, "group", "title", "an attribute");
    h5_write_text(&f, "group/text", "a text\nof two lines");
    assert_int_equal(par_rank() == 0 ? files_exists(path) : 0, 0);
    h5_end(&f);

    f = (struct h5){0};
    assert_int_equal(h5_read_open(&f, path, 0), 0);
    hsize_t n[H5_DIMS];
    assert_int_equal(h5_read_size(&f, "group/value", n), 2);
    assert_int_equal(n[0], ROWS);
    assert_int_equal(n[1], COLUMNS);
    assert_int_equal(h5_read_size(&f, "group/other", n), -1);
    block = rows(1); /* another rank has none */
    assert_int_equal(h5_read(&f, "group/value", H5T_NATIVE_DOUBLE, &block, value), 0);
    for (int i = 0; i < (int)block.m[0]; i++)
        for (int c = 0; c < COLUMNS; c++) check_equal(value[i][c], 10 * ((int)block.lo[0] + i) + c);
    long read_numbers[2];
    double read_size;
    char text[40];
    assert_int_equal(h5_read_attribute(&f, "group", "numbers", H5T_NATIVE_LONG, 2, read_numbers), 0);
    assert_true(read_numbers[0] == numbers[0] && read_numbers[1] == numbers[1]);
    assert_int_equal(h5_read_attribute(&f, "group/value", "size", H5T_NATIVE_DOUBLE, -1, &read_size), 0);
    check_equal(read_size, size);
    assert_int_equal(h5_read_attribute_text(&f, "group", "title", text, sizeof text), 0);
    assert_string_equal(text, "an attribute");
    assert_int_equal(h5_read_text(&f, "group/text", text, sizeof text), 0);
    assert_string_equal(text, "a text\nof two lines");
    h5_read_close(&f);
}

/* Reads the file of the test above. */
static void wrong_requests_have_a_reason(void **state) {
    (void)state;
    double value[ROWS][COLUMNS];
    long numbers[3];
    char text[40];
    struct h5_block block = rows(0);
    struct h5 f = {0};
    assert_int_equal(h5_read_open(&f, path, 0), 0);
    assert_int_not_equal(h5_read(&f, "group/other", H5T_NATIVE_DOUBLE, &block, value), 0);
    assert_string_equal(f.why, "it has no array group/other");
    assert_int_not_equal(h5_read(&f, "group/value", H5T_NATIVE_LONG, &block, value), 0);
    assert_string_equal(f.why, "its array group/value holds another type of number");
    block.n[0]++;
    assert_int_not_equal(h5_read(&f, "group/value", H5T_NATIVE_DOUBLE, &block, value), 0);
    assert_string_equal(f.why, "its array group/value is of size 11 x 3, not 12 x 3");
    assert_int_not_equal(h5_read_text(&f, "group/text", text, 7), 0);
    assert_string_equal(f.why, "its group/text is not a text of less than 7 bytes");
    assert_int_not_equal(h5_read_attribute(&f, "group", "none", H5T_NATIVE_LONG, 2, numbers), 0);
    assert_string_equal(f.why, "it has no value none");
    assert_int_not_equal(h5_read_attribute(&f, "group", "numbers", H5T_NATIVE_LONG, 3, numbers), 0);
    assert_string_equal(f.why, "its value numbers is of another kind");
    h5_read_close(&f);
    f = (struct h5){0};
    assert_int_not_equal(h5_read_open(&f, FRANA_SOURCE_DIR "/README.md", 0), 0);
    assert_string_equal(f.why, "it is not an HDF5 file");
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    snprintf(path, sizeof path, "%s/it.h5", files_folder("h5"));
    if (par_rank() == 0) remove(path); /* of a run before this one */
    par_barrier();
    const struct CMUnitTest tests[] = {cmocka_unit_test(arrays_attributes_and_texts),
                                       cmocka_unit_test(wrong_requests_have_a_reason)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
