/* Carter's leak-off from the faces of cracks. */
#include "cracks/leak_off.h"
#include "base/par.h"
#include "cracks/solve.h"

#include <math.h>

/* The areas |a_h| of both sides of a crack add up to one face: a particle has 2 |a_h| of both. */
double cracks_leak_off_source(struct cracks *c, double t, double dt, double *b) {
    double sum = 0;
    for (int i = 0; i < c->struts.n; i++) {
        c->leak[i] = 0;
        if (c->since[i] < 0) continue;
        const double wet = fmax(t - c->since[i], 0), root = sqrt(wet + dt) - sqrt(wet);
        c->leak[i] = 2 * c->in.leak_off * root * 2 * c->struts.area_size[i];
        if (c->work->set[i] == CRACKS_CAVITY) c->leak[i] = fmin(c->leak[i], fmax(c->content[i], 0));
        b[i] -= c->leak[i];
        sum += c->leak[i];
    }
    return sum;
}

void cracks_leak_off_add(struct cracks *c, double now) {
    double sum = 0;
    for (int i = 0; i < c->struts.n; i++) {
        c->content[i] -= c->leak[i];
        sum += c->leak[i];
        if (c->since[i] < 0 && c->work->set[i] != CRACKS_CAVITY) c->since[i] = now;
    }
    c->leaked += par_sum(sum);
}

void cracks_leak_off_return(struct cracks *c, double *left) {
    double sum = 0;
    for (int i = 0; i < c->struts.n; i++) {
        if (c->work->set[i] != CRACKS_CAVITY || !(c->content[i] < 0)) continue;
        const double back = fmax(fmin(fmin(c->leak[i], -c->content[i]), -left[i]), 0);
        c->content[i] += back;
        left[i] += back;
        sum += back;
    }
    c->leaked -= par_sum(sum);
}
