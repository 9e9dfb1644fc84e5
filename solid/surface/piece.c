/* Finds the smooth surface piece of a sphere, cylinder, box or cavity next to a particle: depth and normal. */
#include "solid/surface/piece.h"
#include "solid/surface/sector.h"

#include <math.h>
#include <string.h>

enum { PIECES_MAX = 4 };

double solid_piece_depth(const struct solid_piece *p, const double x[3], double normal[3]) {
    double r2 = 0;
    for (int c = 0; c < 3; c++) {
        normal[c] = p->mask[c] ? x[c] - p->centre[c] : 0;
        r2 += normal[c] * normal[c];
    }
    const double length = sqrt(r2);
    for (int c = 0; c < 3; c++) normal[c] *= length > 0 ? p->inside / length : 0;
    return p->inside * (p->radius - length);
}

static void add(struct solid_piece *piece, int *n, int mask, int inside, const double centre[3], double radius) {
    struct solid_piece *p = &piece[(*n)++];
    *p = (struct solid_piece){{mask & 1, mask >> 1 & 1, mask >> 2 & 1}, inside, {0}, radius};
    memcpy(p->centre, centre, sizeof p->centre);
}

/* The surface pieces of a shape, and of those of its cavities that are near x. */
static int pieces_of(const struct solid_body *b, const double x[3], struct solid_piece piece[PIECES_MAX]) {
    enum { ALL = 7 };
    int n = 0;
    double centre[3];
    if (b->shape == SOLID_SPHERE) add(piece, &n, ALL, 1, b->centre, b->radius);
    if (b->shape == SOLID_CYLINDER) {
        add(piece, &n, ALL & ~(1 << b->axis), 1, b->centre, b->radius);
        add(piece, &n, 1 << b->axis, 1, b->centre, b->length / 2);
    }
    for (int c = 0; c < 3 && b->shape == SOLID_BOX; c++) {
        centre[c] = (b->low[c] + b->high[c]) / 2;
        centre[(c + 1) % 3] = centre[(c + 2) % 3] = 0;
        add(piece, &n, 1 << c, 1, centre, (b->high[c] - b->low[c]) / 2);
    }
    if (n > 0 && b->cavity_period > 0) {
        for (int c = 0; c < 3; c++)
            centre[c] = b->cavity_centre[c] + rint((x[c] - b->cavity_centre[c]) / b->cavity_period) * b->cavity_period;
        add(piece, &n, ALL, -1, centre, b->cavity_radius);
    }
    return n;
}

int solid_piece_of(const struct solid_body *body, const double x[3], unsigned open, double spacing,
                   struct solid_piece *piece) {
    struct solid_piece all[PIECES_MAX];
    const int n = pieces_of(body, x, all);
    for (int k = 0; k < n; k++) {
        double e[3], beyond[3], normal[3];
        unsigned bounded = 0;
        for (int f = 0; f < SOLID_FACES; f++) {
            solid_sector_axis(f, e);
            for (int c = 0; c < 3; c++) beyond[c] = x[c] + spacing * e[c];
            if (solid_piece_depth(&all[k], beyond, normal) < 1e-6 * spacing) bounded |= 1u << f;
        }
        if (!open || (open & ~bounded)) continue;
        *piece = all[k];
        return 1;
    }
    return 0;
}
