/* Normal probe on known fields: exact where it must be, observed order elsewhere. */
#include "base/par.h"
#include "tests/ibm/bodies.h"
#include "tests/check.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <string.h>
#include <cmocka.h>

static const double density = 2, viscosity = 0.15;

static struct fluid *walled_box(int n, double length, const double *body_force) {
    struct fluid_input in = {.density = density, .viscosity = viscosity, .immersed = 1};
    for (int d = 0; d < 3; d++) {
        in.n[d] = n, in.length[d] = length;
        in.side[d][0].type = in.side[d][1].type = FLUID_WALL;
        if (body_force) in.body_force[d] = body_force[d];
    }
    return fluid_new(&in);
}

/* A flow in its own frame, turned and moved: position and velocity along e[0], e[1], e[2] about the origin o. */
struct flow {
    double e[3][3], o[3];
    void (*velocity)(const double y[3], double u[3]);
    double (*pressure)(const double y[3]);
};

static void to_frame(const struct flow *f, const double x[3], double y[3]) {
    for (int a = 0; a < 3; a++) {
        y[a] = 0;
        for (int d = 0; d < 3; d++) y[a] += f->e[a][d] * (x[d] - f->o[d]);
    }
}

static void set_state(struct fluid *f, const struct flow *flow) {
    const struct fluid_grid *g = fluid_grid_of(f);
    struct fluid_state *s = fluid_state_of(f);
    double *const field[4] = {s->u, s->v, s->w, s->p};
    for (int c = 0; c < 4; c++)
        for (int k = 0; k < g->m[2]; k++)
            for (int j = 0; j < g->m[1]; j++)
                for (int i = 0; i < g->m[0]; i++) {
                    const int at[3] = {i, j, k};
                    double x[3], y[3], u[3], value = 0;
                    for (int d = 0; d < 3; d++) x[d] = (at[d] + g->lo[d] + (d == c ? 1.0 : 0.5)) * g->d[d];
                    to_frame(flow, x, y);
                    flow->velocity(y, u);
                    for (int a = 0; a < 3; a++)
                        if (c < 3) value += u[a] * flow->e[a][c];
                    field[c][fluid_grid_at(g, i, j, k)] = c < 3 ? value : flow->pressure(y);
                }
}

/* An orthonormal frame that depends on a number only. */
static void set_frame(double e[3][3], double angle) {
    const double a = angle, b = 1.3 * angle + 0.4, c = 0.7 * angle - 1;
    const double turn[3][3] = {
        {cos(a) * cos(b), sin(a) * cos(b), -sin(b)},
        {cos(a) * sin(b) * sin(c) - sin(a) * cos(c), sin(a) * sin(b) * sin(c) + cos(a) * cos(c), cos(b) * sin(c)},
        {cos(a) * sin(b) * cos(c) + sin(a) * sin(c), sin(a) * sin(b) * cos(c) - cos(a) * sin(c), cos(b) * cos(c)}};
    memcpy(e, turn, sizeof turn);
}

/* Probes of this rank: every size-th of n, so that most are served by other ranks. */
struct probes {
    int n;
    double *x[3], *normal[3], *acceleration, *wall[3], *traction[3], *pressure;
    uint8_t *active;
    int to_wall; /* stresses are extrapolated to the wall, which moves with wall[] */
};
static struct probes probes_new(int capacity) {
    struct probes p = {0};
    const size_t n = (size_t)capacity;
    for (int d = 0; d < 3; d++) {
        p.x[d] = calloc(n, sizeof(double));
        p.normal[d] = calloc(n, sizeof(double));
        p.wall[d] = calloc(n, sizeof(double));
        p.traction[d] = calloc(n, sizeof(double));
    }
    p.acceleration = calloc(n, sizeof(double));
    p.pressure = calloc(n, sizeof(double));
    p.active = calloc(n, 1);
    return p;
}
static void probes_free(struct probes *p) {
    for (int d = 0; d < 3; d++) {
        free(p->x[d]);
        free(p->normal[d]);
        free(p->wall[d]);
        free(p->traction[d]);
    }
    free(p->acceleration);
    free(p->pressure);
    free(p->active);
}
static void probes_run(struct ibm *b, struct probes *p) {
    struct ibm_probe_input in = {.n = p->n,
                                 .x = {p->x[0], p->x[1], p->x[2]},
                                 .normal = {p->normal[0], p->normal[1], p->normal[2]},
                                 .acceleration_n = p->acceleration,
                                 .length = 2};
    for (int d = 0; d < 3 && p->to_wall; d++) in.velocity[d] = p->wall[d];
    ibm_probe(b, &in, p->traction, p->pressure, p->active);
}

/* The wall moves as the flow does at the probe's root. */
static void set_wall(const struct flow *flow, struct probes *p, int h) {
    const double x[3] = {p->x[0][h], p->x[1][h], p->x[2][h]};
    double y[3], u[3];
    to_frame(flow, x, y);
    flow->velocity(y, u);
    for (int d = 0; d < 3; d++) {
        p->wall[d][h] = 0;
        for (int a = 0; a < 3; a++) p->wall[d][h] += u[a] * flow->e[a][d];
    }
}

static void linear_velocity(const double y[3], double u[3]) {
    u[0] = 0.3 + 1.1 * y[0] - 0.7 * y[1] + 0.2 * y[2];
    u[1] = -0.1 + 0.4 * y[0] + 0.5 * y[1] - 0.9 * y[2];
    u[2] = 0.2 + 0.8 * y[0] + 0.6 * y[1] - 1.6 * y[2];
}
static const double rate[3][3] = {{1.1, -0.7, 0.2}, {0.4, 0.5, -0.9}, {0.8, 0.6, -1.6}};
static const double slope[3] = {2.5, -1.5, 0.8};
static double linear_pressure(const double y[3]) { return 7 + slope[0] * y[0] + slope[1] * y[1] + slope[2] * y[2]; }

/* Velocity and pressure linear in space, acceleration of the root as that pressure requires: exact for any angle,
 * position and normal. */
static void exact_on_linear_fields(void **state) {
    (void)state;
    const int n = 18;
    struct fluid *f = walled_box(n, 1, NULL);
    struct ibm *b = ibm_new(f, 1);
    struct probes p = probes_new(100);
    const double dx = 1.0 / n, mu = density * viscosity;
    for (int angle = 0; angle < 10; angle++) { /* each in both forms */
        p.to_wall = angle % 2;
        struct flow flow = {.o = {0.47, 0.52, 0.55}, .velocity = linear_velocity, .pressure = linear_pressure};
        set_frame(flow.e, 0.9 * angle);
        set_state(f, &flow);
        double normal[100][3]; /* in the flow's frame */
        p.n = 0;
        for (int h = par_rank(); h < 60; h += par_size()) {
            double e[3][3];
            set_frame(e, 0.31 * h + angle);
            for (int a = 0; a < 3; a++) normal[p.n][a] = h < 6 ? (a == h / 2) * (h % 2 ? 1 : -1) : e[0][a];
            for (int d = 0; d < 3; d++) {
                p.normal[d][p.n] = 0;
                for (int a = 0; a < 3; a++) p.normal[d][p.n] += normal[p.n][a] * flow.e[a][d];
                p.x[d][p.n] = 0.5 + 3.7 * dx * sin(1.7 * h + 2.1 * d);
            }
            set_wall(&flow, &p, p.n);
            p.acceleration[p.n] = 0; /* dp/dn = -rho a.n */
            for (int a = 0; a < 3; a++) p.acceleration[p.n] -= slope[a] * normal[p.n][a] / density;
            p.n++;
        }
        probes_run(b, &p);
        for (int h = 0; h < p.n; h++) {
            const double x[3] = {p.x[0][h], p.x[1][h], p.x[2][h]};
            double y[3], stress[3], across = 0;
            to_frame(&flow, x, y);
            assert_true(p.active[h]);
            check_close(p.pressure[h], linear_pressure(y), 1e-12);
            for (int a = 0; a < 3; a++) {
                stress[a] = -linear_pressure(y) * normal[h][a];
                for (int c = 0; c < 3; c++) {
                    const double from_normal = p.to_wall ? 0 : rate[c][a]; /* of a wall that does not bend */
                    stress[a] += mu * (rate[a][c] + from_normal) * normal[h][c];
                    across += mu * rate[a][c] * normal[h][a] * normal[h][c];
                }
            }
            for (int a = 0; a < 3 && p.to_wall; a++) stress[a] -= across * normal[h][a]; /* no slip: there is none */
            for (int d = 0; d < 3; d++) {
                double t = 0;
                for (int a = 0; a < 3; a++) t += stress[a] * flow.e[a][d];
                check_close(p.traction[d][h], t, 1e-12);
            }
        }
    }
    probes_free(&p);
    ibm_free(b);
    fluid_free(f);
}

/* Viscous flow against a wall y1 = 0: no slip, continuity and Stokes' equation hold exactly. Traction on the wall:
 * tangential 2 mu y0, normal -p. */
static void stagnation_velocity(const double y[3], double u[3]) {
    u[0] = 2 * y[0] * y[1];
    u[1] = -y[1] * y[1];
    u[2] = 0;
}
static double stagnation_pressure(const double y[3]) { return 1 - 2 * density * viscosity * y[1]; }

static double stagnation_error(int n, int to_wall) {
    struct fluid *f = walled_box(n, 1, NULL);
    struct ibm *b = ibm_new(f, 1);
    struct probes p = probes_new(100);
    p.to_wall = to_wall;
    struct flow flow = {.o = {0.51, 0.46, 0.53}, .velocity = stagnation_velocity, .pressure = stagnation_pressure};
    set_frame(flow.e, 0.6);
    set_state(f, &flow);
    for (int h = par_rank(); h < 60; h += par_size()) {
        const double along = 0.2 * sin(2.3 * h), side = 0.2 * cos(1.1 * h);
        for (int d = 0; d < 3; d++) {
            p.normal[d][p.n] = flow.e[1][d];
            p.x[d][p.n] = flow.o[d] + along * flow.e[0][d] + side * flow.e[2][d];
        }
        p.acceleration[p.n++] = 0;
    }
    probes_run(b, &p);
    double worst = 0;
    for (int h = 0; h < p.n; h++) {
        const double x[3] = {p.x[0][h], p.x[1][h], p.x[2][h]};
        double y[3];
        to_frame(&flow, x, y);
        for (int d = 0; d < 3; d++) {
            const double exact = 2 * density * viscosity * y[0] * flow.e[0][d] - flow.e[1][d];
            worst = check_worst(worst, p.traction[d][h] - exact);
        }
    }
    probes_free(&p);
    ibm_free(b);
    fluid_free(f);
    return par_max(worst);
}

/* The stress is taken at the tip, 2 dx off the wall: first order. */
static void first_order_on_stagnation_flow(void **state) {
    (void)state;
    const double coarse = stagnation_error(24, 0), fine = stagnation_error(48, 0), order = log2(coarse / fine);
    if (!(order > 0.9 && order < 1.3)) fail_msg("errors %g, %g: order %g", coarse, fine, order);
    check_below(fine, 0.2 * density * viscosity);
}

/* Extrapolated to the wall by cubics. */
static void exact_on_stagnation_flow_at_the_wall(void **state) {
    (void)state;
    check_close(stagnation_error(24, 1), 0, 1e-11);
}

/* Stokes flow past a sphere at rest, of velocity 1 along y0 far away; p over mu. Continued inside to half the
 * radius. */
static const double sphere_radius = 0.25;
static double sphere_r(const double y[3]) {
    return fmax(sqrt(y[0] * y[0] + y[1] * y[1] + y[2] * y[2]), 0.5 * sphere_radius);
}
static void sphere_velocity(const double y[3], double u[3]) {
    const double a = sphere_radius, r = sphere_r(y), q = a / r, q3 = q * q * q;
    for (int d = 0; d < 3; d++) u[d] = -0.75 * (q - q3) * y[0] * y[d] / (r * r);
    u[0] += 1 - 0.75 * q - 0.25 * q3;
}
static double sphere_pressure(const double y[3]) {
    const double r = sphere_r(y);
    return -1.5 * density * viscosity * sphere_radius * y[0] / (r * r * r);
}

/* Force on the sphere from about one probe a cell, over 6 pi mu a, less 1; the box contains all points that the
 * sphere's probes read. */
static double sphere_error(int cells_a_diameter, int to_wall) {
    const int n = cells_a_diameter + 10;
    const double length = 2 * sphere_radius * n / cells_a_diameter, dx = length / n;
    struct fluid *f = walled_box(n, length, NULL);
    struct ibm *b = ibm_new(f, 1);
    struct flow flow = {.velocity = sphere_velocity, .pressure = sphere_pressure};
    for (int d = 0; d < 3; d++) flow.o[d] = 0.5 * length + 0.1 * (1 + d) * dx;
    set_frame(flow.e, 0.8);
    set_state(f, &flow);
    struct body body = body_sphere_even(flow.o, sphere_radius, dx, 0);
    struct probes p = probes_new(body.n + 1);
    p.n = body.n;
    p.to_wall = to_wall;
    for (int d = 0; d < 3; d++) {
        memcpy(p.x[d], body.x[d], (size_t)p.n * sizeof(double));
        memcpy(p.normal[d], body.normal[d], (size_t)p.n * sizeof(double));
    }
    probes_run(b, &p);
    double drag = 0;
    for (int h = 0; h < p.n; h++)
        for (int d = 0; d < 3; d++) drag += p.traction[d][h] * body.area[h] * flow.e[0][d];
    probes_free(&p);
    body_free(&body);
    ibm_free(b);
    fluid_free(f);
    return par_sum(drag) / (6 * M_PI * density * viscosity * sphere_radius) - 1;
}

/* The error of the paper's form is the probe's length over the radius; extrapolated to the wall, at most its square. */
static void stokes_drag(void **state) {
    (void)state;
    double tip[3], wall[3];
    for (int level = 0; level < 3; level++) {
        tip[level] = sphere_error(8 << level, 0);
        wall[level] = sphere_error(8 << level, 1);
    }
    const double order_tip = log2(tip[1] / tip[2]), order_wall = log2(wall[1] / wall[2]);
    if (!(order_tip > 0.5 && order_tip < 1.2 && order_wall > 2))
        fail_msg("tip %g, %g, %g: order %g; wall %g, %g, %g: order %g", tip[0], tip[1], tip[2], order_tip, wall[0],
                 wall[1], wall[2], order_wall);
    check_close(wall[1], 0, 0.03);
    check_close(wall[2], 0, 0.015);
}

static void rest(const double y[3], double u[3]) {
    (void)y;
    u[0] = u[1] = u[2] = 0;
}
static const double gravity = -9.81;
static double hydrostatic(const double y[3]) { return density * gravity * y[2]; } /* p = -rho |g| z */

/* Buoyancy in a fluid at rest under gravity: signs of p_m, of the body force at the root, and of the traction. Exact
 * for a box with roots on its faces; for a sphere cut from a lattice within its area's error. */
static void hydrostatics_lifts(void **state) {
    (void)state;
    const int n = 24;
    struct fluid *f = walled_box(n, 1, (double[3]){0, 0, gravity});
    struct ibm *b = ibm_new(f, 1);
    const struct flow flow = {.e = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .velocity = rest, .pressure = hydrostatic};
    const double dx = 1.0 / n;
    set_state(f, &flow);
    for (int form = 0; form < 4; form++) {
        const int shape = form % 2;
        const double centre[3] = {0.507, 0.491, 0.483}, lattice[3] = {dx / 2, dx / 2, dx / 2}, radius = 0.29;
        const int side[3] = {7, 8, 9};
        struct body body = body_new(1000);
        double volume = 4 * M_PI / 3 * pow(radius, 3);
        if (shape == 0) {
            double area = 0;
            for (int d = 0; d < 3; d++)
                for (int end = 0; end < 2; end++)
                    for (int j = 0; j < side[(d + 1) % 3]; j++)
                        for (int k = 0; k < side[(d + 2) % 3]; k++) {
                            double x[3], normal[3] = {0, 0, 0};
                            normal[d] = end ? 1 : -1;
                            x[d] = centre[d] + 0.5 * normal[d] * side[d] * dx;
                            x[(d + 1) % 3] = centre[(d + 1) % 3] + (j + 0.5 - 0.5 * side[(d + 1) % 3]) * dx;
                            x[(d + 2) % 3] = centre[(d + 2) % 3] + (k + 0.5 - 0.5 * side[(d + 2) % 3]) * dx;
                            body_add(&body, x, normal);
                            area += dx * dx;
                        }
            body_finish(&body, area, dx);
            volume = side[0] * side[1] * side[2] * dx * dx * dx;
        } else {
            body_free(&body);
            body = body_sphere_lattice(centre, radius, dx, lattice, 0.5 * dx);
        }
        struct probes p = probes_new(1000);
        p.n = body.n;
        p.to_wall = form / 2;
        double lift[3] = {0, 0, 0};
        for (int d = 0; d < 3; d++) {
            memcpy(p.x[d], body.x[d], (size_t)p.n * sizeof(double));
            memcpy(p.normal[d], body.normal[d], (size_t)p.n * sizeof(double));
        }
        probes_run(b, &p);
        for (int h = 0; h < p.n; h++)
            for (int d = 0; d < 3; d++) lift[d] += p.traction[d][h] * body.area[h];
        par_sum_array(lift, 3);
        const double weight = density * -gravity * volume;
        for (int d = 0; d < 3; d++) check_close(lift[d], d == 2 ? weight : 0, (shape == 0 ? 1e-12 : 0.03) * weight);
        probes_free(&p);
        body_free(&body);
    }
    ibm_free(b);
    fluid_free(f);
}

/* A pressure gradient that drives a periodic flow exerts G V on a body, whatever the solved pressure is. */
static void driving_gradient_pushes(void **state) {
    (void)state;
    struct fluid_input in = {.density = density, .viscosity = viscosity, .immersed = 1};
    for (int d = 0; d < 3; d++) in.n[d] = 20, in.length[d] = 1;
    in.driving = (struct fluid_driving){FLUID_DRIVING_GRADIENT, 0, 3.0};
    struct fluid *f = fluid_new(&in);
    struct ibm *b = ibm_new(f, 1);
    struct probes p = probes_new(2);
    /* both ends of a unit-area column from x = 0.3 to 1.2, over the periodic side; the fluid's own p = 0 */
    if (par_rank() == par_size() - 1)
        for (int end = 0; end < 2; end++) {
            p.x[0][end] = end ? 1.2 : 0.3, p.x[1][end] = 0.5, p.x[2][end] = 0.93;
            p.normal[0][end] = end ? 1 : -1;
            p.acceleration[end] = (end ? 1 : -1) * 3.0 / density; /* as the fluid at rest is about to move: dp/dn = 0 */
            p.n++;
        }
    probes_run(b, &p);
    double push = 0;
    for (int h = 0; h < p.n; h++) push += p.traction[0][h];
    check_close(par_sum(push), 3.0 * 0.9, 1e-13);
    probes_free(&p);
    ibm_free(b);
    fluid_free(f);
}

/* A tip beyond a wall has no result; one across a periodic side is measured there. */
static void tips_outside_are_inactive(void **state) {
    (void)state;
    struct fluid *f = walled_box(16, 1, NULL);
    struct ibm *b = ibm_new(f, 1);
    const struct flow flow = {
        .e = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, .velocity = linear_velocity, .pressure = linear_pressure};
    struct probes p = probes_new(2);
    set_state(f, &flow);
    p.n = 2;
    for (int h = 0; h < 2; h++) {
        for (int d = 0; d < 3; d++) p.x[d][h] = 0.5;
        p.x[1][h] = h ? 0.93 : 0.5;
        p.normal[1][h] = 1;
        p.traction[0][h] = p.pressure[h] = 9;
    }
    probes_run(b, &p);
    assert_true(p.active[0] && !p.active[1]);
    check_equal(p.traction[0][1], 0);
    check_equal(p.traction[1][1], 0);
    check_equal(p.traction[2][1], 0);
    check_equal(p.pressure[1], 0);
    assert_true(p.pressure[0] != 0);
    probes_free(&p);
    ibm_free(b);
    fluid_free(f);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest tests[] = {cmocka_unit_test(exact_on_linear_fields),
                                       cmocka_unit_test(first_order_on_stagnation_flow),
                                       cmocka_unit_test(exact_on_stagnation_flow_at_the_wall),
                                       cmocka_unit_test(stokes_drag),
                                       cmocka_unit_test(hydrostatics_lifts),
                                       cmocka_unit_test(driving_gradient_pushes),
                                       cmocka_unit_test(tips_outside_are_inactive)};
    const int failed = cmocka_run_group_tests(tests, NULL, NULL);
    par_end();
    return failed;
}
