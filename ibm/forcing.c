/* Multidirect forcing.  (001: sec. 3.5.2; Breugem 2012) */
#include "base/clock.h"
#include "base/par.h"
#include "ibm/kernel.h"
#include "ibm/state.h"

void ibm_interpolate(struct ibm *b, double *const u[3], double given[3], double *squares) {
    const ptrdiff_t row = b->grid->row, plane = b->grid->plane;
    double sum[3] = {0, 0, 0}, square = 0;
    for (int h = 0; h < b->n; h++) {
        const struct ibm_stencil *s = &b->stencil[h];
        const struct ibm_marker *m = &b->marker[h];
        for (int c = 0; c < 3; c++) {
            const double *x = s->weight[c == 0] + IBM_X, *y = s->weight[c == 1] + IBM_Y,
                         *z = s->weight[c == 2] + IBM_Z;
            const double lack = m->v[c] - ibm_kernel_gather(u[c] + s->at[c], row, plane, x, y, z);
            b->increment[c][h] = lack * m->volume;
            sum[c] += lack * m->volume * m->share[c];
            square += lack * lack;
        }
    }
    for (int c = 0; c < 3; c++) given[c] += sum[c];
    *squares = square;
}

void ibm_spread(struct ibm *b, double *const u[3]) {
    const ptrdiff_t row = b->grid->row, plane = b->grid->plane;
    if (b->crossing) ibm_shell_clear(b);
    for (int h = 0; h < b->n; h++) {
        const struct ibm_stencil *s = &b->stencil[h];
        double *const *to = b->marker[h].inside ? u : b->shell;
        for (int c = 0; c < 3; c++) {
            const double *x = s->weight[c == 0] + IBM_X, *y = s->weight[c == 1] + IBM_Y,
                         *z = s->weight[c == 2] + IBM_Z;
            ibm_kernel_scatter(to[c] + s->at[c], row, plane, x, y, z, b->increment[c][h]);
        }
    }
    if (b->crossing) ibm_shell_add(b, u);
}

/* What each marker has given so far in this step. */
static void receive(struct ibm *b, int is_first) {
    for (int c = 0; c < 3; c++)
        for (int h = 0; h < b->n; h++)
            b->received[c][h] = (is_first ? 0 : b->received[c][h]) + b->increment[c][h];
}

void ibm_force(struct ibm *b, int r, double dt) {
    clock_begin(CLOCK_FORCING);
    const struct fluid_grid *g = b->grid;
    double *const *u = fluid_predicted(b->fluid);
    double given[3] = {0, 0, 0}, squares;
    for (int s = 0; s < b->iterations; s++) {
        if (b->crossing) fluid_predicted_refresh(b->fluid, 2); /* no block reaches a ghost otherwise */
        ibm_interpolate(b, u, given, &squares);
        ibm_spread(b, u);
        receive(b, r == 0 && s == 0);
    }
    /* gamma_r rho Q V = gamma_r rho sum (V - U) V / (gamma_r dt) */
    const double scale = fluid_input_of(b->fluid)->density * g->d[0] * g->d[1] * g->d[2] / dt;
    for (int c = 0; c < 3; c++) b->given[c] = (r == 0 ? 0 : b->given[c]) + given[c] * scale;
    clock_end(CLOCK_FORCING);
}

void ibm_force_by_marker(struct ibm *b, double dt, double *const force[3]) {
    const struct fluid_grid *g = b->grid;
    const double scale = fluid_input_of(b->fluid)->density * g->d[0] * g->d[1] * g->d[2] / dt;
    struct ibm_route *route = &b->route;
    ibm_reserve(&route->served, &route->served_size, (size_t)b->n * 3);
    ibm_reserve(&route->mine, &route->mine_size, (size_t)route->n * 3);
    for (int h = 0; h < b->n; h++)
        for (int c = 0; c < 3; c++) route->served[3 * route->order[h] + c] = b->received[c][h] * scale;
    for (int i = 0; i < 3 * route->n; i++) route->mine[i] = 0;
    par_exchange_backward(route->plan, route->served, route->mine, 3 * sizeof(double));
    for (int i = 0; i < route->n; i++)
        for (int c = 0; c < 3; c++) force[c][i] = route->mine[3 * i + c];
}

void ibm_force_total(struct ibm *b, double force[3]) {
    for (int c = 0; c < 3; c++) force[c] = b->given[c];
    par_sum_array(force, 3);
}

double ibm_slip(struct ibm *b) {
    double given[3] = {0, 0, 0}, sum[2] = {0, (double)b->n};
    fluid_predicted_refresh(b->fluid, 2);
    ibm_interpolate(b, fluid_predicted(b->fluid), given, &sum[0]);
    par_sum_array(sum, 2);
    return sum[1] > 0 ? sqrt(sum[0] / sum[1]) : 0;
}
