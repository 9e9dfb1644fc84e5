/* The energy that a bond which breaks at the end of a substep of velocity Verlet has absorbed, from its ends' motion.
 */
#include "solid/force/absorbed.h"
#include "base/memory.h"
#include "solid/contact/implicit.h"

#include <math.h>
#include <string.h>

struct solid_absorbed {
    double dt, theta; /* dt = 0: no substep is being made */
    int capacity;
    double *ghost[3]; /* [n_ghost] d at the beginning, m */
};

void solid_absorbed_free(struct solid_absorbed *absorbed) {
    if (!absorbed) return;
    for (int c = 0; c < 3; c++) memory_free(absorbed->ghost[c]);
    memory_free(absorbed);
}

void solid_absorbed_save(struct solid *s) {
    if (!s->stage.breakage) return;
    if (!s->absorbed) s->absorbed = memory_new(MEMORY_SOLID, 1, sizeof *s->absorbed);
    struct solid_absorbed *absorbed = s->absorbed;
    for (int c = 0; c < s->dim; c++) {
        if (absorbed->capacity < s->n_ghost) {
            memory_free(absorbed->ghost[c]);
            absorbed->ghost[c] = memory_new(MEMORY_SOLID, (size_t)s->n_ghost, sizeof(double));
        }
        if (s->n_ghost > 0) memcpy(absorbed->ghost[c], s->d[c] + s->n, (size_t)s->n_ghost * sizeof(double));
    }
    if (absorbed->capacity < s->n_ghost) absorbed->capacity = s->n_ghost;
}

void solid_absorbed_begin(struct solid *s, double dt, double theta) {
    if (!s->absorbed) return;
    s->absorbed->dt = dt;
    s->absorbed->theta = theta;
}

void solid_absorbed_end(struct solid *s) {
    if (s->absorbed) s->absorbed->dt = 0;
}

/* d at the beginning of the substep: d(n+1) - d(n) = dt (v_n + dt/2 a_old) + dt^2/2 C/rho, where v has dt C/rho of
 * contact. */
static double start_of(const struct solid *s, int h, int c) {
    const struct solid_absorbed *absorbed = s->absorbed;
    if (h >= s->n) return absorbed->ghost[c][h - s->n];
    const double v = s->v[c][h] + (0.5 - absorbed->theta) * absorbed->dt * s->a_old[c][h];
    return s->d[c][h] - absorbed->dt * (v - 0.5 * absorbed->dt * solid_contact_implicit_push(s, h, c));
}

int solid_absorbed_is(const struct solid *s) { return s->absorbed && s->absorbed->dt != 0; }

double solid_absorbed_fraction(const struct solid *s, int h, int l, const double xi[3], double stretch) {
    if (!solid_absorbed_is(s)) return 1;
    double q = 0, xi2 = 0;
    for (int c = 0; c < s->dim; c++) {
        const double eta = start_of(s, l, c) - start_of(s, h, c);
        q += eta * (xi[c] + (xi[c] + eta));
        xi2 += xi[c] * xi[c];
    }
    const double eps = q / xi2;
    return eps / (1 + sqrt(1 + eps)) / stretch;
}
