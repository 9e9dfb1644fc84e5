/* Reads the triangles of an STL. Its normals are not used: the order of the corners says where outside is. */
#include "base/files/image/formats.h"

#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* Binary: 80 bytes of title, the number of triangles, and of each a normal, three corners and two bytes more. */
enum { TITLE = 80, HEAD = TITLE + 4, RECORD = 50, NORMAL = 12 };

/* Four bytes, the lowest first. */
static uint32_t little(const char *at) {
    const unsigned char *b = (const unsigned char *)at;
    return b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
}

int image_stl_read_is(const char *first, size_t n, long long bytes) {
    if (n >= HEAD && bytes == HEAD + (long long)RECORD * little(first + TITLE)) return 1;
    return n >= 6 && memcmp(first, "solid ", 6) == 0;
}

static void read_binary(const char *text, int triangles, double (*to)[3][3]) {
    for (int t = 0; t < triangles; t++)
        for (int q = 0; q < 9; q++) {
            const uint32_t bits = little(text + HEAD + (size_t)t * RECORD + NORMAL + 4 * (size_t)q);
            float value;
            memcpy(&value, &bits, sizeof value);
            to[t][q / 3][q % 3] = (double)value;
        }
}

/* The next corner of a text, `vertex x y z`; NULL: there is none, or it has no three numbers (*corner is not 0 then).
 */
static const char *next_corner(const char *at, double x[3], int *corner) {
    at = strstr(at, "vertex");
    *corner = at != NULL;
    if (at) at += 6;
    for (int c = 0; at && c < 3; c++) {
        char *end;
        x[c] = strtod(at, &end);
        at = end == at ? NULL : end;
    }
    return at;
}

/* Counts the triangles of a text, and fills `to` where it is not NULL. -1 with a sentence. */
static int read_text(struct image_source *s, const char *text, double (*to)[3][3]) {
    double x[3];
    long corners = 0;
    int is_one;
    while ((text = next_corner(text, x, &is_one))) {
        if (to) memcpy(to[corners / 3][corners % 3], x, sizeof x);
        corners++;
    }
    if (is_one) return image_source_refuse(s, "its vertex %ld has no three numbers", corners + 1), -1;
    if (corners % 3) return image_source_refuse(s, "it has %ld vertices, which make no triangles", corners), -1;
    return (int)(corners / 3);
}

double (*image_stl_read(struct image_source *s, const char *path, int *triangles))[3][3] {
    long long bytes;
    double(*to)[3][3] = NULL;
    char *text = image_source_load(s, path, LLONG_MAX - 1, &bytes);
    if (!text) return NULL;
    const int is_binary = bytes >= HEAD && bytes == HEAD + (long long)RECORD * little(text + TITLE);
    const long long n = is_binary ? (bytes - HEAD) / RECORD : bytes < INT32_MAX ? read_text(s, text, NULL) : INT32_MAX;
    *triangles = (int)n;
    if (n > INT32_MAX / 4)
        image_source_refuse(s, "it has more triangles than are read");
    else if (n == 0)
        image_source_refuse(s, "it has no triangles");
    else if (n > 0) {
        to = image_source_new((size_t)n, sizeof *to);
        if (is_binary)
            read_binary(text, *triangles, to);
        else
            read_text(s, text, to);
    }
    free(text);
    for (long long q = 0; to && q < 9 * n; q++)
        if (!isfinite(to[q / 9][q / 3 % 3][q % 3])) {
            image_source_refuse(s, "triangle %lld has a corner with a coordinate that is not finite", q / 9 + 1);
            free(to);
            to = NULL;
        }
    return to;
}
