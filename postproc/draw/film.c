/* Joins PNGs into one animated PNG: the compressed pixels of each are copied as they are.
 * (PNG specification, third edition: chunks acTL, fcTL, fdAT) */
#include "postproc/draw/film.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"

#include <errno.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

enum { IHDR = 13, LONGEST = 1 << 28 };
static const unsigned char signature[8] = {0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

static void put_number(unsigned char *to, uint32_t value) {
    for (int k = 0; k < 4; k++) to[k] = (unsigned char)(value >> (24 - 8 * k));
}

static uint32_t number(const unsigned char *from) {
    return (uint32_t)from[0] << 24 | (uint32_t)from[1] << 16 | (uint32_t)from[2] << 8 | from[3];
}

/* Length, kind, data and their check sum. */
static void put_chunk(FILE *f, const char *kind, const unsigned char *data, uint32_t n) {
    unsigned char word[4];
    uint32_t sum = (uint32_t)crc32(crc32(0, (const unsigned char *)kind, 4), data, n);
    put_number(word, n);
    fwrite(word, 1, 4, f);
    fwrite(kind, 1, 4, f);
    fwrite(data, 1, n, f);
    put_number(word, sum);
    fwrite(word, 1, 4, f);
}

/* The next chunk of a picture: its data after four bytes of room. NULL: there is none, or no memory. */
static unsigned char *chunk_new(FILE *f, char kind[5], uint32_t *n) {
    unsigned char head[8];
    if (fread(head, 1, 8, f) != 8 || (*n = number(head)) > LONGEST) return NULL;
    memcpy(kind, head + 4, 4);
    kind[4] = '\0';
    unsigned char *data = malloc((size_t)*n + 8);
    if (data && fread(data + 4, 1, (size_t)*n + 4, f) == (size_t)*n + 4) return data; /* with the check sum */
    free(data);
    return NULL;
}

struct film {
    FILE *file;
    int frames, rest, frame;
    uint32_t sequence;         /* of the chunks fcTL and fdAT */
    unsigned char first[IHDR]; /* of the first picture */
};

static void begin_frame(struct film *m) {
    unsigned char control[26] = {0};
    put_number(control, m->sequence++);
    memcpy(control + 4, m->first, 8); /* width and height; offsets 0 */
    control[20] = (unsigned char)(m->rest >> 8);
    control[21] = (unsigned char)m->rest;
    control[22] = 1000 >> 8;
    control[23] = 1000 & 255;
    put_chunk(m->file, "fcTL", control, sizeof control);
}

/* Returns 0; 1: the picture is not like the first one; -1: it is not a picture. */
static int take_header(struct film *m, const unsigned char *data, uint32_t n) {
    if (n != IHDR) return -1;
    if (m->frame > 0) return memcmp(m->first, data, IHDR) != 0;
    memcpy(m->first, data, IHDR);
    put_chunk(m->file, "IHDR", data, n);
    unsigned char control[8] = {0}; /* plays without end */
    put_number(control, (uint32_t)m->frames);
    put_chunk(m->file, "acTL", control, sizeof control);
    return 0;
}

/* Adds one picture. Returns 0, or as take_header. */
static int add(struct film *m, FILE *f) {
    unsigned char start[8], *data;
    char kind[5];
    uint32_t n;
    int ended = 0, bad = 0, began = 0;
    if (fread(start, 1, 8, f) != 8 || memcmp(start, signature, 8) != 0) return -1;
    while (!ended && !bad && (data = chunk_new(f, kind, &n))) {
        if (strcmp(kind, "IHDR") == 0) {
            bad = take_header(m, data + 4, n);
            if (!bad) begin_frame(m);
            began = 1;
        } else if (strcmp(kind, "IDAT") == 0 && m->frame == 0) {
            put_chunk(m->file, kind, data + 4, n);
        } else if (strcmp(kind, "IDAT") == 0) {
            put_number(data, m->sequence++);
            put_chunk(m->file, "fdAT", data, n + 4);
        }
        ended = strcmp(kind, "IEND") == 0;
        if (!began) bad = -1;
        free(data);
    }
    m->frame++;
    return bad ? bad : ended ? 0 : -1;
}

int postproc_film_write(const char *path, const char *folder, const char *name, int frames, int rest) {
    struct film m = {.file = atomic_write_open(path), .frames = frames, .rest = rest};
    if (!m.file) return -1;
    int bad = fwrite(signature, 1, sizeof signature, m.file) == sizeof signature ? 0 : -1;
    for (int k = 1; k <= frames && !bad; k++) {
        char file[FOLDER_PATH], picture[128];
        snprintf(picture, sizeof picture, "%s_%04d.png", name, k);
        FILE *f = fopen(folder_path(file, folder, picture), "rb");
        bad = f ? add(&m, f) : -1;
        if (f) fclose(f);
    }
    put_chunk(m.file, "IEND", (const unsigned char *)"", 0);
    if (atomic_write_close(m.file, path, bad)) bad = bad ? bad : -1;
    if (bad < 0 && !errno) errno = EIO;
    return bad;
}
