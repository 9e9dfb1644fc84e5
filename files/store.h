/* Checkpoint files: arrays by global index, so that what any ranks wrote any ranks read.
 *
 * Written to FOLDER/checkpoint/NAME.h5.part, sealed, synced, renamed to NAME.h5, then named in
 * FOLDER/checkpoint/latest. A disk that is full or forbidden ends the run with a sentence and exit code 4, and leaves
 * finished files as they were. Reading never dies: it returns nonzero and store_read_error() says why, the same on
 * every rank.  All collective. */
#pragma once
#include <stddef.h>
#include <stdint.h>

struct store; /* opaque, owned by the caller */

enum store_type { STORE_DOUBLE, STORE_BYTE, STORE_LONG }; /* double, uint8_t, int64_t */

/* A rank's block of a 3D array of doubles, x fastest. value points at its first item (0,0,0), ghosts skipped by the
 * strides; row = plane = 0: contiguous. m may hold a 0: nothing here. */
struct store_block {
    int n[3];             /* the whole array, [n_z][n_y][n_x] */
    int lo[3], m[3];      /* this rank's first index, and how many */
    ptrdiff_t row, plane; /* strides of j and k */
};

/* keep: how many finished files whose names are alike up to the first digit stay, this one included; 0: all. */
struct store *store_begin(const char *folder, const char *name, int keep);
void store_write_block(struct store *s, const char *name, const struct store_block *b, const double *value);
/* A rank's items first .. first+count-1 of n, each of comps values; value [count][comps]. count may be 0. */
void store_write_range(struct store *s, const char *name, enum store_type type, int comps, long n, long first,
                       long count, const void *value);
/* The same value on every rank. */
void store_write_double(struct store *s, const char *name, double value);
void store_write_long(struct store *s, const char *name, long value);
void store_write_text(struct store *s, const char *name, const char *value);
void store_end(struct store *s);

/* Everything is under a seal (files/seal.h). NULL: missing, truncated, damaged outside its arrays, or no checkpoint of
 * this frana. */
struct store *store_read_open(const char *path);
/* The newest that is whole, its arrays looked at: the one that `latest` names or, should that be damaged or missing,
 * another; each that is passed over is told on stderr. */
struct store *store_read_open_latest(const char *folder);
const char *store_read_path(const struct store *s); /* borrowed */
void store_read_close(struct store *s);

/* Another whole checkpoint of the file's folder, the newest, its values looked at; NULL: none. Borrowed until the next
 * call. */
const char *store_read_other(const char *path);
int store_read_is_damaged(const struct store *s); /* the last read found an array that is not what was written */

/* 0, or nonzero when it is missing or of another size or type (value is then untouched), or not what was written. */
int store_read_block(struct store *s, const char *name, const struct store_block *b, double *value);
int store_read_range(struct store *s, const char *name, enum store_type type, int comps, long n, long first, long count,
                     void *value);
int store_read_double(struct store *s, const char *name, double *value);
int store_read_long(struct store *s, const char *name, long *value);
int store_read_text(struct store *s, const char *name, char *value, size_t bytes);
/* Items in a range, or -1 when it is missing. */
long store_read_count(struct store *s, const char *name);
const char *store_read_error(void); /* one sentence about the last call that failed */
