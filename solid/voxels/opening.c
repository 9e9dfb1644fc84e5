/* Opening of an image by a box, with 64 voxels a word: erosion and dilation along x, y and z in turn. */
#include "solid/voxels/opening.h"
#include "base/memory.h"

#include <string.h>

/* Each voxel with those up to edge - 1 after it along the line: all of them (erosion). */
static void erode_line(uint64_t *line, long words, int edge) {
    for (long w = 0; w < words; w++) {
        uint64_t all = line[w];
        const uint64_t next = w + 1 < words ? line[w + 1] : 0;
        for (int s = 1; s < edge; s++) all &= line[w] >> s | next << (64 - s);
        line[w] = all;
    }
}

/* Each voxel with those up to edge - 1 before it: any of them (dilation). */
static void dilate_line(uint64_t *line, long words, int edge) {
    for (long w = words - 1; w >= 0; w--) {
        uint64_t any = line[w];
        const uint64_t before = w > 0 ? line[w - 1] : 0;
        for (int s = 1; s < edge; s++) any |= line[w] << s | before >> (64 - s);
        line[w] = any;
    }
}

/* Slice k of the phase, eroded along x and y. */
static void erode_slice(const struct solid_voxels *v, int phase, const int edge[3], int k, uint64_t *slice) {
    const long words = v->words;
    for (int j = 0; j < v->n[1]; j++) {
        solid_voxels_of(v, phase, j, k, slice + j * words);
        erode_line(slice + j * words, words, edge[0]);
    }
    for (int j = 0; j < v->n[1]; j++)
        for (long w = 0; w < words; w++)
            for (int s = 1; s < edge[1]; s++) slice[j * words + w] &= j + s < v->n[1] ? slice[(j + s) * words + w] : 0;
}

/* A slice dilated along x and y. */
static void dilate_slice(const struct solid_voxels *v, const int edge[3], uint64_t *slice) {
    const long words = v->words;
    for (int j = v->n[1] - 1; j >= 0; j--)
        for (long w = 0; w < words; w++)
            for (int s = 1; s < edge[1] && j - s >= 0; s++) slice[j * words + w] |= slice[(j - s) * words + w];
    for (int j = 0; j < v->n[1]; j++) dilate_line(slice + j * words, words, edge[0]);
}

long solid_opening_thin(const struct solid_voxels *v, int phase, const int edge[3]) {
    const int deep = edge[2];
    const size_t n = (size_t)v->n[1] * (size_t)v->words;
    uint64_t *eroded = memory_new(MEMORY_SOLID, n * (size_t)deep, sizeof *eroded),
             *opened = memory_new(MEMORY_SOLID, n * (size_t)deep, sizeof *opened),
             *line = memory_new(MEMORY_SOLID, (size_t)v->words, sizeof *line);
    long thin = 0;
    for (int k = 0; k < deep - 1 && k < v->n[2]; k++) erode_slice(v, phase, edge, k, eroded + n * (size_t)(k % deep));
    for (int k = 0; k < v->n[2]; k++) {
        uint64_t *boxes = opened + n * (size_t)(k % deep); /* low corners of the boxes from slice k on */
        memset(boxes, 0, n * sizeof *boxes);
        if (k + deep <= v->n[2]) {
            erode_slice(v, phase, edge, k + deep - 1, eroded + n * (size_t)((k + deep - 1) % deep));
            memcpy(boxes, eroded, n * sizeof *boxes);
            for (int s = 1; s < deep; s++)
                for (size_t w = 0; w < n; w++) boxes[w] &= eroded[n * (size_t)s + w];
            dilate_slice(v, edge, boxes);
        }
        for (int j = 0; j < v->n[1]; j++) {
            solid_voxels_of(v, phase, j, k, line);
            for (long w = 0; w < v->words; w++) {
                uint64_t in = 0; /* opened has 0 in slices that were not reached yet */
                for (int s = 0; s < deep; s++) in |= opened[n * (size_t)s + (size_t)(j * v->words + w)];
                thin += __builtin_popcountll(line[w] & ~in);
            }
        }
    }
    MEMORY_FREE(eroded, opened, line);
    return thin;
}
