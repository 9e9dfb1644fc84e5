/* Added mass of wetted faces as part of a particle's mass, face by face with the Sherman-Morrison formula. */
#include "solid/imposed/added_mass.h"
#include "solid/state.h"

void solid_added_mass_apply(struct solid *s) {
    const struct solid_added_mass *m = s->added;
    for (int i = 0; i < m->n; i++) {
        const int h = m->h[i];
        const double density = solid_density(s, h);
        double before = 0, v = 0;
        /* the faces of one particle are adjacent: each includes the mass that the earlier ones have added */
        double carried = density;
        for (int k = i - 1; k >= 0 && m->h[k] == h; k--) carried += m->density[k];
        for (int c = 0; c < s->dim; c++) {
            before += s->a[c][h] * m->normal[c][i];
            v += s->v[c][h] * m->normal[c][i];
        }
        const double after = before * carried / (carried + m->density[i]);
        for (int c = 0; c < s->dim; c++) s->a[c][h] += (after - before) * m->normal[c][i];
        m->lost[i] = before - after;
        s->power_load -= s->volume[h] * density * m->lost[i] * v;
    }
}

/* d.n */
static double along(const struct solid *s, const struct solid_added_mass *m, int i) {
    double sum = 0;
    for (int c = 0; c < s->dim; c++) sum += s->d[c][m->h[i]] * m->normal[c][i];
    return sum;
}

void solid_added_mass_leave(struct solid *s) {
    const struct solid_added_mass *m = s->added;
    for (int i = 0; i < m->n; i++) {
        m->before[i] = m->lost[i];
        m->from[i] = along(s, m, i);
    }
}

double solid_added_mass_arrive(const struct solid *s) {
    const struct solid_added_mass *m = s->added;
    double work = 0;
    for (int i = 0; i < m->n; i++) {
        const int h = m->h[i];
        work -= s->volume[h] * solid_density(s, h) * 0.5 * (m->before[i] + m->lost[i]) * (along(s, m, i) - m->from[i]);
    }
    return work;
}
