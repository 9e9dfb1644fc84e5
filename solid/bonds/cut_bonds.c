/* Breaks the bonds that the initial cracks cross.  (003: ch. 3) */
#include "solid/bonds/cut_bonds.h"
#include "base/die.h"
#include "base/par.h"
#include "solid/bonds/family.h"
#include "solid/bonds/list.h"
#include "solid/bonds/store.h"
#include "solid/geometry/cut.h"

#include <math.h>
#include <stdlib.h>

/* An initial crack in the coordinates of one body's bonds: in a plate spacings from the cloud's origin, in a solid
 * m. */
struct crack {
    const struct solid_cut *cut;
    struct solid_cut_line *line; /* NULL: a quadrilateral */
    double low[3], high[3];      /* its bounds */
    double period[3];            /* 0: not periodic */
};

static struct crack crack_of(const struct solid *s, const struct solid_cut *cut, const struct solid_cloud *cloud) {
    const int plane = s->dim == 2;
    struct crack k = {.cut = cut};
    if (plane) k.line = solid_cut_line_new(cut, cloud->origin, cloud->spacing);
    for (int c = 0; c < s->dim; c++) {
        k.low[c] = INFINITY;
        k.high[c] = -INFINITY;
        k.period[c] = !s->in.periodic[c] ? 0 : plane ? cloud->period[c] : s->in.length[c];
        for (int p = 0; p < cut->points; p++) {
            const double x = plane ? (cut->point[p][c] - cloud->origin[c]) / cloud->spacing : cut->point[p][c];
            k.low[c] = fmin(k.low[c], x);
            k.high[c] = fmax(k.high[c], x);
        }
    }
    return k;
}

static int is_near(const struct crack *k, int dim, const double at[3], double reach) {
    for (int c = 0; c < dim; c++)
        if (at[c] < k->low[c] - reach || at[c] > k->high[c] + reach) return 0;
    return 1;
}

static int crosses(const struct crack *k, const double from[3], const double to[3], double spacing) {
    return k->line ? solid_cut_line_crosses(k->line, from, to)
                   : solid_cut_plane_crosses(k->cut->point, from, to, spacing);
}

/* Breaks those bonds of h that the crack crosses, with h at the position `at`. Returns how many. */
static long break_from(struct solid *s, const struct crack *k, int h, const double at[3], double reach) {
    static struct solid_family_view view;
    long met = 0;
    if (!is_near(k, s->dim, at, reach)) return 0;
    solid_family_view(s, h, &view);
    for (int b = 0; b < view.n; b++) {
        double to[3] = {0};
        for (int c = 0; c < s->dim; c++) {
            const double xi = view.xi[b][c]; /* in a plate: an exact number of spacings */
            to[c] = at[c] + (k->line ? 0x1p-32 * rint(0x1p32 * (xi / s->in.spacing)) : xi);
        }
        if (!crosses(k, at, to, s->in.spacing)) continue;
        if (view.intact[b]) solid_family_break(s, h, b);
        met++;
    }
    return met;
}

/* A bond across a periodic side has a different position from either end, so the crack is tested against all periodic
 * images of h. */
static long break_in_body(struct solid *s, const struct crack *k, int body, const struct solid_cloud *cloud) {
    const double reach = (k->line ? 1 : s->in.spacing) * (2 + s->in.material[s->in.body[body].material].horizon_ratio);
    const int *first = s->family->first;
    int most[3];
    long met = 0;
    for (int c = 0; c < 3; c++) most[c] = k->period[c] > 0;
    const struct solid_list *list = s->family->list[body];
    for (int h = first[body]; h < first[body + 1]; h++) {
        if (list && list->scaled[h - list->first]) { /* its bonds were tested when they were made */
            met++;
            continue;
        }
        double x[3] = {0}, at[3] = {0};
        const long number = cloud ? s->first[par_rank()] + h - cloud->first : 0;
        for (int c = 0; c < s->dim; c++) x[c] = k->line ? cloud->place[c][number] : s->x0[c][h];
        for (int image = 0; image < 27; image++) {
            const int step[3] = {image % 3 - 1, image / 3 % 3 - 1, image / 9 - 1};
            int exists = 1;
            for (int c = 0; c < 3; c++) {
                exists &= abs(step[c]) <= most[c];
                at[c] = x[c] + step[c] * k->period[c];
            }
            if (exists) met += break_from(s, k, h, at, reach);
        }
    }
    return met;
}

void solid_cut_bonds(struct solid *s, struct solid_cloud *const *cloud) {
    char text[256];
    for (int q = 0; q < s->in.cuts; q++) {
        long met = 0;
        if (solid_cut_fault(&s->in.cut[q], s->dim, text, sizeof text))
            die_all(EXIT_CODE_SCENE, "solid.cracks[%d]: %s", q, text);
        for (int b = 0; b < s->in.bodies; b++) {
            struct crack k = crack_of(s, &s->in.cut[q], cloud[b]);
            met += break_in_body(s, &k, b, cloud[b]);
            solid_cut_line_free(k.line);
        }
        if (par_sum_long(met) == 0)
            die_all(EXIT_CODE_SCENE, "solid.cracks[%d] crosses no bond: it lies outside the bodies or along an edge",
                    q);
    }
}
