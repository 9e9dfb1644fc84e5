/* Reads a body's image: each rank a piece of its slices, slab by slab, into bits that each node then holds. */
#include "coupling/setup/image.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/machine.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_piece.h"
#include "base/files/log.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { IMAGES = 27 }; /* of a region: itself, and beyond periodic sides */

/* Values from LEAST on, VALUES of them, are counted one by one: all of 8 and 16 bits. */
enum { LEAST = -32768, VALUES = 32768 + 65536, SLAB = 1 << 23 /* voxels read at once, if a slice has no more */ };

static const char axes[][4] = {"xyz", "xzy", "yxz", "yzx", "zxy", "zyx"}; /* by enum scene_image_axes */

struct counts {
    long voxels[VALUES + 1]; /* the last one: all other values */
    uint8_t solid[VALUES];   /* 0: pore, else 1 + the kind of the solid */
    long *found;             /* [labels] voxels with each label of the scene */
};

struct reader {
    const struct scene_image *scene;
    struct setup_image *image;
    struct files_image *file;
    struct counts *counts;
    int *value;             /* [slab], or */
    double *real;           /* for a threshold */
    int first[3], cells[3]; /* the slab's first voxel, once turned, and its cells */
    uint32_t *in_cell;      /* [cells][kinds] voxels of each kind in each cell of the slab, if it takes several */
    double least, most, sum;
    long solid;
};

static const char *path_of(const struct setup_image *image, const char *key) {
    static char text[96];
    snprintf(text, sizeof text, "solid.bodies[%d].%s", image->number, key);
    return text;
}

struct files_image *setup_image_file(const struct scene_body *body, char *problem, size_t capacity) {
    const struct scene_image *image = &body->image;
    struct files_image_input in = {.file = body->own.file,
                                   .format = image->format,
                                   .dataset = image->dataset,
                                   .type = image->type,
                                   .byte_order = image->byte_order,
                                   .header_bytes = image->header_bytes};
    memcpy(in.axes, axes[image->axes], sizeof in.axes);
    for (int d = 0; d < 3; d++) {
        in.size[d] = image->size[d];
        in.edge[d] = image->unit > 0 ? image->voxel[d] / image->unit : 0;
    }
    return files_image_open(&in, problem, capacity);
}

static struct files_image *file_open(const struct scene_body *body) {
    char problem[512];
    struct files_image *file = setup_image_file(body, problem, sizeof problem);
    if (!file) die(EXIT_CODE_SCENE, "%s", problem);
    return file;
}

/* The kind of the solid with a label: the place of its material among those of the image. */
static int kind_of(const struct scene_image *image, int label) {
    for (int l = 0; l < image->materials; l++)
        for (int k = 0; image->material[l].label == label && k < image->kinds; k++)
            if (image->kind[k] == image->material[l].index) return k;
    return 0;
}

static int kinds_of(const struct scene_image *image) { return image->kinds > 1 ? image->kinds : 1; }

static int solid_of(struct reader *r, int value) {
    const struct scene_image *image = r->scene;
    for (int l = 0; l < image->labels; l++)
        if (image->label[l] == value) {
            r->counts->found[l]++;
            return 1 + kind_of(image, value);
        }
    return 0;
}

/* Counts a value. Returns 0 for one of the pores, else 1 + the kind of the solid. */
static inline int take_value(struct reader *r, int value) {
    const long at = (long)value - LEAST;
    if (at >= 0 && at < VALUES) {
        r->counts->voxels[at]++;
        return r->counts->solid[at];
    }
    r->counts->voxels[VALUES]++;
    r->least = fmin(r->least, value);
    r->most = fmax(r->most, value);
    r->sum += value;
    return solid_of(r, value);
}

static inline int take_real(struct reader *r, double value) {
    r->least = fmin(r->least, value);
    r->most = fmax(r->most, value);
    r->sum += value;
    return value >= r->scene->threshold;
}

/* Where a voxel of the file stands along direction d, once the image is turned. */
static int turned(const struct reader *r, int d, int i) { return r->scene->flips[d] ? r->image->used[d] - 1 - i : i; }

/* phase: 0: pore, else 1 + the kind. Bit 0 of the result says that the voxel is solid, bit 1 + p is bit p of the kind.
 */
static inline int marks_of(int phase) { return phase > 0 ? 1 | (phase - 1) << 1 : 0; }

/* Joins a word of the bits, and one of each plane, to those of number `at`; clears them. */
static inline void join(const struct solid_voxels *v, long at, uint64_t *word) {
    for (int p = 0; p <= v->planes; p++) {
        solid_voxels_join((p ? v->plane[p - 1] : v->bits) + at, word[p]);
        word[p] = 0;
    }
}

/* Takes the voxels of a slab, low <= i < high of those used. */
static void take_slab(struct reader *r, const int low[3], const int high[3]) {
    struct solid_voxels *v = r->image->voxels;
    const int m = r->image->per_cell, kinds = kinds_of(r->scene);
    long at = 0;
    for (int k = low[2]; k < high[2]; k++)
        for (int j = low[1]; j < high[1]; j++) {
            const int tj = turned(r, 1, j), tk = turned(r, 2, k);
            const long line = m == 1 ? solid_voxels_line(v, tj, tk) : 0;
            uint64_t word[1 + SOLID_VOXELS_PLANES] = {0};
            int w = turned(r, 0, low[0]) / 64;
            for (int i = low[0]; i < high[0]; i++, at++) {
                const int phase = r->value ? take_value(r, r->value[at]) : take_real(r, r->real[at]), is = phase > 0;
                const int ti = turned(r, 0, i);
                r->solid += is;
                if (m == 1) {
                    if (ti / 64 != w) {
                        join(v, line + w, word);
                        w = ti / 64;
                    }
                    for (int p = 0; p <= v->planes; p++) word[p] |= (uint64_t)(marks_of(phase) >> p & 1) << ti % 64;
                    continue;
                }
                const long cell =
                    ((long)((tk - r->first[2]) / m) * r->cells[1] + (tj - r->first[1]) / m) * r->cells[0] +
                    (ti - r->first[0]) / m;
                r->in_cell[cell * kinds + (is ? phase - 1 : 0)] += (unsigned)is;
            }
            if (m == 1) join(v, line + w, word);
        }
}

/* Sets the bits of the slab's cells that are solid for more than a half. Its kind is the one with the most voxels, of
 * equals the first. */
static void set_cells(struct reader *r) {
    struct solid_voxels *v = r->image->voxels;
    const int m = r->image->per_cell;
    const int kinds = kinds_of(r->scene);
    const uint32_t half = (uint32_t)m * (uint32_t)m * (uint32_t)m / 2, *cell = r->in_cell;
    for (int k = 0; k < r->cells[2]; k++)
        for (int j = 0; j < r->cells[1]; j++) {
            const long line = solid_voxels_line(v, r->first[1] / m + j, r->first[2] / m + k);
            for (int i = r->first[0] / m; i < r->first[0] / m + r->cells[0]; i++, cell += kinds) {
                uint64_t word[1 + SOLID_VOXELS_PLANES];
                uint32_t solid = 0;
                int most = 0;
                for (int q = 0; q < kinds; q++) {
                    solid += cell[q];
                    if (cell[q] > cell[most]) most = q;
                }
                if (solid <= half) continue;
                for (int p = 0; p <= v->planes; p++) word[p] = (uint64_t)(marks_of(1 + most) >> p & 1) << i % 64;
                join(v, line + i / 64, word);
            }
        }
    memset(r->in_cell, 0, (size_t)(cell - r->in_cell) * sizeof *cell);
}

/* Reads the slabs of cells from <= q < to along the direction that varies last in the file. */
static void read_slabs(struct reader *r, int slow, int from, int to) {
    const struct scene_image *s = r->scene;
    const int *n = r->image->used, m = r->image->per_cell;
    long slice = m;
    for (int d = 0; d < 3; d++) slice *= d == slow ? 1 : n[d];
    const long fits = SLAB / slice > 0 ? SLAB / slice : 1;
    const size_t capacity = (size_t)(fits * slice);
    char problem[512];
    if (s->has_threshold)
        r->real = memory_new(MEMORY_COUPLING, capacity, sizeof *r->real);
    else
        r->value = memory_new(MEMORY_COUPLING, capacity, sizeof *r->value);
    if (m > 1) r->in_cell = memory_new(MEMORY_COUPLING, capacity * (size_t)kinds_of(s), sizeof *r->in_cell);
    for (int q = from; q < to; q += (int)fits) {
        const int end = q + fits < to ? q + (int)fits : to;
        int low[3] = {0}, high[3] = {n[0], n[1], n[2]};
        long file_low[3], file_high[3];
        low[slow] = q * m;
        high[slow] = end * m;
        for (int d = 0; d < 3; d++) {
            file_low[d] = low[d] + (s->has_crop ? s->crop_low[d] : 0);
            file_high[d] = high[d] + (s->has_crop ? s->crop_low[d] : 0);
            r->first[d] = s->flips[d] ? n[d] - high[d] : low[d];
            r->cells[d] = (high[d] - low[d]) / m;
        }
        if (r->real ? files_image_read_real(r->file, file_low, file_high, r->real, problem, sizeof problem)
                    : files_image_read(r->file, file_low, file_high, r->value, problem, sizeof problem))
            die(EXIT_CODE_SCENE, "%s", problem);
        take_slab(r, low, high);
        if (m > 1) set_cells(r);
    }
    MEMORY_FREE(r->real, r->value, r->in_cell);
}

/* Repeats the bits of the first `cells` voxels along c in reverse behind themselves. */
static void mirror(const struct solid_voxels *v, uint64_t *bits, const int cells[3], int c) {
    int n[3];
    for (int d = 0; d < 3; d++) n[d] = d == c ? cells[d] : v->n[d];
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++) {
                int to[3] = {i, j, k};
                to[c] = 2 * n[c] - 1 - to[c];
                if (solid_voxels_is(v, bits, i, j, k)) solid_voxels_set(v, bits, to[0], to[1], to[2]);
            }
}

/* Gives every node the bits of all, and adds mirror images. */
static void share(struct setup_image *image, const struct scene_image *s, const int cells[3]) {
    struct solid_voxels *v = image->voxels;
    for (int p = -1; p < v->planes; p++) {
        struct par_shared *shared = p < 0 ? v->shared_bits : v->shared_plane[p];
        par_shared_unite(shared);
        for (int c = 0; c < 3; c++)
            if (s->mirrors[c] && shared->is_writer) mirror(v, shared->data, cells, c);
        par_shared_fence(shared);
    }
}

/* "0, 1 and 7": the first few values that occur. */
static void list_values(const struct setup_image *image, char *text, size_t capacity) {
    text[0] = '\0';
    for (int l = 0; l < image->labels && l < SETUP_IMAGE_LABELS; l++)
        snprintf(text + strlen(text), capacity - strlen(text), "%s%d", l ? ", " : "", image->label[l].value);
    if (image->labels > SETUP_IMAGE_LABELS) snprintf(text + strlen(text), capacity - strlen(text), ", ...");
}

/* Sums the counts of all ranks and lists the values that occur. */
static void count_all(struct reader *r) {
    struct setup_image *image = r->image;
    struct counts *counts = r->counts;
    const struct scene_image *s = r->scene;
    double voxels = 1, most = r->most;
    for (int d = 0; d < 3; d++) voxels *= image->used[d];
    par_sum_long_array(counts->voxels, VALUES + 1);
    for (int a = 0; !s->has_threshold && a < VALUES; a++) {
        const int value = a + LEAST;
        if (counts->voxels[a] == 0) continue;
        if (image->labels < SETUP_IMAGE_LABELS) {
            image->label[image->labels].value = value;
            image->label[image->labels].voxels = counts->voxels[a];
        }
        image->labels++;
        r->least = fmin(r->least, value);
        most = fmax(most, value);
        r->sum += par_rank() == 0 ? (double)counts->voxels[a] * value : 0;
    }
    if (counts->voxels[VALUES] > 0) image->labels = SETUP_IMAGE_LABELS + 1;
    image->least = par_min(r->least);
    image->most = par_max(most);
    image->mean = par_sum(r->sum) / voxels;
    image->solid = par_sum_long(r->solid);
    for (int l = 0; l < s->labels; l++) {
        const long at = (long)s->label[l] - LEAST;
        const long found = par_sum_long(counts->found[l]) + (at >= 0 && at < VALUES ? counts->voxels[at] : 0);
        char have[512];
        list_values(image, have, sizeof have);
        if (found == 0)
            die_all(EXIT_CODE_SCENE, "%s: label %d does not occur in %s, whose values are %g to %g%s%s%s",
                    path_of(image, "solid"), s->label[l], image->body->own.file, image->least, image->most,
                    image->labels > SETUP_IMAGE_LABELS ? "" : " (", image->labels > SETUP_IMAGE_LABELS ? "" : have,
                    image->labels > SETUP_IMAGE_LABELS ? "" : ")");
    }
}

/* Solid alone, and an image whose minerals are named, may be without pores. */
static void check_all(const struct scene *scene, const struct setup_image *image) {
    const struct scene_image *s = &image->body->image;
    const int needs_pores = s->has_threshold || (scene->fluid && s->materials == 0);
    const char *key = s->has_threshold ? "threshold" : "solid";
    const struct solid_voxels *v = image->voxels;
    const long solid = solid_voxels_count(v, v->bits), all = (long)v->n[0] * v->n[1] * v->n[2];
    const char *whole = image->per_cell > 1 ? ", once several voxels are one cell" : "";
    if (solid == 0)
        die_all(EXIT_CODE_SCENE, "%s: leaves no solid in %s, whose values are %g to %g%s", path_of(image, key),
                image->body->own.file, image->least, image->most, whole);
    if (solid == all && needs_pores)
        die_all(EXIT_CODE_SCENE, "%s: leaves no pore in %s, whose values are %g to %g%s", path_of(image, key),
                image->body->own.file, image->least, image->most, whole);
}

static struct counts *counts_new(const struct scene_image *s) {
    struct counts *counts = memory_new(MEMORY_COUPLING, 1, sizeof *counts);
    counts->found = memory_new(MEMORY_COUPLING, (size_t)s->labels + 1, sizeof *counts->found);
    for (int l = 0; l < s->labels; l++)
        if (s->label[l] >= LEAST && s->label[l] < LEAST + VALUES)
            counts->solid[s->label[l] - LEAST] = (uint8_t)(1 + kind_of(s, s->label[l]));
    return counts;
}

static struct setup_image *image_new(const struct scene *scene, int b, struct files_image *file, int cells[3]) {
    const struct scene_body *body = &scene->solid->body[b];
    const struct scene_image *s = &body->image;
    const double spacing = scene->solid->spacing, ratio = s->voxel[0] / spacing;
    struct setup_image *image = memory_new(MEMORY_COUPLING, 1, sizeof *image);
    int n[3], sites[3], corner[3];
    image->body = body;
    image->number = b;
    image->per_cell = ratio < 1 ? (int)lrint(1 / ratio) : 1;
    snprintf(image->format, sizeof image->format, "%s", files_image_format_word(files_image_format_of(file)));
    snprintf(image->type, sizeof image->type, "%s", files_image_type_word(files_image_type_of(file)));
    snprintf(image->header_unit, sizeof image->header_unit, "%s", files_image_unit(file));
    for (int d = 0; d < 3; d++) {
        image->header_voxel[d] = files_image_voxel(file)[d];
        image->used[d] = s->has_crop ? s->crop_high[d] - s->crop_low[d] : s->size[d];
        cells[d] = image->used[d] / image->per_cell;
        n[d] = cells[d] * (1 + s->mirrors[d]);
        sites[d] = ratio < 1 ? 1 : (int)lrint(s->voxel[d] / spacing);
        corner[d] = (int)lrint(body->own.low[d] / spacing - scene->solid->lattice_offset[d]);
    }
    image->voxels = solid_voxels_new(n, sites, corner);
    solid_voxels_kinds(image->voxels, kinds_of(s));
    return image;
}

/* The bits of all voxels, once a node, and each rank's slices while it reads. Memory that a machine does not have may
 * seem to be given, and ends the program later without a word. */
static void check_memory(const struct scene *scene, int b) {
    const struct scene_image *s = &scene->solid->body[b].image;
    const int slow = axes[s->axes][2] - 'x';
    const double has = (double)machine_memory(), per_cell = fmax(scene->solid->spacing / s->voxel[0], 1);
    double cells = 1, slice = per_cell;
    for (int d = 0; d < 3; d++) {
        const double used = s->has_crop ? s->crop_high[d] - s->crop_low[d] : s->size[d];
        cells *= used / per_cell * (1 + s->mirrors[d]);
        slice *= d == slow ? 1 : used;
    }
    const double needs = cells / 8 + fmax(slice, SLAB) * (s->has_threshold ? sizeof(double) : sizeof(int));
    if (has > 0 && needs > has)
        die_all(EXIT_CODE_SCENE,
                "%s: %s has %d x %d x %d voxels, which take %.3g GB while they are read, and the machine has %.3g GB: "
                "crop it",
                path_of(&(struct setup_image){.number = b}, "file"), scene->solid->body[b].own.file, s->size[0],
                s->size[1], s->size[2], needs * 1e-9, has * 1e-9);
}

struct setup_image *setup_image_read(const struct scene *scene, int b) {
    const struct scene_body *body = &scene->solid->body[b];
    check_memory(scene, b);
    struct files_image *file = file_open(body);
    const int slow = axes[body->image.axes][2] - 'x';
    int cells[3];
    struct setup_image *image = image_new(scene, b, file, cells);
    struct reader r = {.scene = &body->image,
                       .image = image,
                       .file = file,
                       .counts = counts_new(&body->image),
                       .least = INFINITY,
                       .most = -INFINITY};
    read_slabs(&r, slow, par_piece_low(cells[slow], par_size(), par_rank()),
               par_piece_low(cells[slow], par_size(), par_rank() + 1));
    share(image, &body->image, cells);
    count_all(&r);
    files_image_close(file);
    MEMORY_FREE(r.counts->found, r.counts);
    check_all(scene, image);
    return image;
}

void setup_image_free(struct setup_image *image) {
    if (!image) return;
    solid_voxels_free(image->voxels);
    memory_free(image);
}

void setup_image_wraps(const struct scene *scene, const struct setup_image *image, int wraps[3]) {
    const struct solid_voxels *v = image->voxels;
    for (int d = 0; d < 3; d++) {
        const double length = v->n[d] * v->sites[d] * scene->solid->spacing;
        wraps[d] = scene->domain.periodic[d] && length > (1 - 1e-6) * scene->domain.size[d];
    }
}

/* The voxels that have a site in a region of the scene, or in its image so many periods away. */
static void box_of(const struct scene *scene, const struct solid_voxels *v, const double low[3], const double high[3],
                   const int periods[3], int box[2][3]) {
    const double spacing = scene->solid->spacing;
    for (int d = 0; d < 3; d++) {
        const double offset = scene->solid->lattice_offset[d] + 0.5, slack = 1e-6,
                     period = periods[d] ? periods[d] * rint(scene->domain.size[d] / spacing) : 0;
        const double first = ceil(fmax(low[d] / spacing - offset - slack, -1e9)) + period - v->corner[d],
                     last = floor(fmin(high[d] / spacing - offset + slack, 1e9)) + period - v->corner[d];
        box[0][d] = (int)floor(first / v->sites[d]);
        box[1][d] = last < first ? box[0][d] : (int)floor(last / v->sites[d]) + 1;
    }
}

struct solid_components *setup_image_solid(const struct scene *scene, const struct setup_image *image) {
    const struct scene_solid *s = scene->solid;
    int wraps[3], boxes = 0, (*box)[2][3] = calloc((size_t)s->constraints * IMAGES + 1, sizeof *box);
    ENSURE(box, "no memory for %d boxes", s->constraints * IMAGES);
    for (int k = 0; k < s->constraints; k++)
        for (int q = 0; q < IMAGES; q++) {
            const int periods[3] = {q % 3 - 1, q / 3 % 3 - 1, q / 9 - 1};
            int is_one = 1;
            for (int d = 0; d < 3; d++) is_one &= periods[d] == 0 || scene->domain.periodic[d];
            if (is_one)
                box_of(scene, image->voxels, s->constraint[k].low, s->constraint[k].high, periods, box[boxes++]);
        }
    setup_image_wraps(scene, image, wraps);
    struct solid_components *c = solid_components_new(image->voxels, 1, wraps, boxes, (const int(*)[2][3])box);
    free(box);
    return c;
}

static void remove_floating(const struct solid_components *c, struct solid_voxels *v) {
    uint64_t *loose = solid_voxels_array(v);
    solid_components_floating(c, v, loose);
    for (size_t w = 0; w < solid_voxels_bytes(v) / sizeof *loose; w++) v->bits[w] &= ~loose[w];
    memory_free(loose);
}

void setup_image_floating(const struct scene *scene, struct setup_image *image) {
    static const char *const done[] = {"kept", "removed", "held"};
    struct solid_voxels *v = image->voxels;
    const enum scene_floating floating = image->body->image.floating;
    long found[3] = {0};
    struct solid_components *c = par_rank() == 0 ? setup_image_solid(scene, image) : NULL;
    if (c) memcpy(found, (long[3]){c->floating_pieces, c->floating_voxels, c->floating_largest}, sizeof found);
    par_bcast(found, sizeof found, 0);
    if (solid_voxels_why(v)[0])
        log_line("%s: the ranks of a node cannot share memory (%s): each of them holds %.1f MB of bits of the image",
                 image->body->name, solid_voxels_why(v), 1e-6 * (double)solid_voxels_bytes(v) * (1 + v->planes));
    if (found[0] > 0)
        log_line("%s: %ld floating piece%s of solid in %ld of %ld voxels, the largest of %ld voxels: %s",
                 image->body->name, found[0], found[0] == 1 ? "" : "s", found[1], solid_voxels_count(v, v->bits),
                 found[2], done[floating]);
    if (found[0] > 0 && floating == SCENE_FLOATING_HOLD) {
        solid_voxels_hold(v);
        if (c) solid_components_floating(c, v, v->held);
        par_shared_spread(v->shared_held);
    }
    if (found[0] > 0 && floating == SCENE_FLOATING_REMOVE) {
        par_shared_fence(v->shared_bits); /* the others have counted */
        if (c) remove_floating(c, v);
        par_shared_spread(v->shared_bits);
    }
    solid_components_free(c);
}
