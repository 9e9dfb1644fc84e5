#include "base/store.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/store_private.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char error[1400];

const char *store_error(void) { return error; }

static int told(struct store *s, int fault) {
    if (fault) snprintf(error, sizeof error, "checkpoint %s: %s", s->h5.path, s->h5.why);
    return fault;
}

struct store *store_open(const char *path) {
    struct store *s = calloc(1, sizeof *s);
    if (strlen(path) < sizeof s->h5.path && !told(s, h5_open(&s->h5, path, 0))) return s;
    if (strlen(path) >= sizeof s->h5.path) snprintf(error, sizeof error, "checkpoint: its name is too long");
    free(s);
    return NULL;
}

struct store *store_open_latest(const char *folder) {
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
        s = store_open(path);
        if (!s && !first[0]) memcpy(first, error, sizeof first);
    }
    if (!s && first[0]) memcpy(error, first, sizeof first);
    free(name);
    return s;
}

const char *store_path(const struct store *s) { return s->h5.path; }

void store_close(struct store *s) {
    if (!s) return;
    h5_close(&s->h5);
    memory_free(s->scratch);
    free(s);
}

int store_read_block(struct store *s, const char *name, const struct store_block *b, double *value) {
    const struct h5_block h = store_h5_block(b);
    if (store_is_contiguous(b)) return told(s, h5_read(&s->h5, name, H5T_NATIVE_DOUBLE, &h, value));
    const size_t row = (size_t)b->m[0];
    double *packed = store_scratch(s, row * (size_t)b->m[1] * (size_t)b->m[2]);
    if (told(s, h5_read(&s->h5, name, H5T_NATIVE_DOUBLE, &h, packed))) return 1;
    for (int k = 0; k < b->m[2] && row > 0; k++)
        for (int j = 0; j < b->m[1]; j++, packed += row)
            memcpy(value + k * b->plane + j * b->row, packed, row * sizeof *packed);
    return 0;
}

int store_read_range(struct store *s, const char *name, enum store_type type, int comps, long n, long first,
                     long count, void *value) {
    const struct h5_block h = store_h5_range(comps, n, first, count);
    return told(s, h5_read(&s->h5, name, store_h5_type(type), &h, value));
}

int store_read_double(struct store *s, const char *name, double *value) {
    return told(s, h5_attribute_read(&s->h5, "/", name, H5T_NATIVE_DOUBLE, -1, value));
}

int store_read_long(struct store *s, const char *name, long *value) {
    return told(s, h5_attribute_read(&s->h5, "/", name, H5T_NATIVE_LONG, -1, value));
}

int store_read_text(struct store *s, const char *name, char *value, size_t bytes) {
    return told(s, h5_read_text(&s->h5, name, value, bytes));
}

long store_count(struct store *s, const char *name) {
    hsize_t n[H5_DIMS];
    return h5_size(&s->h5, name, n) < 1 ? -1 : (long)n[0];
}
