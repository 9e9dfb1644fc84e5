/* Centroidal points by Lloyd's iteration with quadrature on pixels.  (Du, Faber, Gunzburger 1999: sec. 5.2)
 *
 * The energy is the sum over the pixels of the squared distance to their point. Giving each pixel to its nearest point
 * cannot raise it, and neither can moving a point to the centroid of its pixels. */
#include "meshless/arrange/centroidal.h"
#include "base/die.h"
#include "base/memory.h"

#include <math.h>

static const double change = 1e-6; /* relative, at which the iteration ends */
enum { ITERATIONS_MAX = 100000 };

/* Where the point lies in its own pixel's frame, from the middle of the pixel, in pixels. */
static double offset(const struct meshless_pixels *g, int c, double x) {
    return (x - g->low[c]) / g->width[c] - (double)meshless_pixels_at(g, c, x) - 0.5;
}

static double energy_of(const struct meshless_points *p, const struct meshless_pixels *g,
                        const struct meshless_moments *m) {
    double sum = 0;
    for (long i = 0; i < p->n; i++)
        for (int c = 0; c < p->dim; c++) {
            const double off = offset(g, c, p->x[c][i]);
            sum += g->width[c] * g->width[c] *
                   ((double)m->second[i * p->dim + c] - 2 * off * (double)m->first[i * p->dim + c] +
                    off * off * (double)m->count[i]);
        }
    return sum * g->measure;
}

/* To the centroids of the cells; a point without a pixel stays. */
static void move(struct meshless_points *p, const struct meshless_pixels *g, const struct meshless_moments *m) {
    for (long i = 0; i < p->n; i++)
        for (int c = 0; c < p->dim && m->count[i] > 0; c++) {
            const double pixel = (double)meshless_pixels_at(g, c, p->x[c][i]) + 0.5;
            p->x[c][i] = g->low[c] + g->width[c] * (pixel + (double)m->first[i * p->dim + c] / (double)m->count[i]);
        }
}

void meshless_centroidal(struct meshless_points *p, struct meshless_pixels *g) {
    struct meshless_moments m = meshless_pixels_moments(g, p->n);
    int capacity = 0;
    for (;; p->iterations++) {
        MEMORY_MORE(MEMORY_SOLID, p->energy, p->iterations, capacity);
        meshless_pixels_assign(g, p->n, p->x, p->spacing, &m);
        const double energy = p->energy[p->iterations] = energy_of(p, g, &m);
        const double before = p->iterations > 0 ? p->energy[p->iterations - 1] : INFINITY;
        if (before - energy < change * before && p->iterations > 0) break;
        if (p->iterations == ITERATIONS_MAX)
            die_all(EXIT_CODE_UNSTABLE, "Lloyd's iteration of %ld points has not ended after %d steps", p->n,
                    ITERATIONS_MAX);
        move(p, g, &m);
    }
    meshless_pixels_moments_free(&m);
}
