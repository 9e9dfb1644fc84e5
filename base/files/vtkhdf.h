/* Fields for ParaView: VTKHDF 1.0, written in parallel.  (VTK file formats, "VTKHDF"; docs/run-folder.md)
 *
 * A fluid is an ImageData whose points are the cell centres; particles are an UnstructuredGrid of one vertex each.
 * Fields are point data. Files are written aside and renamed; a fault of the disk ends the run with exit code 4. */
#pragma once
#include <stdint.h>

struct vtkhdf; /* opaque, owned by the caller */

struct vtkhdf_image_input {
    const char *path; /* ends in .hdf */
    double time;      /* s */
    long step;
    int n[3];          /* points of the whole image */
    double origin[3];  /* of point (0,0,0), m */
    double spacing[3]; /* m */
    int lo[3], m[3];   /* this rank's block; m may hold a 0: no point on this rank */
    int wide;          /* 1: fields of doubles are stored as float64; 0: float32 */
};

struct vtkhdf_points_input {
    const char *path;
    double time;
    long step;
    long n;               /* number of this rank's points; they follow those of the ranks below */
    const double (*x)[3]; /* [n] m; borrowed during the call */
    int wide;
};

struct vtkhdf *vtkhdf_image_begin(const struct vtkhdf_image_input *in);   /* Collective. */
struct vtkhdf *vtkhdf_points_begin(const struct vtkhdf_points_input *in); /* Collective. */
/* A field of comps (1 scalar, 3 vector, 6 symmetric tensor xx yy zz xy yz zx, 9) values a point, contiguous:
 * image [m_z][m_y][m_x][comps], points [n][comps]. Collective. */
void vtkhdf_add(struct vtkhdf *f, const char *name, int comps, const double *value);
void vtkhdf_add_long(struct vtkhdf *f, const char *name, int comps, const int64_t *value);
void vtkhdf_add_byte(struct vtkhdf *f, const char *name, int comps, const uint8_t *value);
void vtkhdf_end(struct vtkhdf *f); /* Collective. */

/* The index file PATH.hdf.series gives ParaView the times of the files. file is relative to the index file's folder; an
 * entry of the same name is replaced. Written aside and renamed, by rank 0. Collective. */
void vtkhdf_series_add(const char *series, const char *file, double time);
/* Drops entries later than the time (by more than 1e-9 of it), because a resumed run writes them again. Collective. */
void vtkhdf_series_cut(const char *series, double time);

struct vtkhdf_series_entry {
    char file[256];
    double time;
};
/* Entries in the file's order, malloc'ed into *list; -1 when there is no such file. Not collective. */
int vtkhdf_series_read(const char *series, struct vtkhdf_series_entry **list);

/* A file read back by one rank. */
struct vtkhdf_field {
    char name[64];
    int comps;
    int integer; /* stored as whole numbers */
};
struct vtkhdf_source {
    int image;                    /* 1: image; 0: points */
    int n[3];                     /* image */
    double origin[3], spacing[3]; /* image */
    long points;                  /* number of points, in both cases */
    double time;
    long step;
    int fields;
    struct vtkhdf_field *field; /* owned */
    void *file;                 /* private */
};

/* NULL when it cannot be read as a VTKHDF file of ours; *error (may be NULL) then says why. Not collective. */
struct vtkhdf_source *vtkhdf_read_open(const char *path, const char **error);
void vtkhdf_read_close(struct vtkhdf_source *s);
/* Values a point of a field; 0 if there is no such field. */
int vtkhdf_read_comps(const struct vtkhdf_source *s, const char *name);
/* Values [points][comps], malloc'ed; NULL if there is no such field. Not collective. */
double *vtkhdf_read_double(struct vtkhdf_source *s, const char *name);
/* Of an image, the block of points lo ... lo + m - 1 only: [m_z][m_y][m_x][comps], malloc'ed; NULL if there is no such
 * field. Not collective. */
double *vtkhdf_read_block(struct vtkhdf_source *s, const char *name, const int lo[3], const int m[3]);
int64_t *vtkhdf_read_long(struct vtkhdf_source *s, const char *name);
double (*vtkhdf_read_points(struct vtkhdf_source *s))[3]; /* of points, or of an image's */
