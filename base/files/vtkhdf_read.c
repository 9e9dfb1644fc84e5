/* Reads VTKHDF files back on one rank. */
#include "base/files/h5.h"
#include "base/files/vtkhdf.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The whole dataset as a block, read by one rank. */
static int whole(struct h5 *f, const char *name, struct h5_block *block) {
    memset(block, 0, sizeof *block);
    block->dims = h5_read_size(f, name, block->n);
    for (int k = 0; k < block->dims; k++) block->m[k] = block->n[k];
    return block->dims < 0;
}

static int read_all(struct h5 *f, const char *name, hid_t type, void *value) {
    struct h5_block b;
    return whole(f, name, &b) || h5_read(f, name, type, &b, value);
}

static void field(struct vtkhdf_source *s, const char *name) {
    char path[320];
    hsize_t n[H5_DIMS];
    struct h5 *f = s->file;
    struct vtkhdf_field *a = &s->field[s->fields];
    if (strlen(name) >= sizeof a->name) return;
    snprintf(path, sizeof path, "VTKHDF/PointData/%s", name);
    const int dims = h5_read_size(f, path, n), own = s->image ? 3 : 1;
    if (dims != own && dims != own + 1) return;
    const hid_t set = H5Dopen2(f->file, path, H5P_DEFAULT), type = H5Dget_type(set);
    strcpy(a->name, name);
    a->comps = dims == own ? 1 : (int)n[own];
    a->integer = H5Tget_class(type) == H5T_INTEGER;
    H5Tclose(type);
    H5Dclose(set);
    s->fields++;
}

static int list_fields(struct vtkhdf_source *s) {
    struct h5 *f = s->file;
    const hid_t group = H5Gopen2(f->file, "VTKHDF/PointData", H5P_DEFAULT);
    H5G_info_t info;
    if (group < 0 || H5Gget_info(group, &info) < 0) return 1;
    s->field = calloc(info.nlinks + 1, sizeof *s->field);
    for (hsize_t k = 0; k < info.nlinks; k++) {
        char name[256];
        if (H5Lget_name_by_idx(group, ".", H5_INDEX_NAME, H5_ITER_INC, k, name, sizeof name, H5P_DEFAULT) > 0)
            field(s, name);
    }
    H5Gclose(group);
    return 0;
}

static int geometry(struct vtkhdf_source *s, const char *type) {
    struct h5 *f = s->file;
    int64_t extent[6], points;
    s->image = strcmp(type, "ImageData") == 0;
    if (!s->image) {
        const int fault = read_all(f, "VTKHDF/NumberOfPoints", H5T_NATIVE_INT64, &points);
        s->points = fault ? 0 : points;
        return fault;
    }
    if (h5_read_attribute(f, "VTKHDF", "WholeExtent", H5T_NATIVE_INT64, 6, extent) ||
        h5_read_attribute(f, "VTKHDF", "Origin", H5T_NATIVE_DOUBLE, 3, s->origin) ||
        h5_read_attribute(f, "VTKHDF", "Spacing", H5T_NATIVE_DOUBLE, 3, s->spacing))
        return 1;
    s->points = 1;
    for (int k = 0; k < 3; k++) {
        s->n[k] = (int)(extent[2 * k + 1] - extent[2 * k] + 1);
        s->points *= s->n[k];
    }
    return 0;
}

struct vtkhdf_source *vtkhdf_read_open(const char *path, const char **error) {
    static char why[320];
    char type[32] = "";
    int64_t step = 0;
    struct vtkhdf_source *s = calloc(1, sizeof *s);
    struct h5 *f = s->file = calloc(1, sizeof *f);
    int fault = h5_read_open(f, path, 1);
    if (!fault) fault = h5_read_attribute_text(f, "VTKHDF", "Type", type, sizeof type);
    if (!fault && strcmp(type, "ImageData") != 0 && strcmp(type, "UnstructuredGrid") != 0) {
        snprintf(f->why, sizeof f->why, "it holds a %s", type);
        fault = 1;
    }
    fault = fault || geometry(s, type) || list_fields(s) ||
            h5_read_attribute(f, "VTKHDF", "time", H5T_NATIVE_DOUBLE, -1, &s->time) ||
            h5_read_attribute(f, "VTKHDF", "step", H5T_NATIVE_INT64, -1, &step);
    s->step = step;
    if (!fault) return s;
    snprintf(why, sizeof why, "%s", f->why[0] ? f->why : "it is not a VTKHDF file of frana's");
    if (error) *error = why;
    vtkhdf_read_close(s);
    return NULL;
}

void vtkhdf_read_close(struct vtkhdf_source *s) {
    if (!s) return;
    h5_read_close(s->file);
    free(s->file);
    free(s->field);
    free(s);
}

static const struct vtkhdf_field *find(const struct vtkhdf_source *s, const char *name) {
    for (int k = 0; k < s->fields; k++)
        if (strcmp(s->field[k].name, name) == 0) return &s->field[k];
    return NULL;
}

int vtkhdf_read_comps(const struct vtkhdf_source *s, const char *name) {
    const struct vtkhdf_field *a = find(s, name);
    return a ? a->comps : 0;
}

double *vtkhdf_read_block(struct vtkhdf_source *s, const char *name, const int lo[3], const int m[3]) {
    char path[256];
    const struct vtkhdf_field *a = find(s, name);
    if (!a || !s->image || a->integer) return NULL;
    struct h5_block b = {.dims = a->comps > 1 ? 4 : 3};
    size_t n = (size_t)a->comps;
    for (int k = 0; k < 3; k++) { /* HDF5 counts the slowest index first */
        b.n[k] = (hsize_t)s->n[2 - k];
        b.lo[k] = (hsize_t)lo[2 - k];
        b.m[k] = (hsize_t)m[2 - k];
        n *= (size_t)m[k];
    }
    b.n[3] = b.m[3] = (hsize_t)a->comps;
    double *value = malloc((n + 1) * sizeof *value);
    snprintf(path, sizeof path, "VTKHDF/PointData/%s", name);
    if (value && !h5_read(s->file, path, H5T_NATIVE_DOUBLE, &b, value)) return value;
    free(value);
    return NULL;
}

static void *read_field(struct vtkhdf_source *s, const char *name, int integer) {
    char path[256];
    struct h5 *f = s->file;
    const struct vtkhdf_field *a = find(s, name);
    if (!a) return NULL;
    const size_t n = (size_t)s->points * (size_t)a->comps;
    int64_t *value = malloc((n + 1) * sizeof *value); /* integers of eight bytes, converted to doubles */
    snprintf(path, sizeof path, "VTKHDF/PointData/%s", name);
    const hid_t type = a->integer ? H5T_NATIVE_INT64 : H5T_NATIVE_DOUBLE;
    if (!value || (integer && !a->integer) || read_all(f, path, type, value)) {
        free(value);
        return NULL;
    }
    if (a->integer && !integer)
        for (size_t i = 0; i < n; i++) {
            const double x = (double)value[i];
            memcpy(&value[i], &x, sizeof x);
        }
    return value;
}

double *vtkhdf_read_double(struct vtkhdf_source *s, const char *name) { return read_field(s, name, 0); }

int64_t *vtkhdf_read_long(struct vtkhdf_source *s, const char *name) { return read_field(s, name, 1); }

double (*vtkhdf_read_points(struct vtkhdf_source *s))[3] {
    double(*x)[3] = malloc(((size_t)s->points + 1) * sizeof *x);
    if (!s->image) {
        if (x && read_all(s->file, "VTKHDF/Points", H5T_NATIVE_DOUBLE, x)) {
            free(x);
            x = NULL;
        }
        return x;
    }
    for (long p = 0; x && p < s->points; p++) {
        const long i = p % s->n[0], j = p / s->n[0] % s->n[1], k = p / s->n[0] / s->n[1];
        x[p][0] = s->origin[0] + (double)i * s->spacing[0];
        x[p][1] = s->origin[1] + (double)j * s->spacing[1];
        x[p][2] = s->origin[2] + (double)k * s->spacing[2];
    }
    return x;
}
