/* Struts that are switched off where the fluid outside is resolved in the crack. */
#include "cracks/resolved.h"
#include "base/par.h"
#include "cracks/aperture.h"
#include "cracks/solve.h"
#include "cracks/struts.h"

#include <math.h>

int cracks_resolved_is(const struct cracks *c, cracks_vec jump) {
    return cracks_kernel_sum(jump * jump) > c->gap * c->gap;
}

/* The lanes of an entry's struts that are to be off. jump [lanes]: of their ends, m, written. The rows' u holds the
 * displacements. */
static unsigned lanes_separated(const struct cracks *c, int first, const struct cracks_entry *e,
                                cracks_vec jump[CRACKS_LANES]) {
    double *const *const u = c->struts.rows.u;
    const unsigned lanes = e->lanes | e->off;
    unsigned separated = 0;
    for (int k = 0; k < CRACKS_LANES; k++) {
        if (!(lanes >> k & 1)) continue;
        jump[k] = (cracks_vec){0};
        for (int d = 0; d < 3; d++) jump[k][d] = u[d][e->at + k] - u[d][first + k];
        separated |= (unsigned)cracks_resolved_is(c, jump[k]) << k;
    }
    return separated;
}

/* Switches the struts of a row. Returns the lanes in which one has changed; leaves: the volume of those that were
 * switched off, less that of those switched on, m3; on: the number of struts that are on, both by lane. */
static unsigned switch_struts(struct cracks *c, int row, double *leaves, double *on) {
    const struct cracks_rows *r = &c->struts.rows;
    unsigned changed = 0;
    for (int k = 0; k < CRACKS_LANES; k++) leaves[k] = on[k] = 0;
    for (long s = r->start[row]; s < r->end[row]; s++) {
        struct cracks_entry *e = &r->strut[s];
        cracks_vec jump[CRACKS_LANES];
        const unsigned separated = lanes_separated(c, r->first[row], e, jump),
                       together = (e->lanes | e->off) & ~separated, change = separated ^ e->off;
        for (int k = 0; k < CRACKS_LANES; k++) {
            on[k] += together >> k & 1;
            if (!(change >> k & 1)) continue;
            leaves[k] += (separated >> k & 1 ? 1 : -1) * cracks_kernel_sum(c->table.half[e->kind] * jump[k]);
        }
        e->lanes = (uint8_t)together;
        e->off = (uint8_t)separated;
        changed |= change;
    }
    return changed;
}

/* What leaves the volume of a particle is void in proportion; the rest is fluid. is_on: a strut of it is on. Returns
 * the fluid, m3. */
static double move_volume(struct cracks *c, int i, double leaves, int is_on) {
    double fluid = c->content[i], empty = c->cavity[i];
    if (is_on) {
        empty = leaves > 0 && c->volume[i] > 0 ? fmin(empty, empty * leaves / c->volume[i]) : 0;
        fluid = leaves - empty;
    } else {
        leaves = c->volume[i];
        c->storage[i] = 0;
    }
    c->volume[i] -= leaves;
    c->cavity[i] -= empty;
    c->content[i] -= fluid;
    return fluid;
}

void cracks_resolved_update(struct cracks *c, int moves_volume) {
    struct cracks_struts *t = &c->struts;
    const struct cracks_rows *r = &t->rows;
    const cracks_vec *u = cracks_aperture_displacements(c);
    double *leaves = r->y[0], *on = r->y[1], *changed = r->y[2], sum[2] = {0, 0}; /* by slot; one number a row */
    for (int i = 0; i < t->n + t->ghosts; i++)
        for (int k = 0; k < 3; k++) r->u[k][t->place[i]] = u[i][k];
    for (int row = 0; row < r->n; row++)
        changed[row] = switch_struts(c, row, leaves + CRACKS_LANES * row, on + CRACKS_LANES * row);
    cracks_struts_areas_begin(t);
    for (int row = 0; row < r->n; row++)
        if (changed[row] > 0) cracks_struts_areas(c, row);
    for (int i = 0; i < t->n; i++) {
        const int slot = t->slot[i], is_changed = (unsigned)changed[slot / CRACKS_LANES] >> slot % CRACKS_LANES & 1;
        sum[1] += is_changed;
        if (!moves_volume) continue;
        if (is_changed)
            sum[0] += move_volume(c, i, leaves[slot], on[slot] > 0);
        else if (on[slot] == 0)
            sum[0] += move_volume(c, i, 0, 0); /* what flowed through it */
    }
    par_sum_array(sum, 2);
    c->resolved += sum[0];
    if (sum[1] == 0) return;
    cracks_struts_update(t, sizeof *t->area_size, t->area_size);
    c->work->ones_hold = c->work->force_holds = 0;
}
