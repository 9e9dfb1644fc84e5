/* What a bond that breaks at the end of a substep of velocity Verlet has taken up: from the way of its ends. */
#include "solid/force/way.h"
#include "base/memory.h"
#include "solid/contact/implicit.h"

#include <math.h>
#include <string.h>

struct solid_way {
    double dt, theta; /* dt = 0: no substep is being made */
    int room;
    double *ghost[3]; /* [n_ghost] d at the beginning, m */
};

void solid_way_free(struct solid_way *way) {
    if (!way) return;
    for (int c = 0; c < 3; c++) memory_free(way->ghost[c]);
    memory_free(way);
}

void solid_way_keep(struct solid *s) {
    if (!s->stage.breakage) return;
    if (!s->way) s->way = memory_new(MEMORY_SOLID, 1, sizeof *s->way);
    struct solid_way *way = s->way;
    for (int c = 0; c < s->dim; c++) {
        if (way->room < s->n_ghost) {
            memory_free(way->ghost[c]);
            way->ghost[c] = memory_new(MEMORY_SOLID, (size_t)s->n_ghost, sizeof(double));
        }
        if (s->n_ghost > 0) memcpy(way->ghost[c], s->d[c] + s->n, (size_t)s->n_ghost * sizeof(double));
    }
    if (way->room < s->n_ghost) way->room = s->n_ghost;
}

void solid_way_begin(struct solid *s, double dt, double theta) {
    if (!s->way) return;
    s->way->dt = dt;
    s->way->theta = theta;
}

void solid_way_end(struct solid *s) {
    if (s->way) s->way->dt = 0;
}

/* d at the beginning of the substep: d(n+1) - d(n) = dt (v_n + dt/2 a_old) + dt^2/2 C/rho, where v has dt C/rho of
 * contact. */
static double start_of(const struct solid *s, int h, int c) {
    const struct solid_way *way = s->way;
    if (h >= s->n) return way->ghost[c][h - s->n];
    const double v = s->v[c][h] + (0.5 - way->theta) * way->dt * s->a_old[c][h];
    return s->d[c][h] - way->dt * (v - 0.5 * way->dt * solid_contact_implicit_push(s, h, c));
}

double solid_way_taken(const struct solid *s, int h, int l, const double xi[3], double stretch) {
    if (!s->way || s->way->dt == 0) return 1;
    double q = 0, xi2 = 0;
    for (int c = 0; c < s->dim; c++) {
        const double eta = start_of(s, l, c) - start_of(s, h, c);
        q += eta * (xi[c] + (xi[c] + eta));
        xi2 += xi[c] * xi[c];
    }
    const double eps = q / xi2;
    return eps / (1 + sqrt(1 + eps)) / stretch;
}
