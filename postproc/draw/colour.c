/* Colour maps, and conversion between sRGB and linear light. */
#include "postproc/draw/colour.h"
#include "base/ensure.h"

#include <math.h>

enum { NODES = 11 };

/* A map of n nodes at equal steps.
 * magma and viridis of S. van der Walt and N. Smith (2015; matplotlib, CC0), at ten equal steps; linear interpolation
 * stays within 0.02 of the full tables. The light end of magma is changed from yellow, which turns olive in shadow, to
 * a near-white of nearly the same lightness. The third is RdBu of ColorBrewer (Harrower and Brewer 2003), reversed. */
struct map {
    int n;
    unsigned node[NODES];
};
static const struct map magma = {
    10, {0x000004, 0x180f3e, 0x451077, 0x721f81, 0x9f2f7f, 0xcd4071, 0xf1605d, 0xfd9567, 0xfec98d, 0xf6f0e6}};
static const struct map viridis = {
    10, {0x440154, 0x482878, 0x3e4a89, 0x31688e, 0x26828e, 0x1f9e89, 0x35b779, 0x6dcd59, 0xb4de2c, 0xfde725}};
static const struct map diverging = {
    11, {0x053061, 0x2166ac, 0x4393c3, 0x92c5de, 0xd1e5f0, 0xf7f7f7, 0xfddbc7, 0xf4a582, 0xd6604d, 0xb2182b, 0x67001f}};

static const struct map *table_of(enum postproc_map map) {
    switch (map) {
    case POSTPROC_MAGMA_REVERSED:
        return &magma;
    case POSTPROC_VIRIDIS:
        return &viridis;
    case POSTPROC_DIVERGING:
        return &diverging;
    }
    ENSURE(0, "colour map %d", (int)map);
}

void postproc_colour_map(enum postproc_map map, double t, double srgb[3]) {
    if (isnan(t)) {
        for (int c = 0; c < 3; c++) srgb[c] = 0.5;
        return;
    }
    t = fmin(fmax(t, 0), 1);
    if (map == POSTPROC_MAGMA_REVERSED) t = 1 - t;
    const struct map *table = table_of(map);
    const int i = (int)fmin(t * (table->n - 1), table->n - 2);
    const double f = t * (table->n - 1) - i;
    for (int c = 0; c < 3; c++) {
        const int shift = 16 - 8 * c;
        const double a = table->node[i] >> shift & 255, b = table->node[i + 1] >> shift & 255;
        srgb[c] = (a + f * (b - a)) / 255;
    }
}

double postproc_colour_linear(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : pow((srgb + 0.055) / 1.055, 2.4); }

double postproc_colour_srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * pow(linear, 1 / 2.4) - 0.055;
}
