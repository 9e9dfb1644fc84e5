/* The pressures of a substep, and their load on the solid. */
#include "cracks/project.h"
#include "base/clock.h"
#include "base/par.h"
#include "cracks/resolved.h"
#include "cracks/aperture.h"
#include "cracks/coarse.h"
#include "cracks/inject.h"
#include "cracks/leak_off.h"
#include "cracks/outlet.h"
#include "cracks/pores.h"
#include "cracks/solve.h"
#include "cracks/struts.h"
#include "cracks/sums.h"
#include "solid/imposed/reactions.h"

#include <math.h>

/* Struts of the present bonds. What new ones add to the volume is void. */
void cracks_project_end(struct cracks *c) {
    if (!cracks_struts_changed(c)) return;
    cracks_struts_renew(c);
    c->work = cracks_solve_workspace(c->work, &c->struts);
    c->work->coarse = cracks_coarse_renew(c->work->coarse, c);
    cracks_inject_renew(c);
    if (c->restored) {
        if (c->in.outside) cracks_resolved_update(c, 0);
        c->restored = 0;
        return;
    }
    cracks_aperture_volume(c, c->work->b);
    for (int i = 0; i < c->struts.n; i++) {
        c->cavity[i] += c->work->b[i] - c->volume[i];
        c->volume[i] = c->work->b[i];
    }
}

/* force = B p of the pressures to begin with: those of the last substep, with what injections have set. */
static void force_begin(struct cracks *c) {
    const struct cracks_struts *t = &c->struts;
    struct cracks_work *w = c->work;
    if (w->force_holds) return;
    cracks_struts_update(t, sizeof *c->p, c->p);
    cracks_sums_force(c, c->p, w->force);
    w->force_holds = 1;
}

/* u = d + dt v- + dt^2 M^-1 force, with v- the velocity in the middle of the last substep and the other loads'
 * acceleration since:
 *     v- = v + dt/2 a - dt M^-1 share          a and v include the last share, of which v has taken half a step
 * So u is the displacement at the end of the substep if the pressures stay. */
static void predict(struct cracks *c, double dt) {
    const struct solid *s = c->solid;
    const struct cracks_struts *t = &c->struts;
    for (int i = 0; i < t->n; i++) {
        const int h = t->h[i];
        const cracks_vec pushed = dt * t->mobility[i] * (c->work->force[i] - s->volume[h] * c->share[i]);
        for (int k = 0; k < s->dim; k++)
            c->work->u[i][k] = s->d[k][h] + dt * ((s->v[k][h] + 0.5 * dt * s->a[k][h]) + pushed[k]);
        for (int k = s->dim; k < 4; k++) c->work->u[i][k] = 0;
    }
    cracks_struts_update(t, sizeof *c->work->u, c->work->u);
}

/* The residual of the pressures to begin with, content + dt (Q - L p) - S p - B^T u. Returns the sum of dt |Q|; size:
 * volume that rounding is compared to. */
static double residual_begin(struct cracks *c, double dt, double *size) {
    const struct cracks_struts *t = &c->struts;
    struct cracks_work *w = c->work;
    const double injected = cracks_inject_begin(c, c->solid->t, dt);
    force_begin(c);
    predict(c, dt);
    cracks_sums_volume(c, w->u, w->b);
    cracks_struts_update(t, sizeof *c->p, c->p);
    *size = 0;
    for (int i = 0; i < t->n; i++) {
        *size += fabs(w->b[i]) + fabs(c->content[i]);
        w->residual[i] = c->content[i] - w->b[i] - c->storage[i] * c->p[i];
    }
    cracks_inject_source(c, dt, w->residual);
    if (c->outlets) cracks_outlet_source(c, dt, w->residual);
    cracks_sums_flow(c, -dt, c->p, w->residual);
    if (c->leak) *size += cracks_leak_off_source(c, c->solid->t, dt, w->residual);
    *size = par_sum(*size);
    return injected;
}

/* The pressures' load in the solid: the new share instead of the last one. The supports of held particles take the
 * opposite. The change of v belongs to no work: the load's is that over whole substeps, so the balance has it as the
 * integrator's part. */
static void load(struct cracks *c, double dt) {
    struct solid *s = c->solid;
    const struct cracks_struts *t = &c->struts;
    for (int i = 0; i < t->n; i++) {
        const int h = t->h[i];
        const cracks_vec now = c->work->force[i] / s->volume[h], change = now - c->share[i];
        const cracks_vec a = s->volume[h] * t->mobility[i] * change;
        for (int k = 0; k < s->dim; k++) {
            s->load[k][h] = (s->load[k][h] - c->share[i][k]) + now[k];
            s->a[k][h] += a[k];
            const double dv = 0.5 * dt * a[k];
            s->e_integrator -= solid_density(s, h) * s->volume[h] * dv * (s->v[k][h] + 0.5 * dv);
            s->v[k][h] += dv;
            if (s->flag[h] & SOLID_HELD_X << k) s->power_constraint -= s->volume[h] * change[k] * s->v[k][h];
        }
        const cracks_vec force = s->volume[h] * change;
        solid_reactions_push(s, h, (const double[]){force[0], force[1], force[2]}, dt);
        c->share[i] = now;
    }
}

/* content += dt (Q - L p); volume and void at the end of the substep:  v + S p - void = content + residual. A void is
 * at least 0 but for the tolerance of the set. */
static void fill(struct cracks *c, double dt) {
    const struct cracks_struts *t = &c->struts;
    struct cracks_work *w = c->work;
    double *flow = w->along;
    for (int i = 0; i < t->n; i++) flow[i] = 0;
    cracks_struts_update(t, sizeof *c->p, c->p);
    cracks_sums_flow(c, dt, c->p, flow);
    cracks_inject_fill(c, dt, w->residual);
    if (c->outlets) cracks_outlet_fill(c, dt);
    if (c->leak) cracks_leak_off_add(c, c->solid->t + dt);
    for (int i = 0; i < t->n; i++) {
        c->content[i] -= flow[i];
        if (c->outlets) c->outlets->gain[t->h[i]] -= flow[i];
    }
    if (c->leak) cracks_leak_off_return(c, w->residual);
    for (int i = 0; i < t->n; i++) {
        const double left = w->set[i] == CRACKS_GIVEN ? 0 : w->residual[i];
        c->volume[i] = c->content[i] - c->storage[i] * c->p[i] - left;
        c->cavity[i] = w->set[i] == CRACKS_CAVITY ? -left : 0;
    }
}

/* Before the first substep in which the fluid flows: the pores are full at the present pressures and displacements, and
 * the cracks are empty. */
static void fill_pores(struct cracks *c) {
    double filled = 0;
    cracks_aperture_volume(c, c->volume);
    cracks_aperture_open(c);
    for (int i = 0; i < c->struts.n; i++) {
        const double pores = c->volume[i] - c->open[i];
        c->storage[i] = cracks_pores_storage(c, i);
        c->cavity[i] = c->open[i];
        c->content[i] = pores + c->storage[i] * c->p[i];
        filled += c->content[i];
    }
    c->filled = par_sum(filled);
}

void cracks_project_load_again(struct cracks *c) {
    for (int i = 0; i < c->struts.n; i++)
        for (int k = 0; k < c->solid->dim; k++) c->solid->load[k][c->struts.h[i]] += c->share[i][k];
}

/* Finds the pressures at the substep's end and what they push with. */
static void project(struct cracks *c, double dt) {
    cracks_project_end(c);
    if (c->status.failed) return;
    if (c->in.porous && !c->began) fill_pores(c);
    c->began = 1;
    if (c->open) cracks_aperture_open(c);
    cracks_aperture_conductance(c);
    if (c->outlets) cracks_aperture_bound(c, dt);
    const double *open = cracks_aperture_cracks(c);
    for (int i = 0; i < c->struts.n; i++) {
        c->storage[i] = c->in.compressibility * fmax(open[i] - c->cavity[i], 0);
        if (c->open) c->storage[i] += cracks_pores_storage(c, i);
        c->work->set[i] = c->p[i] > c->in.least_pressure ? CRACKS_FULL : CRACKS_CAVITY;
    }
    double size;
    if (c->outlets) cracks_outlet_begin(c, dt);
    const double injected = residual_begin(c, dt, &size);
    const int found = cracks_solve(c, dt, injected, size);
    if (c->outlets) cracks_outlet_end(c);
    if (!found) return;
    load(c, dt);
    fill(c, dt);
    c->steps++;
}

void cracks_project(struct solid *s, double dt, void *cracks) {
    (void)s;
    clock_begin(CLOCK_CRACKS);
    project(cracks, dt);
    clock_end(CLOCK_CRACKS);
}
