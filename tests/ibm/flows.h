/* Two creeping flows with known answers: through a simple cubic array of spheres, and between planes. */
#pragma once
#include "tests/ibm/bodies.h"
#include "ibm/feedback.h"

struct flow_result {
    double drag;     /* force of the fluid on the markers along x, N, of the whole box */
    double velocity; /* superficial, m/s */
    double slip;     /* root mean square at the markers / velocity */
    long steps, markers;
    double seconds; /* of marching */
};

/* The forcing and its step. */
struct flow_forcing {
    int iterations;   /* N_s of the multidirect forcing */
    double fraction;  /* step over the viscous limit, 1.65 dx^2 / (12 nu), nu = 1 */
    double slip_time; /* of the forcing with feedback, over the same limit; 0: multidirect */
};

static inline double flow_limit(double dx) { return 1.65 * dx * dx / 12; }

static inline struct ibm *flow_ibm(struct fluid *f, const struct flow_forcing *forcing) {
    struct ibm *b = ibm_new(f, forcing->iterations);
    if (forcing->slip_time > 0) ibm_feedback_set(b, forcing->slip_time * flow_limit(fluid_grid_of(f)->d[0]));
    return b;
}

static inline struct fluid *flow_periodic_box(const int n[3], double dx, double velocity) {
    struct fluid_input in = {.density = 1, .viscosity = 1, .immersed = 1};
    for (int d = 0; d < 3; d++) in.n[d] = n[d], in.length[d] = n[d] * dx;
    in.driving = (struct fluid_driving){FLUID_DRIVING_BULK, 0, velocity};
    in.initial_velocity[0] = velocity;
    return fluid_new(&in); /* sides: FLUID_PERIODIC is 0 */
}

/* Marches until the drag changes by less than tolerance over each of two times of `interval`. */
static inline struct flow_result flow_march(struct fluid *f, const struct body *body,
                                            const struct flow_forcing *forcing, double interval, double tolerance) {
    const double dt = forcing->fraction * flow_limit(fluid_grid_of(f)->d[0]);
    const long every = (long)ceil(interval / dt);
    struct ibm *b = flow_ibm(f, forcing);
    struct flow_result result = {.markers = body->total, .velocity = fluid_input_of(f)->driving.value};
    double last = 0, force[3];
    int calm = 0;
    const double start = par_seconds();
    body_send(b, body);
    for (long step = 1; step < 200 * every; step++) {
        for (int r = 0; r < 3; r++) {
            fluid_predict(f, r, dt);
            ibm_forcing_stage(b, r, dt);
            fluid_project(f, r, dt);
        }
        result.steps = step;
        if (step % every) continue;
        ibm_forcing_total(b, force);
        result.drag = -force[0];
        calm = fabs(force[0] - last) < tolerance * fabs(force[0]) ? calm + 1 : 0;
        if (calm == 2) break;
        last = force[0];
    }
    result.seconds = par_seconds() - start;
    result.slip = ibm_forcing_slip(b) / result.velocity;
    ibm_free(b);
    return result;
}

/* Simple cubic arrays of spheres: drag factors K over Stokes' drag of one sphere.  (docs/sources.md) */
static inline double array_drag_factor(double solid_fraction) {
    static const double known[3][2] = {{0.125, 4.29159}, {0.2, 6.77592}, {0.343, 15.3995}};
    for (int n = 0; n < 3; n++)
        if (known[n][0] == solid_fraction) return known[n][1];
    return NAN;
}

/* (3 c / 4 pi)^(1/3) L */
static inline double array_radius(double solid_fraction) { return cbrt(3 * solid_fraction / (4 * M_PI)); }

/* k / L^2 = 1 / (6 pi a K) */
static inline double array_exact(double solid_fraction) {
    return 1 / (6 * M_PI * array_radius(solid_fraction) * array_drag_factor(solid_fraction));
}

struct array_case {
    int n;                        /* cells across the box, L = 1 */
    double solid_fraction;        /* c: 0.125, 0.2 or 0.343 */
    int even;                     /* evenly spread markers instead of a lattice's outer layer */
    enum body_depth depth;        /* of the outer layer */
    double retraction;            /* r_d, cells */
    double sphere[3], lattice[3]; /* centre of the sphere, and the lattice's site, relative to a cell's centre, cells */
    struct flow_forcing forcing;
};

static inline struct body array_body(const struct array_case *c) {
    const double dx = 1.0 / c->n, radius = array_radius(c->solid_fraction);
    double centre[3], lattice[3];
    for (int d = 0; d < 3; d++) {
        centre[d] = (c->n / 2 + 0.5 + c->sphere[d]) * dx;
        lattice[d] = (0.5 + c->lattice[d]) * dx;
    }
    if (c->even) return body_sphere_even(centre, radius, dx, c->retraction * dx);
    return body_sphere_cut(centre, radius, dx, lattice, c->depth, c->retraction * dx);
}

/* The error of k / L^2. */
static inline double array_error(const struct array_case *c, struct flow_result *result) {
    const int n[3] = {c->n, c->n, c->n};
    struct fluid *f = flow_periodic_box(n, 1.0 / c->n, 1e-3);
    struct body body = array_body(c);
    *result = flow_march(f, &body, &c->forcing, 0.004, 2e-4);
    body_free(&body);
    fluid_free(f);
    return result->velocity / result->drag / array_exact(c->solid_fraction) - 1;
}

/* Two sheets of markers `height` cells apart in a periodic box twice as high, driven along x: fluid on both sides.
 * Returns the distance e of the effective wall from the markers, in cells: mean velocity = G (H - 2 e)^3 / (12 mu H).
 * area: A_h / dx^2 of a marker. */
static inline double sheets_shift(int height, double offset, double area, const struct flow_forcing *forcing,
                                  struct flow_result *result) {
    const int n[3] = {4, 2 * height, 4};
    const double dx = 1.0 / height, up[3] = {0, 1, 0};
    struct fluid *f = flow_periodic_box(n, dx, 1e-3);
    struct body body = body_new(32);
    for (int sheet = 0; sheet < 2; sheet++)
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < 4; i++) {
                const double y = (sheet ? 1.5 : 0.5) * height + offset;
                body_add(&body, (double[3]){(i + 0.5) * dx, y * dx, (k + 0.5) * dx}, up);
            }
    body_finish(&body, 32 * area * dx * dx, dx);
    *result = flow_march(f, &body, forcing, 0.01, 1e-6);
    body_free(&body);
    fluid_free(f);
    const double gradient = result->drag / (n[0] * dx * n[1] * dx * n[2] * dx);
    return 0.5 * (1 - cbrt(12 * result->velocity / gradient)) * height;
}

/* Mean of u over the cells of height j. Collective. */
static inline double walls_mean(struct fluid *f, int j) {
    const struct fluid_grid *g = fluid_grid_of(f);
    double sum = 0;
    for (int k = 0; k < g->m[2]; k++)
        for (int i = 0; i < g->m[0]; i++)
            if (j >= g->lo[1] && j < g->lo[1] + g->m[1])
                sum += fluid_state_of(f)->u[fluid_grid_at(g, i, j - g->lo[1], k)];
    return par_sum(sum) / (g->n[0] * g->n[2]);
}

/* Two thick walls, each a pair of sheets with fluid at rest (in the wall's frame) behind them; one moves along x.
 * Returns e of the wall at rest, cells: where the line through the shear flow between them reaches zero. */
static inline double walls_shift(double offset, double area, const struct flow_forcing *forcing) {
    enum { GAP = 12, WALL = 6, HEIGHT = 2 * (GAP + WALL) };
    static const int low[4] = {WALL / 2, WALL / 2 + GAP, WALL / 2 + GAP + WALL, HEIGHT - WALL / 2};
    struct fluid_input in = {.n = {4, HEIGHT, 4}, .density = 1, .viscosity = 1, .immersed = 1};
    for (int d = 0; d < 3; d++) in.length[d] = in.n[d];
    struct fluid *f = fluid_new(&in);
    const struct fluid_grid *g = fluid_grid_of(f);
    struct ibm *b = flow_ibm(f, forcing);
    struct body body = body_new(64);
    const double up[3] = {0, 1, 0}, speed = 1e-3, dt = forcing->fraction * flow_limit(1);
    for (int sheet = 0; sheet < 4; sheet++)
        for (int k = 0; k < 4; k++)
            for (int i = 0; i < 4; i++) body_add(&body, (double[3]){i + 0.5, low[sheet] + offset, k + 0.5}, up);
    body_finish(&body, 64 * area, 1);
    for (int h = 0; h < body.n; h++) body.v[0][h] = body.x[1][h] > low[1] - 1 && body.x[1][h] < low[2] + 1 ? speed : 0;
    for (int k = 0; k < g->m[2]; k++) /* near the answer: the shear flow between sharp walls */
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) {
                const double y = j + g->lo[1] + 0.5 - offset;
                const double rise = fmin((y - low[0]) / GAP, (low[3] - y) / GAP);
                fluid_state_of(f)->u[fluid_grid_at(g, i, j, k)] = speed * fmax(0, fmin(1, rise));
            }
    fluid_state_refresh(f);
    body_send(b, &body);
    for (long step = 0; step < (long)(0.5 * GAP * GAP / dt); step++) {
        for (int r = 0; r < 3; r++) {
            fluid_predict(f, r, dt);
            ibm_forcing_stage(b, r, dt);
            fluid_project(f, r, dt);
        }
    }
    const int j0 = low[0] + 4, j1 = low[1] - 3;
    const double u0 = walls_mean(f, j0), u1 = walls_mean(f, j1);
    body_free(&body);
    ibm_free(b);
    fluid_free(f);
    return j0 + 0.5 - u0 * (j1 - j0) / (u1 - u0) - (low[0] + offset);
}

/* Inclined walls of cells of size 1: two slabs, normal across[], that move in opposite directions along way[] (a unit
 * vector at right angles). The box is a period of the slabs. Returns how far their faces are found too far inside. */
static inline double slabs_shift(const int across[3], int period, const double way[3], double offset,
                                 enum body_depth depth, double retraction, const struct flow_forcing *forcing) {
    struct fluid_input in = {.density = 1, .viscosity = 1, .immersed = 1};
    double length = 0, area = 1, speed = 1e-3, v[3];
    for (int c = 0; c < 3; c++) {
        in.n[c] = across[c] ? period / across[c] : 4;
        in.length[c] = in.n[c];
        area *= in.n[c];
        length += across[c] * across[c];
        v[c] = speed * way[c];
    }
    length = sqrt(length);
    struct body_shape slabs = {.across = {across[0], across[1], across[2]},
                               .period = period / length / 2,
                               .thickness = period / length / 4,
                               .offset = offset};
    const double gap = slabs.period - slabs.thickness, lattice[3] = {0.5, 0.5, 0.5};
    area /= period / length; /* of one plane */
    struct fluid *f = fluid_new(&in);
    const struct fluid_grid *g = fluid_grid_of(f);
    struct ibm *b = flow_ibm(f, forcing);
    struct body body = body_cut(&slabs, in.n, lattice, depth, retraction, 4 * area, v);
    struct fluid_state *state = fluid_state_of(f);
    double *const u[3] = {state->u, state->v, state->w};
    for (int k = 0; k < g->m[2]; k++) /* near the answer */
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++)
                for (int c = 0; c < 3; c++) {
                    const double x[3] = {g->lo[0] + i + (c == 0 ? 1 : 0.5), g->lo[1] + j + (c == 1 ? 1 : 0.5),
                                         g->lo[2] + k + (c == 2 ? 1 : 0.5)};
                    double normal[3], towards = 0;
                    int slab;
                    const double from = -body_shape_depth(&slabs, x, normal, &slab);
                    for (int d = 0; d < 3; d++) towards += normal[d] * across[d];
                    const double rise = from < 0 ? 0 : (towards > 0 ? from : gap - from) / gap;
                    u[c][fluid_grid_at(g, i, j, k)] = (slab ? -1 : 1) * (1 - 2 * rise) * v[c];
                }
    fluid_state_refresh(f);
    body_send(b, &body);
    const double dt = forcing->fraction * flow_limit(1);
    for (long step = 0; step < (long)(0.5 * gap * gap / dt); step++)
        for (int r = 0; r < 3; r++) {
            fluid_predict(f, r, dt);
            ibm_forcing_stage(b, r, dt);
            fluid_project(f, r, dt);
        }
    double *force[3], sum = 0;
    for (int c = 0; c < 3; c++) force[c] = calloc((size_t)body.n + 1, sizeof(double));
    ibm_forcing_by_marker(b, dt, force);
    for (int i = 0; i < body.n; i++) /* on the slab that moves forward, and against the one that moves back */
        for (int c = 0; c < 3; c++) sum += force[c][i] * body.v[c][i] / speed;
    sum = par_sum(sum);
    for (int c = 0; c < 3; c++) free(force[c]);
    body_free(&body);
    ibm_free(b);
    fluid_free(f);
    return (4 * area * 2 * speed / sum - gap) / 2;
}

/* Square array of cylinders across the flow, c = 0.2: the error of k/L^2 = 1/51.5269.  (docs/sources.md) */
static inline double cylinders_error(int n, const double centre[2], enum body_depth depth, double retraction,
                                     const struct flow_forcing *forcing, struct flow_result *result) {
    const int cells[3] = {n, n, 4};
    struct body_shape shape = {.round = {1, 1, 0}, .inside = 1, .radius = sqrt(0.2 / M_PI) * n};
    const double lattice[3] = {0.5, 0.5, 0.5};
    for (int c = 0; c < 2; c++) shape.centre[c] = n / 2 + 0.5 + centre[c];
    struct fluid *f = flow_periodic_box(cells, 1, 1e-3);
    struct body body = body_cut(&shape, cells, lattice, depth, retraction, 2 * M_PI * shape.radius * cells[2], NULL);
    *result = flow_march(f, &body, forcing, 0.004 * n * n, 2e-4);
    body_free(&body);
    fluid_free(f);
    return 51.5269 * result->velocity / (result->drag / cells[2]) - 1;
}

/* First zeros of the Bessel function J0 and of the spherical Bessel function j1. */
#define PIPE_ZERO 2.404825557695773
#define CAVITY_ZERO 4.493409457909064

/* Decay of the slowest flow inside a pipe (along it) or a spherical cavity (a rotation): u ~ exp(-q^2 t) with
 * q = zero/radius. Returns the error of the radius, cells of size 1, without that of the grid's second derivative,
 * q^2 (1 - q^2/16) or q^2 (1 - q^2/20) in the mean over directions. */
static inline double hollow_shift(int is_pipe, double radius, const double centre[3], enum body_depth depth,
                                  double retraction, const struct flow_forcing *forcing) {
    const int across = 2 * (int)(radius + 5), n[3] = {across, across, is_pipe ? 4 : across};
    const double lattice[3] = {0.5, 0.5, 0.5}, zero = is_pipe ? PIPE_ZERO : CAVITY_ZERO;
    struct body_shape shape = {.round = {1, 1, !is_pipe}, .inside = -1, .radius = radius};
    for (int c = 0; c < 3; c++) shape.centre[c] = across / 2 + centre[c];
    struct fluid_input in = {.density = 1, .viscosity = 1, .immersed = 1};
    for (int c = 0; c < 3; c++) in.n[c] = n[c], in.length[c] = n[c];
    struct fluid *f = fluid_new(&in);
    const struct fluid_grid *g = fluid_grid_of(f);
    struct ibm *b = flow_ibm(f, forcing);
    struct body body = body_cut(&shape, n, lattice, depth, retraction,
                                is_pipe ? 2 * M_PI * radius * n[2] : 4 * M_PI * radius * radius, NULL);
    double *const u[3] = {fluid_state_of(f)->u, fluid_state_of(f)->v, fluid_state_of(f)->w};
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++)
                for (int c = 0; c < 3; c++) {
                    const double x[3] = {g->lo[0] + i + (c == 0 ? 1 : 0.5) - shape.centre[0],
                                         g->lo[1] + j + (c == 1 ? 1 : 0.5) - shape.centre[1],
                                         is_pipe ? 0 : g->lo[2] + k + (c == 2 ? 1 : 0.5) - shape.centre[2]};
                    const double r = sqrt(body_square(x)), q = zero * r / radius;
                    const double turn = q > 1e-3 ? (sin(q) / q - cos(q)) / (q * q) : 1 / 3.0; /* j1(q) / q */
                    const double way = is_pipe ? c == 2 : (c == 0 ? -x[1] : c == 1 ? x[0] : 0);
                    u[c][fluid_grid_at(g, i, j, k)] = r < radius ? 1e-6 * way * (is_pipe ? j0(q) : turn) : 0;
                }
    fluid_state_refresh(f);
    body_send(b, &body);
    const double dt = forcing->fraction * flow_limit(1), life = radius * radius / (zero * zero);
    double energy[2] = {0, 0};
    const long first = (long)(0.5 * life / dt), last = (long)(1.5 * life / dt);
    for (long step = 0; step <= last; step++) {
        if (step == first || step == last) {
            double *sum = &energy[step == last];
            for (int k = 0; k < g->m[2]; k++)
                for (int j = 0; j < g->m[1]; j++)
                    for (int i = 0; i < g->m[0]; i++)
                        for (int c = 0; c < 3; c++) *sum += pow(u[c][fluid_grid_at(g, i, j, k)], 2);
            *sum = par_sum(*sum);
        }
        for (int r = 0; r < 3 && step < last; r++) {
            fluid_predict(f, r, dt);
            ibm_forcing_stage(b, r, dt);
            fluid_project(f, r, dt);
        }
    }
    body_free(&body);
    ibm_free(b);
    fluid_free(f);
    const double rate = 0.5 * log(energy[0] / energy[1]) / ((double)(last - first) * dt);
    const double q2 = rate * (1 + rate / (is_pipe ? 16 : 20));
    return zero / sqrt(q2) - radius;
}
