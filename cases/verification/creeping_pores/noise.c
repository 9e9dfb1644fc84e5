/* A synthetic rock for sizes.sh: noise, averaged three times over cubes of 7 voxels in a periodic box of N^3, of which
 * the highest 18 % are pore, 0; the others are 1. x varies first. usage: noise N >IMAGE.raw */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDE = 7, TIMES = 3, BINS = 1 << 16 };
#define PORE 0.18

static float noise(uint64_t q) { /* splitmix64 */
    q += 0x9e3779b97f4a7c15ULL;
    q = (q ^ q >> 30) * 0xbf58476d1ce4e5b9ULL;
    q = (q ^ q >> 27) * 0x94d049bb133111ebULL;
    return (float)((q ^ q >> 31) >> 40) / (1 << 24) - 0.5F;
}

/* The mean over WIDE neighbours of each value of a line of n with the stride. */
static void average(float *a, long n, long stride, double *line) {
    double sum = 0;
    for (long i = 0; i < n; i++) line[i] = (double)a[i * stride];
    for (long i = 0; i < WIDE; i++) sum += line[i % n];
    for (long i = 0; i < n; i++) {
        a[i * stride] = (float)(sum / WIDE);
        sum += line[(i + WIDE) % n] - line[i];
    }
}

int main(int argc, char **argv) {
    const long n = argc == 2 ? atol(argv[1]) : 0, all = n * n * n;
    float *a = n >= WIDE ? malloc((size_t)all * sizeof *a) : NULL, low = 1, high = -1;
    double *line = malloc((size_t)n * sizeof *line + 1);
    static long count[BINS];
    if (!a || !line) return 2;
    for (long q = 0; q < all; q++) a[q] = noise((uint64_t)q);
    for (int t = 0; t < TIMES; t++)
        for (long k = 0; k < n; k++)
            for (long j = 0; j < n; j++) {
                average(a + (k * n + j) * n, n, 1, line);
            }
    for (int t = 0; t < TIMES; t++)
        for (long k = 0; k < n; k++)
            for (long i = 0; i < n; i++) {
                average(a + k * n * n + i, n, n, line);
                average(a + k * n + i, n, n * n, line);
            }
    for (long q = 0; q < all; q++) {
        low = a[q] < low ? a[q] : low;
        high = a[q] > high ? a[q] : high;
    }
    const float scale = (BINS - 1) / (high - low);
    for (long q = 0; q < all; q++) count[(int)((a[q] - low) * scale)]++;
    long above = 0;
    int bin = BINS;
    while (bin > 0 && above + count[bin - 1] <= (long)(PORE * (double)all)) above += count[--bin];
    for (long q = 0; q < all; q++) putchar((int)((a[q] - low) * scale) < bin);
    free(a);
    free(line);
    return 0;
}
