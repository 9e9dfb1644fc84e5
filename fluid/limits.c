/* Stability limits of the fluid's time step, and the check for NaN and too large velocities. */
#include "base/ensure.h"
#include "base/par.h"
#include "base/step_status.h"
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"
#include "fluid/momentum/diffusion.h"

#include <math.h>
#include <string.h>

/* The larger size, or NaN if b is NaN. The compiler makes one instruction of it, which it may not do with fmax. */
static inline double larger(double a, double b) { return fabs(a) > fabs(b) ? fabs(a) : fabs(b); }

/* The rate of cell n. */
static inline double cell_rate(const struct fluid *f, size_t n, const double per[3]) {
    const double *u = f->state.u + n, *v = f->state.v + n, *w = f->state.w + n;
    return larger(u[-1], u[0]) * per[0] + larger(v[-f->grid->row], v[0]) * per[1] +
           larger(w[-f->grid->plane], w[0]) * per[2];
}

/* The largest rate in a row of cells; a NaN gives INFINITY. */
static double row_rate(const struct fluid *f, int j, int k, const double per[3]) {
    const size_t n = fluid_grid_at(f->grid, 0, j, k);
    double most = 0, lost = 0; /* lost: NaN if a rate is not a finite number, which `most` does not show */
#pragma omp simd reduction(max : most) reduction(+ : lost)
    for (int i = 0; i < f->grid->m[0]; i++) {
        const double rate = cell_rate(f, n + (size_t)i, per);
        most = rate > most ? rate : most;
        lost += 0 * rate;
    }
    return lost == 0 ? most : INFINITY;
}

/* The cell of a row that has the largest rate. */
static int cell_of(const struct fluid *f, int j, int k, const double per[3]) {
    double most = 0;
    int at = 0;
    for (int i = 0; i < f->grid->m[0]; i++) {
        const double rate = cell_rate(f, fluid_grid_at(f->grid, i, j, k), per);
        if (rate <= most) continue;
        most = rate == rate ? rate : INFINITY;
        at = i;
    }
    return at;
}

double fluid_limits_convection_rate(const struct fluid *f, double x[3]) {
    const struct fluid_grid *g = f->grid;
    const double per[3] = {1 / g->d[0], 1 / g->d[1], 1 / g->d[2]};
    int cell[3] = {0};
    double most = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const double rate = row_rate(f, j, k, per);
            if (rate <= most) continue;
            most = rate;
            cell[1] = j, cell[2] = k;
        }
    if (!x) return most;
    cell[0] = cell_of(f, cell[1], cell[2], per);
    for (int d = 0; d < 3; d++) x[d] = (cell[d] + g->lo[d] + 0.5) * g->d[d];
    return most;
}

/* The rectangle -1.65 <= Re <= 0, |Im| <= sqrt(3) lies within the stability region of third-order Runge-Kutta, so that
 * each limit may be reached alone or both together: sqrt(3) = dt sum |u|/d, 1.65 = dt 4 nu sum 1/d^2.  (Wesseling
 * 2001) */
static const double RK3_VISCOUS = 1.65;

/* The step at which dt 4 nu sum 1/d^2 is `most`, s. */
static double viscous_step(const struct fluid *f, double most) {
    const double *d = f->grid->d;
    return most / (4 * f->in.viscosity * (1 / (d[0] * d[0]) + 1 / (d[1] * d[1]) + 1 / (d[2] * d[2])));
}

double fluid_limits_explicit_step(const struct fluid *f) { return viscous_step(f, RK3_VISCOUS); }

/* AB2 is stable for all modes of central differences where D = dt 4 nu sum 1/d^2 is at most 0.8 and C = dt sum |u|/d at
 * most 0.7 (2 D_i)^(1/4), D_i = dt 4 nu/d^2 of the direction with the largest d: on the imaginary axis it grows by
 * C^4/4, and diffusion takes D_i/2. (tests/fluid/test_scheme.c tries the modes' eigenvalues) */
static const double AB2_VISCOUS = 0.8, AB2_CONVECTIVE = 0.7;

static struct fluid_limits of_ab2(const struct fluid *f, double rate) {
    struct fluid_limits l = {INFINITY, INFINITY, INFINITY};
    const double *d = f->grid->d, most = fmax(d[0], fmax(d[1], d[2])), nu = f->in.viscosity;
    if (nu > 0) l.viscous = viscous_step(f, AB2_VISCOUS);
    if (rate > 0) l.convective = pow(AB2_CONVECTIVE / rate, 4. / 3) * cbrt(8 * nu / (most * most));
    l.step = fmin(l.convective, l.viscous);
    return l;
}

struct fluid_limits fluid_limits_of(const struct fluid *f, double rate) {
    struct fluid_limits l = {INFINITY, INFINITY, INFINITY};
    if (f->scheme.is_multistep) return of_ab2(f, rate);
    if (rate > 0) l.convective = sqrt(3) / rate;
    if (f->diffusion)
        l.viscous = fluid_diffusion_step(f);
    else if (f->in.viscosity > 0)
        l.viscous = fluid_limits_explicit_step(f);
    l.step = fmin(l.convective, l.viscous);
    return l;
}

struct fluid_limits fluid_limits_stable_step(struct fluid *f) {
    return fluid_limits_of(f, par_max(fluid_limits_convection_rate(f, NULL)));
}

/* The largest rate of the velocities that this rank's sides and a held bulk velocity give, 1/s. */
static double given_rate(const struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    const struct fluid_driving *driving = &f->in.driving;
    double most = driving->type == FLUID_DRIVING_BULK ? fabs(driving->value) / g->d[driving->direction] : 0;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            const struct fluid_boundary_side *s = &f->boundary->side[d][side];
            const int a = d == 0 ? 1 : 0, b = d == 2 ? 1 : 2;
            double normal = 0, along = 0;
            if (!s->here) continue;
            for (int i = 0; s->normal == FLUID_NORMAL_GIVEN && s->plane && i < g->m[a] * g->m[b]; i++)
                normal = fmax(normal, fabs(s->plane[i]));
            for (int c = 0; c < 3; c++)
                if (c != d && s->condition[c] == FLUID_DIRICHLET) along += fabs(s->value[c]) / g->d[c];
            most = fmax(most, normal / g->d[d] + along);
        }
    return most;
}

struct fluid_limits fluid_limits_foreseen(const struct fluid *f) {
    return fluid_limits_of(f, par_max(fmax(fluid_limits_convection_rate(f, NULL), given_rate(f))));
}

/* The largest velocity scale of sides, initial flow, driving and diffusion over a cell. */
double fluid_limits_speed(const struct fluid *f) {
    const struct fluid_input *in = &f->in;
    double most = 0, length = 0;
    for (int d = 0; d < 3; d++) {
        length = fmax(length, in->length[d]);
        most = fmax(most, in->viscosity / f->grid->d[d]);
        most = fmax(most, fabs(in->initial_velocity[d]) + fabs(in->vortices.velocity));
        for (int side = 0; side < 2; side++) {
            const struct fluid_boundary_side *b = &f->boundary->side[d][side];
            for (int c = 0; c < 3; c++)
                most = fmax(most, fabs(b->value[c]) * (b->condition[c] == FLUID_NEUMANN ? length : 1));
            most = fmax(most, fabs(in->side[d][side].bulk_velocity));
            most = fmax(most, sqrt(fabs(b->value[3]) / in->density));
        }
    }
    for (int d = 0; d < 3; d++) most = fmax(most, sqrt(fabs(in->body_force[d]) * length));
    switch (in->driving.type) {
    case FLUID_DRIVING_NONE:
        return most;
    case FLUID_DRIVING_GRADIENT:
        return fmax(most, sqrt(fabs(in->driving.value) * length / in->density));
    case FLUID_DRIVING_BULK:
        return fmax(most, fabs(in->driving.value));
    }
    ENSURE(0, "driving %d", (int)in->driving.type);
}

static int bad(double value, double most) { return !(fabs(value) <= most); }

struct step_status fluid_limits_check(struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    const double most = fmax(1e4 * fluid_limits_speed(f), 100 * f->in.speed);
    const double *field[4] = {f->state.u, f->state.v, f->state.w, f->state.p};
    struct step_status s = {.failed = 0};
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int c = 0; c < 4; c++) {
                const double *row = field[c] + fluid_grid_at(g, 0, j, k), limit = c < 3 ? most : 1e300;
                int wrong = 0;
                for (int i = 0; i < g->m[0]; i++) wrong |= bad(row[i], limit);
                if (!wrong) continue;
                int i = 0;
                while (!bad(row[i], limit)) i++;
                const int at[3] = {i + g->lo[0], j + g->lo[1], k + g->lo[2]};
                for (int d = 0; d < 3; d++) s.x[d] = (at[d] + (d == c ? 1.0 : 0.5)) * g->d[d];
                s.failed = 1;
                s.seen_in = STEP_STATUS_FLUID;
                s.rank = par_rank();
                s.value = row[i];
                strcpy(s.field, c == 0 ? "u" : c == 1 ? "v" : c == 2 ? "w" : "p");
                return s;
            }
    return s;
}
