/* Wetted area of each interface particle.  (001: sec. 3.5.3) */
#include "solid/surface/area.h"

#include "base/par.h"
#include "solid/geometry/on_surface.h"
#include "solid/geometry/shape.h"
#include "solid/surface/surface.h"
#include "solid/surface/sector.h"

#include <math.h>

double solid_surface_area_fresh(const struct solid *s, int h) {
    const double edge = solid_sector_spacing(s, h);
    return edge * edge;
}

static void add_away(double sum[3], const double site[3], const double x[3], double reach) {
    double p[3], r2 = 0;
    for (int c = 0; c < 3; c++) {
        p[c] = x[c] - site[c];
        r2 += p[c] * p[c];
    }
    if (r2 > reach * reach) return;
    for (int c = 0; c < 3; c++) sum[c] -= p[c];
}

/* |n_f.e| at the face towards the void site in direction f. */
static double face_area_factor(const struct solid_family_view *view, const struct solid_normal_data *start, int f,
                               double spacing) {
    const double self[3] = {0, 0, 0}, reach = 2 * spacing * (1 + 1e-9);
    double site[3], seen[3] = {0, 0, 0}, e[3], r2 = 0, mean2 = 0;
    solid_sector_axis(f, e);
    for (int c = 0; c < 3; c++) site[c] = spacing * e[c];
    add_away(seen, site, self, reach);
    for (int b = 0; b < view->n; b++) add_away(seen, site, view->xi[b], reach);
    for (int c = 0; c < 3; c++) r2 += seen[c] * seen[c];
    const double side = start->two_sided && start->n[f / 2] * e[f / 2] < 0 ? -1 : 1; /* an axis has no sign */
    double mean[3];
    for (int c = 0; c < 3; c++) {
        mean[c] = side * start->n[c] + (r2 > 1e-6 * spacing * spacing ? seen[c] / sqrt(r2) : e[c]);
        mean2 += mean[c] * mean[c];
    }
    return mean2 > 1e-6 ? fabs(mean[f / 2]) / sqrt(mean2) : fabs(start->n[f / 2]);
}

double solid_surface_area_share(const struct solid *s, int h, const struct solid_family_view *view,
                                const struct solid_normal_data *start) {
    const double square = solid_surface_area_fresh(s, h);
    if (solid_shape_of(&s->in.body[s->body[h]])->places == SOLID_PLACES_POINTS)
        return (start->two_sided ? 2 : 1) * square;
    double share = 0;
    for (int f = 0; f < SOLID_FACES; f++)
        if (start->open >> f & 1) share += square * face_area_factor(view, start, f, s->in.spacing);
    return share;
}

void solid_surface_area_restrict(struct solid *s, struct solid_surface *surface, const double low[3],
                                 const double high[3]) {
    double sum[2] = {0, 0}; /* sums of area and of wetted faces */
    for (int h = 0; h < s->n; h++) {
        if (!(s->flag[h] & SOLID_FIRST)) continue;
        const double x[3] = {s->x0[0][h], s->x0[1][h], s->x0[2][h]};
        if (!solid_on_surface_is_inside(solid_on_surface_depth(x, low, high, 3), s->in.spacing)) continue;
        sum[0] += surface->share[h];
        sum[1] += surface->faces[h];
    }
    par_sum_array(sum, 2);
    surface->immersed_area = sum[0];
    surface->initial_area = sum[1] > 0 ? sum[0] / sum[1] : 0;
    for (int i = 0; i < surface->n; i++)
        if (s->flag[surface->h[i]] & SOLID_FIRST) surface->area[i] = surface->initial_area;
}
