#include "solid/integrate.h"
#include "base/clock.h"
#include "base/par.h"

#include <math.h>
#include <stdio.h>

void solid_advance(struct solid *s, double dt, int substeps) {
    clock_begin(CLOCK_SOLID);
    const int verlet = s->stage.integrator == SOLID_VERLET;
    if (verlet) solid_verlet_begin(s);
    for (int i = 0; i < substeps; i++) {
        if (verlet)
            solid_verlet_step(s, dt);
        else
            solid_rk3_step(s, dt);
    }
    if (verlet) solid_verlet_end(s);
    clock_end(CLOCK_SOLID);
}

struct step_status solid_check(const struct solid *s) {
    struct step_status status = {0};
    for (int c = 0; c < 3; c++) {
        double sum = 0;
        for (int h = 0; h < s->n; h++) sum += fabs(s->d[c][h]) + fabs(s->v[c][h]);
        if (isfinite(sum)) continue;
        for (int h = 0; h < s->n && !status.failed; h++) {
            if (isfinite(s->d[c][h]) && isfinite(s->v[c][h])) continue;
            const int bad_d = !isfinite(s->d[c][h]);
            status.failed = 1;
            status.rank = par_rank();
            status.value = bad_d ? s->d[c][h] : s->v[c][h];
            for (int k = 0; k < 3; k++) status.x[k] = s->x0[k][h];
            snprintf(status.field, sizeof status.field, bad_d ? "displacement" : "solid velocity");
        }
        if (status.failed) break;
    }
    return status;
}
