/* The tensor from the levels, as a table and as a page. */
#include "program/permeability/result.h"

#include <math.h>

#define WALL_OFF                                                                                                       \
    0.05 /* cells: arrays of spheres and of cylinders at 12 to 64 cells a period are off by 0.01 to 0.04               \
          */
#define STAIRS (2 / 3.0) /* a smooth surface over that of its stairs */
#define BEYOND 0.5       /* of the step from grid to grid: order 1.58, between 4/3 along edges and 2 at walls */
#define OF_VOXELS 0.35   /* of the step: orders from 1.12 to 2.9 */
#define EDGES 0.005      /* of k: what the weight of edges leaves, which may hardly change from grid to grid */
#define OF_SHAPES (2 / 3.0)
#define ORDER_LOW 0.8 /* of the error of voxels: edges of solid lower it, walls alone have 2 */
#define ORDER_HIGH 2
#define ORDER_OFF 0.25
#define ROUGH 0.25      /* of k */
#define ASYMMETRIC 1e-3 /* of the largest entry: more than the iteration leaves */

/* What an order p adds to the step from the grid twice as fine to the one three times as fine. */
static double beyond_third(double p) { return pow(3, -p) / (pow(2, -p) - pow(3, -p)); }

/* The order of which the steps 1 - 2 and 2 - 3 have this ratio, between the bounds: the ratio rises with it. */
static double order_of(double ratio) {
    double low = ORDER_LOW, high = ORDER_HIGH;
    for (int k = 0; k < 50; k++) {
        const double p = 0.5 * (low + high);
        if ((1 - pow(2, -p)) / (pow(2, -p) - pow(3, -p)) < ratio)
            low = p;
        else
            high = p;
    }
    return 0.5 * (low + high);
}

/* From three levels of voxels, by the order of K_ii + K_jj: of a channel between two axes all four entries then keep
 * their ratios, and no principal value falls below 0. */
static void extrapolate_three(struct permeability_result *r) {
    const struct permeability_level *l = r->level;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double step = l[2].K[i][j] - l[1].K[i][j];
            double sum[3];
            for (int k = 0; k < 3; k++) sum[k] = l[k].K[i][i] + l[k].K[j][j];
            const double p = order_of((sum[1] - sum[0]) / (sum[2] - sum[1]));
            const double low = beyond_third(fmax(p - ORDER_OFF, ORDER_LOW)),
                         high = beyond_third(fmin(p + ORDER_OFF, ORDER_HIGH)), at = beyond_third(p);
            r->K[i][j] = l[2].K[i][j] + at * step;
            r->error[i][j] = fmax(low - at, at - high) * fabs(step);
        }
}

static void extrapolate(struct permeability_result *r) {
    const struct permeability_level *a = &r->level[0], *b = &r->level[r->levels - 1];
    const double phi = b->porosity, slope = 3 / phi + 2 / fmax(1 - phi, 1e-6); /* of ln k, k ~ phi^3/(1 - phi)^2 */
    const double off = r->of_voxels ? EDGES : slope * (fabs(b->porosity - a->porosity) + WALL_OFF * STAIRS * b->layer);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const double step = b->K[i][j] - a->K[i][j];
            r->K[i][j] = b->K[i][j] + (r->levels > 1 && r->of_voxels ? BEYOND * step : 0);
            r->error[i][j] = (r->of_voxels ? OF_VOXELS : OF_SHAPES) * fabs(step) + fabs(b->K[i][j]) * off;
            if (r->levels == 1) r->error[i][j] = NAN;
        }
    if (r->levels == 3) extrapolate_three(r);
}

int permeability_result_is_rough(const struct permeability_result *r) {
    int is = 0;
    for (int c = 0; c < 3; c++) is |= r->error[c][c] > ROUGH * r->K[c][c];
    return is && r->of_voxels;
}

/* Mean velocity along an axis for the scene's driving, m/s. */
static double velocity_of(const struct scene *s, const struct permeability_result *r, int axis) {
    const double k = r->K[axis][axis];
    if (r->drive.bulk) return r->drive.value;
    return k * permeability_drive_gradient(&r->drive, s, axis, k) / (s->fluid->density * s->fluid->viscosity);
}

void permeability_result_make(const struct scene *s, struct permeability_result *r) {
    int whole = 1;
    extrapolate(r);
    for (int i = 0; i < 9; i++) whole &= isfinite(r->K[i / 3][i % 3]) != 0;
    for (int q = 0; q < 3; q++)
        r->principal.value[q] = r->principal.along[q][0] = r->principal.along[q][1] = r->principal.along[q][2] = NAN;
    if (whole) r->principal = physics_darcy_principal_of((const double(*)[3])r->K);
    for (int c = 0; c < 3; c++) r->reynolds[c] = velocity_of(s, r, c) * sqrt(fabs(r->K[c][c])) / s->fluid->viscosity;
}

static double md(double k) { return 1e3 * k / PHYSICS_DARCY; }

void permeability_result_csv(FILE *to, const struct permeability_result *r) {
    const struct physics_darcy_principal *p = &r->principal;
    const struct permeability_level *last = &r->level[r->levels - 1];
    fputs("quantity,value,unit\n", to);
    for (int q = 0; q < 4; q++)
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) {
                const double k = q < 2 ? r->K[i][j] : r->error[i][j];
                fprintf(to, "k_%c%c%s%s,%.15g,%s\n", "xyz"[i], "xyz"[j], q < 2 ? "" : "_error", q % 2 ? "_md" : "",
                        q % 2 ? md(k) : k, q % 2 ? "mD" : "m2");
            }
    for (int q = 0; q < 3; q++) {
        fprintf(to, "principal_%d,%.15g,m2\n", q + 1, p->value[q]);
        fprintf(to, "principal_%d_md,%.15g,mD\n", q + 1, md(p->value[q]));
        for (int i = 0; i < 3; i++) fprintf(to, "principal_%d_%c,%.15g,1\n", q + 1, "xyz"[i], p -> along[q][i]);
    }
    for (int c = 0; c < 3; c++) {
        fprintf(to, "tortuosity_%c,%.15g,1\n", "xyz"[c], last -> tortuosity[c]);
        fprintf(to, "reynolds_k_%c,%.15g,1\n", "xyz"[c], r -> reynolds[c]);
        fprintf(to, "leads_%c,%d,1\n", "xyz"[c], last -> percolates[c]);
        fprintf(to, "meets_%c,%.15g,1\n", "xyz"[c], last -> overlap[c]);
    }
    for (int i = 0; i < 9 && r->has_smooth; i++)
        fprintf(to, "k_%c%c_smooth,%.15g,m2\n", "xyz"[i / 3], "xyz"[i % 3], r -> smooth.K[i / 3][i % 3]);
    fprintf(to, "porosity,%.15g,1\n", last->porosity);
    for (int l = 0; l < r->levels; l++) {
        const struct permeability_level *at = &r->level[l];
        for (int c = 0; c < 3; c++) {
            fprintf(to, "k_%c%c_level_%d,%.15g,m2\n", "xyz"[c], "xyz"[c], at -> finer, at -> K[c][c]);
            fprintf(to, "iterations_%c_level_%d,%d,1\n", "xyz"[c], at -> finer, at -> effort[c].outer);
            fprintf(to, "products_%c_level_%d,%ld,1\n", "xyz"[c], at -> finer, at -> effort[c].products);
            fprintf(to, "iteration_error_%c_level_%d,%.15g,1\n", "xyz"[c], at -> finer, at -> effort[c].error);
        }
        fprintf(to, "pore_cells_level_%d,%ld,1\n", at->finer, at->through);
        fprintf(to, "bytes_level_%d,%.15g,byte\n", at->finer, at->bytes);
        fprintf(to, "seconds_level_%d,%.15g,s\n", at->finer, at->seconds);
    }
}

static void page_tensor(FILE *to, const struct permeability_result *r) {
    fprintf(to, "Tensor of permeability, m2, in creeping flow\n%17s%15s%15s\n", "x", "y", "z");
    for (int i = 0; i < 3; i++)
        fprintf(to, "  %c%15.6g%15.6g%15.6g\n", "xyz"[i], r -> K[i][0], r -> K[i][1], r -> K[i][2]);
    fprintf(to, "\nThe same in mD (1 D = 9.869233e-13 m2)\n");
    for (int i = 0; i < 3; i++)
        fprintf(to, "  %c%15.6g%15.6g%15.6g\n", "xyz"[i], md(r->K[i][0]), md(r->K[i][1]), md(r->K[i][2]));
    fprintf(to, "\n%s\n",
            r->levels == 1 ? "On one grid, whose error is not known"
            : r->of_voxels && r->levels == 3
                ? "Of the voxels, extrapolated from three grids, with the error of the grid"
            : r->of_voxels ? "Of the voxels, extrapolated from two grids, with the error of the grid"
                           : "Of the shapes, on the finer grid, with the error of the grid");
    for (int c = 0; c < 3; c++) {
        const double k = r->K[c][c], e = r->error[c][c];
        if (!r->level[0].percolates[c])
            fprintf(to, "  k_%c%c = 0: blocked, no pores lead through along %c\n", "xyz"[c], "xyz"[c], "xyz"[c]);
        else if (r->levels > 1)
            fprintf(to, "  k_%c%c = %.4g +- %.2g m2 = %.4g +- %.2g mD\n", "xyz"[c], "xyz"[c], k, e, md(k), md(e));
        else
            fprintf(to, "  k_%c%c = %.4g m2 = %.4g mD\n", "xyz"[c], "xyz"[c], k, md(k));
    }
}

static void page_smooth(FILE *to, const struct permeability_level *l) {
    fprintf(to, "\nOf a smooth solid whose stairs the voxels are, on one grid");
    for (int c = 0; c < 3; c++)
        fprintf(to, "%s k_%c%c = %.4g m2 = %.4g mD", c ? "," : ":", "xyz"[c], "xyz"[c], l -> K[c][c], md(l->K[c][c]));
    fputs("\n", to);
}

static void page_principal(FILE *to, const struct physics_darcy_principal *p) {
    if (isnan(p->value[0])) {
        fprintf(to, "\nNo principal values: parts off the diagonal are not measured across sides that let nothing "
                    "through.\n");
        return;
    }
    fprintf(to, "\nPrincipal values of the symmetric part, and their directions\n");
    for (int q = 0; q < 3; q++)
        fprintf(to, "  %d %14.6g m2 %14.6g mD   (%.4f, %.4f, %.4f)\n", q + 1, p->value[q], md(p->value[q]),
                p->along[q][0], p->along[q][1], p->along[q][2]);
}

static void page_levels(FILE *to, const struct permeability_result *r) {
    fprintf(to, "\nGrids\n");
    for (int l = 0; l < r->levels; l++) {
        const struct permeability_level *at = &r->level[l];
        fprintf(to, "  %d x %d x %d cells, porosity %.5g, k %.6g, %.6g, %.6g m2, %d, %d and %d iterations, %.3g s\n",
                at->n[0], at->n[1], at->n[2], at->porosity, at->K[0][0], at->K[1][1], at->K[2][2], at->effort[0].outer,
                at->effort[1].outer, at->effort[2].outer, at->seconds);
    }
    fprintf(to, "Tortuosities");
    for (int c = 0; c < 3; c++) {
        const double tortuosity = r->level[r->levels - 1].tortuosity[c];
        if (isnan(tortuosity))
            fprintf(to, "%s %c blocked", c ? "," : ":", "xyz"[c]);
        else
            fprintf(to, "%s %c %.5g", c ? "," : ":", "xyz"[c], tortuosity);
    }
    fputs("\n", to);
}

/* A sample that is not a periodic medium, whose tensor would be symmetric. */
static void page_asymmetry(FILE *to, const struct permeability_result *r) {
    double most = 0, size = 0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            size = fmax(size, fabs(r->K[i][j]));
            if (!isnan(r->K[i][j] - r->K[j][i])) most = fmax(most, fabs(r->K[i][j] - r->K[j][i]));
        }
    if (most > ASYMMETRIC * size)
        fprintf(
            to,
            "Off the diagonal the two halves of the tensor differ by up to %.2g m2: between open layers, or sides of "
            "given pressure,\nthe sample is not a periodic medium, whose tensor would be symmetric.\n",
            most);
}

/* Sides at which the pores of a sample that was cut from a larger one end at solid. */
static void page_cut(FILE *to, const struct permeability_level *l) {
    int cut = 0;
    for (int c = 0; c < 3; c++) {
        if (isnan(l->overlap[c])) continue;
        cut |= l->is_cut[c];
        fprintf(to, "Across the sides of %c %.1f %% of the pores' area is pore on both sides%s\n", "xyz"[c],
                100 * l -> overlap[c], l -> is_cut[c] ? ": the other pores end at solid" : "");
    }
    if (cut)
        fprintf(
            to,
            "WARNING: this sample is cut from a larger one, and its pores do not continue across the periodic sides. "
            "So k is\ntoo small, perhaps by a large factor. Mirror the image (key mirror), or put the sample between "
            "two sides of given pressure.\n");
}

/* Pores of a cell or two, of which the grids do not tell k. */
static void page_rough(FILE *to, const struct permeability_result *r) {
    for (int c = 0; c < 3; c++)
        if (r->error[c][c] > 2 * ROUGH * fabs(r->K[c][c]))
            fprintf(to,
                    "WARNING: the grid does not resolve the pores along %c: k is not known better than within %.2g and "
                    "%.2g m2.\nGive more cells (domain.cells).\n",
                    "xyz"[c], fmax(r->K[c][c] - r->error[c][c], 0), r -> K[c][c] + r -> error[c][c]);
}

void permeability_result_page(FILE *to, const struct scene *s, const struct permeability_result *r) {
    fprintf(to, "%s\n\n", s->title);
    page_tensor(to, r);
    if (r->has_smooth) page_smooth(to, &r->smooth);
    page_principal(to, &r->principal);
    page_asymmetry(to, r);
    page_levels(to, r);
    page_rough(to, r);
    page_cut(to, &r->level[r->levels - 1]);
    for (int c = 0; c < 3; c++)
        if (r->reynolds[c] > 0.1)
            fprintf(to,
                    "With the scene's driving the Reynolds number along %c is %.3g: k of that flow is not the one of "
                    "creeping flow.\n",
                    "xyz"[c], r -> reynolds[c]);
    if (r->drive.axis >= 0)
        fprintf(to,
                "The sides of given pressure along %c stood at the ends of each direction in turn; the sides of that "
                "direction\nstood along %c meanwhile.\n",
                "xyz"[r->drive.axis], "xyz"[r->drive.axis]);
}
