/* Opens the newest whole checkpoint and reads its arrays with their checksums verified. */
#include "base/memory.h"
#include "base/par.h"
#include "base/files/store.h"
#include "base/files/store_private.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char error[1400];

const char *store_read_error(void) { return error; }

static int set_error(struct store *s, int fault) {
    if (fault) snprintf(error, sizeof error, "checkpoint %s: %s", s->h5.path, s->h5.why);
    return fault;
}

/* Opens the file after its seal has been verified, because HDF5 may crash on a damaged file. Rank 0 verifies, and all
 * ranks get the result. */
static int open_sealed(struct store *s, const char *path) {
    int bad = 0;
    snprintf(s->h5.path, sizeof s->h5.path, "%s", path);
    if (par_rank() == 0) bad = seal_file_read(&s->seal, path, s->h5.why, sizeof s->h5.why);
    par_bcast(&bad, sizeof bad, 0);
    par_bcast(&s->seal, sizeof s->seal, 0);
    if (bad) par_bcast(s->h5.why, sizeof s->h5.why, 0);
    return bad || h5_read_open(&s->h5, path, 0);
}

struct store *store_read_open(const char *path) {
    struct store *s = calloc(1, sizeof *s);
    if (strlen(path) < sizeof s->h5.path && !set_error(s, open_sealed(s, path))) return s;
    if (strlen(path) >= sizeof s->h5.path) snprintf(error, sizeof error, "checkpoint: its name is too long");
    free(s);
    return NULL;
}

static int damaged(struct store *s, const char *name) {
    s->damaged = 1;
    snprintf(s->h5.why, sizeof s->h5.why, "its array %s is damaged: its checksum is not the one it was written with",
             name);
    return set_error(s, 1);
}

/* Verifies each array's checksum before any of it is used; the ranks share the reading. */
static int check_arrays(struct store *s) {
    uint64_t sum[SEAL_ARRAYS] = {0};
    const int fault = seal_file_sum_part(&s->seal, s->h5.path, par_rank(), par_size(), sum);
    if (par_max(fault) > 0) {
        snprintf(s->h5.why, sizeof s->h5.why, "it cannot be read");
        return set_error(s, 1);
    }
    for (uint64_t k = 0; k < s->seal.arrays; k++)
        if ((uint64_t)par_sum_long((long)sum[k]) != s->seal.array[k].sum) return damaged(s, s->seal.array[k].name);
    return 0;
}

int store_read_is_there(const char *folder) {
    char checkpoint[FOLDER_PATH];
    char(*name)[256] = NULL;
    int n = 0;
    folder_path(checkpoint, folder, "checkpoint");
    if (par_rank() == 0) n = store_candidates(checkpoint, &name);
    par_bcast(&n, sizeof n, 0);
    free(name);
    if (n == 0) snprintf(error, sizeof error, "%s holds no checkpoint", checkpoint);
    return n > 0;
}

struct store *store_read_open_latest(const char *folder) {
    char checkpoint[FOLDER_PATH], path[FOLDER_PATH], first[sizeof error] = "";
    char(*name)[256] = NULL;
    struct store *s = NULL;
    int n = 0;
    folder_path(checkpoint, folder, "checkpoint");
    if (par_rank() == 0) n = store_candidates(checkpoint, &name);
    par_bcast(&n, sizeof n, 0);
    if (n == 0) snprintf(error, sizeof error, "%s holds no checkpoint", checkpoint);
    for (int k = 0; k < n && !s; k++) {
        if (par_rank() == 0) folder_path(path, checkpoint, name[k]);
        par_bcast(path, sizeof path, 0);
        s = store_read_open(path);
        if (s && check_arrays(s)) {
            store_read_close(s);
            s = NULL;
        }
        if (!s && par_rank() == 0) fprintf(stderr, "frana: passed over %s\n", error);
        if (!s && !first[0]) memcpy(first, error, sizeof first);
    }
    if (!s && first[0]) memcpy(error, first, sizeof first);
    free(name);
    return s;
}

const char *store_read_path(const struct store *s) { return s->h5.path; }

void store_read_close(struct store *s) {
    if (!s) return;
    h5_read_close(&s->h5);
    memory_free(s->scratch);
    free(s);
}

int store_read_is_damaged(const struct store *s) { return s->damaged; }

const char *store_read_other(const char *path) {
    static char other[FOLDER_PATH];
    char folder[FOLDER_PATH], why[256], (*name)[256] = NULL;
    const char *slash = strrchr(path, '/'), *own = slash ? slash + 1 : path;
    other[0] = '\0';
    if (par_rank() == 0 && strlen(path) < sizeof folder) {
        snprintf(folder, sizeof folder, "%.*s", slash ? (int)(slash - path) : 1, slash ? path : ".");
        const int n = store_candidates(folder, &name);
        for (int k = 0; k < n && !other[0]; k++)
            if (strcmp(name[k], own) != 0 && seal_file_check(folder_path(other, folder, name[k]), why, sizeof why))
                other[0] = '\0';
        free(name);
    }
    par_bcast(other, sizeof other, 0);
    return other[0] ? other : NULL;
}

/* Verifies the checksum of the array that was read. This rank has read count of its n items, with this checksum: either
 * the ranks' parts together make the array, or each rank has read all of it. */
static int check_sum(struct store *s, const char *name, long n, long count, uint64_t sum) {
    const struct seal_array *a = seal_find(&s->seal, name);
    if (n == 0) return 0;
    if (par_sum_long(count) == n) sum = (uint64_t)par_sum_long((long)sum);
    return par_max(!a || sum != a->sum) > 0 ? damaged(s, name) : 0;
}

int store_read_block(struct store *s, const char *name, const struct store_block *block, double *value) {
    const struct h5_block h = store_h5_block(block);
    const long n = (long)block->n[0] * block->n[1] * block->n[2], count = (long)block->m[0] * block->m[1] * block->m[2];
    if (store_is_contiguous(block))
        return set_error(s, h5_read(&s->h5, name, H5T_NATIVE_DOUBLE, &h, value)) ||
               check_sum(s, name, n, count, store_sum_block(block, value));
    const size_t row = (size_t)block->m[0];
    double *packed = store_scratch(s, row * (size_t)block->m[1] * (size_t)block->m[2]);
    if (set_error(s, h5_read(&s->h5, name, H5T_NATIVE_DOUBLE, &h, packed)) ||
        check_sum(s, name, n, count, store_sum_block(block, packed)))
        return 1;
    for (int k = 0; k < block->m[2] && row > 0; k++)
        for (int j = 0; j < block->m[1]; j++, packed += row)
            memcpy(value + k * block->plane + j * block->row, packed, row * sizeof *packed);
    return 0;
}

int store_read_range(struct store *s, const char *name, enum store_type type, int comps, long n, long first, long count,
                     void *value) {
    const struct h5_block h = store_h5_range(comps, n, first, count);
    return set_error(s, h5_read(&s->h5, name, store_h5_type(type), &h, value)) ||
           check_sum(s, name, n, count, seal_sum(value, (size_t)count, store_row(type, comps), (uint64_t)first));
}

int store_read_double(struct store *s, const char *name, double *value) {
    return set_error(s, h5_read_attribute(&s->h5, "/", name, H5T_NATIVE_DOUBLE, -1, value));
}

int store_read_long(struct store *s, const char *name, long *value) {
    return set_error(s, h5_read_attribute(&s->h5, "/", name, H5T_NATIVE_LONG, -1, value));
}

int store_read_text(struct store *s, const char *name, char *value, size_t bytes) {
    return set_error(s, h5_read_text(&s->h5, name, value, bytes));
}

long store_read_count(struct store *s, const char *name) {
    hsize_t n[H5_DIMS];
    return h5_read_size(&s->h5, name, n) < 1 ? -1 : (long)n[0];
}
