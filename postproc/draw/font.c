/* Stroke font for text in pictures. */
#include "postproc/draw/font.h"

#include <math.h>
#include <string.h>

/* A glyph is a list of strokes separated by blanks. A stroke is a list of points: a digit for x (0 ... 9), a letter for
 * y (d: baseline, k: x height 7, n: capitals 10, a: -3). A '~' in front makes a smooth curve (Catmull-Rom) through the
 * points. */
static const char *const glyph[128] = {
    [' '] = "",
    ['!'] = "0n0g 0d",
    ['"'] = "0n0l 2n2l",
    ['#'] = "1d2n 4d5n 0g6g 0k6k",
    ['%'] = "0d6n ~1n2m1l0m1n ~5f6e5d4e5f",
    ['\''] = "0n0l",
    ['('] = "~2n0j0g2b",
    [')'] = "~0n2j2g0b",
    ['*'] = "0g4k 0k4g 2f2l",
    ['+'] = "0h4h 2f2j",
    [','] = "1d0b",
    ['-'] = "0h4h",
    ['.'] = "0d",
    ['/'] = "0c4n",
    [':'] = "0d 0j",
    [';'] = "1d0b 1j",
    ['<'] = "4k0h4e",
    ['='] = "0g5g 0j5j",
    ['>'] = "0k4h0e",
    ['?'] = "~0m2n4m4k2i 2i2g 2d",
    ['['] = "2n0n0b2b",
    ['\\'] = "0n4c",
    [']'] = "0n2n2b0b",
    ['^'] = "0k2n4k",
    ['_'] = "0c5c",
    ['|'] = "0b0n",
    ['~'] = "~0h1i3g4h",
    ['0'] = "~2n3n5l5f3d2d0f0l2n",
    ['1'] = "0l2n2d",
    ['2'] = "~0l1m2n4n5l4i2f0d 0d5d",
    ['3'] = "~0m2n4n5l4j2i ~2i4h5f4d2d0e",
    ['4'] = "4d4n0f5f",
    ['5'] = "5n1n0i ~0i2j4i5g4e2d0e",
    ['6'] = "~4n2m0j0f2d3d5f5g3j2j0g",
    ['7'] = "0n5n2d",
    ['8'] = "~2n3n5m5k3i2i0k0m2n ~2i3i5h5f3d2d0f0h2i",
    ['9'] = "~1d3e5h5l3n2n0l0k2h3h5k",
    ['A'] = "0d3n6d 1g5g",
    ['B'] = "3d0d0n3n 0i3i ~3n5m5j3i ~3i6h6e3d",
    ['C'] = "~6l5m3n1m0k0g1e3d5e6f",
    ['D'] = "3d0d0n3n ~3n5m6k6g5e3d",
    ['E'] = "5n0n0d5d 0i4i",
    ['F'] = "5n0n0d 0i4i",
    ['G'] = "~6l5m3n1m0k0g1e3d5e6f 6f6i4i",
    ['H'] = "0d0n 6d6n 0i6i",
    ['I'] = "0d0n",
    ['J'] = "4n4g ~4g4e2d0e0g",
    ['K'] = "0d0n 5n0h 2j5d",
    ['L'] = "0n0d5d",
    ['M'] = "0d0n3g6n6d",
    ['N'] = "0d0n6d6n",
    ['O'] = "~3n1m0k0g1e3d5e6g6k5m3n",
    ['P'] = "0d0n3n 0i3i ~3n5m5j3i",
    ['Q'] = "~3n1m0k0g1e3d5e6g6k5m3n 4f6d",
    ['R'] = "0d0n3n 0i3i ~3n5m5j3i 3i6d",
    ['S'] = "~6l5m3n1m0l1j5h6f5e3d1e0f",
    ['T'] = "0n6n 3n3d",
    ['U'] = "0n0g ~0g1e3d5e6g 6g6n",
    ['V'] = "0n3d6n",
    ['W'] = "0n2d4n6d8n",
    ['X'] = "0n6d 6n0d",
    ['Y'] = "0n3i6n 3i3d",
    ['Z'] = "0n6n0d6d",
    ['a'] = "~5i3k1j0h0g1e3d5f 5k5d",
    ['b'] = "0n0d ~0i2k4j5h5g4e2d0f",
    ['c'] = "~5j3k1j0h0g1e3d5e",
    ['d'] = "5n5d ~5i3k1j0h0g1e3d5f",
    ['e'] = "0h5h ~5h5i3k1j0h0g1e3d5e",
    ['f'] = "~4n2n1l 1l1d 0k3k",
    ['g'] = "~5i3k1j0h0g1e3d5f 5k5c ~5c3a1a0b",
    ['h'] = "0n0d ~0i2k4k5i 5i5d",
    ['i'] = "0k0d 0n",
    ['j'] = "2k2c ~2c1a0a 2n",
    ['k'] = "0n0d 4k0g 2i5d",
    ['l'] = "0n0d",
    ['m'] = "0k0d ~0i2k3k4i 4i4d ~4i6k7k8i 8i8d",
    ['n'] = "0k0d ~0i2k4k5i 5i5d",
    ['o'] = "~2k3k5i5f3d2d0f0i2k",
    ['p'] = "0k0a ~0i2k4j5h5g4e2d0f",
    ['q'] = "5k5a ~5i3k1j0h0g1e3d5f",
    ['r'] = "0k0d ~0i2k3k",
    ['s'] = "~4j3k1k0j1h3g4e3d1d0e",
    ['t'] = "1m1f ~1f2d3d 0k3k",
    ['u'] = "0k0f ~0f1d3d5f 5k5d",
    ['v'] = "0k2d4k",
    ['w'] = "0k2d4k6d8k",
    ['x'] = "0k4d 4k0d",
    ['y'] = "0k2d 4k1a",
    ['z'] = "0k4k0d4d",
};
static const char unknown[] = "0d0k4k4d0d";

enum { STROKE_MAX = 32, SMOOTH = 6 };

static const char *glyph_of(unsigned char c) { return c < 128 && glyph[c] ? glyph[c] : unknown; }

/* The letters drawn for characters of UTF-8; others are drawn as a box. */
static const struct {
    const char *character, *drawn; /* one letter */
} replaced[] = {{"µ", "u"}, {"×", "x"}, {"Δ", "D"}, {"ω", "w"}, {"⁻", "-"}, {"⁰", "0"}, {"¹", "1"}, {"²", "2"},
                {"³", "3"}, {"⁴", "4"}, {"⁵", "5"}, {"⁶", "6"}, {"⁷", "7"}, {"⁸", "8"}, {"⁹", "9"}};

/* The next letter of a text, which is moved on. */
static unsigned char letter(const char **text) {
    const unsigned char c = (unsigned char)**text;
    if (c < 128) {
        (*text)++;
        return c;
    }
    for (size_t k = 0; k < sizeof replaced / sizeof *replaced; k++) {
        const size_t bytes = strlen(replaced[k].character);
        if (strncmp(*text, replaced[k].character, bytes) != 0) continue;
        *text += bytes;
        return (unsigned char)replaced[k].drawn[0];
    }
    do (*text)++;
    while (((unsigned char)**text & 0xc0) == 0x80);
    return 128;
}

static double advance(const char *strokes) { /* in units: its width and a gap */
    int wide = *strokes ? 0 : 2;
    for (const char *s = strokes; *s; s++)
        if (*s >= '0' && *s <= '9' && *s - '0' > wide) wide = *s - '0';
    return wide + 2.6;
}

static void stroke_draw(struct postproc_canvas *c, const double (*p)[3], int n, int smooth, struct postproc_pen pen) {
    if (n == 1) postproc_canvas_line(c, p[0], p[0], pen);
    const int closed = n > 2 && p[0][0] == p[n - 1][0] && p[0][1] == p[n - 1][1];
    for (int i = 0; i + 1 < n; i++) {
        const double *b = p[i], *d = p[i + 1];
        if (!smooth) {
            postproc_canvas_line(c, b, d, pen);
            continue;
        }
        const double *a = i > 0 ? p[i - 1] : closed ? p[n - 2] : b;
        const double *e = i + 2 < n ? p[i + 2] : closed ? p[1] : d;
        double last[3] = {b[0], b[1], b[2]};
        for (int k = 1; k <= SMOOTH; k++) {
            const double t = (double)k / SMOOTH, tt = t * t, ttt = tt * t;
            double next[3] = {0, 0, b[2]};
            for (int m = 0; m < 2; m++)
                next[m] = 0.5 * (2 * b[m] + (d[m] - a[m]) * t + (2 * a[m] - 5 * b[m] + 4 * d[m] - e[m]) * tt +
                                 (3 * b[m] - a[m] - 3 * d[m] + e[m]) * ttt);
            postproc_canvas_line(c, last, next, pen);
            memcpy(last, next, sizeof last);
        }
    }
}

void postproc_font_draw(struct postproc_canvas *c, double x, double y, double height, unsigned colour,
                        const char *text) {
    const double unit = height / 10;
    const struct postproc_pen pen = {.colour = colour, .alpha = 0.8, .width = fmax(1, 0.13 * height), .hidden = 1};
    for (const char *t = text; *t;) {
        const char *s = glyph_of(letter(&t));
        const double wide = advance(s) * unit;
        while (*s) {
            double p[STROKE_MAX][3];
            int n = 0;
            const int smooth = *s == '~';
            if (smooth) s++;
            for (; *s && *s != ' ' && n < STROKE_MAX; s += 2, n++) {
                p[n][0] = x + (s[0] - '0') * unit;
                p[n][1] = y - (s[1] - 'd') * unit;
                p[n][2] = 1e30;
            }
            stroke_draw(c, (const double(*)[3])p, n, smooth, pen);
            if (*s == ' ') s++;
        }
        x += wide;
    }
}

double postproc_font_width(double height, const char *text) {
    double wide = 0;
    for (const char *t = text; *t;) wide += advance(glyph_of(letter(&t)));
    return wide * height / 10;
}
