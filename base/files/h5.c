/* Writes HDF5 files from all ranks; reserves disk space first and reports errors as sentences. */
#include "base/files/h5.h"
#include "base/die.h"
#include "base/par.h"
#include "base/par_hdf5.h"
#include "base/files/atomic_write.h"
#include "base/files/plain_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

__attribute__((format(printf, 2, 3))) static void because(struct h5 *f, const char *format, ...) {
    va_list args;
    if (f->why[0]) return;
    va_start(args, format);
    vsnprintf(f->why, sizeof f->why, format, args);
    va_end(args);
}

/* Notes a fault inside HDF5. If the file cannot be opened any more, because its folder or its disk is gone, the
 * system's error message is used. */
static void because_hdf5(struct h5 *f, const char *does_not) {
    const int fd = open(f->part, O_RDWR | O_CLOEXEC);
    because(f, "%s", fd < 0 ? strerror(errno) : does_not);
    if (fd >= 0) close(fd);
}

/* All ranks get the fault of the lowest rank that has one, with its message. */
static int agree(struct h5 *f, int fault) {
    if (f->shared) {
        const int first = (int)par_min(fault ? par_rank() : par_size());
        fault = first < par_size();
        if (fault) par_bcast(f->why, sizeof f->why, first);
    }
    if (fault) f->failed = 1;
    return fault;
}

hid_t h5_access_list(const struct h5 *f) {
    const hid_t list = H5Pcreate(H5P_FILE_ACCESS);
    if (f->shared) par_hdf5_access(list);
    H5Pset_fclose_degree(list, H5F_CLOSE_STRONG);
    H5Pset_file_locking(list, 0, 1); /* files become visible by renaming only; some file systems have no locks */
    return list;
}

hid_t h5_open_alone(const char *path) {
    const hid_t list = h5_access_list(&(struct h5){.shared = 0});
    const hid_t file = H5Fopen(path, H5F_ACC_RDONLY, list);
    H5Pclose(list);
    return file;
}

hid_t h5_transfer_list(const struct h5 *f) {
    const hid_t list = H5Pcreate(H5P_DATASET_XFER);
    if (f->shared) par_hdf5_transfer(list);
    return list;
}

/* A new handle. HDF5's own error output is turned off: its faults are reported as sentences of this program. */
static void clear(struct h5 *f, const char *path) {
    H5Eset_auto2(H5E_DEFAULT, NULL, NULL);
    memset(f, 0, sizeof *f);
    f->file = -1;
    f->shared = par_size() > 1;
    if (strlen(path) >= sizeof f->path) die(EXIT_CODE_FILE, "%s: the name is too long", path);
    snprintf(f->path, sizeof f->path, "%s", path);
    snprintf(f->part, sizeof f->part, "%s.part", path);
}

enum { HEADERS = 1 << 16 }; /* bytes, more than all that HDF5 writes beside the arrays */

/* Reserves disk blocks for an array of so many bytes at the end of the file and for the headers before and behind it.
 * This is done before HDF5 learns of the array, because MPI-IO may not report a short write, and HDF5 cannot close a
 * file whose promised bytes do not fit on the disk. */
static int reserve(struct h5 *f, hsize_t bytes) {
    int code = 0;
    if (par_rank() == 0) {
        const int fd = open(f->part, O_RDWR | O_CLOEXEC);
        const off_t end = f->end + (off_t)bytes + 2 * HEADERS;
        if (fd < 0)
            code = errno;
        else if (end > f->reserved)
            code = posix_fallocate(fd, f->reserved, end - f->reserved);
        if (!code && end > f->reserved) f->reserved = end;
        if (fd >= 0) close(fd);
        if (code) because(f, "%s", strerror(code));
    }
    return agree(f, code != 0);
}

/* Tests whether the disk still takes a write, at the last reserved byte: a size limit may be reached, or the disk may
 * become unreachable, while the file is written. HDF5 is not called again after a failure, because ranks that cannot
 * write would wait in HDF5 for each other for ever. */
static int try_write(struct h5 *f) {
    int code = 0;
    if (par_rank() == 0 && f->reserved > 0) {
        const int fd = open(f->part, O_WRONLY | O_CLOEXEC);
        if (fd < 0 || pwrite(fd, "", 1, f->reserved - 1) != 1) code = errno;
        if (fd >= 0) close(fd);
        if (code) because(f, "%s", strerror(code));
    }
    f->stuck = agree(f, code != 0);
    return f->stuck;
}

void h5_begin(struct h5 *f, const char *path) {
    clear(f, path);
    int fault = 0;
    if (par_rank() == 0) { /* to get the system's error message, which MPI hides */
        const int fd = plain_file_create(f->part);
        fault = fd < 0;
        if (fault) because(f, "%s", strerror(errno));
        if (fd >= 0) close(fd);
    }
    if (agree(f, fault) || reserve(f, 0)) return;
    const hid_t list = h5_access_list(f);
    f->file = H5Fcreate(f->part, H5F_ACC_TRUNC, H5P_DEFAULT, list);
    H5Pclose(list);
    f->reserved = 0; /* H5F_ACC_TRUNC has released the reserved blocks */
    fault = f->file < 0;
    if (fault) because_hdf5(f, "HDF5 cannot create it");
    if (!agree(f, fault)) reserve(f, 0);
}

hsize_t h5_items(const struct h5_block *block, const hsize_t m[H5_DIMS]) {
    hsize_t items = 1;
    for (int k = 0; k < block->dims; k++) items *= m[k];
    return items;
}

void h5_group(struct h5 *f, const char *name) {
    if (f->failed) return;
    const hid_t group = H5Gcreate2(f->file, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT);
    const int fault = group < 0;
    if (fault) because(f, "group %s cannot be made", name);
    if (group >= 0) H5Gclose(group);
    agree(f, fault);
}

void h5_select(const struct h5_block *block, hid_t in_file, hid_t *in_memory) {
    *in_memory = H5Screate_simple(block->dims, block->m, NULL);
    if (h5_items(block, block->m) == 0) {
        H5Sselect_none(in_file);
        H5Sselect_none(*in_memory);
    } else {
        H5Sselect_hyperslab(in_file, H5S_SELECT_SET, block->lo, NULL, block->m, NULL);
    }
}

void h5_write(struct h5 *f, const char *name, hid_t type, const struct h5_block *block, const void *value) {
    static const char nothing = 0;
    if (f->failed || reserve(f, h5_items(block, block->n) * H5Tget_size(type)) || try_write(f)) return;
    const hid_t list = H5Pcreate(H5P_DATASET_CREATE), space = H5Screate_simple(block->dims, block->n, NULL);
    H5Pset_alloc_time(list, H5D_ALLOC_TIME_EARLY);
    H5Pset_fill_time(list, H5D_FILL_TIME_NEVER);
    const hid_t set = H5Dcreate2(f->file, name, type, space, H5P_DEFAULT, list, H5P_DEFAULT);
    int fault = set < 0;
    if (fault) because(f, "array %s cannot be made", name);
    const haddr_t at = fault ? HADDR_UNDEF : H5Dget_offset(set);
    if (at != HADDR_UNDEF) {
        f->at = (off_t)at;
        f->end = f->at + (off_t)H5Dget_storage_size(set);
    }
    /* an empty array has no position in the file */
    if (!agree(f, fault) && h5_items(block, block->n) > 0) {
        hid_t in_memory;
        h5_select(block, space, &in_memory);
        const hid_t transfer = h5_transfer_list(f);
        fault = H5Dwrite(set, type, in_memory, space, transfer, value ? value : &nothing) < 0;
        if (fault) because(f, "array %s cannot be written", name);
        H5Pclose(transfer);
        H5Sclose(in_memory);
        f->stuck = agree(f, fault);
    }
    if (set >= 0 && !f->stuck) H5Dclose(set);
    H5Sclose(space);
    H5Pclose(list);
}

void h5_write_text(struct h5 *f, const char *name, const char *value) {
    const struct h5_block b = {.dims = 1, .n = {1}, .m = {par_rank() == 0}};
    const hid_t type = H5Tcopy(H5T_C_S1);
    H5Tset_size(type, strlen(value) + 1);
    h5_write(f, name, type, &b, value);
    H5Tclose(type);
}

static void attribute(struct h5 *f, const char *object_path, const char *name, hid_t type, hid_t space,
                      const void *value) {
    const hid_t object = H5Oopen(f->file, object_path, H5P_DEFAULT);
    const hid_t a = object < 0 ? -1 : H5Acreate2(object, name, type, space, H5P_DEFAULT, H5P_DEFAULT);
    const int fault = a < 0 || H5Awrite(a, type, value) < 0;
    if (fault) because(f, "attribute %s of %s cannot be written", name, object_path);
    if (a >= 0) H5Aclose(a);
    if (object >= 0) H5Oclose(object);
    agree(f, fault);
}

void h5_attribute(struct h5 *f, const char *object_path, const char *name, hid_t type, int count, const void *value) {
    if (f->failed) return;
    const hsize_t n = count < 0 ? 1 : (hsize_t)count;
    const hid_t space = count < 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &n, NULL);
    attribute(f, object_path, name, type, space, value);
    H5Sclose(space);
}

/* A text as VTK requires it: of fixed length, ASCII, without the terminating zero unless it is empty. */
void h5_attribute_text(struct h5 *f, const char *object_path, const char *name, const char *value) {
    if (f->failed) return;
    const hid_t type = H5Tcopy(H5T_C_S1), space = H5Screate(H5S_SCALAR);
    H5Tset_size(type, strlen(value) > 0 ? strlen(value) : 1);
    H5Tset_strpad(type, H5T_STR_NULLPAD);
    attribute(f, object_path, name, type, space, value);
    H5Sclose(space);
    H5Tclose(type);
}

/* Checks that the closed file can be read, releases reserved blocks that were not used, appends the seal and renames
 * the file. By one rank. */
static int publish(struct h5 *f) {
    haddr_t end = 0;
    const hid_t file = h5_open_alone(f->part);
    if (file < 0 || H5Fget_eoa(file, &end) < 0) {
        because_hdf5(f, "it cannot be read back");
        return 1;
    }
    H5Fclose(file);
    struct stat is;
    int code = stat(f->part, &is) == 0 ? 0 : errno;
    if (!code && f->seal)
        code = seal_file_write(f->seal, f->part, end);
    else if (!code && is.st_size > (off_t)end && truncate(f->part, (off_t)end) != 0)
        code = errno;
    if (!code) code = atomic_write_publish(f->part, f->path, !f->unsynced);
    if (code) because(f, "%s", strerror(code));
    return code != 0;
}

/* HDF5's flush waits for the disk. A file that is not synced is flushed to the system alone, by closing it. */
static void finish(struct h5 *f) {
    if (f->stuck || try_write(f)) return;
    int fault = !f->unsynced && H5Fflush(f->file, H5F_SCOPE_GLOBAL) < 0;
    if (fault) because_hdf5(f, "HDF5 cannot flush it");
    agree(f, fault);
    fault = H5Fclose(f->file) < 0;
    if (fault) because_hdf5(f, "HDF5 cannot close it");
    f->stuck = agree(f, fault);
    agree(f, par_rank() == 0 && !f->failed && publish(f));
}

void h5_end(struct h5 *f) {
    if (f->file >= 0) finish(f);
    if (!f->failed) return;
    if (par_rank() == 0) unlink(f->part);
    par_barrier();
    /* a file that HDF5 could not close would crash the library at the program's regular end */
    if (f->stuck && par_rank() == 0) die(EXIT_CODE_FILE, "%s: cannot be written: %s", f->path, f->why);
    if (f->stuck) par_barrier(); /* the other ranks wait until rank 0 ends the program */
    die_all(EXIT_CODE_FILE, "%s: cannot be written: %s", f->path, f->why);
}
