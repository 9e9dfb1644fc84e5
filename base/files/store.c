/* Writes checkpoint files, names the latest, and deletes the oldest. */
#include "base/files/store.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"
#include "base/files/plain_file.h"
#include "base/files/store_private.h"

#include <ctype.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct store *store_begin(const char *folder, const char *name, int keep) {
    char path[FOLDER_PATH];
    struct store *s = calloc(1, sizeof *s);
    clock_begin(CLOCK_OUTPUT);
    folder_path(s->folder, folder, "checkpoint");
    if (snprintf(s->name, sizeof s->name, "%s.h5", name) >= (int)sizeof s->name)
        die_all(EXIT_CODE_FILE, "checkpoint %s: the name is too long", name);
    s->keep = keep;
    h5_begin(&s->h5, folder_path(path, s->folder, s->name));
    s->h5.seal = &s->seal;
    return s;
}

hid_t store_h5_type(enum store_type type) {
    switch (type) {
    case STORE_DOUBLE:
        return H5T_NATIVE_DOUBLE;
    case STORE_BYTE:
        return H5T_NATIVE_UINT8;
    case STORE_LONG:
        return H5T_NATIVE_INT64;
    }
    ENSURE(0, "store type %d", (int)type);
}

size_t store_row(enum store_type type, int comps) { return (type == STORE_BYTE ? 1 : 8) * (size_t)comps; }

/* Scratch memory, owned by the store. */
double *store_scratch(struct store *s, size_t items) {
    if (items > s->scratch_items) {
        memory_free(s->scratch);
        s->scratch = memory_new(MEMORY_OUTPUT, items, sizeof *s->scratch);
        s->scratch_items = items;
    }
    return s->scratch;
}

int store_is_contiguous(const struct store_block *block) {
    return block->row == 0 || (block->row == block->m[0] && block->plane == (ptrdiff_t)block->m[0] * block->m[1]);
}

struct h5_block store_h5_block(const struct store_block *block) {
    struct h5_block h = {.dims = 3};
    for (int k = 0; k < 3; k++) { /* HDF5 counts the slowest index first */
        h.n[k] = (hsize_t)block->n[2 - k];
        h.lo[k] = (hsize_t)block->lo[2 - k];
        h.m[k] = (hsize_t)block->m[2 - k];
    }
    return h;
}

struct h5_block store_h5_range(int comps, long n, long first, long count) {
    struct h5_block h = {.dims = comps > 1 ? 2 : 1};
    h.n[0] = (hsize_t)n;
    h.lo[0] = (hsize_t)first;
    h.m[0] = (hsize_t)count;
    h.n[1] = h.m[1] = (hsize_t)comps;
    return h;
}

uint64_t store_sum_block(const struct store_block *block, const double *value) {
    const uint64_t n0 = (uint64_t)block->n[0], n1 = (uint64_t)block->n[1];
    uint64_t sum = 0;
    if (block->m[0] == 0) return 0;
    for (int k = 0; k < block->m[2]; k++)
        for (int j = 0; j < block->m[1]; j++, value += block->m[0])
            sum += seal_sum(value, (size_t)block->m[0], sizeof *value,
                            ((uint64_t)(block->lo[2] + k) * n1 + (uint64_t)(block->lo[1] + j)) * n0 +
                                (uint64_t)block->lo[0]);
    return sum;
}

/* Adds the array just written to the seal; sum: this rank's part of the checksum. */
static void seal(struct store *s, const char *name, size_t row, uint64_t sum) {
    if (s->h5.failed || s->h5.end == s->h5.at) return;
    seal_add(&s->seal, name, (uint64_t)s->h5.at, (uint64_t)(s->h5.end - s->h5.at), row,
             (uint64_t)par_sum_long((long)sum));
}

void store_write_block(struct store *s, const char *name, const struct store_block *block, const double *value) {
    const struct h5_block h = store_h5_block(block);
    if (!store_is_contiguous(block)) {
        const size_t row = (size_t)block->m[0];
        double *packed = store_scratch(s, row * (size_t)block->m[1] * (size_t)block->m[2]), *to = packed;
        for (int k = 0; k < block->m[2] && row > 0; k++)
            for (int j = 0; j < block->m[1]; j++, to += row)
                memcpy(to, value + k * block->plane + j * block->row, row * sizeof *to);
        value = packed;
    }
    h5_write(&s->h5, name, H5T_NATIVE_DOUBLE, &h, value);
    seal(s, name, sizeof *value, store_sum_block(block, value));
}

void store_write_range(struct store *s, const char *name, enum store_type type, int comps, long n, long first,
                       long count, const void *value) {
    const struct h5_block h = store_h5_range(comps, n, first, count);
    h5_write(&s->h5, name, store_h5_type(type), &h, value);
    const size_t row = store_row(type, comps);
    if (n > 0) seal(s, name, row, seal_sum(value, (size_t)count, row, (uint64_t)first));
}

void store_write_double(struct store *s, const char *name, double value) {
    h5_attribute(&s->h5, "/", name, H5T_NATIVE_DOUBLE, -1, &value);
}

void store_write_long(struct store *s, const char *name, long value) {
    h5_attribute(&s->h5, "/", name, H5T_NATIVE_LONG, -1, &value);
}

void store_write_text(struct store *s, const char *name, const char *value) { h5_write_text(&s->h5, name, value); }

/* Whether two file names are of the same kind: equal up to the first digit. */
static int is_alike(const char *a, const char *b) {
    while (*a && *a == *b && !isdigit((unsigned char)*a)) a++, b++;
    return isdigit((unsigned char)*a) && isdigit((unsigned char)*b);
}

struct old {
    char name[256];
    struct timespec when;
};

static int newest_first(const void *a, const void *b) {
    const struct old *p = a, *q = b;
    if (p->when.tv_sec != q->when.tv_sec) return p->when.tv_sec < q->when.tv_sec ? 1 : -1;
    if (p->when.tv_nsec != q->when.tv_nsec) return p->when.tv_nsec < q->when.tv_nsec ? 1 : -1;
    return strcmp(q->name, p->name);
}

/* Finished checkpoints in a folder, newest first, malloc'ed. */
static int list_old(const char *folder, struct old **list) {
    int n = 0;
    DIR *dir = opendir(folder);
    *list = NULL;
    for (struct dirent *entry; dir && (entry = readdir(dir));) {
        char path[FOLDER_PATH];
        struct stat is;
        const size_t length = strlen(entry->d_name);
        if (length < 4 || strcmp(entry->d_name + length - 3, ".h5") != 0) continue;
        if (stat(folder_path(path, folder, entry->d_name), &is) != 0 || !S_ISREG(is.st_mode)) continue;
        *list = realloc(*list, (size_t)(n + 1) * sizeof **list);
        snprintf((*list)[n].name, sizeof(*list)[n].name, "%s", entry->d_name);
        (*list)[n++].when = is.st_mtim;
    }
    if (dir) closedir(dir);
    if (n > 0) qsort(*list, (size_t)n, sizeof **list, newest_first);
    return n;
}

/* Deletes all but the `keep` newest checkpoints of the new file's kind. */
static void drop_older(const struct store *s) {
    struct old *list;
    const int n = list_old(s->folder, &list);
    int kept = 1;
    for (int k = 0; k < n; k++) {
        char path[FOLDER_PATH];
        if (strcmp(list[k].name, s->name) == 0 || !is_alike(list[k].name, s->name)) continue;
        if (kept++ >= s->keep) unlink(folder_path(path, s->folder, list[k].name));
    }
    free(list);
}

static void name_latest(const struct store *s) {
    char path[FOLDER_PATH];
    struct atomic_write a;
    atomic_write_begin(&a, folder_path(path, s->folder, "latest"));
    fprintf(a.file, "%s\n", s->name);
    atomic_write_end(&a);
}

void store_end(struct store *s) {
    h5_end(&s->h5);
    if (par_rank() == 0) {
        name_latest(s);
        if (s->keep > 0) drop_older(s);
    }
    par_barrier();
    memory_free(s->scratch);
    free(s);
    clock_end(CLOCK_OUTPUT);
}

/* Files to try for a resume, best first: the one that `latest` names, then the others, newest first. */
int store_candidates(const char *folder, char (**name)[256]) {
    char path[FOLDER_PATH], latest[256] = "";
    struct old *list;
    FILE *f = plain_file_read(folder_path(path, folder, "latest"));
    if (f && !fgets(latest, sizeof latest, f)) latest[0] = '\0';
    latest[strcspn(latest, "\r\n")] = '\0'; /* names may hold spaces */
    if (f) fclose(f);
    const int old = list_old(folder, &list);
    int n = 0;
    *name = calloc((size_t)old + 1, sizeof **name);
    for (int k = 0; k < old; k++)
        if (strcmp(list[k].name, latest) == 0) memcpy((*name)[n++], list[k].name, sizeof **name);
    for (int k = 0; k < old; k++)
        if (strcmp(list[k].name, latest) != 0) memcpy((*name)[n++], list[k].name, sizeof **name);
    free(list);
    return n;
}
