/* Angular momentum of the fluid, and the couple on the box as the scheme applies it. */
/* Both are about the domain's centre, with each velocity at the place of its face. For component c and another
 * direction a let M_ac = rho sum x_a q_c dV. Summed by parts, what the scheme changes of M_ac leaves terms at the
 * sides, and the sum of the fluxes F_ac within. In M_ac - M_ca these cancel where the flux is u_a u_c, which is the
 * same for both at an edge of cells; its viscous part -nu (dq_c/dx_a - dq_a/dx_c) leaves the velocities beside the
 * sides. Through a periodic side the flux carries the length of the period as its arm: what leaves at one end enters at
 * the other, which is that far away. */
#include "base/par.h"
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"
#include "fluid/measure/side_flux.h"

#include <math.h>

static double cell_mass(const struct fluid *f) {
    const double *d = f->grid->d;
    return f->in.density * d[0] * d[1] * d[2];
}

/* couple += x times a force along c. */
static void add(double couple[3], const double x[3], int c, double force) {
    const int a = (c + 1) % 3, b = (c + 2) % 3;
    couple[a] += x[b] * force;
    couple[b] -= x[a] * force;
}

void fluid_box_couple_side(const struct fluid *f, const struct fluid_side_flux *flux, int c, int d, int side,
                           double couple[3]) {
    const double mass = cell_mass(f) / f->grid->d[d];
    double unit[3] = {0, 0, 0};
    add(couple, flux->moment, c, -mass);
    unit[d] = side ? 1 : -1;
    if (c != d) add(couple, unit, c, -mass * f->in.viscosity * flux->velocity);
}

/* What is carried of component c along d through the low end of a period at face n, m2/s2. */
static double edge_flux(const struct fluid *f, const double *const q[3], int c, int d, ptrdiff_t n) {
    const ptrdiff_t sd = fluid_boundary_stride(f->grid, d), sc = fluid_boundary_stride(f->grid, c);
    const double *through = q[d] + n - sd;
    return 0.25 * (q[c][n] + q[c][n - sd]) * (through[0] + through[sc]);
}

/* Sum of the fluxes through the period's low end of faces on an open side, where fluid comes in: nothing is carried
 * along it, m2/s2. */
static double not_carried(const struct fluid *f, const double *const q[3], int c, int d) {
    const ptrdiff_t sd = fluid_boundary_stride(f->grid, d);
    const struct fluid_boundary_side *side = f->boundary->side[c];
    double sum = 0;
    for (int high = 0; high < 2; high++) {
        int first[3], last[3], at[3];
        if (!side[high].here || side[high].normal != FLUID_NORMAL_FREE) continue;
        fluid_side_flux_faces(f, c, d, 0, first, last);
        first[c] = high ? last[c] - 1 : first[c];
        last[c] = first[c] + 1;
        for (at[2] = first[2]; at[2] < last[2]; at[2]++)
            for (at[1] = first[1]; at[1] < last[1]; at[1]++)
                for (at[0] = first[0]; at[0] < last[0]; at[0]++) {
                    const ptrdiff_t n = (ptrdiff_t)fluid_grid_at(f->grid, at[0], at[1], at[2]);
                    if (fluid_boundary_comes_in(q[c][n] + q[c][n - sd], high ? 1 : -1)) sum += edge_flux(f, q, c, d, n);
                }
    }
    return sum;
}

void fluid_box_couple_periods(const struct fluid *f, const double *const q[3], double couple[3]) {
    const struct fluid_grid *g = f->grid;
    const struct fluid_flux_kind whole = {1, f->in.viscosity};
    for (int d = 0; d < 3; d++)
        for (int c = 0; c < 3; c++) {
            double arm[3] = {0, 0, 0};
            if (!g->periodic[d] || g->lo[d] != 0 || c == d) continue;
            arm[d] = g->length[d]; /* flux: along -d, through the low side */
            add(couple, arm, c,
                cell_mass(f) / g->d[d] * (fluid_side_flux(f, q, whole, c, d, 0).sum + not_carried(f, q, c, d)));
        }
}

/* Adds the couple of the pressure on one side. */
static void add_pressure(const struct fluid *f, int d, int side, double couple[3]) {
    const struct fluid_grid *g = f->grid;
    const ptrdiff_t up = side ? fluid_boundary_stride(g, d) : 0;
    const double sign = side ? -1 : 1;
    int low[3], high[3], at[3];
    double moment[3] = {0, 0, 0};
    fluid_side_flux_faces(f, d, d, side, low, high);
    for (at[2] = low[2]; at[2] < high[2]; at[2]++)
        for (at[1] = low[1]; at[1] < high[1]; at[1]++)
            for (at[0] = low[0]; at[0] < high[0]; at[0]++) {
                const double p = f->state.p[(ptrdiff_t)fluid_grid_at(g, at[0], at[1], at[2]) + up];
                for (int b = 0; b < 3; b++) moment[b] += fluid_side_flux_place(g, b, d, at[b]) * p;
            }
    add(couple, moment, d, sign * g->d[0] * g->d[1] * g->d[2] / g->d[d]);
}

void fluid_box_couple_pressure(const struct fluid *f, double share, double couple[3]) {
    double sum[3] = {0, 0, 0};
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
            if (f->boundary->side[d][side].here) add_pressure(f, d, side, sum);
    for (int c = 0; c < 3; c++) couple[c] += share * sum[c];
}

/* Sum of x_a over the faces of component c, m. */
static void moments(const struct fluid *f, int c, double moment[3]) {
    const struct fluid_grid *g = f->grid;
    int low[3], high[3];
    fluid_boundary_advanced(f->boundary, g, c, low, high);
    const double faces = (double)(high[0] - low[0]) * (high[1] - low[1]) * (high[2] - low[2]);
    for (int a = 0; a < 3; a++)
        moment[a] =
            0.5 * faces * (fluid_side_flux_place(g, a, c, low[a]) + fluid_side_flux_place(g, a, c, high[a] - 1));
}

void fluid_box_couple_source(const struct fluid *f, double share, double couple[3]) {
    for (int c = 0; c < 3; c++) {
        const double source = fluid_source(f, c);
        double moment[3];
        if (source == 0) continue;
        moments(f, c, moment);
        add(couple, moment, c, share * cell_mass(f) * source);
    }
}

int fluid_box_couple_end(struct fluid *f, double out[3]) {
    for (int c = 0; c < 3; c++) out[c] = f->box_balance.couple[c];
    par_sum_array(out, 3);
    return !f->diffusion && !f->scheme.is_multistep;
}
