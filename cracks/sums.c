/* Sums over struts and links, from and to arrays by wet particle. */
#include "cracks/sums.h"
#include "base/par.h"
#include "cracks/solve.h"
#include "cracks/struts.h"

static void spread(const struct cracks_struts *t, const double *p) {
    for (int i = 0; i < t->n + t->ghosts; i++) t->rows.x[t->place[i]] = p[i];
}

void cracks_sums_force(const struct cracks *c, const double *p, cracks_vec *force) {
    const struct cracks_struts *t = &c->struts;
    const struct cracks_rows *r = &t->rows;
    spread(t, p);
    cracks_kernel_force(r->n, r->first, r->start, r->end, r->strut, c->table.half, r->x, r->y);
    for (int i = 0; i < t->n; i++)
        force[i] = (cracks_vec){r->y[0][t->slot[i]], r->y[1][t->slot[i]], r->y[2][t->slot[i]], 0};
}

static void volume_of(const struct cracks *c, const long *end, const cracks_vec *u, double *volume) {
    const struct cracks_struts *t = &c->struts;
    const struct cracks_rows *r = &t->rows;
    for (int i = 0; i < t->n + t->ghosts; i++)
        for (int k = 0; k < 3; k++) r->u[k][t->place[i]] = u[i][k];
    cracks_kernel_volume(r->n, r->first, r->start, end, r->strut, c->table.half, r->u, r->y[0]);
    for (int i = 0; i < t->n; i++) volume[i] = r->y[0][t->slot[i]];
}

void cracks_sums_volume(const struct cracks *c, const cracks_vec *u, double *volume) {
    volume_of(c, c->struts.rows.end, u, volume);
}

void cracks_sums_volume_of_cracks(const struct cracks *c, const cracks_vec *u, double *volume) {
    volume_of(c, c->struts.rows.middle, u, volume);
}

void cracks_sums_flow(const struct cracks *c, double factor, const double *p, double *y) {
    const struct cracks_struts *t = &c->struts;
    const struct cracks_rows *r = &t->rows;
    spread(t, p);
    cracks_kernel_flow(r->n, r->first, r->link_start, r->link_start + 1, r->link, c->work->conductance, r->x, r->y[0]);
    for (int i = 0; i < t->n; i++) y[i] += factor * r->y[0][t->slot[i]];
}

/* Brings the ghosts' u, by place. */
static void exchange(const struct cracks *c) {
    const struct cracks_struts *t = &c->struts;
    const struct cracks_rows *r = &t->rows;
    cracks_vec *u = c->work->u;
    if (par_size() == 1) return;
    for (int k = 0; k < t->served; k++) {
        const int i = t->serve[k], at = t->place[i];
        u[i] = (cracks_vec){r->u[0][at], r->u[1][at], r->u[2][at], 0};
    }
    cracks_struts_update(t, sizeof *u, u);
    for (int i = t->n; i < t->n + t->ghosts; i++)
        for (int k = 0; k < 3; k++) r->u[k][t->place[i]] = u[i][k];
}

void cracks_sums_apply(const struct cracks *c, double dt, int flows, double *p, double *y) {
    const struct cracks_struts *t = &c->struts;
    const struct cracks_rows *r = &t->rows;
    cracks_struts_update(t, sizeof *p, p);
    spread(t, p);
    cracks_kernel_push(r->n, r->first, r->start, r->end, r->strut, c->table.half, dt * dt, t->rate, r->x, r->u);
    exchange(c);
    cracks_kernel_volume(r->n, r->first, r->start, r->end, r->strut, c->table.half, r->u, r->y[0]);
    if (!flows) {
        for (int i = 0; i < t->n; i++) y[i] = r->y[0][t->slot[i]];
        return;
    }
    cracks_kernel_flow(r->n, r->first, r->link_start, r->link_start + 1, r->link, c->work->conductance, r->x, r->y[1]);
    for (int i = 0; i < t->n; i++) y[i] = r->y[0][t->slot[i]] + dt * r->y[1][t->slot[i]];
}
