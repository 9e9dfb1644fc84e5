/* Outlets of cracks: where the fluid of cracks below the grid meets the resolved flow. */
/* A particle of the interface that has a strut is an outlet. The flow's pressure there is read by a probe from the
 * wall, extrapolated to it (ibm/probe.c), whatever the loads are; of a wall that is
 * wetted on both faces it is the mean of both. A particle without any intact bond has the pressure that is extrapolated
 * to its centre. Where no tip lies in the domain the crack is shut.
 *
 * A crack is as many outlets wide as it has layers of struts, six at m = 3. A change of the rate through all of them by
 * dQ in a step needs the pressure rho dQ/(dx dt), as the inertia of the fluid in one cell before them does; so the
 * conductance of one is dx dt/(6 rho). With dx dt/rho each, a flow from one side of a body to the other through a crack
 * that is a third of a spacing wide grows by itself. */
#include "coupling/interface/crack_outlets.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "cracks/resolved.h"
#include "cracks/outlet.h"
#include "cracks/project.h"
#include "solid/bonds/family.h"

#include <math.h>
#include <string.h>

/* Spacings: below it the mean bond of a particle gives no normal. */
static const double SHORT = 1e-3;

struct crack_outlets {
    struct ibm *ibm; /* its route for the probes of outlets */
    int capacity;
    int n, outlets;                 /* probes; particles */
    int *place;                     /* [n] of the outlet in h */
    int *owner;                     /* [n] index in the interface */
    double *root[3], *normal[3];    /* [n] on the wall, m; outward unit normal */
    double *root_v[3];              /* [n] m/s */
    double *traction[3], *pressure; /* [n] Pa */
    uint8_t *active;                /* [n] */
    int *h;                         /* [outlets] local index in the solid */
    double *flow, *conductance;     /* [outlets] mean pressure of the probes, Pa; m3/(s Pa) */
    int points, point_capacity;
    double (*point)[3], *rate; /* [points] where volume enters the flow, m; m3/s */
};

/* Room for one outlet more, with two probes. */
static void reserve(struct crack_outlets *m, int outlets) {
    if (m->n + 2 <= m->capacity) return;
    const size_t used = (size_t)m->n, capacity = 2 * (size_t)m->capacity + 64;
    double **const array[] = {&m->root[0],   &m->root[1],     &m->root[2],     &m->normal[0],   &m->normal[1],
                              &m->normal[2], &m->root_v[0],   &m->root_v[1],   &m->root_v[2],   &m->pressure,
                              &m->flow,      &m->conductance, &m->traction[0], &m->traction[1], &m->traction[2]};
    for (size_t a = 0; a < sizeof array / sizeof *array; a++)
        *array[a] = memory_grown(MEMORY_COUPLING, *array[a], used, capacity, sizeof **array[a]);
    m->place = memory_grown(MEMORY_COUPLING, m->place, used, capacity, sizeof *m->place);
    m->owner = memory_grown(MEMORY_COUPLING, m->owner, used, capacity, sizeof *m->owner);
    m->active = memory_grown(MEMORY_COUPLING, m->active, used, capacity, sizeof *m->active);
    m->h = memory_grown(MEMORY_COUPLING, m->h, (size_t)outlets, capacity, sizeof *m->h);
    m->capacity = (int)capacity;
}

struct crack_outlets *crack_outlets_new(struct run *r) {
    if (!r->cracks || !r->needs.immersed) return NULL;
    struct crack_outlets *m = memory_new(MEMORY_COUPLING, 1, sizeof *m);
    m->ibm = ibm_new(r->fluid, 0);
    reserve(m, 0); /* the arrays' addresses say what is to be read, on every rank */
    return m;
}

void crack_outlets_free(struct crack_outlets *m) {
    if (!m) return;
    MEMORY_FREE(m->place, m->owner, m->root[0], m->root[1], m->root[2], m->normal[0], m->normal[1], m->normal[2],
                m->root_v[0], m->root_v[1], m->root_v[2], m->pressure, m->active, m->traction[0], m->traction[1],
                m->traction[2], m->h, m->flow, m->conductance, m->point, m->rate);
    ibm_free(m->ibm);
    memory_free(m);
}

long crack_outlets_count(const struct run *r) {
    long count = 0;
    for (int i = 0; i < r->surface->n; i++) count += cracks_outlet_is_wet(r->cracks, r->surface->h[i]);
    return par_sum_long(count);
}

/* The normal of the face that the flow wets, without those of a crack that struts fill: from the bonds that are intact
 * and those that are struts (001: eq. 3.46). The interface's normal leans into the crack there, and the flow's pressure
 * would open it once more. n is left as it is where nothing balances. */
static void find_face_normal(const struct run *r, int h, double n[3]) {
    const struct solid *s = r->solid;
    struct solid_family_view view;
    double sum[3] = {0, 0, 0}, weight = 0;
    solid_family_view(s, h, &view);
    for (int b = 0; b < view.n; b++) {
        double jump[3];
        for (int c = 0; c < 3; c++) jump[c] = s->d[c][view.l[b]] - s->d[c][h];
        if (!view.intact[b] && cracks_resolved_is(r->cracks, (cracks_vec){jump[0], jump[1], jump[2], 0})) continue;
        for (int c = 0; c < 3; c++) sum[c] -= view.weight[b] * (view.xi[b][c] + jump[c]);
        weight += view.weight[b];
    }
    const double length = sqrt(sum[0] * sum[0] + sum[1] * sum[1] + sum[2] * sum[2]);
    if (!(length > SHORT * s->in.spacing * weight)) return;
    for (int c = 0; c < 3; c++) n[c] = sum[c] / length;
}

void crack_outlets_find(struct run *r) {
    struct crack_outlets *m = r->crack_outlets;
    const struct solid *s = r->solid;
    const struct solid_surface *f = r->surface;
    int outlets = 0;
    m->n = 0;
    for (int i = 0; i < f->n; i++) {
        const int h = f->h[i], faces = f->two_sided[i];
        if (!cracks_outlet_is_wet(r->cracks, h)) continue;
        reserve(m, outlets);
        double x[3], n[3] = {f->normal[0][i], f->normal[1][i], f->normal[2][i]};
        solid_position(s, h, x);
        if (faces == SOLID_ONE_FACE && s->in.depth != SOLID_DEPTH_SHAPE) find_face_normal(r, h, n);
        for (int side = 1; side >= (faces == SOLID_TWO_FACES ? -1 : 1); side -= 2) {
            const int q = m->n++;
            m->place[q] = outlets;
            m->owner[q] = i;
            for (int c = 0; c < 3; c++) {
                m->normal[c][q] = side * n[c];
                m->root[c][q] = x[c] + (faces == SOLID_ISOLATED ? 0 : side * f->depth[i] * n[c]);
                m->root_v[c][q] = s->v[c][h];
            }
        }
        m->h[outlets++] = h;
    }
    m->outlets = outlets;
}

/* Both lists of probes have the order of the interface. A particle without bonds has no probe of the load. */
void crack_outlets_correct_tractions(struct run *r) {
    const struct crack_outlets *m = r->crack_outlets;
    struct wall_probes *to = &r->probes;
    for (int q = 0, p = 0; q < m->n; q++, p++) {
        while (q < m->n && r->surface->two_sided[m->owner[q]] == SOLID_ISOLATED) q++;
        if (q == m->n) return;
        while (p < to->n && to->owner[p] < m->owner[q]) p++;
        ENSURE(p < to->n && to->owner[p] == m->owner[q], "an outlet without a probe of the load");
        for (int c = 0; c < 3; c++) to->traction[c][p] += to->pressure[p] * (to->normal[c][p] - m->normal[c][q]);
    }
}

static void add_point(struct crack_outlets *m, const double x[3], double rate) {
    if (m->points == m->point_capacity) {
        const size_t used = (size_t)m->points, capacity = 2 * used + 64;
        m->point = memory_grown(MEMORY_COUPLING, m->point, used, capacity, sizeof *m->point);
        m->rate = memory_grown(MEMORY_COUPLING, m->rate, used, capacity, sizeof *m->rate);
        m->point_capacity = (int)capacity;
    }
    memcpy(m->point[m->points], x, sizeof m->point[0]);
    m->rate[m->points++] = rate;
}

/* The places before an outlet, one cell off the wall: x [2][3]. Returns how many can take volume. q: its first probe;
 * on return the first of the next outlet. */
static int source_points(const struct run *r, int outlet, int *q, double x[2][3]) {
    const struct crack_outlets *m = r->crack_outlets;
    const double dx = fluid_grid_of(r->fluid)->d[0];
    int places = 0;
    for (; *q < m->n && m->place[*q] == outlet; ++*q) {
        for (int c = 0; c < 3; c++) x[places][c] = m->root[c][*q] + dx * m->normal[c][*q];
        places += fluid_volume_source_holds(r->fluid, x[places]);
    }
    return places;
}

/* Inside, volume enters where it was taken up. What cannot leave before its outlet is taken off there, so that both
 * sums are the same. What remains, because a particle stands beside the domain and by rounding, is taken off the
 * outlets. */
void crack_outlets_set_sources(struct run *r) {
    struct crack_outlets *m = r->crack_outlets;
    const struct cracks *c = r->cracks;
    const struct cracks_outlets *outlets = c->outlets;
    double sum[3] = {0, 0, 0};     /* all rates; those of outlets, absolute; those of outlets */
    cracks_project_end(r->cracks); /* the state may have been restored */
    crack_outlets_find(r);
    m->points = 0;
    for (int k = 0, q = 0; k < m->outlets; k++) {
        double x[2][3];
        const int places = source_points(r, k, &q, x);
        const double rate = cracks_outlet_rate(outlets, m->h[k]);
        for (int p = 0; p < places && rate != 0; p++) add_point(m, x[p], -rate / places);
        if (places == 0) outlets->gain[m->h[k]] -= rate * r->dt;
    }
    const int before = m->points;
    for (int i = 0; i < c->struts.n; i++) {
        const int h = c->struts.h[i];
        double x[3];
        solid_position(r->solid, h, x);
        if (outlets->gain[h] != 0 && fluid_volume_source_holds(r->fluid, x)) add_point(m, x, outlets->gain[h] / r->dt);
    }
    for (int k = 0; k < m->points; k++) {
        sum[0] += m->rate[k];
        sum[1] += k < before ? fabs(m->rate[k]) : 0;
    }
    par_sum_array(sum, 2);
    for (int k = 0; k < before && sum[1] > 0; k++) {
        m->rate[k] -= sum[0] * fabs(m->rate[k]) / sum[1];
        sum[2] -= m->rate[k];
    }
    if (!(sum[1] > 0)) m->points = 0;
    r->cracks->handed += par_sum(sum[2]) * r->dt;
    fluid_volume_source_set(r->fluid, m->points, (const double(*)[3])m->point, m->rate);
}

/* The means over the active probes of each outlet. Returns how many outlets have one; those are the first in h. */
static int find_mean_pressures(struct crack_outlets *m, double conductance) {
    int kept = 0;
    for (int k = 0, q = 0; k < m->outlets; k++) {
        double sum = 0;
        int probes = 0;
        for (; q < m->n && m->place[q] == k; q++) {
            sum += m->active[q] ? m->pressure[q] : 0;
            probes += m->active[q];
        }
        if (probes == 0) continue;
        m->h[kept] = m->h[k];
        m->flow[kept] = sum / probes;
        m->conductance[kept++] = conductance;
    }
    return kept;
}

void crack_outlets_set_pressures(struct run *r) {
    struct crack_outlets *m = r->crack_outlets;
    const double dx = fluid_grid_of(r->fluid)->d[0];
    const struct ibm_probe_input in = {.n = m->n,
                                       .x = {m->root[0], m->root[1], m->root[2]},
                                       .normal = {m->normal[0], m->normal[1], m->normal[2]},
                                       .velocity = {m->root_v[0], m->root_v[1], m->root_v[2]},
                                       .is_carried = 1,
                                       .length = r->scene->coupling->probe_length};
    ibm_probe(m->ibm, &in, m->traction, m->pressure, m->active);
    const double layers = 2 * r->cracks->table.reach,
                 inertia = layers * fluid_input_of(r->fluid)->density / (dx * r->dt);
    const int n = find_mean_pressures(m, 1 / inertia);
    cracks_outlet_set(r->cracks, n, m->h, m->flow, m->conductance);
    cracks_project_load_again(r->cracks);
}

void crack_outlets_end_step(struct run *r) {
    cracks_outlet_end_step(r->cracks, r->dt);
    cracks_resolved_update(r->cracks, 1);
}
