/* Implicit diffusion: Helmholtz solutions, exact steady flows, order in time, large steps. */
/* Helmholtz's equation for every pair of conditions, flows that must be exact, the order in time, and stability in any
 * step. */
#include "fluid/poisson/poisson.h"
#include "tests/fluid/fluid_case.h"
#include "tests/check.h"

#include <stdlib.h>

enum { PP, DD, NN, DN, ND, FF, PAIRS };
static const enum fluid_end ends[PAIRS][2] = {
    {FLUID_END_PERIODIC, FLUID_END_PERIODIC}, {FLUID_END_DIRICHLET, FLUID_END_DIRICHLET},
    {FLUID_END_NEUMANN, FLUID_END_NEUMANN},   {FLUID_END_DIRICHLET, FLUID_END_NEUMANN},
    {FLUID_END_NEUMANN, FLUID_END_DIRICHLET}, {FLUID_END_FACE, FLUID_END_FACE}};

/* The value beyond an end: the image of the value at the end, or on faces zero. */
static double beyond(const double *line, int n, int stride, int i, const enum fluid_end end[2]) {
    if (i >= 0 && i < n) return line[i * stride];
    const enum fluid_end e = end[i < 0 ? 0 : 1];
    const int inside = e == FLUID_END_PERIODIC ? (i + n) % n : i < 0 ? 0 : n - 1;
    return e == FLUID_END_FACE ? 0 : e == FLUID_END_DIRICHLET ? -line[inside * stride] : line[inside * stride];
}

/* The last value of a line between faces is the side's own. */
static int is_unknown(const int n[3], const int pair[3], const int at[3]) {
    for (int d = 0; d < 3; d++)
        if (pair[d] == FF && at[d] == n[d] - 1) return 0;
    return 1;
}

struct planes {
    const struct fluid_grid *g;
    ptrdiff_t row;
    const int *pair;
    const double *b;
    double *plane, *all; /* [m_y][row]; [n_z][n_y][n_x] */
};

static void fill(void *data, int k, double *rhs) {
    const struct planes *planes = data;
    const int *n = planes->g->n;
    for (int j = 0; j < planes->g->m[1]; j++)
        memcpy(rhs + j * n[0], planes->b + ((k + planes->g->lo[2]) * n[1] + j + planes->g->lo[1]) * n[0],
               (size_t)n[0] * sizeof *rhs);
}

static double *place(void *data, int k) {
    (void)k;
    return ((const struct planes *)data)->plane;
}

static void use(void *data, int k) {
    const struct planes *planes = data;
    const struct fluid_grid *g = planes->g;
    const int *n = g->n;
    for (int j = 0; j < g->m[1] && k < g->m[2]; j++)
        for (int i = 0; i < n[0]; i++) {
            const int at[3] = {i, j + g->lo[1], k + g->lo[2]};
            planes->all[(at[2] * n[1] + at[1]) * n[0] + i] =
                is_unknown(n, planes->pair, at) ? planes->plane[j * planes->row + i] : 0;
        }
}

/* Largest residual of lap q - shift q = b over the terms that it is the difference of. */
static double residual(struct fluid_poisson *p, const struct fluid_poisson_input *in, const struct fluid_grid *g,
                       const int pair[3], int which, double shift) {
    const int *n = in->n, stride[3] = {1, n[0], n[0] * n[1]};
    const int count = n[0] * n[1] * n[2];
    double *b = malloc((size_t)count * sizeof *b), *all = calloc((size_t)count, sizeof *all);
    double *plane = calloc((size_t)(in->row * (g->m[1] + 1)), sizeof *plane);
    double worst = 0, largest = 0, norm = shift;
    for (int i = 0; i < count; i++) {
        const int at[3] = {i % n[0], i / n[0] % n[1], i / (n[0] * n[1])};
        b[i] = is_unknown(n, pair, at) ? random_at(i, pair[0], pair[1], pair[2]) : 0;
    }
    fluid_poisson_shift(p, which, shift);
    struct planes planes = {g, in->row, pair, b, plane, all};
    fluid_poisson_forward(p, fill, &planes);
    fluid_poisson_solve(p, 0);
    fluid_poisson_backward(p, &(struct fluid_poisson_target){place, use, &planes});
    par_sum_array(all, count);
    for (int c = 0; c < count; c++) {
        const int at[3] = {c % n[0], c / n[0] % n[1], c / (n[0] * n[1])};
        double sum = -shift * all[c];
        for (int d = 0; d < 3; d++) {
            const double *line = all + c - at[d] * stride[d];
            sum += (beyond(line, n[d], stride[d], at[d] - 1, in->end[d]) - 2 * all[c] +
                    beyond(line, n[d], stride[d], at[d] + 1, in->end[d])) /
                   (in->d[d] * in->d[d]);
        }
        if (is_unknown(n, pair, at)) worst = check_worst(worst, sum - b[c]);
        largest = fmax(largest, fabs(all[c]));
    }
    for (int d = 0; d < 3; d++) norm += 4 / (in->d[d] * in->d[d]);
    free(b);
    free(all);
    free(plane);
    return worst / (0.5 + norm * largest);
}

/* With shifts from a step far below the viscous limit to one a hundred thousand times above it, kept side by side. */
static void check(const int n[3], const int pair[3]) {
    const double length[3] = {1.0, 0.7, 1.3};
    struct fluid_grid *g = fluid_grid_new(n, length, (int[3]){pair[0] == PP, pair[1] == PP, pair[2] == PP}, 1, NULL);
    struct fluid_poisson_input in = {.row = g->row, .shifts = 3};
    for (int d = 0; d < 3; d++) {
        in.n[d] = n[d];
        in.d[d] = g->d[d];
        in.ranks[d] = g->ranks[d];
        in.cut[d] = g->cut[d];
        memcpy(in.end[d], ends[pair[d]], sizeof in.end[d]);
    }
    struct fluid_poisson *p = fluid_poisson_new(&in);
    const double per = 1 / (g->d[0] * g->d[0]);
    const double shift[5] = {per, 1e3 * per, 1e-2 * per, per, 1e-5 * per};
    for (int s = 0; s < 5; s++) {
        const double e = residual(p, &in, g, pair, s % 3, shift[s]);
        if (!(e < 4e-15)) fail_msg("pairs %d %d %d, shift %d: %g", pair[0], pair[1], pair[2], s, e);
    }
    fluid_poisson_free(p);
    fluid_grid_free(g);
}

static void every_pair(const int n[3]) {
    for (int c = 0; c < PAIRS * PAIRS * PAIRS; c++) check(n, (int[3]){c % PAIRS, c / PAIRS % PAIRS, c / PAIRS / PAIRS});
}

static void helmholtz_of_every_pair(void **state) {
    (void)state;
    every_pair((int[3]){5, 4, 6});
    for (int c = 0; c < PAIRS; c++) {
        if (par_size() <= 2) check((int[3]){2, 2, 2}, (int[3]){c, (c + 1) % PAIRS, (c + 5) % PAIRS});
        check((int[3]){32, 9, 33}, (int[3]){c, (c + 2) % PAIRS, c});
    }
}

static struct fluid_input box(int n, double length, double viscosity) {
    struct fluid_input in = {
        .n = {n, n, n}, .length = {length, length, length}, .density = 2, .viscosity = viscosity, .implicit = 1};
    for (int d = 0; d < 3; d++) all_sides(&in, d, FLUID_PERIODIC);
    return in;
}

/* Plane Poiseuille flow, nodally exact (tests/fluid/test_channel.c), in a few steps of any length. */
static void poiseuille(void **state) {
    (void)state;
    for (int stream = 0; stream < 3; stream++)
        for (int across = 0; across < 3; across++) {
            if (stream == across) continue;
            struct fluid_input in = box(4, 4, 0.5);
            in.n[across] = 9;
            in.length[across] = 1;
            all_sides(&in, across, FLUID_WALL);
            in.driving = (struct fluid_driving){FLUID_DRIVING_GRADIENT, stream, 3};
            struct fluid *f = fluid_new(&in);
            const struct fluid_grid *g = fluid_grid_of(f);
            for (int s = 0; s < 12; s++) fluid_step(f, 100);
            double worst = 0;
            for (int c = 0; c < 3; c++)
                for (int k = 0; k < g->m[2]; k++)
                    for (int j = 0; j < g->m[1]; j++)
                        for (int i = 0; i < g->m[0]; i++) {
                            const int at[3] = {i, j, k};
                            const double y = (at[across] + g->lo[across] + 0.5) / 9;
                            const double expected = c == stream ? 1.5 * (y * (1 - y) + 0.25 / 81) : 0;
                            worst = check_worst(worst, component(f, c)[fluid_grid_at(g, i, j, k)] - expected);
                        }
            check_below(par_max(worst), 1e-12);
            fluid_free(f);
        }
}

/* Taylor and Green's vortices in a plane of faces (slip sides) or periodic: the amplitude after a time, over the exact
 * decay of the semi-discrete equations. */
static double decay_error(enum fluid_side_type sides, int steps) {
    struct fluid_input in = box(12, 1, 0.02);
    all_sides(&in, 0, sides);
    all_sides(&in, 1, sides);
    in.n[2] = 4;
    in.vortices = (struct fluid_vortices){1, {1, 1, 0}};
    struct fluid *f = fluid_new(&in);
    const double h = 1.0 / 12, rate = 2 * in.viscosity * pow(2 / h * sin(M_PI * h), 2), t = 1;
    const double before = fluid_measures_kinetic_energy(f);
    for (int s = 0; s < steps; s++) fluid_step(f, t / steps);
    const double error = sqrt(fluid_measures_kinetic_energy(f) / before) / exp(-rate * t) - 1;
    check_below(fluid_measures_of(f).divergence_max, 1e-12);
    fluid_free(f);
    return fabs(error);
}

static void first_order_in_time(void **state) {
    (void)state;
    const enum fluid_side_type sides[2] = {FLUID_PERIODIC, FLUID_SLIP};
    for (int k = 0; k < 2; k++) {
        double e[3];
        for (int i = 0; i < 3; i++) e[i] = decay_error(sides[k], 40 << i);
        for (int i = 0; i < 2; i++) {
            const double order = log2(e[i] / e[i + 1]);
            if (!(order > 0.95 && order < 1.1)) fail_msg("order %g (errors %g %g)", order, e[i], e[i + 1]);
        }
    }
}

/* The flow that a scheme ends with, of a channel with a moving wall whose inflow is not developed. */
static struct fluid *settled(int implicit, int across) {
    struct fluid_input in = {.n = {8, 8, 8}, .length = {1, 1, 1}, .density = 2, .viscosity = 1};
    const int stream = (across + 1) % 3, side = (across + 2) % 3;
    all_sides(&in, side, FLUID_SLIP);
    all_sides(&in, across, FLUID_WALL);
    in.side[across][1].velocity[stream] = 0.5;
    in.side[stream][across == 1].type = FLUID_OUTFLOW;
    in.side[stream][across != 1] = (struct fluid_side){.type = FLUID_INFLOW, .bulk_velocity = 1};
    in.implicit = implicit;
    struct fluid *f = fluid_new(&in);
    const double dt = implicit ? 0.05 : 0.9 * fluid_limits_stable_step(f).viscous;
    for (double t = 0; t < 8; t += dt) fluid_step(f, dt);
    return f;
}

static void same_steady_flow_as_explicit(void **state) {
    (void)state;
    for (int across = 0; across < 3; across++) {
        struct fluid *f[2] = {settled(0, across), settled(1, across)};
        const struct fluid_grid *g = fluid_grid_of(f[0]);
        for (int c = 0; c < 4; c++) {
            double worst = 0, most = 0;
            for (int k = 0; k < g->m[2]; k++)
                for (int j = 0; j < g->m[1]; j++)
                    for (int i = 0; i < g->m[0]; i++) {
                        const size_t n = fluid_grid_at(g, i, j, k);
                        worst = check_worst(worst, component(f[0], c)[n] - component(f[1], c)[n]);
                        most = fmax(most, fabs(component(f[0], c)[n]));
                    }
            const double off = par_max(worst) / fmax(par_max(most), 1);
            if (!(off < 1e-9)) fail_msg("walls across %c, component %d: %g", "xyz"[across], c, off);
        }
        fluid_free(f[0]);
        fluid_free(f[1]);
    }
}

/* Noise in a box of walls, one of which moves, at nu dt/d^2 from 0.1 to 1e4: the energy falls to that of the flow
 * driven by the wall, and the momentum balance closes. */
static void no_step_is_too_large(void **state) {
    (void)state;
    for (int power = -1; power <= 4; power++) {
        struct fluid_input in = box(8, 1, 1);
        for (int d = 0; d < 3; d++) all_sides(&in, d, FLUID_WALL);
        in.side[2][1].velocity[0] = 0.01;
        struct fluid *f = fluid_new(&in);
        const struct fluid_grid *g = fluid_grid_of(f);
        for (int c = 0; c < 3; c++)
            for (int k = 0; k < g->m[2]; k++)
                for (int j = 0; j < g->m[1]; j++)
                    for (int i = 0; i < g->m[0]; i++)
                        component(f, c)[fluid_grid_at(g, i, j, k)] = 1e-3 * random_at(i, j + g->lo[1], k + g->lo[2], c);
        fluid_state_refresh(f);
        const double dt = pow(10, power) / 64;
        double before[3], after[3], force[3];
        for (int s = 0; s < 60; s++) {
            fluid_measures_momentum(f, before, NULL);
            fluid_box_force_begin(f);
            fluid_step(f, dt);
            fluid_box_force_end(f, force);
            fluid_measures_momentum(f, after, NULL);
            for (int c = 0; c < 3 && s > 0; c++) /* the first step corrects noise that is not divergence-free */
                check_close((after[c] - before[c]) / dt, force[c], 1e-12);
        }
        /* largest velocity a tenth of a cell's below the wall's: energy below that of half the box at the wall's
         * velocity */
        if (power >= 1) check_below(fluid_measures_kinetic_energy(f), 0.5 * 2 * 0.5 * 1e-4);
        check_below(fluid_measures_of(f).divergence_max, 1e-13);
        fluid_free(f);
    }
}

FLUID_TEST_MAIN(cmocka_unit_test(helmholtz_of_every_pair), cmocka_unit_test(poiseuille),
                cmocka_unit_test(first_order_in_time), cmocka_unit_test(same_steady_flow_as_explicit),
                cmocka_unit_test(no_step_is_too_large))
