/* Reads the slices of a folder as one image. */
#include "base/files/image/formats.h"

#include <ctype.h>
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/stat.h>

struct slices {
    char *folder, **name;
    long n, open; /* the slice that is open, -1: none */
    struct image_source slice;
};

int image_slices_are(const char *path) {
    struct stat info;
    return stat(path, &info) == 0 && S_ISDIR(info.st_mode);
}

static int is_slice(const struct dirent *entry) {
    const char *dot = strrchr(entry->d_name, '.');
    return entry->d_name[0] != '.' && dot && (!strcasecmp(dot, ".tif") || !strcasecmp(dot, ".tiff"));
}

/* The last digits before the ending: where they begin and end. */
static void find_number(const char *name, int *from, int *to) {
    *to = (int)(strrchr(name, '.') - name);
    while (*to > 0 && !isdigit((unsigned char)name[*to - 1])) --*to;
    *from = *to;
    while (*from > 0 && isdigit((unsigned char)name[*from - 1])) --*from;
}

static long number_of(const char *name) {
    int from, to;
    find_number(name, &from, &to);
    return strtol(name + from, NULL, 10);
}

static int by_number(const struct dirent **a, const struct dirent **b) {
    const long x = number_of((*a)->d_name), y = number_of((*b)->d_name);
    return (x > y) - (x < y);
}

static void close_slice(struct slices *all) {
    if (all->slice.close) all->slice.close(&all->slice);
    memset(&all->slice, 0, sizeof all->slice);
    all->open = -1;
}

static void close_all(struct image_source *s) {
    struct slices *all = s->file;
    close_slice(all);
    for (long k = 0; k < all->n; k++) free(all->name[k]);
    free(all->name);
    free(all->folder);
    free(all);
}

/* Names that differ by more than the number are of several images; a number that is missing is a lost slice. */
static int check_names(struct image_source *s, const struct slices *all) {
    int from, to, first_from, first_to;
    find_number(all->name[0], &first_from, &first_to);
    for (long k = 0; k < all->n; k++) {
        const char *name = all->name[k], *first = all->name[0];
        find_number(name, &from, &to);
        if (from == to && all->n > 1)
            return image_source_refuse(s, "its file %.80s has no number: slices are put in order by it", name);
        if (from != first_from || strncmp(name, first, (size_t)from) != 0 || strcmp(name + to, first + first_to) != 0)
            return image_source_refuse(s, "its files %.80s and %.80s differ by more than a number: one image is read",
                                       first, name);
        if (k > 0 && number_of(name) != number_of(all->name[k - 1]) + 1)
            return image_source_refuse(s, "%.80s is followed by %.80s: the numbers of slices must follow one another",
                                       all->name[k - 1], name);
    }
    return 0;
}

static int open_slice(struct image_source *s, struct slices *all, long k) {
    char path[4096];
    if (all->open == k) return 0;
    close_slice(all);
    if (snprintf(path, sizeof path, "%s/%s", all->folder, all->name[k]) >= (int)sizeof path)
        return image_source_refuse(s, "the names of its files are too long");
    struct image_source *one = &all->slice;
    one->unit = "";
    for (int f = 0; f < 3; f++) one->axis[f] = s->axis[f];
    snprintf(one->subject, sizeof one->subject, "its slice %.200s", all->name[k]);
    if (image_tiff_open(one, &(struct files_image_input){.file = path}))
        return image_source_refuse(s, "slice %.80s: %.500s", all->name[k], one->why);
    all->open = k;
    return 0;
}

/* All slices must be alike. */
static int check_slices(struct image_source *s, struct slices *all) {
    const struct image_source *one = &all->slice;
    for (long k = 0; k < all->n; k++) {
        if (open_slice(s, all, k)) return 1;
        if (one->n[2] != 1)
            return image_source_refuse(s, "slice %.80s has %ld pages: one is needed", all->name[k], one->n[2]);
        if (k == 0) {
            s->type = one->type;
            s->unit = one->unit;
            for (int f = 0; f < 3; f++) {
                s->n[f] = f < 2 ? one->n[f] : all->n;
                s->voxel[f] = one->voxel[f];
                s->block[f] = f < 2 ? one->block[f] : 1;
            }
        }
        if (one->n[0] != s->n[0] || one->n[1] != s->n[1] || one->type != s->type)
            return image_source_refuse(s, "slice %.80s differs from %.80s in its size or the type of its voxels",
                                       all->name[k], all->name[0]);
    }
    return 0;
}

static int read_box(struct image_source *s, const long low[3], const long high[3], double *value) {
    struct slices *all = s->file;
    for (long k = low[2]; k < high[2]; k++, value += (high[0] - low[0]) * (high[1] - low[1])) {
        if (open_slice(s, all, k)) return 1;
        const long from[3] = {low[0], low[1], 0}, to[3] = {high[0], high[1], 1};
        if (all->slice.read(&all->slice, from, to, value))
            return image_source_refuse(s, "slice %.80s: %.500s", all->name[k], all->slice.why);
    }
    return 0;
}

int image_slices_open(struct image_source *s, const struct files_image_input *input) {
    struct dirent **entry = NULL;
    const int n = scandir(input->file, &entry, is_slice, by_number);
    if (n <= 0) {
        free(entry);
        return image_source_refuse(s, n < 0 ? "the folder cannot be read" : "the folder has no TIFF (.tif, .tiff)");
    }
    struct slices *all = image_source_new(1, sizeof *all);
    *all = (struct slices){
        .folder = strdup(input->file), .name = image_source_new((size_t)n, sizeof(char *)), .n = n, .open = -1};
    for (int k = 0; k < n; k++) {
        all->name[k] = strdup(entry[k]->d_name);
        free(entry[k]);
    }
    free(entry);
    s->file = all;
    s->format = FILES_IMAGE_TIFF;
    s->read = read_box;
    s->close = close_all;
    return check_names(s, all) || check_slices(s, all);
}
