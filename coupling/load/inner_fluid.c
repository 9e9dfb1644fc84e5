/* The inertia of the fluid inside the body, which the load by reaction gives back to the solid. */
/* The forcing also drives the fluid inside the body, which does not exist in reality. Its inertia rho dU/dt is given
 * back with an acceleration I that follows from the fluid's velocity at each particle at the beginning of the stages up
 * to this one; and so is the body force b on it. If the impulse were delayed, it would add energy to the solid's waves.
 *
 * The inertia acts on the faces, through the pressure of the inner fluid. So most of it is given to the fluid itself
 * where this is deep in a body: the inner fluid then moves by itself, its pressure vanishes, and the faces feel the
 * fluid outside alone. Within the kernel's reach of the surface the forcing and the push would be mixed, so there the
 * particles get it, evenly. The sum is the same. (docs/theory.md)
 *
 * Along a periodic direction of a box without open sides a body force or a driving gradient accelerates the domain's
 * fluid as a whole, and no pressure belongs to that. This acceleration goes to the particles, and the fluid gets what
 * the inertia differs from it: what falls freely with its fluid feels no load.
 *
 * The body force is given to the particles everywhere. On a part of the inner fluid no pressure could balance it: it
 * would drive a circulation inside the body.
 *
 * A driving gradient acts on the body as on the fluid, as with the probes: what of it acts on the inner fluid is the
 * body's. */
#include "coupling/load/inner_fluid.h"
#include "base/memory.h"
#include "base/par.h"
#include "coupling/load/inner_lines.h"
#include "coupling/run.h"
#include "fluid/grid/side.h"
#include "fluid/scheme.h"
#include "solid/bonds/broken_tracker.h"
#include "solid/imposed/external_loads.h"
#include "solid/surface/deep.h"
#include "solid/surface/surface.h"

#include <math.h>
#include <string.h>

enum { STAGES = 3 }; /* of the fluid's step at most */

struct inner_fluid {
    struct ibm *ibm;      /* all particles, to read the fluid within the body */
    double (*u)[3];       /* [n] velocity of the inner fluid, m/s; then what it gets in a stage, m/s */
    uint8_t *is_inside;   /* [n] the particle stands in the fluid's domain */
    uint8_t *is_carrying; /* [n] and carries fluid along */
    double *back[3];      /* [n] what the inner fluid gives back, N/m3 */
    struct inner_fluid_exchange exchange;
    double mean_now[3]; /* velocity of the domain's fluid when the stage began, m/s */
    double mean[3];     /* force per volume by which the fluid is accelerated as a whole in the stage, N/m3 */
    double *to_fluid;   /* [n] the share of it that the fluid gets, 1 */
    uint16_t *least;    /* [n] bonds of a deep particle (solid/surface/deep.h) */
    int pushes;         /* 1: some fluid was pushed in the last step */
    int has_deep;       /* 1: some particles were deep at the start */
    float *line;        /* [n] part of the line through the particle that was deep then (inner_lines.h) */
};

/* Most of the share of the deep fluid's inertia that the fluid gets. With all of it a motion of the inner fluid that no
 * marker sees would have no inertia. */
static const double DEEP_SHARE = 0.99;

/* By nu dt/dx^2 the share is less. The prediction takes the friction of the inner fluid for inertia: a motion of wave
 * number k, of which the kernels give back the part G(k), is unstable beyond sigma G = 1 - 0.7 sqrt(nu dt) k. With
 * G = 1 - 0.3 (k dx)^2 that is sigma = 1 - 0.41 nu dt/dx^2 with RK3, and 0.45 with AB2 (docs/design/coupling.md). */
static const double BY_VISCOSITY = 0.6;

/* Where a body is compressed its particles stand closer, and give and read more: there the share is less, in proportion
 * to the volume (find_deep). */
static double deep_share(const struct run *r) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const double dx = fmin(g->d[0], fmin(g->d[1], g->d[2])),
                 viscous = fluid_input_of(r->fluid)->viscosity * r->dt / (dx * dx);
    return fmax(0, fmin(DEEP_SHARE, 1 - BY_VISCOSITY * viscous));
}

/* The most of the fluid on a line through the domain whose inertia may be predicted, by the share times the deep part
 * of the line. Beyond it a body that leaves little fluid before it is unstable: what the markers' force answers within
 * the step is then too small a part of the inertia. The recursion of a duct's fluid, the stages and a body at rest
 * gives 0.70 with RK3 and 0.60 with AB2 for ducts of ten cells, and more for longer ones; a heavy block with fluid
 * beside it grew at 0.68 with RK3 (docs/design/coupling.md). */
static double most_predicted(const struct run *r) { return fluid_scheme_stages(r->fluid) == 1 ? 0.55 : 0.62; }

int inner_fluid_is_deep(const struct inner_fluid *k, const struct run *r, int h) {
    return r->surface->tracker->intact[h] >= k->least[h];
}

/* Marks the deep particles at the start. Returns whether any rank has one. Collective. */
static int mark_deep(const struct inner_fluid *k, const struct run *r, uint8_t *is_deep) {
    double any = 0;
    for (int h = 0; h < r->solid->n; h++) {
        is_deep[h] = (uint8_t)inner_fluid_is_deep(k, r, h);
        any += is_deep[h];
    }
    return par_max(any) > 0;
}

/* The most stages of the fluid's step while the solid moves. */
static int stages_of(const struct scene *scene) {
    int most = 1;
    for (int k = 0; k < scene->stages; k++)
        if (scene->stage[k].solid != SCENE_SOLID_RIGID && scene->stage[k].fluid_integrator == FLUID_RK3) most = STAGES;
    return most;
}

/* Whether what drives the fluid along c accelerates it as a whole: no side holds it, and no fluid comes in or leaves.
 */
static int is_free_along(const struct run *r, int c) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const struct fluid_input *in = fluid_input_of(r->fluid);
    int is = g->periodic[c];
    for (int d = 0; d < 3; d++)
        for (int high = 0; high < 2; high++) is &= g->periodic[d] || fluid_side_flow(&in->side[d][high], d, high) == 0;
    return is;
}

/* Whether the mean acceleration of the domain's fluid is followed. */
static int follows_mean(const struct run *r) {
    const struct fluid_input *in = fluid_input_of(r->fluid);
    const int is_driven = in->driving.type != FLUID_DRIVING_NONE;
    int follows = 0;
    for (int c = 0; c < 3; c++)
        follows |= is_free_along(r, c) && (in->body_force[c] != 0 || (is_driven && fluid_driving_along(in, c) != 0));
    return follows;
}

struct inner_fluid *inner_fluid_new(struct run *r) {
    const size_t n = (size_t)r->solid->n + 1;
    struct inner_fluid *k = memory_new(MEMORY_COUPLING, 1, sizeof *k);
    k->ibm = ibm_new(r->fluid, 0);
    k->u = memory_new(MEMORY_COUPLING, n, sizeof *k->u);
    k->is_inside = memory_new(MEMORY_COUPLING, n, 1);
    k->is_carrying = memory_new(MEMORY_COUPLING, n, 1);
    k->to_fluid = memory_new(MEMORY_COUPLING, n, sizeof(double));
    k->least = memory_new(MEMORY_COUPLING, n, sizeof *k->least);
    solid_deep_least_bonds(r->solid, k->least);
    k->line = memory_new(MEMORY_COUPLING, n, sizeof *k->line);
    k->has_deep = mark_deep(k, r, k->is_inside);
    inner_lines_measure(r, k->is_inside, k->line);
    r->follows_inner_mean = follows_mean(r);
    for (int c = 0; c < 3; c++) {
        k->back[c] = memory_new(MEMORY_COUPLING, n, sizeof(double));
        for (int stage = 0; stage < stages_of(r->scene); stage++) {
            r->inner[stage].velocity[c] = memory_new(MEMORY_COUPLING, n, sizeof(double));
            r->inner[stage].excess[c] = memory_new(MEMORY_COUPLING, n, sizeof(double));
        }
    }
    for (int stage = 0; stage < STAGES; stage++) r->inner[stage].time = -1;
    return k;
}

void inner_fluid_free(struct inner_fluid *k, struct run *r) {
    if (!k) return;
    ibm_free(k->ibm);
    MEMORY_FREE(k->u, k->is_inside, k->is_carrying, k->to_fluid, k->least, k->line);
    for (int c = 0; c < 3; c++) {
        memory_free(k->back[c]);
        for (int stage = 0; stage < STAGES; stage++)
            MEMORY_FREE(r->inner[stage].velocity[c], r->inner[stage].excess[c]);
    }
    memory_free(k);
}

double inner_fluid_body_force(const struct run *r, int c) {
    const struct fluid_input *in = fluid_input_of(r->fluid);
    return in->density * in->body_force[c];
}

/* The share of the last step's shortfall that a stage adds in this step. Chosen by runs of walls
 * (cases/stability/stiffness, added_mass): 0.3 to 0.5 is stable. From 0.7 on waves of 5 to 10 steps a period grow,
 * and below 0.3 slow waves. */
static const double CORRECTED = 0.5;

/* The same for deep particles. What the fluid gets reaches the faces through the pressure, a stage later, so more is
 * added in advance. Chosen by runs of walls of 8 and 32 cells (cases/stability/added_mass): with RK3 slow waves grow
 * below 0.62, and from 0.75 on the inner fluid alone does; with AB2 these limits are 0.88 and 1.05. The upper limits
 * follow from the recursion for an inner fluid on which nothing else acts. */
static double corrected_deep(const struct run *r) { return fluid_scheme_stages(r->fluid) == 1 ? 0.95 : 0.7; }

void inner_fluid_sort_again(struct inner_fluid *k) { ibm_markers_sort_again(k->ibm); }

void inner_fluid_begin(struct run *r) {
    const struct solid *s = r->solid;
    for (int c = 0; c < 3; c++) {
        double *restrict x = r->position[c];
        const double *restrict x0 = s->x0[c], *restrict d = s->d[c];
        for (int h = 0; h < s->n; h++) x[h] = x0[h] + d[h];
    }
    r->deposited = -1;
}

/* The mean velocity of the domain's fluid; along c that of any plane across, as volume is conserved. Collective. */
static void read_mean(const struct run *r, double mean[3]) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const struct fluid_state *state = fluid_state_of(r->fluid);
    const double *const u[3] = {state->u, state->v, state->w};
    for (int c = 0; c < 3; c++) {
        const int end[3] = {c == 0 ? 1 : g->m[0], c == 1 ? 1 : g->m[1], c == 2 ? 1 : g->m[2]};
        mean[c] = 0;
        for (int z = 0; z < end[2] && g->lo[c] == 0; z++)
            for (int y = 0; y < end[1]; y++)
                for (int x = 0; x < end[0]; x++) mean[c] += u[c][fluid_grid_at(g, x, y, z)];
        mean[c] *= (double)g->n[c] / ((double)g->n[0] * g->n[1] * g->n[2]);
    }
    par_sum_array(mean, 3);
}

static void read_fluid(struct inner_fluid *k, const struct run *r) {
    const struct fluid_state *state = fluid_state_of(r->fluid);
    ibm_transfer_sample(k->ibm, (double *const[3]){state->u, state->v, state->w}, k->u);
}

void inner_fluid_read(struct inner_fluid *k, struct run *r, int stage) {
    const struct solid *s = r->solid;
    if (stage == 0)
        ibm_markers_set(k->ibm, s->n, (const double *const *)r->position, (const double *const *)s->v, s->volume);
    read_fluid(k, r);
    if (r->follows_inner_mean) read_mean(r, k->mean_now);
}

/* Without a push its work is 0, whatever was read. */
void inner_fluid_read_last(struct inner_fluid *k, struct run *r) {
    if (k->pushes) read_fluid(k, r);
}

/* Marks the particles that stand in the fluid's domain. */
static void mark_inside(struct inner_fluid *k, const struct run *r) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    uint8_t *restrict is_inside = k->is_inside;
    memset(is_inside, 1, (size_t)r->solid->n);
    for (int c = 0; c < 3; c++) {
        const double *restrict x = r->position[c], length = g->length[c];
        for (int h = 0; h < r->solid->n && !g->periodic[c]; h++) is_inside[h] &= (x[h] >= 0) & (x[h] <= length);
    }
}

/* Whether a projection ends each stage, so that what the fluid gets in one reaches the faces at its end. If not, thick
 * walls before short columns of fluid grow within 100 steps. */
static int reaches_faces(const struct run *r) {
    return fluid_scheme_stages(r->fluid) == 1 || fluid_input_of(r->fluid)->projection != FLUID_LAST_STAGE;
}

static void find_deep(struct inner_fluid *k, const struct run *r) {
    const double share = reaches_faces(r) ? deep_share(r) : 0, most = most_predicted(r);
    const float *restrict line = k->line;
    const uint16_t *restrict intact = r->surface->tracker->intact, *restrict least = k->least;
    double *restrict to_fluid = k->to_fluid;
    for (int h = 0; h < r->solid->n; h++) {
        const int is_deep = intact[h] >= least[h] && k->is_inside[h] && share > 0;
        const double limited = share * line[h] > most ? most / line[h] : share;
        to_fluid[h] = is_deep ? limited * fmax(0, fmin(1, solid_deep_volume_ratio(r->solid, h))) : 0;
    }
}

/* When a stage of the present step begins, s. */
static double start_of(const struct run *r, int stage) {
    double t = r->t;
    for (int q = 0; q < stage; q++) t += fluid_scheme_gamma(r->fluid, q) * r->dt;
    return t;
}

/* The stages that no step has read yet count from the fluid's velocity at the beginning of this step. */
static void begin_stages(struct run *r, double now_at) {
    const size_t bytes = (size_t)r->solid->n * sizeof(double);
    for (int q = 1; q < fluid_scheme_stages(r->fluid); q++) {
        struct run_inner *inner = &r->inner[q];
        if (inner->time >= 0) continue;
        inner->time = now_at;
        for (int c = 0; c < 3; c++) {
            memcpy(inner->velocity[c], r->inner[0].velocity[c], bytes);
            memset(inner->excess[c], 0, bytes);
        }
        r->inner_mean[q] = (struct run_inner_mean){.velocity = {0}};
        memcpy(r->inner_mean[q].velocity, r->inner_mean[0].velocity, sizeof r->inner_mean[q].velocity);
    }
    for (int q = fluid_scheme_stages(r->fluid); q < STAGES; q++) r->inner[q].time = -1;
}

/* Single particles carry no fluid along. */
static void mark_carrying(struct inner_fluid *k, const struct run *r) {
    const struct solid_surface *f = r->surface;
    memcpy(k->is_carrying, k->is_inside, (size_t)r->solid->n);
    for (int i = 0; i < f->n && f->isolated > 0; i++)
        if (f->two_sided[i] == SOLID_ISOLATED) k->is_carrying[f->h[i]] = 0;
}

/* Begins to count what is given in a step: so far nothing, less the body force, which the loads contain. */
static void begin_exchange(struct inner_fluid *k, const struct run *r) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const double *restrict volume = r->solid->volume;
    double inside = 0, force = 0;
    unsigned long carrying = 0;
    for (int c = 0; c < 3; c++) force += fabs(inner_fluid_body_force(r, c));
    for (int h = 0; h < r->solid->n && force > 0; h++) inside += k->is_inside[h] ? volume[h] : 0;
    for (int c = 0; c < 3; c++) {
        k->exchange.impulse[c] = r->dt * inside * inner_fluid_body_force(r, c);
        k->exchange.received[c] = 0;
    }
    const int may_differ = !(g->periodic[0] && g->periodic[1] && g->periodic[2]) || r->surface->isolated > 0;
    for (int h = 0; h < r->solid->n && may_differ; h++) carrying += k->is_carrying[h] * (unsigned long)(h + 1);
    k->exchange.carrying = carrying;
}

const struct inner_fluid_exchange *inner_fluid_last_exchange(const struct inner_fluid *k) { return &k->exchange; }

void inner_fluid_momentum(const struct inner_fluid *k, const struct run *r, double sum[4]) {
    const double density = fluid_input_of(r->fluid)->density, *restrict volume = r->solid->volume;
    const uint8_t *restrict is_carrying = k->is_carrying;
    memset(sum, 0, 4 * sizeof *sum);
    for (int stage = 0; stage < fluid_scheme_stages(r->fluid); stage++) {
        const double gamma = fluid_scheme_gamma(r->fluid, stage);
        for (int c = 0; c < 3; c++) {
            const double *restrict u = r->inner[stage].velocity[c], *restrict excess = r->inner[stage].excess[c];
            double part = 0, size = 0;
#pragma omp simd reduction(+ : part, size)
            for (int h = 0; h < r->solid->n; h++) {
                const double mass = is_carrying[h] ? density * volume[h] : 0;
                part += mass * (gamma * u[h] + excess[h]);
                size += mass * (fabs(gamma * u[h]) + fabs(excess[h]));
            }
            sum[c] += part;
            sum[3] += size;
        }
    }
}

enum { BLOCK = 512 }; /* particles of which the fluid's velocity stays in the cache for all components */

/* Of a stage and a component (inner_fluid_set_loads). */
struct source {
    double any, part, gamma, deep; /* 0: in the first step, else 1; g over the time between both velocities; gamma; C */
    double per_volume, body_force; /* density over the stage's length, kg/m3/s; N/m3 */
    double mean;                   /* as of struct inner_fluid */
};

/* The same impulse per mass as inner_fluid_set_loads has for the fluid of a particle deep in a body, for what the
 * source itself accelerates the domain's fluid, a body force or a driving gradient: of the gain of its mean velocity
 * the component along the source, from 0 to all that the source gives. The rest is due to bodies that push the fluid,
 * by its pressure. */
static void find_mean(struct inner_fluid *k, struct run *r, int stage, double passed, const struct source *g) {
    struct run_inner_mean *mean = &r->inner_mean[stage];
    double along = 0, square = 0;
    if (!r->follows_inner_mean) return;
    for (int c = 0; c < 3; c++) {
        const double source = is_free_along(r, c) ? fluid_source(r->fluid, c) : 0;
        along += source * (k->mean_now[c] - mean->velocity[c]);
        square += source * source * passed;
    }
    const double part = g->any > 0 && square > 0 ? fmax(0, fmin(1, along / square)) : 0;
    for (int c = 0; c < 3; c++) {
        const double gain = is_free_along(r, c) ? part * passed * fluid_source(r->fluid, c) : 0,
                     coming = g->part * gain;
        k->mean[c] = g->per_volume * (coming + g->deep * g->gamma * gain - g->any * mean->excess[c]);
        mean->excess[c] = coming - (1 - g->deep) * g->gamma * gain;
        mean->velocity[c] = k->mean_now[c];
    }
}

/* Sets back and load of the particles from .. to-1; returns the sum of load times volume, N. */
static double give_back(struct inner_fluid *k, const struct source *g, struct run_inner *inner, struct solid *s, int c,
                        int from, int to) {
    const double(*restrict now)[3] = (const double(*)[3])k->u;
    const uint8_t *restrict is_inside = k->is_inside, *restrict is_carrying = k->is_carrying;
    const double *restrict to_fluid = k->to_fluid, *restrict volume = s->volume;
    double *restrict u = inner->velocity[c], *restrict excess = inner->excess[c];
    double *restrict back = k->back[c], *restrict load = s->load[c];
    const struct source a = *g;
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int h = from; h < to; h++) {
        const double gain = a.any * (now[h][c] - u[h]), coming = a.part * gain,
                     ahead = to_fluid[h] > 0 ? a.deep : CORRECTED,
                     impulse = coming + ahead * a.gamma * gain - a.any * excess[h],
                     body_force = is_inside[h] ? a.body_force : 0,
                     all = (is_carrying[h] ? a.per_volume * impulse : 0) - body_force;
        u[h] = now[h][c];
        excess[h] = coming - (1 - ahead) * a.gamma * gain;
        back[h] = all;
        load[h] = (1 - to_fluid[h]) * all - to_fluid[h] * (a.body_force - a.mean);
        sum += load[h] * volume[h];
    }
    return sum;
}

/* Sets the loads to what the inner fluid gives back in a stage, which takes the solid `length`: the impulse per mass
 *
 *     g a + C gamma (U - U_old) - excess ,   a = (U - U_old)/(time between them) ,   g = gamma dt ,
 *     excess <- g a - (1 - C) gamma (U - U_old) ,
 *
 * with U at the beginning of this stage, and U_old of the same stage a step ago: what the markers do to the fluid
 * differs from stage to stage of a step in which the body moves. g a extrapolates the next change; what turns out to
 * be too much is subtracted in the next step (`excess`). So the sum over the steps is gamma (U - U_start), less what is
 * still to come, also after a sudden start and a change of the step. Adds to impulse. */
void inner_fluid_set_loads(struct inner_fluid *k, struct run *r, int stage, double length, double impulse[3]) {
    struct solid *s = r->solid;
    struct run_inner *inner = &r->inner[stage];
    const double density = fluid_input_of(r->fluid)->density, now_at = start_of(r, stage),
                 passed = now_at - inner->time, gamma = fluid_scheme_gamma(r->fluid, stage);
    const int has_last = inner->time >= 0 && passed > 0;
    if (stage == 0) {
        mark_inside(k, r);
        find_deep(k, r);
    }
    mark_carrying(k, r);
    if (stage == 0) begin_exchange(k, r);
    struct source source = {.any = has_last ? 1 : 0,
                            .part = has_last ? gamma * r->dt / passed : 0,
                            .gamma = gamma,
                            .deep = corrected_deep(r),
                            .per_volume = density / length};
    find_mean(k, r, stage, passed, &source);
    for (int from = 0; from < s->n; from += BLOCK)
        for (int c = 0; c < 3; c++) {
            source.body_force = inner_fluid_body_force(r, c);
            source.mean = k->mean[c];
            const int to = from + BLOCK < s->n ? from + BLOCK : s->n;
            const double force = give_back(k, &source, inner, s, c, from, to);
            impulse[c] += length * force;
            k->exchange.impulse[c] += length * force;
            k->exchange.received[c] += length * force;
        }
    for (int c = 0; c < 3 && s->external_loads; c++)
        for (int h = 0; h < s->n; h++) s->load[c][h] += solid_external_loads_on(s, h, c);
    inner->time = now_at;
    if (stage == 0) begin_stages(r, now_at);
}

void inner_fluid_push(struct inner_fluid *k, struct run *r, int stage, double length) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const double density = fluid_input_of(r->fluid)->density, mass = density * g->d[0] * g->d[1] * g->d[2];
    double sum[3], whole[3];
    k->pushes = k->has_deep && reaches_faces(r);
    if (!k->pushes) return;
    for (int c = 0; c < 3; c++) {
        const double body_force = inner_fluid_body_force(r, c);
        for (int h = 0; h < r->solid->n; h++)
            k->u[h][c] = k->to_fluid[h] * (k->back[c][h] + body_force - k->mean[c]) * length / density;
    }
    ibm_transfer_spread(k->ibm, stage, fluid_predicted(r->fluid), (const double(*)[3])k->u, sum, whole);
    for (int c = 0; c < 3; c++) {
        k->exchange.impulse[c] += mass * whole[c];
        k->exchange.received[c] += mass * sum[c];
    }
    ibm_inside_count(r->ibm, r->dt, sum);
}

void inner_fluid_couple(const struct inner_fluid *k, const struct run *r, double couple[3]) {
    couple[0] = couple[1] = couple[2] = 0;
    if (k->pushes) ibm_couple_forcing(k->ibm, r->dt, couple);
}

/* The push changes the fluid's energy by its product with the mean of the velocities before and after the stage
 * (ibm/feedback_work.c). */
double inner_fluid_work(const struct inner_fluid *k, const struct run *r, int stage, double length) {
    const struct solid *s = r->solid;
    const double(*restrict after)[3] = (const double(*)[3])k->u;
    const double *restrict to_fluid = k->to_fluid, *restrict volume = s->volume;
    double work = 0;
    for (int c = 0; c < 3; c++) {
        const double *restrict x0 = s->x0[c], *restrict d = s->d[c], *restrict from = r->position[c],
                               *restrict before = r->inner[stage].velocity[c], *restrict back = k->back[c];
        const double body_force = inner_fluid_body_force(r, c), mean = k->mean[c], half = k->pushes ? 0.5 * length : 0;
#pragma omp simd reduction(+ : work)
        for (int h = 0; h < s->n; h++) {
            const double all = back[h] + body_force, fluids = to_fluid[h] * (all - mean);
            work += volume[h] * ((all - fluids - body_force) * (x0[h] + d[h] - from[h]) +
                                 fluids * half * (before[h] + after[h][c]));
        }
    }
    return work;
}
