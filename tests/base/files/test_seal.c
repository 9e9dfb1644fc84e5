/* Every changed bit of a checkpoint is detected, and the damaged array is named. */
#include "base/files/seal.h"
#include "base/files/store.h"
#include "tests/check.h"
#include "tests/base/files/files.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <cmocka.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *folder;

enum { NX = 4, NY = 3, NZ = 5, N = 21, BYTES = 11, FILE_MAX = 1 << 18 };

static void of_any_division(void **state) {
    (void)state;
    unsigned char value[40 * BYTES];
    for (size_t i = 0; i < sizeof value; i++) value[i] = (unsigned char)(i * i % 251);
    for (size_t row = 1; row <= BYTES; row++) {
        const uint64_t whole = seal_sum(value, 40, row, 0);
        for (size_t cut = 0; cut <= 40; cut++)
            assert_int_equal(seal_sum(value, cut, row, 0) + seal_sum(value + cut * row, 40 - cut, row, cut), whole);
    }
}

static void of_no_other_value(void **state) {
    (void)state;
    unsigned char value[5 * BYTES] = {0};
    const uint64_t whole = seal_sum(value, 5, BYTES, 0);
    for (size_t bit = 0; bit < 8 * sizeof value; bit++) {
        value[bit / 8] ^= (unsigned char)(1u << bit % 8);
        assert_true(seal_sum(value, 5, BYTES, 0) != whole);
        value[bit / 8] = 0;
    }
    assert_true(seal_sum(value, 5, BYTES, 1) != whole);
    double pair[2] = {1, 2};
    const uint64_t straight = seal_sum(pair, 2, 8, 0);
    pair[0] = 2, pair[1] = 1;
    assert_true(seal_sum(pair, 2, 8, 0) != straight);
}

static const char *const array_name[] = {"u", "d", "lambda", "flag"};

static void write_all(const char *name, const double *u, const double *d, const uint8_t *lambda) {
    long first, count, low, planes;
    files_split(N, 1, &first, &count);
    files_split(NZ, 0, &low, &planes);
    const struct store_block b = {.n = {NX, NY, NZ}, .lo = {0, 0, (int)low}, .m = {NX, NY, (int)planes}};
    struct store *s = store_begin(folder, name, 2);
    store_write_block(s, "u", &b, u + low * NX * NY);
    store_write_range(s, "d", STORE_DOUBLE, 3, N, first, count, d + 3 * first);
    store_write_range(s, "lambda", STORE_BYTE, BYTES, N, first, count, lambda + first * BYTES);
    store_write_range(s, "flag", STORE_BYTE, 1, N, first, count, lambda + first);
    store_write_range(s, "nothing", STORE_DOUBLE, 3, 0, 0, 0, NULL);
    store_write_double(s, "t", 0.25);
    store_write_text(s, "stage", "settle");
    store_end(s);
}

static void write_some(const char *name) {
    double u[NX * NY * NZ], d[3 * N];
    uint8_t lambda[N * BYTES];
    for (int i = 0; i < NX * NY * NZ; i++) u[i] = 1.0 / (i + 1);
    for (int i = 0; i < 3 * N; i++) d[i] = i;
    for (int i = 0; i < N * BYTES; i++) lambda[i] = (uint8_t)i;
    write_all(name, u, d, lambda);
}

/* Reads the whole file with this division over ranks; 0, or 1 and store_read_error. */
static int read_all(const char *path) {
    double u[NX * NY * NZ], d[3 * N], t;
    uint8_t lambda[N * BYTES], flag[N];
    char stage[64];
    long first, count, low, wide;
    files_split(N, 0, &first, &count);
    files_split(NX, 1, &low, &wide);
    const struct store_block b = {.n = {NX, NY, NZ}, .lo = {(int)low, 0, 0}, .m = {(int)wide, NY, NZ}};
    struct store *s = store_read_open(path);
    if (!s) return 1;
    const int bad = store_read_block(s, "u", &b, u) ||
                    store_read_range(s, "d", STORE_DOUBLE, 3, N, 0, N, d) || /* all of it on every rank */
                    store_read_range(s, "lambda", STORE_BYTE, BYTES, N, first, count, lambda) ||
                    store_read_range(s, "flag", STORE_BYTE, 1, N, first, count, flag) ||
                    store_read_range(s, "nothing", STORE_DOUBLE, 3, 0, 0, 0, NULL) || store_read_double(s, "t", &t) ||
                    store_read_text(s, "stage", stage, sizeof stage);
    store_read_close(s);
    return bad;
}

static uint8_t good[FILE_MAX];
static size_t bytes;

static void load(const char *path) {
    FILE *in = fopen(path, "rb");
    assert_non_null(in);
    bytes = fread(good, 1, sizeof good, in);
    check_below(bytes, sizeof good);
    fclose(in);
    par_barrier();
}

/* The file as it was, up to its first `size` bytes, with one byte changed by `bits`. */
static void spoil(const char *path, size_t size, size_t at, uint8_t bits) {
    par_barrier();
    if (par_rank() == 0) {
        FILE *out = fopen(path, "wb");
        assert_non_null(out);
        good[at] ^= bits;
        assert_int_equal(fwrite(good, 1, size, out), size);
        good[at] ^= bits;
        fclose(out);
    }
    par_barrier();
}

static void a_bit_of_each_array_is_told(void **state) {
    (void)state;
    char path[FOLDER_PATH], says[128], why[256];
    struct seal seal;
    write_some("bit_1");
    load(folder_path(path, folder, "checkpoint/bit_1.h5"));
    assert_int_equal(read_all(path), 0);
    assert_int_equal(seal_file_check(path, why, sizeof why), 0);
    assert_int_equal(seal_file_read(&seal, path, why, sizeof why), 0);
    assert_int_equal(seal.arrays, 4);
    for (int k = 0; k < 4; k++) {
        const struct seal_array *a = seal_find(&seal, array_name[k]);
        assert_non_null(a);
        const size_t place[] = {0, a->bytes / 2, a->bytes - 1};
        for (int p = 0; p < 3; p++) {
            spoil(path, bytes, a->at + place[p], (uint8_t)(1 << 3 * p));
            assert_int_equal(read_all(path), 1);
            snprintf(says, sizeof says, "its array %s is damaged", array_name[k]);
            assert_non_null(strstr(store_read_error(), says));
            assert_int_equal(seal_file_check(path, why, sizeof why), 1);
            assert_non_null(strstr(why, says));
        }
    }
    spoil(path, bytes, 0, 0);
    assert_int_equal(read_all(path), 0);
}

/* HDF5's own bytes, values and texts, and the seal itself: the damage is found before HDF5 opens the file. */
static void a_bit_anywhere_else_is_told(void **state) {
    (void)state;
    char path[FOLDER_PATH], why[256];
    struct seal seal, other;
    write_some("else_1");
    load(folder_path(path, folder, "checkpoint/else_1.h5"));
    assert_int_equal(seal_file_read(&seal, path, why, sizeof why), 0);
    for (size_t at = 0; at < bytes; at += 1 + at / 9 % 23) {
        int inside = 0;
        for (uint64_t k = 0; k < seal.arrays; k++)
            inside |= at >= seal.array[k].at && at < seal.array[k].at + seal.array[k].bytes;
        if (inside) continue;
        spoil(path, bytes, at, (uint8_t)(1u << at % 8));
        if (!seal_file_read(&other, path, why, sizeof why)) fail_msg("a bit of byte %zu is not told", at);
    }
    assert_null(store_read_open(path));
    par_barrier();
}

static void a_cut_is_told(void **state) {
    (void)state;
    char path[FOLDER_PATH];
    write_some("cut_1");
    load(folder_path(path, folder, "checkpoint/cut_1.h5"));
    const size_t size[] = {0, 7, 8, 40, 48, 2000, bytes / 2, bytes - sizeof(struct seal) - 1, bytes - 1};
    for (size_t k = 0; k < sizeof size / sizeof *size; k++) {
        spoil(path, size[k], 0, 0);
        assert_null(store_read_open(path));
        assert_non_null(strstr(store_read_error(), size[k] < 8 ? "not an HDF5 file" : "truncated or damaged"));
    }
}

static void another_format_is_told(void **state) {
    (void)state;
    char path[FOLDER_PATH];
    write_some("format_1");
    load(folder_path(path, folder, "checkpoint/format_1.h5"));
    spoil(path, bytes - sizeof(struct seal), 0, 0); /* the format before seals */
    assert_null(store_read_open(path));
    assert_non_null(strstr(store_read_error(), "written by an earlier version of frana"));
    spoil(path, bytes, bytes - sizeof(struct seal) + offsetof(struct seal, format), 1);
    assert_null(store_read_open(path));
    assert_non_null(strstr(store_read_error(), "it is of format 5, this frana reads format 4"));
}

static void another_that_is_whole_is_named(void **state) {
    (void)state;
    char older[FOLDER_PATH], newer[FOLDER_PATH], why[256];
    struct seal seal;
    folder_clear(folder);
    write_some("step_10");
    write_some("step_20");
    folder_path(older, folder, "checkpoint/step_10.h5");
    load(folder_path(newer, folder, "checkpoint/step_20.h5"));
    assert_string_equal(store_read_other(newer), older);
    assert_string_equal(store_read_other(older), newer);
    assert_int_equal(seal_file_read(&seal, newer, why, sizeof why), 0);
    spoil(newer, bytes, seal.array[2].at + 5, 64);
    assert_null(store_read_other(older)); /* its headers are intact, an array is damaged */
    par_barrier();
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("seal");
    const struct CMUnitTest tests[] = {cmocka_unit_test(of_any_division),
                                       cmocka_unit_test(of_no_other_value),
                                       cmocka_unit_test(a_bit_of_each_array_is_told),
                                       cmocka_unit_test(a_bit_anywhere_else_is_told),
                                       cmocka_unit_test(a_cut_is_told),
                                       cmocka_unit_test(another_format_is_told),
                                       cmocka_unit_test(another_that_is_whole_is_named)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
