/* What a probe measures at its tip e: pressure and velocity with their gradients.  (001: eqs 3.83, 3.84, 3.86)
 *
 * On the 2 x 2 x 2 stencil of one cell about e, p and u are interpolated by the kernel and differenced. All of it is a product of
 * three one-dimensional sums: the mean of the kernels at the two points of a direction, or their difference. So each field is
 * a block of 4 x 4 x 4 values, contracted with four values or four slopes a direction:
 *
 *        y, z           4 values along x at once      16 loads, 44 multiply-adds
 *        x              four sums in one transposition
 *
 * Weights are made for a few tips at a time, before their blocks are read: their square roots and the blocks' sums are too long
 * for a processor to look from one tip to the next. */
#include "base/vec.h"
#include "ibm/kernel.h"
#include "ibm/state.h"

/* Alignment and direction: six lanes of one vector, the last two idle. */
enum { XC, YC, XF, YF, ZC, ZF, LANES = 8 };
enum { GROUP = 8 }; /* tips whose weights are made at once: 6 KB */

/* What all tips have in common. */
struct frame {
    vec offset;   /* the place, in cells of the domain, of the grid point 0 of an alignment, and 1/2 more */
    vec per_cell; /* 1/d, 1/m */
    vec stride;   /* doubles */
};

/* Four grid points i-1 .. i+2 a direction. */
struct tip {
    double value[4][LANES], slope[4][LANES]; /* slope: 1/m */
    double value_x[2][4], slope_x[2][4];     /* those along x, [alignment] */
    int64_t at[LANES];                       /* of the first grid point, doubles */
};

static struct frame frame_of(const struct fluid_grid *g) {
    static const int direction[LANES] = {0, 1, 0, 1, 2, 2, 2, 2};
    static const double first[LANES] = {0.5, 0.5, 1, 1, 0.5, 1, 1, 1}; /* centres, faces */
    const ptrdiff_t stride[3] = {1, g->row, g->plane};
    struct frame f;
    for (int l = 0; l < LANES; l++) {
        const int d = direction[l];
        f.offset[l] = g->lo[d] + first[l] + 0.5;
        f.per_cell[l] = 1 / g->d[d];
        f.stride[l] = (double)stride[d];
    }
    return f;
}

/* From eight lanes, the four weights along x: [alignment]. */
static inline void take_x(double x[2][4], const vec w[4]) {
    const ibm_row a = __builtin_shufflevector(w[0], w[1], 0, 8, 2, 10),
                  b = __builtin_shufflevector(w[2], w[3], 0, 8, 2, 10);
    ibm_row_store(x[0], __builtin_shufflevector(a, b, 0, 1, 4, 5));
    ibm_row_store(x[1], __builtin_shufflevector(a, b, 2, 3, 6, 7));
}

/* Both points of a direction are offset alike from their nearest grid points, i and i+1: the mean of the two kernels for the value,
 * and their difference over the cell for the slope. s: the tip, cells.  (001: eq. 3.78) */
static inline void tip_set(const struct frame *f, const double *s, struct tip *e) {
    typedef int64_t whole __attribute__((vector_size(64)));
    const ibm_row place = ibm_row_load(s); /* and what follows, unused */
    const vec low = __builtin_shufflevector(place, place, 0, 1, 0, 1, 2, 2, 2, 2) - f->offset;
    vec near = low + 0.5;
    for (int l = 0; l < LANES; l++) near[l] = __builtin_floor(near[l]);
    const vec t = low - near;
    const vec middle = (1 + vec_sqrt(1 - 3 * t * t)) * (1.0 / 3);
    const vec before = 0.5 * (1 - middle - t), behind = 0.5 * (1 - middle + t);
    const vec value[4] = {0.5 * before, 0.5 * (before + middle), 0.5 * (middle + behind), 0.5 * behind};
    const vec slope[4] = {-before * f->per_cell, (before - middle) * f->per_cell,
                          (middle - behind) * f->per_cell, behind * f->per_cell};
    const whole at = __builtin_convertvector((near - 1) * f->stride, whole);
    for (int i = 0; i < 4; i++) {
        vec_store(e->value[i], value[i]);
        vec_store(e->slope[i], slope[i]);
    }
    take_x(e->value_x, value);
    take_x(e->slope_x, slope);
    memcpy(e->at, &at, sizeof at);
}

/* (sum a, sum b, sum c, sum d) */
static inline ibm_row sums(ibm_row a, ibm_row b, ibm_row c, ibm_row d) {
    const ibm_row ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const ibm_row cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/* One field at the tip: f, df/dx, df/dy, df/dz. x: whether at faces; y, z: lanes. */
static inline ibm_row contract(const double *field, const struct fluid_grid *g, const struct tip *e, int x,
                               int y, int z) {
    const double *at = field + e->at[x ? XF : XC] + e->at[y] + e->at[z];
    ibm_row mean = ibm_row_set(0), dy = mean, dz = mean;
    for (int k = 0; k < 4; k++, at += g->plane) {
        ibm_row value = ibm_row_set(0), slope = value;
        for (int j = 0; j < 4; j++) {
            const ibm_row line = ibm_row_load(at + j * g->row);
            value += e->value[j][y] * line;
            slope += e->slope[j][y] * line;
        }
        mean += e->value[k][z] * value;
        dy += e->value[k][z] * slope;
        dz += e->slope[k][z] * value;
    }
    const ibm_row value_x = ibm_row_load(e->value_x[x]), slope_x = ibm_row_load(e->slope_x[x]);
    return sums(value_x * mean, slope_x * mean, value_x * dy, value_x * dz);
}

/* p|e, dp/dn|e, mu (grad u + grad u^T)|e n.  (001: eqs 3.88-3.95)      n [3] */
static inline void tip_measure(const struct fluid_grid *g, const struct fluid_state *f, double mu,
                               const struct tip *e, const double *n, double *result) {
    const size_t first = fluid_grid_at(g, 0, 0, 0);
    const ibm_row p = contract(f->p + first, g, e, 0, YC, ZC), u = contract(f->u + first, g, e, 1, YC, ZC),
                  v = contract(f->v + first, g, e, 0, YF, ZC), w = contract(f->w + first, g, e, 0, YC, ZF);
    const ibm_row normal = {0, n[0], n[1], n[2]}, along = {1, mu, mu, mu}, across = {0, mu, mu, mu};
    result[0] = p[0];
    ibm_row_store(result + 1, along * sums(p * normal, u * normal, v * normal, w * normal) +
                                  across * (n[0] * u + n[1] * v + n[2] * w));
}

void ibm_tips_measure(const struct fluid_grid *g, const struct fluid_state *f, double mu, size_t tips,
                      const double *item, double *result) {
    const struct frame frame = frame_of(g);
    struct tip e[GROUP];
    for (size_t h = 0; h < tips; h += GROUP) {
        const size_t group = tips - h < GROUP ? tips - h : GROUP;
        for (size_t i = 0; i < group; i++) tip_set(&frame, item + (h + i) * IBM_TIP_SENT, &e[i]);
        for (size_t i = 0; i < group; i++)
            tip_measure(g, f, mu, &e[i], item + (h + i) * IBM_TIP_SENT + 3,
                        result + (h + i) * IBM_TIP_RETURNED);
    }
}
