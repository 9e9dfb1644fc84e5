/* Boxes of pore and solid cells for the tests of stokes. */
#pragma once
#include "base/par.h"
#include "stokes/solve.h"
#include "tests/check.h"

typedef int make_is_pore(const int at[3], const void *with);

/* Each rank sets its part of the cells. */
static inline struct stokes_mask *make_mask(const int n[3], make_is_pore *is_pore, const void *with) {
    struct stokes_mask *m = stokes_mask_new(n);
    for (int k = 0; k < n[2]; k++)
        for (int j = 0; j < n[1]; j++)
            for (int i = 0; i < n[0]; i++) {
                const int at[3] = {i, j, k};
                if ((i + j + k) % par_size() == par_rank() && is_pore(at, with)) stokes_mask_set(m, i, j, k);
            }
    stokes_mask_count(m);
    return m;
}

/* Cells of edge 1. */
static inline struct stokes *make_stokes(const int n[3], make_is_pore *is_pore, const void *with,
                                         const struct stokes_input *in) {
    struct stokes_mask *m = make_mask(n, is_pore, with);
    struct stokes_input input = *in;
    for (int c = 0; c < 3; c++) input.d[c] = input.d[c] > 0 ? input.d[c] : 1;
    struct stokes *s = stokes_new(m, &input);
    stokes_mask_free(m);
    return s;
}

/* Noise: a share of the cells is pore. */
static inline int make_noise(const int at[3], const void *share) {
    unsigned q = (unsigned)((at[2] * 61 + at[1]) * 67 + at[0]) * 2654435761u;
    q = (q ^ q >> 15) * 2246822519u;
    return (q ^ q >> 13) % 1000 < 1000 * *(const double *)share;
}

/* Spheres: count, and of each the centre and the radius in cells; periodic in a cube of `edge` cells. */
struct make_spheres {
    int count, edge;
    double sphere[4][4];
};
static inline int make_between_spheres(const int at[3], const void *with) {
    const struct make_spheres *s = with;
    for (int q = 0; q < s->count; q++) {
        double sum = 0;
        for (int c = 0; c < 3; c++) {
            const double x = at[c] + 0.5 - s->sphere[q][c], d = x - s->edge * rint(x / s->edge);
            sum += d * d;
        }
        if (sum < s->sphere[q][3] * s->sphere[q][3]) return 0;
    }
    return 1;
}
