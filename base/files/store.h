/* Checkpoint files. Arrays are stored by global index, so that any number of ranks can read them.
 *
 * Written to FOLDER/checkpoint/NAME.h5.part, sealed, synced, renamed to NAME.h5, then named in
 * FOLDER/checkpoint/latest. If the disk is full or not writable, the run ends with one sentence and exit code 4;
 * finished files stay as they were. Reading never dies: it returns nonzero and store_read_error() says why, the same on
 * every rank.  All collective. */
#pragma once
#include <stddef.h>
#include <stdint.h>

struct store; /* opaque, owned by the caller */

enum store_type { STORE_DOUBLE, STORE_BYTE, STORE_LONG }; /* double, uint8_t, int64_t */

/* A rank's block of a 3D array of doubles, x fastest. value points at its first item (0,0,0), ghosts skipped by the
 * strides; row = plane = 0: contiguous. m may hold a 0: no item on this rank. */
struct store_block {
    int n[3];             /* the whole array, [n_z][n_y][n_x] */
    int lo[3], m[3];      /* this rank's first index, and how many */
    ptrdiff_t row, plane; /* strides of j and k */
};

/* keep: how many finished checkpoints of the same kind are kept, this one included (same kind: file names equal up to
 * the first digit); 0: all. */
struct store *store_begin(const char *folder, const char *name, int keep);
void store_write_block(struct store *s, const char *name, const struct store_block *block, const double *value);
/* A rank's items first .. first+count-1 of n, each of comps values; value [count][comps]. count may be 0. */
void store_write_range(struct store *s, const char *name, enum store_type type, int comps, long n, long first,
                       long count, const void *value);
/* The same value on every rank. */
void store_write_double(struct store *s, const char *name, double value);
void store_write_long(struct store *s, const char *name, long value);
void store_write_text(struct store *s, const char *name, const char *value);
void store_end(struct store *s);

/* All of the file is verified by its seal (base/files/seal.h). NULL: the file is missing, truncated, damaged outside
 * its arrays, or no checkpoint of this version. */
struct store *store_read_open(const char *path);
/* Whether the folder has a checkpoint, intact or not. Collective. */
int store_read_is_there(const char *folder);
/* Opens the newest intact checkpoint and verifies its arrays: the one that `latest` names or, if that is damaged or
 * missing, another. Each file that is passed over is reported on stderr. */
struct store *store_read_open_latest(const char *folder);
const char *store_read_path(const struct store *s); /* borrowed */
void store_read_close(struct store *s);

/* The newest other intact checkpoint in the file's folder, its arrays verified; NULL: none. Borrowed until the next
 * call. */
const char *store_read_other(const char *path);
int store_read_is_damaged(const struct store *s); /* the last read found an array whose checksum is wrong */

/* 0, or nonzero if the array is missing, has another size or type (value is then untouched), or has a wrong
 * checksum. */
int store_read_block(struct store *s, const char *name, const struct store_block *block, double *value);
int store_read_range(struct store *s, const char *name, enum store_type type, int comps, long n, long first, long count,
                     void *value);
int store_read_double(struct store *s, const char *name, double *value);
int store_read_long(struct store *s, const char *name, long *value);
int store_read_text(struct store *s, const char *name, char *value, size_t bytes);
/* Number of items of a range; -1 if it is missing. */
long store_read_count(struct store *s, const char *name);
const char *store_read_error(void); /* one sentence about the last call that failed */
