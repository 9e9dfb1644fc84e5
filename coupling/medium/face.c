/* Mean pressure at the front or the back face of the medium's box. */
#include "coupling/medium/parts.h"
#include "fluid/grid/side.h"

#include <math.h>

/* A place outside the box at which the section's mean pressure is known. */
struct known {
    double at, p; /* cells from the domain's low end along the axis (beyond the domain where it is periodic), Pa */
};

/* The nearest section, counted outward from the box, at whose pressure no force acts that the bodies in the box cause:
 * its outer face is beyond the force's reach.
 *
 *        |<-- reach -->|
 *     ---+------+------+------+---
 *     box|      |    no force |      sections of cells; the force acts at their faces
 *     ---+------+------+------+---           */
static int first_clear(const struct medium *m, int high) {
    const double d = m->g->d[m->axis];
    return high ? (int)ceil(m->high[m->axis] / d + m->reach - 1 - MEDIUM_SNAP)
                : (int)floor(m->low[m->axis] / d - m->reach + MEDIUM_SNAP);
}

/* 1: the section is neither in the box nor beyond the domain's end. Beyond a periodic end the sections repeat, up to
 * the last one that is clear of the box's other face. */
static int is_outside(const struct medium *m, int high, int i) {
    const int n = m->g->n[m->axis];
    if (!m->g->periodic[m->axis]) return i >= 0 && i < n;
    return high ? i <= first_clear(m, 0) + n : i >= first_clear(m, 1) - n;
}

/* The places nearest to the face, the nearest first: sections, and the side if its pressure is given. Returns their
 * number, at most 2. */
static int find_known(const struct medium *m, const struct fluid_input *in, int high, struct known k[2]) {
    const int n = m->g->n[m->axis];
    int found = 0;
    for (int i = first_clear(m, high); found < 2 && is_outside(m, high, i); i += high ? 1 : -1)
        k[found++] = (struct known){.at = i + 0.5, .p = m->section[(i % n + n) % n]};
    if (found == 2 || m->g->periodic[m->axis]) return found;
    struct fluid_boundary_side side;
    fluid_side_conditions(&in->side[m->axis][high], m->axis, &side);
    if (side.condition[3] == FLUID_DIRICHLET) k[found++] = (struct known){.at = high ? n : 0, .p = side.value[3]};
    return found;
}

/* No pressure is given at the side, and no section is clear of the box: the outermost section, if it is outside the box
 * at all, or else the outermost two. Returns their number. */
static int find_outermost(const struct medium *m, int high, struct known k[2]) {
    const int n = m->g->n[m->axis], last = high ? n - 1 : 0, next = high ? n - 2 : 1;
    const double d = m->g->d[m->axis], gap = high ? n - m->high[m->axis] / d : m->low[m->axis] / d;
    k[0] = (struct known){.at = next + 0.5, .p = m->section[next]};
    k[1] = (struct known){.at = last + 0.5, .p = m->section[last]};
    if (gap < 1 - MEDIUM_SNAP) return 2;
    k[0] = k[1];
    return 1;
}

double medium_face_pressure(const struct medium *m, const struct fluid_input *in, double driving, int high) {
    const double d = m->g->d[m->axis], x = (high ? m->high[m->axis] : m->low[m->axis]) / d;
    struct known k[2];
    int found = find_known(m, in, high, k);
    if (found == 0) found = find_outermost(m, high, k);
    if (found == 1) return k[0].p + driving * d * (x - k[0].at);
    return k[1].p + (k[0].p - k[1].p) * (x - k[1].at) / (k[0].at - k[1].at);
}

int medium_face_is_clear(const struct medium *m, int high) { return is_outside(m, high, first_clear(m, high)); }
