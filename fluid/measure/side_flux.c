/* The flux of momentum through one side of the domain, with its moments. */
#include "fluid/measure/side_flux.h"
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"

#include <string.h>

enum { AHEAD = 12 }; /* faces of a column */

/* How the flux of one line of faces beside a side is summed. */
struct line {
    int normal, free_face;              /* c == d; fluid_boundary_is_open */
    int drains;                         /* as fluid_boundary_side */
    int side;                           /* 0 low, 1 high */
    ptrdiff_t s, sd, sc;                /* strides: towards the outside; of d; of c */
    ptrdiff_t to_velocity;              /* to the face whose velocity is summed: 0, or s */
    double convection, sign, nu_over_d; /* 1; outward; m/s */
};

/* Sums over the faces of a line. */
struct sums {
    double flux, along, velocity; /* m2/s2; of the flux times the number of the face in the line; m/s */
};

/* The flux of face i of the line, m2/s2. */
static inline __attribute__((always_inline)) double flux_of_face(const struct line *l, const double *q,
                                                                 const double *face, const int normal, const int free) {
    const double here = q[0], beyond = q[l->s], mean = 0.5 * (here + beyond);
    if (normal && free) return l->convection * l->sign * fluid_boundary_open_flux(here, q[-l->s], l->sign, l->drains);
    if (normal) /* at the centre between the last advanced face and the side's own */
        return l->convection * l->sign * mean * mean - l->nu_over_d * (beyond - here);
    const double velocity = 0.5 * (face[0] + face[l->sc]); /* at the corners on the side's face */
    const double carried = free && fluid_boundary_comes_in(velocity, l->sign) ? 0 : mean;
    return l->convection * l->sign * velocity * carried - l->nu_over_d * (beyond - here);
}

/* Of n faces from q on, `step` apart. The cache lines of a column are prefetched. */
static inline __attribute__((always_inline)) struct sums sums_of_line(const struct line *l, const double *q,
                                                                      const double *through, int n, ptrdiff_t step,
                                                                      const int normal, const int free) {
    const double *face = l->side ? through : through - l->sd;
    double flux = 0, along = 0, velocity = 0;
    if (step == 1) {
#pragma omp simd reduction(+ : flux, along, velocity)
        for (int i = 0; i < n; i++) {
            const double here = flux_of_face(l, q + i, face + i, normal, free);
            flux += here;
            along += i * here;
            velocity += q[i + l->to_velocity];
        }
        return (struct sums){flux, along, velocity};
    }
    for (int i = 0; i < n; i++, q += step, face += step) {
        __builtin_prefetch(q + AHEAD * step);
        __builtin_prefetch(q + AHEAD * step + l->s);
        if (!normal) __builtin_prefetch(face + AHEAD * step);
        const double here = flux_of_face(l, q, face, normal, free);
        flux += here;
        along += i * here;
        velocity += q[l->to_velocity];
    }
    return (struct sums){flux, along, velocity};
}

static inline struct sums sums_of(const struct line *l, const double *q, const double *through, int n, ptrdiff_t step) {
    if (l->free_face)
        return l->normal ? sums_of_line(l, q, through, n, step, 1, 1) : sums_of_line(l, q, through, n, step, 0, 1);
    return l->normal ? sums_of_line(l, q, through, n, step, 1, 0) : sums_of_line(l, q, through, n, step, 0, 0);
}

void fluid_side_flux_faces(const struct fluid *f, int c, int d, int side, int low[3], int high[3]) {
    fluid_boundary_advanced(f->boundary, f->grid, c, low, high);
    low[d] = side ? high[d] - 1 : low[d];
    high[d] = low[d] + 1;
}

/* A side across x is summed by columns along y. */
struct fluid_side_flux fluid_side_flux(const struct fluid *f, const double *const q[3], struct fluid_flux_kind kind,
                                       int c, int d, int side) {
    const struct fluid_grid *g = f->grid;
    const struct fluid_boundary_side *at_side = &f->boundary->side[d][side];
    const ptrdiff_t sd = fluid_boundary_stride(g, d), s = side ? sd : -sd;
    const int is_free = at_side->normal == FLUID_NORMAL_FREE;
    const struct line line = {.normal = c == d,
                              .free_face = fluid_boundary_is_open(at_side, d, c),
                              .drains = at_side->drains,
                              .side = side,
                              .s = s,
                              .sd = sd,
                              .sc = fluid_boundary_stride(g, c),
                              .to_velocity = is_free && c != d ? s : 0,
                              .convection = kind.convection,
                              .sign = side ? 1 : -1,
                              .nu_over_d = kind.viscosity / g->d[d]};
    const int along = d == 0 ? 1 : 0, across = 3 - d - along; /* directions of the lines, and from line to line */
    const ptrdiff_t step = fluid_boundary_stride(g, along);
    struct fluid_side_flux all = {0};
    int low[3], high[3], at[3];
    fluid_side_flux_faces(f, c, d, side, low, high);
    const double first = fluid_side_flux_place(g, along, c, low[along]);
    memcpy(at, low, sizeof at);
    for (; at[across] < high[across]; at[across]++) {
        const size_t n = fluid_grid_at(g, at[0], at[1], at[2]);
        const struct sums sum = sums_of(&line, q[c] + n, q[d] + n, high[along] - low[along], step);
        all.sum += sum.flux;
        all.moment[along] += g->d[along] * sum.along + first * sum.flux;
        all.moment[across] += fluid_side_flux_place(g, across, c, at[across]) * sum.flux;
        all.velocity += sum.velocity;
    }
    all.moment[d] = fluid_side_flux_place(g, d, c, low[d] + (is_free && c != d ? (side ? 1 : -1) : 0)) * all.sum;
    return all;
}
