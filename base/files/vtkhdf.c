/* Writes VTKHDF files of cell fields or particles from all ranks. */
#include "base/files/vtkhdf.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/files/h5.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { VERTEX = 1 }; /* VTK_VERTEX */

struct vtkhdf {
    struct h5 h5;
    struct h5_block block; /* of a scalar field */
    int wide;
    size_t items;  /* of this rank */
    float *narrow; /* doubles converted to the stored type */
    size_t narrow_items;
};

static struct vtkhdf *begin(const char *path, const char *type, double time, long step, int wide) {
    const int64_t version[2] = {1, 0}, whole_step = step;
    struct vtkhdf *f = calloc(1, sizeof *f);
    clock_begin(CLOCK_OUTPUT);
    f->wide = wide;
    h5_begin(&f->h5, path);
    f->h5.unsynced = 1; /* fields can be made again by the run, so they are not flushed to the disk; checkpoints are */
    h5_group(&f->h5, "VTKHDF");
    h5_attribute(&f->h5, "VTKHDF", "Version", H5T_NATIVE_INT64, 2, version);
    h5_attribute_text(&f->h5, "VTKHDF", "Type", type);
    h5_group(&f->h5, "VTKHDF/PointData");
    /* as attributes of our own: VTK 9.1 fails on field data of an ImageData */
    h5_attribute(&f->h5, "VTKHDF", "time", H5T_NATIVE_DOUBLE, -1, &time);
    h5_attribute(&f->h5, "VTKHDF", "step", H5T_NATIVE_INT64, -1, &whole_step);
    return f;
}

struct vtkhdf *vtkhdf_image_begin(const struct vtkhdf_image_input *in) {
    struct vtkhdf *f = begin(in->path, "ImageData", in->time, in->step, in->wide);
    const int64_t extent[6] = {0, in->n[0] - 1, 0, in->n[1] - 1, 0, in->n[2] - 1};
    const double direction[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
    h5_attribute(&f->h5, "VTKHDF", "WholeExtent", H5T_NATIVE_INT64, 6, extent);
    h5_attribute(&f->h5, "VTKHDF", "Origin", H5T_NATIVE_DOUBLE, 3, in->origin);
    h5_attribute(&f->h5, "VTKHDF", "Spacing", H5T_NATIVE_DOUBLE, 3, in->spacing);
    h5_attribute(&f->h5, "VTKHDF", "Direction", H5T_NATIVE_DOUBLE, 9, direction);
    f->block.dims = 3;
    f->items = 1;
    for (int k = 0; k < 3; k++) { /* HDF5 counts the slowest index first */
        f->block.n[k] = (hsize_t)in->n[2 - k];
        f->block.lo[k] = (hsize_t)in->lo[2 - k];
        f->block.m[k] = (hsize_t)in->m[2 - k];
        f->items *= (size_t)in->m[k];
    }
    return f;
}

/* Writes the cells of an unstructured grid of particles: each point is a cell of its own. */
static void cells(struct vtkhdf *f, long n, long first, long all) {
    const int last = par_rank() == par_size() - 1;
    const struct h5_block one = {.dims = 1, .n = {1}, .m = {par_rank() == 0}};
    struct h5_block ends = f->block;
    const int64_t count = all;
    int64_t *id = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *id);
    uint8_t *type = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *type);
    for (long i = 0; i <= n; i++) id[i] = first + i;
    memset(type, VERTEX, (size_t)n);
    ends.n[0] = (hsize_t)all + 1;
    ends.m[0] = (hsize_t)n + (hsize_t)last;
    h5_write(&f->h5, "VTKHDF/NumberOfPoints", H5T_NATIVE_INT64, &one, &count);
    h5_write(&f->h5, "VTKHDF/NumberOfCells", H5T_NATIVE_INT64, &one, &count);
    h5_write(&f->h5, "VTKHDF/NumberOfConnectivityIds", H5T_NATIVE_INT64, &one, &count);
    h5_write(&f->h5, "VTKHDF/Connectivity", H5T_NATIVE_INT64, &f->block, id);
    h5_write(&f->h5, "VTKHDF/Offsets", H5T_NATIVE_INT64, &ends, id);
    h5_write(&f->h5, "VTKHDF/Types", H5T_NATIVE_UINT8, &f->block, type);
    MEMORY_FREE(type, id);
}

struct vtkhdf *vtkhdf_points_begin(const struct vtkhdf_points_input *in) {
    struct vtkhdf *f = begin(in->path, "UnstructuredGrid", in->time, in->step, in->wide);
    const long all = par_sum_long(in->n), first = par_sum_before(in->n);
    f->block = (struct h5_block){.dims = 1, .n = {(hsize_t)all}, .lo = {(hsize_t)first}, .m = {(hsize_t)in->n}};
    f->items = (size_t)in->n;
    cells(f, in->n, first, all);
    struct h5_block three = f->block;
    three.dims = 2;
    three.n[1] = three.m[1] = 3;
    /* positions are stored as doubles: a displacement is far smaller than a position */
    h5_write(&f->h5, "VTKHDF/Points", H5T_NATIVE_DOUBLE, &three, in->x);
    return f;
}

static void add(struct vtkhdf *f, const char *name, int comps, hid_t type, const void *value) {
    char path[256];
    struct h5_block b = f->block;
    snprintf(path, sizeof path, "VTKHDF/PointData/%s", name);
    if (comps > 1) {
        b.n[b.dims] = b.m[b.dims] = (hsize_t)comps;
        b.dims++;
    }
    h5_write(&f->h5, path, type, &b, value);
}

void vtkhdf_add(struct vtkhdf *f, const char *name, int comps, const double *value) {
    const size_t n = f->items * (size_t)comps;
    if (f->wide) {
        add(f, name, comps, H5T_NATIVE_DOUBLE, value);
        return;
    }
    if (n > f->narrow_items) {
        memory_free(f->narrow);
        f->narrow = memory_new(MEMORY_OUTPUT, n, sizeof *f->narrow);
        f->narrow_items = n;
    }
    for (size_t i = 0; i < n; i++) f->narrow[i] = (float)value[i];
    add(f, name, comps, H5T_NATIVE_FLOAT, f->narrow);
}

void vtkhdf_add_long(struct vtkhdf *f, const char *name, int comps, const int64_t *value) {
    add(f, name, comps, H5T_NATIVE_INT64, value);
}

void vtkhdf_add_byte(struct vtkhdf *f, const char *name, int comps, const uint8_t *value) {
    add(f, name, comps, H5T_NATIVE_UINT8, value);
}

void vtkhdf_end(struct vtkhdf *f) {
    h5_end(&f->h5);
    memory_free(f->narrow);
    free(f);
    clock_end(CLOCK_OUTPUT);
}
