/* Checkpoints written on one division of the arrays are read on any other. */
#include "base/files/seal.h"
#include "base/files/store.h"
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
#include <unistd.h>

static const char *folder;

enum { NX = 7, NY = 5, NZ = 9, N = 53, BYTES = 23 };

static double u_at(int i, int j, int k) { return sin(1.0 * i + 0.1 * j) + k / 3.0; }

/* A division over ranks along one axis, with `halo` ghosts round the block. */
static struct store_block block(int axis, int empty, int halo) {
    struct store_block b = {.n = {NX, NY, NZ}, .m = {NX, NY, NZ}};
    long first, count;
    files_split(b.n[axis], empty, &first, &count);
    b.lo[axis] = (int)first;
    b.m[axis] = (int)count;
    if (halo > 0) {
        b.row = b.m[0] + 2 * halo;
        b.plane = b.row * (b.m[1] + 2 * halo);
    }
    return b;
}

static double *array(const struct store_block *b, int halo, double **first, size_t *size) {
    *size = (size_t)(b->m[0] + 2 * halo) * (size_t)(b->m[1] + 2 * halo) * (size_t)(b->m[2] + 2 * halo);
    double *a = malloc((*size + 1) * sizeof *a);
    for (size_t i = 0; i <= *size; i++) a[i] = -7;
    *first = a + halo * (b->plane + b->row + 1);
    return a;
}

static ptrdiff_t at(const struct store_block *b, int i, int j, int k) {
    const ptrdiff_t row = b->row ? b->row : b->m[0], plane = b->row ? b->plane : row * b->m[1];
    return k * plane + j * row + i;
}

static void write_all(const char *name, int axis, int empty, int halo, int keep) {
    struct store_block b = block(axis, empty, halo);
    double *u;
    size_t size;
    long first, count;
    double *a = array(&b, halo, &u, &size);
    for (int k = 0; k < b.m[2]; k++)
        for (int j = 0; j < b.m[1]; j++)
            for (int i = 0; i < b.m[0]; i++) u[at(&b, i, j, k)] = u_at(b.lo[0] + i, b.lo[1] + j, b.lo[2] + k);
    files_split(N, empty, &first, &count);
    double d[N];
    int64_t id[N];
    uint8_t lambda[N][BYTES];
    for (long h = 0; h < count; h++) {
        d[h] = 1.0 / (double)(first + h + 3);
        id[h] = (first + h) << 35;
        for (int c = 0; c < BYTES; c++) lambda[h][c] = (uint8_t)(first + h + c);
    }
    struct store *s = store_begin(folder, name, keep);
    store_write_block(s, "u", &b, u);
    store_write_range(s, "d", STORE_DOUBLE, 1, N, first, count, d);
    store_write_range(s, "id", STORE_LONG, 1, N, first, count, id);
    store_write_range(s, "lambda", STORE_BYTE, BYTES, N, first, count, lambda);
    store_write_range(s, "nothing", STORE_DOUBLE, 1, 0, 0, 0, NULL);
    store_write_double(s, "t", 0.1);
    store_write_long(s, "step", 1L << 40);
    store_write_text(s, "scene", "domain:\n  size: [1, 2, 3]\n");
    store_write_text(s, "empty", "");
    store_end(s);
    free(a);
}

static void check_all(struct store *s, int axis, int empty, int halo) {
    struct store_block b = block(axis, empty, halo);
    double *u;
    size_t size, inside = 0;
    double *a = array(&b, halo, &u, &size);
    assert_int_equal(store_read_block(s, "u", &b, u), 0);
    for (int k = 0; k < b.m[2]; k++)
        for (int j = 0; j < b.m[1]; j++)
            for (int i = 0; i < b.m[0]; i++)
                check_equal(u[at(&b, i, j, k)], u_at(b.lo[0] + i, b.lo[1] + j, b.lo[2] + k));
    for (size_t i = 0; i <= size; i++) inside += a[i] != -7;
    assert_int_equal(inside, (size_t)b.m[0] * (size_t)b.m[1] * (size_t)b.m[2]); /* ghosts are not changed */
    free(a);

    long first, count, step = 0;
    double d[N], t = 0;
    int64_t id[N];
    uint8_t lambda[N][BYTES];
    char scene[64];
    files_split(N, empty, &first, &count);
    assert_int_equal(store_read_range(s, "d", STORE_DOUBLE, 1, N, first, count, d), 0);
    assert_int_equal(store_read_range(s, "id", STORE_LONG, 1, N, first, count, id), 0);
    assert_int_equal(store_read_range(s, "lambda", STORE_BYTE, BYTES, N, first, count, lambda), 0);
    assert_int_equal(store_read_range(s, "nothing", STORE_DOUBLE, 1, 0, 0, 0, NULL), 0);
    for (long h = 0; h < count; h++) {
        check_equal(d[h], 1.0 / (double)(first + h + 3));
        check_equal(id[h], (first + h) << 35);
        for (int c = 0; c < BYTES; c++) assert_int_equal(lambda[h][c], (uint8_t)(first + h + c));
    }
    assert_int_equal(store_read_count(s, "id"), N);
    assert_int_equal(store_read_count(s, "lambda"), N);
    assert_int_equal(store_read_count(s, "none"), -1);
    assert_int_equal(store_read_double(s, "t", &t), 0);
    assert_int_equal(store_read_long(s, "step", &step), 0);
    check_equal(t, 0.1);
    check_equal(step, 1L << 40);
    assert_int_equal(store_read_text(s, "scene", scene, sizeof scene), 0);
    assert_string_equal(scene, "domain:\n  size: [1, 2, 3]\n");
    assert_int_equal(store_read_text(s, "empty", scene, sizeof scene), 0);
    assert_string_equal(scene, "");
    assert_int_equal(store_read_text(s, "scene", scene, 5), 1);
}

static void any_division_reads_what_any_wrote(void **state) {
    (void)state;
    for (int wrote = 0; wrote < 3; wrote++) {
        write_all("division_1", wrote, wrote, wrote, 2);
        for (int reads = 0; reads < 3; reads++) {
            struct store *s = store_read_open_latest(folder);
            assert_non_null(s);
            check_all(s, reads, reads + 1, 2 - reads);
            store_read_close(s);
        }
    }
}

static void what_does_not_fit_is_told(void **state) {
    (void)state;
    char path[FOLDER_PATH];
    double value[N + 1], t;
    long step;
    write_all("misfit_1", 2, 0, 0, 2);
    struct store *s = store_read_open(folder_path(path, folder, "checkpoint/misfit_1.h5"));
    assert_non_null(s);
    value[0] = 5;
    assert_int_equal(store_read_range(s, "none", STORE_DOUBLE, 1, N, 0, N, value), 1);
    assert_non_null(strstr(store_read_error(), "it has no array none"));
    assert_int_equal(store_read_range(s, "d", STORE_DOUBLE, 1, N + 1, 0, N + 1, value), 1);
    assert_non_null(strstr(store_read_error(), "its array d is of size 53, not 54"));
    assert_int_equal(store_read_range(s, "d", STORE_LONG, 1, N, 0, N, value), 1);
    assert_non_null(strstr(store_read_error(), "another type"));
    assert_int_equal(store_read_range(s, "id", STORE_DOUBLE, 1, N, 0, N, value), 1);
    assert_int_equal(store_read_range(s, "lambda", STORE_BYTE, BYTES + 1, N, 0, 1, value), 1);
    assert_int_equal(store_read_range(s, "u", STORE_DOUBLE, 1, N, 0, N, value), 1);
    check_equal(value[0], 5);
    assert_int_equal(store_read_double(s, "none", &t), 1);
    assert_int_equal(store_read_long(s, "t", &step), 1); /* a double is not an integer */
    assert_non_null(strstr(store_read_error(), "its value t is of another kind"));
    store_read_close(s);
}

static void latest_two_are_kept(void **state) {
    (void)state;
    char path[FOLDER_PATH], name[32], latest[64] = "";
    write_all("stage_flow", 2, 0, 0, 2);      /* another kind: stays */
    for (int step = 98; step < 102; step++) { /* the names' order is not the files' */
        snprintf(name, sizeof name, "step_%d", step);
        write_all(name, 2, 0, 0, 2);
    }
    for (int step = 98; step < 102; step++) {
        snprintf(name, sizeof name, "checkpoint/step_%d.h5", step);
        assert_int_equal(files_exists(folder_path(path, folder, name)), step >= 100);
        strcat(name, ".part");
        assert_false(files_exists(folder_path(path, folder, name)));
    }
    assert_true(files_exists(folder_path(path, folder, "checkpoint/stage_flow.h5")));
    FILE *f = fopen(folder_path(path, folder, "checkpoint/latest"), "r");
    assert_non_null(f);
    assert_int_equal(fscanf(f, "%63s", latest), 1);
    fclose(f);
    assert_string_equal(latest, "step_101.h5");
    par_barrier();
}

static void damaged_files_are_passed_over(void **state) {
    (void)state;
    char older[FOLDER_PATH], newer[FOLDER_PATH];
    folder_path(older, folder, "checkpoint/step_200.h5");
    folder_path(newer, folder, "checkpoint/step_201.h5");
    write_all("step_200", 2, 0, 0, 2);
    write_all("step_201", 2, 0, 0, 2);
    if (par_rank() == 0) assert_int_equal(truncate(newer, 4000), 0);
    par_barrier();
    assert_null(store_read_open(newer));
    assert_non_null(strstr(store_read_error(), "truncated"));
    struct store *s = store_read_open_latest(folder);
    assert_non_null(s);
    assert_string_equal(store_read_path(s), older);
    check_all(s, 0, 1, 1);
    store_read_close(s);
    if (par_rank() == 0) assert_int_equal(truncate(newer, 0), 0);
    par_barrier();
    assert_null(store_read_open(newer));
    assert_non_null(strstr(store_read_error(), "not an HDF5 file"));
    assert_null(store_read_open("/nowhere/at/all.h5"));
    assert_non_null(strstr(store_read_error(), "No such file"));
    par_barrier();
}

/* A bit of an array is inverted, or `latest` names no file, is empty, is missing: the newest intact checkpoint is
 * found. */
static void the_newest_that_is_whole_is_found(void **state) {
    (void)state;
    char older[FOLDER_PATH], newer[FOLDER_PATH], latest[FOLDER_PATH], why[256];
    struct seal seal;
    folder_clear(folder);
    write_all("step_300", 2, 0, 0, 2);
    write_all("step_301", 2, 0, 0, 2);
    folder_path(older, folder, "checkpoint/step_300.h5");
    folder_path(newer, folder, "checkpoint/step_301.h5");
    folder_path(latest, folder, "checkpoint/latest");
    const char *const names[] = {"step_999.h5\n", "", NULL};
    for (int k = 0; k < 3; k++) {
        if (par_rank() == 0) {
            remove(latest);
            FILE *f = names[k] ? fopen(latest, "w") : NULL;
            if (f) fputs(names[k], f), fclose(f);
        }
        par_barrier();
        struct store *s = store_read_open_latest(folder);
        assert_non_null(s);
        assert_string_equal(store_read_path(s), newer);
        store_read_close(s);
        par_barrier();
    }
    assert_int_equal(seal_file_read(&seal, newer, why, sizeof why), 0);
    for (uint64_t k = 0; k < seal.arrays; k++) { /* each array in turn */
        const off_t at = (off_t)(seal.array[k].at + seal.array[k].bytes * (k % 3) / 3);
        FILE *f = par_rank() == 0 ? fopen(newer, "r+") : NULL;
        for (int back = 0; back < 2; back++) {
            if (f) {
                fseek(f, at, SEEK_SET);
                const int byte = fgetc(f) ^ 4;
                fseek(f, at, SEEK_SET);
                fputc(byte, f);
                fflush(f);
            }
            par_barrier();
            struct store *s = store_read_open_latest(folder);
            assert_non_null(s);
            assert_string_equal(store_read_path(s), back ? newer : older);
            if (!back) assert_non_null(strstr(store_read_error(), seal.array[k].name));
            store_read_close(s);
            par_barrier();
        }
        if (f) fclose(f);
    }
}

static void no_checkpoint_is_told(void **state) {
    (void)state;
    folder_clear(folder);
    assert_null(store_read_open_latest(folder));
    assert_non_null(strstr(store_read_error(), "holds no checkpoint"));
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    folder = files_folder("store");
    const struct CMUnitTest tests[] = {cmocka_unit_test(any_division_reads_what_any_wrote),
                                       cmocka_unit_test(what_does_not_fit_is_told),
                                       cmocka_unit_test(latest_two_are_kept),
                                       cmocka_unit_test(damaged_files_are_passed_over),
                                       cmocka_unit_test(the_newest_that_is_whole_is_found),
                                       cmocka_unit_test(no_checkpoint_is_told)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
