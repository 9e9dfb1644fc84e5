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

#include <math.h>

static double cell_mass(const struct fluid *f) {
    const double *d = f->grid->d;
    return f->in.density * d[0] * d[1] * d[2];
}

/* Coordinate a of the face i of component c, from the domain's centre, m. */
static double place(const struct fluid_grid *g, int a, int c, int i) {
    return (g->lo[a] + i + (a == c ? 1 : 0.5)) * g->d[a] - 0.5 * g->length[a];
}

/* couple += x times a force along c. */
static void add(double couple[3], const double x[3], int c, double force) {
    const int a = (c + 1) % 3, b = (c + 2) % 3;
    couple[a] += x[b] * force;
    couple[b] -= x[a] * force;
}

/* The advanced faces of component c beside one side of direction d. */
struct face {
    const struct fluid *f;
    const double *const *q;
    int c, d, side;
    double convection, viscosity; /* which terms count: 1 or 0; m2/s */
    double *couple;
};

/* The flux through the side at face n, outward, less the viscous traction, m2/s2, as fluid/measure/box_force.c has it.
 */
static double flux(const struct face *e, ptrdiff_t n) {
    const struct fluid_grid *g = e->f->grid;
    const ptrdiff_t sd = fluid_boundary_stride(g, e->d), s = e->side ? sd : -sd, sc = fluid_boundary_stride(g, e->c);
    const double *q = e->q[e->c] + n, sign = e->side ? 1 : -1;
    const int is_open = !g->periodic[e->d] && fluid_boundary_is_open(&e->f->boundary->side[e->d][e->side], e->d, e->c);
    if (e->c == e->d && is_open) /* q[s] may lie beyond the ghosts */
        return e->convection * sign *
               fluid_boundary_open_flux(q[0], q[-s], sign, e->f->boundary->side[e->d][e->side].drains);
    const double mean = 0.5 * (q[0] + q[s]);
    const double viscous = e->viscosity / g->d[e->d] * (q[s] - q[0]);
    if (e->c == e->d) return e->convection * sign * mean * mean - viscous;
    const double *through = e->q[e->d] + n - (e->side ? 0 : sd);
    const double velocity = 0.5 * (through[0] + through[sc]);
    return e->convection * sign * velocity * (is_open && fluid_boundary_comes_in(velocity, sign) ? 0 : mean) - viscous;
}

static void at_side(const struct face *e, const int at[3]) {
    const struct fluid_grid *g = e->f->grid;
    const int c = e->c, d = e->d, sign = e->side ? 1 : -1;
    const int is_free = e->f->boundary->side[d][e->side].normal == FLUID_NORMAL_FREE;
    const ptrdiff_t n = (ptrdiff_t)fluid_grid_at(g, at[0], at[1], at[2]), sd = fluid_boundary_stride(g, d);
    const double mass = cell_mass(e->f) / g->d[d];
    double x[3], unit[3] = {0, 0, 0};
    for (int b = 0; b < 3; b++) x[b] = place(g, b, c, at[b] + (b == d && c != d && is_free ? sign : 0));
    add(e->couple, x, c, -mass * flux(e, n));
    if (c == d) return;
    unit[d] = sign;
    add(e->couple, unit, c, -mass * e->viscosity * e->q[c][is_free ? n + sign * sd : n]);
}

/* 1: the face lies on an open side, through which fluid comes in where the period ends: nothing is carried along it. */
static int comes_in(const struct face *e, const int at[3], ptrdiff_t n) {
    const struct fluid_boundary_side *side = e->f->boundary->side[e->c];
    const ptrdiff_t sd = fluid_boundary_stride(e->f->grid, e->d);
    const double normal = e->q[e->c][n] + e->q[e->c][e->side ? n + sd : n - sd];
    for (int high = 0; high < 2; high++)
        if (side[high].here && side[high].normal == FLUID_NORMAL_FREE &&
            at[e->c] == (high ? e->f->grid->m[e->c] - 1 : -1) && fluid_boundary_comes_in(normal, high ? 1 : -1))
            return 1;
    return 0;
}

static void at_period(const struct face *e, const int at[3]) {
    const struct fluid_grid *g = e->f->grid;
    const ptrdiff_t n = (ptrdiff_t)fluid_grid_at(g, at[0], at[1], at[2]);
    const struct face still = {e->f, e->q, e->c, e->d, e->side, 0, e->viscosity, e->couple};
    double arm[3] = {0, 0, 0};
    arm[e->d] = g->length[e->d];
    add(e->couple, arm, e->c,
        cell_mass(e->f) / g->d[e->d] *
            flux(comes_in(e, at, n) ? &still : e, n)); /* flux: along -d, through the low side */
}

static void along_side(const struct face *e, void (*visit)(const struct face *e, const int at[3])) {
    const struct fluid *f = e->f;
    int low[3], high[3], at[3];
    fluid_boundary_advanced(f->boundary, f->grid, e->c, low, high);
    low[e->d] = e->side ? high[e->d] - 1 : low[e->d];
    high[e->d] = low[e->d] + 1;
    for (at[2] = low[2]; at[2] < high[2]; at[2]++)
        for (at[1] = low[1]; at[1] < high[1]; at[1]++)
            for (at[0] = low[0]; at[0] < high[0]; at[0]++) visit(e, at);
}

/* Adds this rank's share of the couple of the fluxes, N m. */
void fluid_box_couple_flux(const struct fluid *f, const double *const q[3], double couple[3]) {
    const struct fluid_grid *g = f->grid;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++)
            for (int c = 0; c < 3; c++) {
                const struct face e = {f, q, c, d, side, 1, f->in.viscosity, couple};
                if (f->boundary->side[d][side].here) along_side(&e, at_side);
                if (g->periodic[d] && side == 0 && g->lo[d] == 0 && c != d) along_side(&e, at_period);
            }
}

static void pressure_at(const struct face *e, const int at[3]) {
    const struct fluid_grid *g = e->f->grid;
    const ptrdiff_t n = (ptrdiff_t)fluid_grid_at(g, at[0], at[1], at[2]);
    const double p = e->f->state.p[n + (e->side ? fluid_boundary_stride(g, e->d) : 0)];
    double x[3];
    for (int b = 0; b < 3; b++) x[b] = place(g, b, e->c, at[b]);
    add(e->couple, x, e->c, (e->side ? -p : p) * g->d[0] * g->d[1] * g->d[2] / g->d[e->d]);
}

void fluid_box_couple_pressure(const struct fluid *f, double share, double couple[3]) {
    double sum[3] = {0, 0, 0};
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            const struct face e = {f, NULL, d, d, side, 0, 0, sum};
            if (f->boundary->side[d][side].here) along_side(&e, pressure_at);
        }
    for (int c = 0; c < 3; c++) couple[c] += share * sum[c];
}

/* Sum of q (NULL: of ones) and of x_a q over the faces of component c. */
static void moments(const struct fluid *f, int c, const double *q, double moment[3]) {
    const struct fluid_grid *g = f->grid;
    int low[3], high[3];
    fluid_boundary_advanced(f->boundary, g, c, low, high);
    for (int b = 0; b < 3; b++) moment[b] = 0;
    for (int k = low[2]; k < high[2]; k++)
        for (int j = low[1]; j < high[1]; j++) {
            const size_t row = fluid_grid_at(g, 0, j, k);
            double sum = 0, along = 0;
            for (int i = low[0]; i < high[0]; i++) {
                const double value = q ? q[row + (size_t)i] : 1;
                sum += value;
                along += value * i;
            }
            moment[0] += g->d[0] * along + place(g, 0, c, 0) * sum;
            moment[1] += place(g, 1, c, j) * sum;
            moment[2] += place(g, 2, c, k) * sum;
        }
}

void fluid_box_couple_source(const struct fluid *f, double share, double couple[3]) {
    for (int c = 0; c < 3; c++) {
        const double source = fluid_source(f, c);
        double moment[3];
        if (source == 0) continue;
        moments(f, c, NULL, moment);
        add(couple, moment, c, share * cell_mass(f) * source);
    }
}

void fluid_box_couple_angular_momentum(struct fluid *f, double out[3]) {
    for (int c = 0; c < 3; c++) out[c] = 0;
    for (int c = 0; c < 3; c++) {
        double moment[3];
        moments(f, c, fluid_component(&f->state, c), moment);
        add(out, moment, c, cell_mass(f));
    }
    par_sum_array(out, 3);
}

int fluid_box_couple_end(struct fluid *f, double out[3]) {
    for (int c = 0; c < 3; c++) out[c] = f->box_balance.couple[c];
    par_sum_array(out, 3);
    return !f->diffusion && !f->scheme.is_multistep;
}
