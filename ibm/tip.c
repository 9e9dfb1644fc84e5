/* Pressure, velocity and their gradients at a probe's tip.  (001: eqs 3.83, 3.84, 3.86) */
/* Values at a probe's tip e: pressure and velocity with their gradients.  (001: eqs 3.83, 3.84, 3.86)
 *
 * On the 2 x 2 x 2 stencil of one cell about e, p and u are interpolated by the kernel and differenced. All of it is a
 * product of three one-dimensional sums: the mean of the kernels at the two points of a direction, or their difference.
 * So each field is a block of 4 x 4 x 4 values, contracted with four values or four slopes a direction:
 *
 *        y, z           4 values along x at once      16 loads, 44 multiply-adds
 *        x              four sums in one transposition
 *
 * Weights of eight tips are computed together, before their blocks are read, to hide the latency of the square roots
 * and of the blocks' sums. */
#include "base/vec_shuffle.h"
#include "ibm/kernel.h"
#include "ibm/state.h"

/* Alignment and direction, six of eight numbers; the last two are idle. */
enum { XC, YC, XF, YF, ZC, ZF, LANES = 8, PARTS = LANES / VEC_LANES };
static const int direction[LANES] = {0, 1, 0, 1, 2, 2, 2, 2};
enum { GROUP = 8 }; /* tips whose weights are computed together: 6 KB */

/* Values common to all tips. */
struct frame {
    double offset[LANES];   /* coordinate of grid point 0 of an alignment plus 1/2, in cells of the domain */
    double per_cell[LANES]; /* 1/d, 1/m */
    double stride[LANES];   /* doubles */
};

/* Four grid points i-1 .. i+2 a direction. */
struct tip {
    double value[4][LANES], slope[4][LANES], bend[4][LANES]; /* of a field, of its first and of its second derivative:
                                                              * 1, 1/m, 1/m2 */
    double value_x[2][4], slope_x[2][4], bend_x[2][4];       /* those along x, [alignment] */
    int64_t at[LANES];                                       /* of the first grid point, doubles */
};

static struct frame frame_of(const struct fluid_grid *g) {
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

/* Stores a part's weights; those along x also by themselves, [alignment]. */
static inline void put(int part, const vec w[4], double to[4][LANES], double x[2][4]) {
    for (int i = 0; i < 4; i++) {
        vec_store(to[i] + part * VEC_LANES, w[i]);
        if (part == 0) x[0][i] = w[i][XC];
        if (part == XF / VEC_LANES) x[1][i] = w[i][XF % VEC_LANES];
    }
}

/* The two points of a direction have the same offset from their nearest grid points, i and i+1. The value is the mean
 * of the two kernels, the slope their difference over the cell. t: offset, cells.  (001: eq. 3.78) */
static inline void weigh_by_kernel(vec t, vec per_cell, vec value[4], vec slope[4]) {
    const vec middle = (1 + vec_sqrt(1 - 3 * t * t)) * (1.0 / 3);
    const vec before = 0.5 * (1 - middle - t), behind = 0.5 * (1 - middle + t);
    value[0] = 0.5 * before, value[1] = 0.5 * (before + middle);
    value[2] = 0.5 * (middle + behind), value[3] = 0.5 * behind;
    slope[0] = -before * per_cell, slope[1] = (before - middle) * per_cell;
    slope[2] = (middle - behind) * per_cell, slope[3] = behind * per_cell;
}

/* The cubic through the same four points, which does not smooth; its first and second derivatives. */
static inline void weigh_by_cubic(vec t, vec per_cell, vec value[4], vec slope[4], vec bend[4]) {
    const vec s = t + 0.5, a = s + 1, b = s - 1, c = s - 2, per_cell2 = per_cell * per_cell;
    value[0] = s * b * c * (-1.0 / 6), value[1] = a * b * c * 0.5;
    value[2] = a * s * c * -0.5, value[3] = a * s * b * (1.0 / 6);
    slope[0] = ((6 - 3 * s) * s - 2) * (1.0 / 6) * per_cell;
    slope[1] = ((3 * s - 4) * s - 1) * 0.5 * per_cell;
    slope[2] = ((2 - 3 * s) * s + 2) * 0.5 * per_cell;
    slope[3] = (3 * s * s - 1) * (1.0 / 6) * per_cell;
    bend[0] = -b * per_cell2, bend[1] = (3 * s - 2) * per_cell2;
    bend[2] = (1 - 3 * s) * per_cell2, bend[3] = s * per_cell2;
}

/* s: position of the tip, cells, and a number that is not used. to_wall: the values are extrapolated to the wall. */
static inline void tip_set(const struct frame *f, const double *s, int to_wall, struct tip *e) {
#pragma GCC unroll 8
    for (int part = 0; part < PARTS; part++) {
        const int l = part * VEC_LANES;
        const vec low = vec_shuffle_pick(s, direction + l) - vec_load(f->offset + l), near = vec_floor(low + 0.5),
                  t = low - near, per_cell = vec_load(f->per_cell + l);
        vec value[4], slope[4], bend[4];
        if (to_wall)
            weigh_by_cubic(t, per_cell, value, slope, bend);
        else
            weigh_by_kernel(t, per_cell, value, slope);
        put(part, value, e->value, e->value_x);
        put(part, slope, e->slope, e->slope_x);
        if (to_wall) put(part, bend, e->bend, e->bend_x);
        const vec_mask at = vec_whole((near - 1) * vec_load(f->stride + l));
        memcpy(e->at + l, &at, sizeof at);
    }
}

/* (sum a, sum b, sum c, sum d) */
static inline ibm_row sums(ibm_row a, ibm_row b, ibm_row c, ibm_row d) {
    const ibm_row ab = __builtin_shufflevector(a, b, 0, 4, 2, 6) + __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const ibm_row cd = __builtin_shufflevector(c, d, 0, 4, 2, 6) + __builtin_shufflevector(c, d, 1, 5, 3, 7);
    return __builtin_shufflevector(ab, cd, 0, 1, 4, 5) + __builtin_shufflevector(ab, cd, 2, 3, 6, 7);
}

/* One field at the tip: f, df/dx, df/dy, df/dz. x: 1 at faces; y, z: lanes. */
static inline ibm_row contract(const double *field, const struct fluid_grid *g, const struct tip *e, int x, int y,
                               int z) {
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

/* One field's second derivative along n: the sum of n_i n_j d2f/dx_i dx_j. */
static inline double bend_along(const double *field, const struct fluid_grid *g, const struct tip *e, int x, int y,
                                int z, const double *n) {
    const double *at = field + e->at[x ? XF : XC] + e->at[y] + e->at[z];
    ibm_row by_value = ibm_row_set(0), by_slope = by_value, by_bend = by_value;
    for (int k = 0; k < 4; k++, at += g->plane) {
        ibm_row value = ibm_row_set(0), slope = value, bend = value;
        for (int j = 0; j < 4; j++) {
            const ibm_row line = ibm_row_load(at + j * g->row);
            value += e->value[j][y] * line;
            slope += e->slope[j][y] * line;
            bend += e->bend[j][y] * line;
        }
        by_bend += e->value[k][z] * value;
        by_slope += 2 * n[1] * e->value[k][z] * slope + 2 * n[2] * e->slope[k][z] * value;
        by_value += n[1] * n[1] * e->value[k][z] * bend + n[2] * n[2] * e->bend[k][z] * value +
                    2 * n[1] * n[2] * e->slope[k][z] * slope;
    }
    const ibm_row all = ibm_row_load(e->value_x[x]) * by_value + n[0] * ibm_row_load(e->slope_x[x]) * by_slope +
                        n[0] * n[0] * ibm_row_load(e->bend_x[x]) * by_bend;
    return all[0] + all[1] + all[2] + all[3];
}

/* The shear at the wall, by the cubic on the straight line from the wall to the tip that has the wall's velocity V and
 * the tip's u, du/dn and d2u/dn2:  du/dn|w = 3 (u|e - V)/l - 2 du/dn|e + l/2 d2u/dn2|e. Only its tangential part is
 * used: a rigid wall has no normal one. slope, bend: (dp/dn, du/dn) and (d2p/dn2, d2u/dn2) */
static inline void carry_to_wall(const struct ibm_tip_form *form, const double u[3], const double slope[4],
                                 const double bend[4], const double *n, const double *V, double *result) {
    const double l = form->length;
    double speed2 = 0, across = 0, *stress = result + IBM_TIP_STRESS;
    for (int c = 0; c < 3; c++) {
        const double drift = u[c] - V[c];
        stress[c] = form->mu * (3 / l * drift - 2 * slope[1 + c] + 0.5 * l * bend[1 + c]);
        across += stress[c] * n[c];
        speed2 += drift * drift;
    }
    for (int c = 0; c < 3; c++) stress[c] -= across * n[c];
    result[IBM_TIP_WALL_SLOPE] = slope[0] - l * bend[0];
    result[IBM_TIP_SCALE] = form->mu / (l * l) * sqrt(speed2);
}

/* p|e, dp/dn|e, mu (grad u + grad u^T)|e n  (001: eqs 3.88-3.95), or the values at the wall. item: the tip's */
static inline void tip_measure(const struct fluid_grid *g, const struct fluid_state *f, const struct ibm_tip_form *form,
                               const struct tip *e, const double *item, double *result) {
    const double *n = item + IBM_TIP_NORMAL, mu = form->mu;
    const size_t first = fluid_grid_at(g, 0, 0, 0);
    const ibm_row p = contract(f->p + first, g, e, 0, YC, ZC), u = contract(f->u + first, g, e, 1, YC, ZC),
                  v = contract(f->v + first, g, e, 0, YF, ZC), w = contract(f->w + first, g, e, 0, YC, ZF);
    const ibm_row normal = {0, n[0], n[1], n[2]}, along = {1, mu, mu, mu}, across = {0, mu, mu, mu};
    const ibm_row slope = sums(p * normal, u * normal, v * normal, w * normal),
                  of_normal = n[0] * u + n[1] * v + n[2] * w;
    result[0] = p[0];
    ibm_row_store(result + IBM_TIP_SLOPE, along * slope + across * of_normal);
    if (form->length > 0) {
        const double bend[4] = {
            bend_along(f->p + first, g, e, 0, YC, ZC, n), bend_along(f->u + first, g, e, 1, YC, ZC, n),
            bend_along(f->v + first, g, e, 0, YF, ZC, n), bend_along(f->w + first, g, e, 0, YC, ZF, n)};
        carry_to_wall(form, (double[3]){u[0], v[0], w[0]}, (double[4]){slope[0], slope[1], slope[2], slope[3]}, bend, n,
                      item + IBM_TIP_VELOCITY, result);
    }
}

/* The first value of a tip's block in each of the four fields. */
static inline void blocks_of(const double *const field[4], const struct tip *e, const double *at[4]) {
    at[0] = field[0] + e->at[XC] + e->at[YC] + e->at[ZC];
    at[1] = field[1] + e->at[XF] + e->at[YC] + e->at[ZC];
    at[2] = field[2] + e->at[XC] + e->at[YF] + e->at[ZC];
    at[3] = field[3] + e->at[XC] + e->at[YC] + e->at[ZF];
}

/* While a group is measured, the blocks of the next one come into the first-level cache: each row's last value. Of a
 * row that lies in two lines, a neighbouring tip has mostly brought the first one. */
void ibm_tip_measure(const struct fluid_grid *g, const struct fluid_state *f, const struct ibm_tip_form *form, int tips,
                     const double *item, double *result) {
    const struct frame frame = frame_of(g);
    const size_t first = fluid_grid_at(g, 0, 0, 0);
    const double *const field[4] = {f->p + first, f->u + first, f->v + first, f->w + first}, *at[4];
    struct tip two[2][GROUP], *here = two[0], *ahead = two[1];
    for (int h = -GROUP; h < tips; h += GROUP) {
        const int next = h + GROUP, more = tips - next < GROUP ? tips - next : GROUP;
        for (int i = 0; i < more; i++) {
            tip_set(&frame, item + (size_t)(next + i) * IBM_TIP_SENT, form->length > 0, &ahead[i]);
            blocks_of(field, &ahead[i], at);
            for (int c = 0; c < 4; c++)
                for (int row = 0; row < 16; row++)
                    __builtin_prefetch(at[c] + row / 4 * g->plane + row % 4 * g->row + 3);
        }
        const int group = tips - h < GROUP ? tips - h : GROUP;
        for (int i = 0; i < group && h >= 0; i++)
            tip_measure(g, f, form, &here[i], item + (size_t)(h + i) * IBM_TIP_SENT,
                        result + (size_t)(h + i) * IBM_TIP_RETURNED);
        struct tip *const swap = here;
        here = ahead;
        ahead = swap;
    }
}
