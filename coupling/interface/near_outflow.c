/* Finds bodies that stand close before a side through which the flow leaves. */
/* Measured on a sphere of 2.4 cells radius in a channel of 16 cells between slip sides, at Reynolds numbers of 0.6 and
 * 30; load over that far from the side, in percent:
 *
 *     gap over radius      2.3      1       0.17
 *     outflow             0, -1   -12, -5   -27, -10
 *     pressure            -1, 0   -6, 0     -18, -8
 *
 * A block of 4 x 6 x 6 cells that ends on the outflow itself, its Reynolds number 30, has -135 % of the load, after a
 * long drift: the forcing reads the velocities on the outflow's faces and does not act on them. If it goes on beyond
 * the side it has -20 %, and on a side of given pressure -15 %. */
#include "coupling/interface/near_outflow.h"
#include "base/par.h"

#include <math.h>
#include <stdio.h>

/* Radii, which are half the body's least extent along the side. */
static const double FAR = 1;

/* Of body b: -low, high along each axis. */
static void bounds_of(const struct solid *s, int b, double bounds[3][2]) {
    for (int c = 0; c < 3; c++) bounds[c][0] = bounds[c][1] = -INFINITY;
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < 3 && s->body[h] == b; c++) {
            bounds[c][0] = fmax(bounds[c][0], 0.5 * s->in.spacing - s->x0[c][h]);
            bounds[c][1] = fmax(bounds[c][1], 0.5 * s->in.spacing + s->x0[c][h]);
        }
    par_max_array(&bounds[0][0], 6);
}

/* One side. Returns whether there is a sentence. */
static int of_side(const struct run *r, const char *name, double bounds[3][2], int c, int end, char *sentence) {
    const struct scene *scene = r->scene;
    const enum fluid_side_type type = scene->fluid->side[c][end].type;
    double across = INFINITY;
    int spans = 0; /* the section: the flow goes through it, and was not measured */
    if (type != FLUID_OUTFLOW && type != FLUID_PRESSURE) return 0;
    for (int d = 0; d < 3; d++)
        if (d != c) {
            across = fmin(across, bounds[d][0] + bounds[d][1]);
            spans += bounds[d][0] + bounds[d][1] > scene->domain.size[d] * (1 - 1e-9);
        }
    const double gap = end ? scene->domain.size[c] - bounds[c][1] : -bounds[c][0];
    if (type == FLUID_OUTFLOW && fabs(gap) < 0.5 * r->solid->in.spacing) {
        snprintf(sentence, NEAR_OUTFLOW_SENTENCE,
                 "body %s ends on the outflow %c_%s: the load on it is wrong and may point upstream, because the "
                 "forcing does not act on the outflow's faces. Let the body extend beyond the side, or end two "
                 "spacings before it",
                 name, "xyz"[c], end ? "high" : "low");
        return 1;
    }
    if (spans == 2 || gap < 0.5 * r->solid->in.spacing || gap > FAR * 0.5 * across * (1 + 1e-9)) return 0;
    snprintf(sentence, NEAR_OUTFLOW_SENTENCE,
             "body %s stands %.3g m before the open side %c_%s, less than its radius: the load on it is too small, by "
             "1 %% at two "
             "radii from the side, 5 to 12 %% at one, 10 to 27 %% at a sixth",
             name, gap, "xyz"[c], end ? "high" : "low");
    return 1;
}

int near_outflow_of(const struct run *r, int body, char sentence[NEAR_OUTFLOW_MAX][NEAR_OUTFLOW_SENTENCE]) {
    double bounds[3][2];
    int n = 0;
    if (!r->fluid || !r->needs.immersed || r->solid->dim < 3) return 0;
    bounds_of(r->solid, body, bounds);
    for (int c = 0; c < 3; c++)
        for (int end = 0; end < 2; end++)
            n += of_side(r, r->scene->solid->body[body].name, bounds, c, end, sentence[n]);
    return n;
}
