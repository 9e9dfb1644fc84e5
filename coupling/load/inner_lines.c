/* How much of the fluid on a straight line through the domain is deep in bodies. */
/* The lines of a direction are columns of a spacing's width, each with a row of the lattice in its middle, and bundles
 * of them: squares at least two cells wide. Every bundle counts that holds the line, so what is found moves with a body
 * that moves by a spacing. */
#include "coupling/load/inner_lines.h"
#include "base/memory.h"
#include "base/par.h"
#include "fluid/grid/side.h"

#include <math.h>

/* The columns along a direction c. */
struct columns {
    int c, across[2];
    int n[2], bundle[2];           /* columns along both directions across; those of a bundle's side */
    double width, from[2];         /* m; where the first column begins */
    double length, cross[2];       /* of the domain along c and across, m */
    double *deep, *shallow, *size; /* [n[1]][n[0]] volumes of particles and of the domain, m3 */
};

static int is_free(const struct run *r, int c) {
    const struct fluid_side *side = fluid_input_of(r->fluid)->side[c];
    return fluid_grid_of(r->fluid)->periodic[c] ||
           (fluid_side_flow(&side[0], c, 0) < 0 && fluid_side_flow(&side[1], c, 1) < 0);
}

static double *volumes(const struct columns *l) {
    return memory_new(MEMORY_COUPLING, (size_t)l->n[0] * (size_t)l->n[1], sizeof(double));
}

/* The width of the i-th column along the k-th direction across within the domain, m. */
static double width_of(const struct columns *l, const struct fluid_grid *g, int k, int i) {
    if (g->periodic[l->across[k]]) return fmin(l->width, l->cross[k] - i * l->width);
    const double low = l->from[k] + i * l->width;
    return fmax(0, fmin(low + l->width, l->cross[k]) - fmax(low, 0));
}

/* The border between two rows of the lattice where the first column begins, m: the last one that is not within a domain
 * that ends there. */
static double first_border(double origin, double width, int is_periodic) {
    const double from = origin - floor(origin / width) * width;
    if (from < 1e-9 * width || from > (1 - 1e-9) * width) return 0;
    return is_periodic ? from : from - width;
}

static struct columns columns_along(const struct run *r, int c) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const double w = r->solid->in.spacing;
    struct columns l = {.c = c, .across = {(c + 1) % 3, (c + 2) % 3}, .width = w, .length = g->length[c]};
    for (int k = 0; k < 2; k++) {
        const int d = l.across[k];
        l.cross[k] = g->length[d];
        l.from[k] = first_border(r->solid->in.origin[d], w, g->periodic[d]);
        l.n[k] = (int)ceil((l.cross[k] - (g->periodic[d] ? 0 : l.from[k])) / w * (1 - 1e-9));
        l.bundle[k] = (int)fmin(ceil(2 * g->d[d] / w * (1 - 1e-9)), l.n[k]);
    }
    l.deep = volumes(&l);
    l.shallow = volumes(&l);
    l.size = volumes(&l);
    for (int j = 0; j < l.n[1]; j++)
        for (int i = 0; i < l.n[0]; i++)
            l.size[j * l.n[0] + i] = l.length * width_of(&l, g, 0, i) * width_of(&l, g, 1, j);
    return l;
}

/* The column in which a particle stands at the start; -1: outside the domain. */
static int column_of(const struct columns *l, const struct run *r, int h) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const double along = r->solid->x0[l->c][h];
    int at[2];
    if (!g->periodic[l->c] && (along < 0 || along > l->length)) return -1;
    for (int k = 0; k < 2; k++) {
        const int d = l->across[k];
        double x = r->solid->x0[d][h];
        if (!g->periodic[d] && (x < 0 || x > l->cross[k])) return -1;
        x -= l->from[k];
        if (g->periodic[d]) x -= floor(x / l->cross[k]) * l->cross[k];
        at[k] = (int)fmin(x / l->width, l->n[k] - 1);
    }
    return at[1] * l->n[0] + at[0];
}

static double sum(double a, double b) { return a + b; }

/* Along the k-th direction across: joins the values of the columns of the bundle that begins at each (way 1), or of the
 * bundles that hold it (-1). Bundles end within a domain that is not periodic. */
static void join(const struct columns *l, int is_periodic, int k, int way, double (*of)(double, double),
                 double *value) {
    const int n = l->n[k], step = k == 0 ? 1 : l->n[0], row = k == 0 ? l->n[0] : 1;
    const int last = is_periodic ? n - 1 : n - l->bundle[k];
    double *joined = memory_new(MEMORY_COUPLING, (size_t)n, sizeof *joined);
    for (int j = 0; j < l->n[1 - k]; j++) {
        for (int i = 0; i < n; i++) {
            joined[i] = 0;
            for (int q = 0; q < l->bundle[k]; q++) {
                const int at = i + way * q, begins = way > 0 ? i : at;
                if (begins > last || (begins < 0 && !is_periodic)) continue;
                joined[i] = of(joined[i], value[j * row + (at + n) % n * step]);
            }
        }
        for (int i = 0; i < n; i++) value[j * row + i * step] = joined[i];
    }
    memory_free(joined);
}

static void join_both(const struct columns *l, const struct run *r, int way, double (*of)(double, double),
                      double *value) {
    for (int k = 0; k < 2; k++) join(l, fluid_grid_of(r->fluid)->periodic[l->across[k]], k, way, of, value);
}

static void measure_along(const struct run *r, int c, const uint8_t *is_deep, float *part) {
    const struct columns l = columns_along(r, c);
    double *const volume[3] = {l.deep, l.shallow, l.size};
    for (int h = 0; h < r->solid->n; h++) {
        const int i = column_of(&l, r, h);
        if (i >= 0) volume[!is_deep[h]][i] += r->solid->volume[h];
    }
    par_sum_array(l.deep, l.n[0] * l.n[1]);
    par_sum_array(l.shallow, l.n[0] * l.n[1]);
    for (int q = 0; q < 3; q++) join_both(&l, r, 1, sum, volume[q]);
    for (int i = 0; i < l.n[0] * l.n[1]; i++) l.deep[i] = l.shallow[i] > 0 ? fmin(1, l.deep[i] / l.size[i]) : 0;
    join_both(&l, r, -1, fmax, l.deep);
    for (int h = 0; h < r->solid->n; h++) {
        const int i = column_of(&l, r, h);
        if (i >= 0) part[h] = fmaxf(part[h], (float)l.deep[i]);
    }
    MEMORY_FREE(l.deep, l.shallow, l.size);
}

void inner_lines_measure(const struct run *r, const uint8_t *is_deep, float *part) {
    for (int h = 0; h < r->solid->n; h++) part[h] = 0;
    for (int c = 0; c < 3; c++)
        if (is_free(r, c)) measure_along(r, c, is_deep, part);
}
