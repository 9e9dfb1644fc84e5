/* Struts that are switched off where the fluid outside is resolved in the crack. */
#include "cracks/apart.h"
#include "base/par.h"
#include "cracks/aperture.h"
#include "cracks/off.h"
#include "cracks/solve.h"
#include "cracks/struts.h"

#include <math.h>

/* Switches the struts of a particle. Returns whether one has changed; leaves: the volume of those that were switched
 * off, less that of those switched on, m3; on: the number of struts that are on. */
static int switch_struts(struct cracks *c, const cracks_vec *u, int i, double *leaves, long *on) {
    struct cracks_struts *t = &c->struts;
    const int kinds = c->table.kinds;
    int changed = 0;
    *leaves = 0;
    *on = 0;
    for (long k = t->start[i]; k < t->start[i + 1]; k++) {
        const cracks_vec jump = u[t->other[k]] - u[i];
        const int was_off = t->kind[k] >= kinds, now_off = cracks_off_is(c, jump);
        const int kind = was_off ? t->kind[k] - kinds : t->kind[k];
        *on += !now_off;
        if (was_off == now_off) continue;
        *leaves += (now_off ? 1 : -1) * cracks_kernel_sum(c->table.half[kind] * jump);
        t->kind[k] = (uint16_t)(now_off ? kind + kinds : kind);
        changed = 1;
    }
    return changed;
}

/* What leaves the volume of a particle is void in proportion; the rest is fluid. Returns the fluid, m3. */
static double book(struct cracks *c, int i, double leaves, long on) {
    double fluid = c->content[i], empty = c->cavity[i];
    if (on > 0) {
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

void cracks_apart_look(struct cracks *c, int books) {
    struct cracks_struts *t = &c->struts;
    const cracks_vec *u = cracks_aperture_displacements(c);
    double sum[2] = {0, 0};
    for (int i = 0; i < t->n; i++) {
        double leaves;
        long on;
        if (!switch_struts(c, u, i, &leaves, &on)) {
            if (on == 0 && books) sum[0] += book(c, i, 0, 0); /* what flowed through it */
            continue;
        }
        cracks_struts_area(t, &c->table, i);
        if (books) sum[0] += book(c, i, leaves, on);
        sum[1]++;
    }
    par_sum_array(sum, 2);
    c->resolved += sum[0];
    if (sum[1] == 0) return;
    cracks_struts_update(t, sizeof *t->area_size, t->area_size);
    c->work->ones_hold = c->work->force_holds = 0;
}
