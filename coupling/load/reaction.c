/* Load by reaction: what the forcing takes from the fluid is given to the solid, within the stage. */
/* In stage r of the fluid's step, of length g = gamma_r dt, the forcing with feedback (ibm/feedback.c) gives the fluid
 * at a marker of volume W the impulse rho W (g f + w e), with e the mean of V - U over the stage. In the solid's
 * substeps of the stage, T long together, the particle is under
 *
 *     m dV/dt = ... - rho W (f + w (V - U)/T) + V_h (rho I - rho b) ,
 *
 * so that a step takes the same impulse from the solid, f being the same in all its stages. The part with V is
 * implicit in the particle's own velocity (solid/force/drag.c). So momentum is kept to round-off, marker by marker, and
 * the work that is done on the solid is taken from the fluid but for the slip's loss. In the linear model without the
 * inner fluid no step creates energy for w J S <= 1, whatever the densities and the stiffness are. (compare Tschisgale
 * et al. 2017)
 *
 * The forcing also drives the fluid inside the body, which is not there. Its inertia rho dU/dt is given back with an
 * acceleration I that follows from the fluid's velocity at each particle at the beginning of the stages up to this one;
 * and so is the body force b on it. What comes late feeds waves. It is given to all particles evenly, not to the faces
 * on which the inner pressure acts: the sum is right, the strain of a body that is accelerated is not quite. A driving
 * gradient acts on the body as on the fluid, as with the probes: what of it acts on the inner fluid is the body's. */
#include "coupling/load/reaction.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/vec.h"
#include "coupling/interface/leak.h"
#include "coupling/interface/place.h"
#include "coupling/run.h"
#include "fluid/scheme.h"
#include "ibm/feedback.h"
#include "solid/force/drag.h"
#include "solid/imposed/external_loads.h"
#include "solid/imposed/reactions.h"
#include "solid/step/integrate.h"

#include <math.h>
#include <string.h>

/* The slip time over the times in which momentum diffuses over a cell, the flow crosses one, and a wave of the solid
 * crosses one. A longer slip time lets more fluid through the wall and damps the solid's motion; with a shorter one the
 * part of the force that the markers cannot see fades more slowly, in dt^2 over the slip time. */
static const double SLIP_OF_DIFFUSION = 4e-3, SLIP_OF_CONVECTION = 0.02, SLIP_OF_WAVE = 0.02;

enum { STAGES = 3 }; /* of the fluid's step at most */

struct reaction {
    struct ibm *inner; /* all particles, to read the fluid within the body */
    struct solid_drag drag;
    int capacity;
    int *h;                    /* [markers] */
    double *rate;              /* [markers] z, 1/s */
    double (*u)[3];            /* [markers] U, m/s */
    double (*v_begin)[3];      /* [markers] work of the drag */
    double (*slip)[3];         /* [markers] integral of V - U, m */
    double (*marker_force)[3]; /* [markers] reaction to the marker force f, on the solid in this step, N/m3 */
    double (*drag_force)[3];   /* [markers] mean force of the drag on the solid in the step, N/m3 */
    double (*inner_u)[3];      /* [n] velocity of the inner fluid, m/s */
    uint8_t *is_inside;        /* [n] the particle stands in the fluid's domain and carries fluid along */
    double *back[3];           /* [n] what the inner fluid gives back, N/m3 */
    double power;              /* of that on this rank's particles, mean over the last step, W */
};

/* Of the forcing with feedback, s. It does not depend on the step. */
static double slip_time(struct run *r) {
    const struct fluid_input *in = fluid_input_of(r->fluid);
    const struct solid_input *solid = &r->solid->in;
    const double dx = fluid_grid_of(r->fluid)->d[0];
    double most =
        fmin(SLIP_OF_DIFFUSION * dx * dx / in->viscosity, SLIP_OF_CONVECTION * dx / fluid_limits_speed(r->fluid));
    most = fmin(most, leak_slip_time(r->medium, r->fluid, r->surface->immersed_area));
    for (int m = 0; m < solid->materials && r->needs.bonds; m++)
        most = fmin(most, SLIP_OF_WAVE * dx * sqrt(solid->material[m].density / solid->material[m].youngs_modulus));
    return most;
}

/* The most stages of the fluid's step while the solid moves. */
static int stages_of(const struct scene *scene) {
    int most = 1;
    for (int k = 0; k < scene->stages; k++)
        if (scene->stage[k].solid != SCENE_SOLID_RIGID && scene->stage[k].fluid_integrator == SCENE_FLUID_RK3)
            most = STAGES;
    return most;
}

static void begin(struct run *r) {
    struct reaction *k = r->reaction = memory_new(MEMORY_COUPLING, 1, sizeof *k);
    ibm_feedback_set(r->ibm, slip_time(r));
    if (!r->needs.bonds) return;
    const size_t n = (size_t)r->solid->n + 1;
    k->inner = ibm_new(r->fluid, 0);
    k->inner_u = memory_new(MEMORY_COUPLING, n, sizeof *k->inner_u);
    k->is_inside = memory_new(MEMORY_COUPLING, n, 1);
    for (int c = 0; c < 3; c++) {
        k->back[c] = memory_new(MEMORY_COUPLING, n, sizeof(double));
        for (int stage = 0; stage < stages_of(r->scene); stage++) {
            r->inner[stage].velocity[c] = memory_new(MEMORY_COUPLING, n, sizeof(double));
            r->inner[stage].predicted[c] = memory_new(MEMORY_COUPLING, n, sizeof(double));
        }
    }
    for (int stage = 0; stage < STAGES; stage++) r->inner[stage].time = -1;
}

static void end(struct run *r) {
    struct reaction *k = r->reaction;
    ibm_free(k->inner);
    void *const owned[] = {
        k->h,         k->rate,    k->u,       k->v_begin, k->slip, k->marker_force, k->drag_force, k->inner_u,
        k->is_inside, k->back[0], k->back[1], k->back[2], k};
    for (size_t i = 0; i < sizeof owned / sizeof *owned; i++) memory_free(owned[i]);
    for (int c = 0; c < 3; c++)
        for (int stage = 0; stage < STAGES; stage++) {
            memory_free(r->inner[stage].velocity[c]);
            memory_free(r->inner[stage].predicted[c]);
        }
}

static void reserve(struct reaction *k, int n) {
    if (n <= k->capacity && k->h) return;
    const size_t room = (size_t)(k->capacity = n + n / 4 + 64);
    void *const old[] = {k->h, k->rate, k->u, k->v_begin, k->slip, k->marker_force, k->drag_force};
    for (size_t i = 0; i < sizeof old / sizeof *old; i++) memory_free(old[i]);
    k->h = memory_new(MEMORY_COUPLING, room, sizeof *k->h);
    k->rate = memory_new(MEMORY_COUPLING, room, sizeof *k->rate);
    k->u = memory_new(MEMORY_COUPLING, room, sizeof *k->u);
    k->v_begin = memory_new(MEMORY_COUPLING, room, sizeof *k->v_begin);
    k->slip = memory_new(MEMORY_COUPLING, room, sizeof *k->slip);
    k->marker_force = memory_new(MEMORY_COUPLING, room, sizeof *k->marker_force);
    k->drag_force = memory_new(MEMORY_COUPLING, room, sizeof *k->drag_force);
}

/* Sum of the weights w_r of the stages. */
static double sum_of_weights(const struct run *r) {
    double sum = 0;
    for (int stage = 0; stage < fluid_scheme_stages(r->fluid); stage++)
        sum += ibm_feedback_weight(r->ibm, stage, r->dt);
    return sum;
}

/* The substeps of each fluid stage, out of at least as many: in proportion to gamma_r, at least one each; the first
 * stage gets the rest. */
static void split(const struct fluid *f, int substeps, int of_stage[3]) {
    of_stage[0] = substeps;
    for (int stage = 1; stage < fluid_scheme_stages(f); stage++) {
        of_stage[stage] = (int)fmax(1, floor(fluid_scheme_gamma(f, stage) * substeps + 0.5));
        of_stage[0] -= of_stage[stage];
    }
}

/* The body force on the fluid, N/m3. */
static double body_force_of(const struct run *r, int c) {
    const struct fluid_input *in = fluid_input_of(r->fluid);
    return in->density * in->body_force[c];
}

static double dot(int n, const double *a, const double *b) {
    vec sum = vec_set(0);
    int i = 0;
    for (; i + VEC_LANES <= n; i += VEC_LANES) sum += vec_load(a + i) * vec_load(b + i);
    double rest = 0;
    for (; i < n; i++) rest += a[i] * b[i];
    return vec_sum(sum) + rest;
}

/* Fraction of what a stage gave too little a step ago that it gives now. Chosen by runs of walls
 * (cases/stability/stiffness, added_mass): 0.3 to 0.5 is stable. From 0.7 on waves of 5 to 10 steps a period grow, and
 * below 0.3 slow waves. */
static const double CORRECTED = 0.5;

/* Stores where the particles are at the beginning of a stage. */
static void store_positions(struct run *r) {
    const struct solid *s = r->solid;
    for (int c = 0; c < 3; c++) {
        double *restrict x = r->position[c];
        const double *restrict x0 = s->x0[c], *restrict d = s->d[c];
        for (int h = 0; h < s->n; h++) x[h] = x0[h] + d[h];
    }
    r->deposited = -1;
}

/* Reads the fluid within the body, where the particles were at the beginning of the step. */
static void read_inner(struct run *r, int stage) {
    struct reaction *k = r->reaction;
    const struct solid *s = r->solid;
    const struct fluid_state *state = fluid_state_of(r->fluid);
    double *const u[3] = {state->u, state->v, state->w};
    if (stage == 0)
        ibm_markers_set(k->inner, s->n, (const double *const *)r->position, (const double *const *)s->v, s->volume);
    ibm_whole_sample(k->inner, u, k->inner_u);
}

/* Marks the particles that stand in the fluid's domain. */
static void mark_inside(struct run *r) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    uint8_t *restrict is_inside = r->reaction->is_inside;
    memset(is_inside, 1, (size_t)r->solid->n);
    for (int c = 0; c < 3; c++) {
        const double *restrict x = r->position[c], length = g->length[c];
        for (int h = 0; h < r->solid->n && !g->periodic[c]; h++) is_inside[h] &= (x[h] >= 0) & (x[h] <= length);
    }
}

/* When a stage of the present step begins, s. */
static double start_of(const struct run *r, int stage) {
    double t = r->t;
    for (int q = 0; q < stage; q++) t += fluid_scheme_gamma(r->fluid, q) * r->dt;
    return t;
}

/* Sets the loads to what the inner fluid gives back in a stage, which takes the solid `length`: the impulse per mass
 *
 *     g a + CORRECTED (gamma (U - U_old) - g_old a_old) ,   a = (U - U_old)/(time between them) ,   g = gamma dt
 *
 * with U at the beginning of this stage, and U_old, g_old, a_old of the same stage a step ago: what the markers do to
 * the fluid differs from stage to stage of a step in which the body moves. Each stage's sum follows U as long as the
 * step stays the same. Single particles carry no fluid along. A stage that was not read a step ago gives nothing. Adds
 * to impulse. */
static void set_inner_inertia(struct run *r, int stage, double length, double impulse[3]) {
    struct reaction *k = r->reaction;
    struct solid *s = r->solid;
    struct run_inner *inner = &r->inner[stage];
    const struct solid_surface *f = r->surface;
    const double density = fluid_input_of(r->fluid)->density, now_at = start_of(r, stage),
                 passed = now_at - inner->time, gamma = fluid_scheme_gamma(r->fluid, stage);
    const int has_last = inner->time >= 0 && passed > 0;
    const double any = has_last ? 1 : 0, part = has_last ? gamma * r->dt / passed : 0;
    if (stage == 0) mark_inside(r);
    for (int c = 0; c < 3; c++) {
        const double(*restrict now)[3] = (const double(*)[3])k->inner_u;
        const uint8_t *restrict is_inside = k->is_inside;
        const double body_force = body_force_of(r, c);
        double *restrict u = inner->velocity[c], *restrict predicted = inner->predicted[c];
        double *restrict back = k->back[c], *restrict load = s->load[c];
#pragma omp simd
        for (int h = 0; h < s->n; h++) {
            const double gain = any * (now[h][c] - u[h]), coming = part * gain,
                         impulse_h = coming + CORRECTED * (gamma * gain - any * predicted[h]);
            u[h] = now[h][c];
            predicted[h] = coming;
            back[h] = is_inside[h] ? density / length * impulse_h - body_force : 0;
        }
        for (int i = 0; i < f->n && f->set_free > 0; i++)
            if (f->two_sided[i] == SOLID_SET_FREE) back[f->h[i]] = is_inside[f->h[i]] ? -body_force : 0;
        memcpy(load, back, (size_t)s->n * sizeof *load);
        for (int h = 0; h < s->n && s->external_loads; h++) load[h] += solid_external_loads_on(s, h, c);
        impulse[c] += length * dot(s->n, back, s->volume);
    }
    inner->time = now_at;
    for (int q = fluid_scheme_stages(r->fluid); q < STAGES; q++) r->inner[q].time = -1;
}

/* Takes U of the markers, and f before the first stage: sets the drag, and adds the marker force to the load. */
static void set_drag(struct run *r, int stage, double length) {
    struct reaction *k = r->reaction;
    struct solid *s = r->solid;
    const struct markers *m = &r->markers;
    const double density = fluid_input_of(r->fluid)->density;
    const double w = ibm_feedback_weight(r->ibm, stage, r->dt);
    const double(*f)[3] = ibm_feedback_force(r->ibm);
    ibm_feedback_velocity(r->ibm, k->u);
    for (int i = 0; i < m->n; i++) {
        const int h = r->surface->h[i];
        const double per_volume = ibm_feedback_is_in_domain(r->ibm, i) ? density * m->volume[i] / s->volume[h] : 0;
        k->h[i] = h;
        k->rate[i] = w * per_volume / (length * solid_density(s, h));
        for (int c = 0; c < 3; c++) {
            k->slip[i][c] = 0;
            if (stage == 0) k->marker_force[i][c] = -per_volume * f[i][c];
            s->load[c][h] += k->marker_force[i][c];
        }
    }
    k->drag = (struct solid_drag){m->n, k->h, k->rate, k->u, k->v_begin, k->slip};
}

/* Applies the mean slip of the substeps through the forcing; adds the load of the stage to sum, which is an impulse. */
static void apply_slip(struct run *r, int stage, double length, double impulse[3]) {
    struct reaction *k = r->reaction;
    const struct solid *s = r->solid;
    for (int i = 0; i < k->drag.n; i++) {
        const int h = k->h[i];
        const double mass = s->volume[h] * solid_density(s, h);
        for (int c = 0; c < 3; c++) {
            const double slipped = -mass * k->rate[i] * k->slip[i][c];
            impulse[c] += s->volume[h] * length * k->marker_force[i][c] + slipped;
            k->drag_force[i][c] = (stage == 0 ? 0 : k->drag_force[i][c]) + slipped / (s->volume[h] * r->dt);
            k->slip[i][c] *= (k->rate[i] > 0) / length;
        }
    }
    ibm_feedback_apply_slip(r->ibm, stage, r->dt, (const double(*)[3])k->slip);
}

/* The work of what the inner fluid gives back, from the positions at which it was read. */
static double work_of_inner(const struct run *r) {
    const struct solid *s = r->solid;
    double work = 0;
    for (int c = 0; c < 3; c++) {
        const double *x0 = s->x0[c], *d = s->d[c], *before = r->position[c], *back = r->reaction->back[c];
        const double *volume = s->volume;
        vec sum = vec_set(0);
        int h = 0;
        for (; h + VEC_LANES <= s->n; h += VEC_LANES)
            sum +=
                vec_load(volume + h) * vec_load(back + h) * (vec_load(x0 + h) + vec_load(d + h) - vec_load(before + h));
        for (; h < s->n; h++) work += volume[h] * back[h] * (x0[h] + d[h] - before[h]);
        work += vec_sum(sum);
    }
    return work;
}

double reaction_inner_power(const struct run *r) { return par_sum(r->reaction ? r->reaction->power : 0); }

/* A step of fluid and solid. The markers stand at X^n. */
static void step(struct run *r) {
    struct reaction *k = r->reaction;
    struct solid *s = r->solid;
    const double h = r->dt / r->substeps;
    double impulse[3] = {0}, work = 0;
    int substeps[3];
    reserve(k, r->markers.n);
    split(r->fluid, r->substeps, substeps);
    fluid_state_of(r->fluid)->t = s->t = r->t;
    s->drag = &k->drag;
    solid_reactions_begin(s);
    for (int stage = 0; stage < fluid_scheme_stages(r->fluid); stage++) {
        const double length = substeps[stage] * h;
        clock_begin(CLOCK_PROBE);
        store_positions(r);
        read_inner(r, stage);
        set_inner_inertia(r, stage, length, impulse);
        clock_end(CLOCK_PROBE);
        fluid_predict(r->fluid, stage, r->dt);
        ibm_feedback_begin(r->ibm, stage, r->dt);
        set_drag(r, stage, length);
        solid_integrate(s, h, substeps[stage]);
        work += work_of_inner(r);
        apply_slip(r, stage, length, impulse);
        fluid_project(r->fluid, stage, r->dt);
    }
    s->drag = NULL;
    for (int i = 0; i < k->drag.n; i++) /* the load of the step, for whoever looks at it after the step */
        for (int c = 0; c < 3; c++) s->load[c][k->h[i]] += k->drag_force[i][c];
    k->power = work / r->dt;
    for (int c = 0; c < 3; c++) r->load[c] = impulse[c] / r->dt;
    par_sum_array(r->load, 3);
    r->moved = r->step + 1;
}

/* The force on a solid at rest. The inner fluid is at rest with the body, but it is pushed. */
static void sample(struct run *r) {
    const struct solid *s = r->solid;
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    double volume = 0;
    r->reaction->power = 0;
    for (int h = 0; h < s->n; h++) volume += place_is_inside(g, s, h) ? s->volume[h] : 0;
    volume = par_sum(volume);
    ibm_forcing_total(r->ibm, r->load);
    for (int c = 0; c < 3; c++) r->load[c] = -r->load[c] - body_force_of(r, c) * volume;
}

const struct load_kind reaction_kind = {
    .keeps_force = 1, .begin = begin, .end = end, .step = step, .sample = sample, .forcing_times = sum_of_weights};
