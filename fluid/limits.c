#include "base/par.h"
#include "fluid/internal.h"

#include <math.h>
#include <string.h>

/* The larger size, and NaN where b is: the compiler makes one instruction of it, which it may not of fmax. */
static inline double larger(double a, double b) { return fabs(a) > fabs(b) ? fabs(a) : fabs(b); }

/* Largest sum of |velocity|/d over cells, from the faces of each, 1/s. */
static double convection_rate(const struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    const double per[3] = {1 / g->d[0], 1 / g->d[1], 1 / g->d[2]};
    double most = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++) {
            const size_t n = fluid_grid_at(g, 0, j, k);
            const double *u = f->state.u + n, *v = f->state.v + n, *w = f->state.w + n;
            for (int i = 0; i < g->m[0]; i++) {
                const double rate = larger(u[i - 1], u[i]) * per[0] + larger(v[i - g->row], v[i]) * per[1] +
                                    larger(w[i - g->plane], w[i]) * per[2];
                most = rate <= most ? most : rate == rate ? rate : INFINITY; /* a NaN shows */
            }
        }
    return par_max(most);
}

/* The rectangle -1.65 <= Re <= 0, |Im| <= sqrt(3) lies within the stability region of third-order Runge-Kutta, so that
 * either limit may be met alone or both together: sqrt(3) = dt sum |u|/d, 1.65 = dt 4 nu sum 1/d^2.  (Wesseling 2001) */
struct fluid_limits fluid_stable_step(struct fluid *f) {
    const double *d = f->grid->d, rate = convection_rate(f);
    struct fluid_limits l = {INFINITY, INFINITY, INFINITY};
    if (rate > 0) l.convective = sqrt(3) / rate;
    if (f->in.viscosity > 0)
        l.viscous =
            1.65 / (4 * f->in.viscosity * (1 / (d[0] * d[0]) + 1 / (d[1] * d[1]) + 1 / (d[2] * d[2])));
    l.step = fmin(l.convective, l.viscous);
    return l;
}

double fluid_cfl(struct fluid *f, double dt) { return dt * convection_rate(f); }

/* A speed far above every one that the scene can set up: of the sides, the start, the driving, or diffusion over a cell. */
static double speed_beyond_reason(const struct fluid *f) {
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
    if (in->driving.type == FLUID_DRIVING_GRADIENT)
        most = fmax(most, sqrt(fabs(in->driving.value) * length / in->density));
    if (in->driving.type == FLUID_DRIVING_BULK) most = fmax(most, fabs(in->driving.value));
    return 1e4 * most;
}

static int bad(double value, double most) { return !(fabs(value) <= most); }

struct step_status fluid_check(struct fluid *f) {
    const struct fluid_grid *g = f->grid;
    const double most = speed_beyond_reason(f);
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
                s.rank = par_rank();
                s.value = row[i];
                strcpy(s.field, c == 0 ? "u" : c == 1 ? "v" : c == 2 ? "w" : "p");
                return s;
            }
    return s;
}
