/* Boundary conditions of the six sides: values on the sides' faces and in the ghost cells.  (001: secs 3.4.3, 4.1) */
#include "fluid/grid/boundary.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par_halo.h"
#include "base/side.h"
#include "fluid/grid/profile.h"
#include "fluid/grid/side.h"

#include <math.h>
#include <stdlib.h>

static void refuse_contradictions(const struct fluid_input *in) {
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            const struct fluid_side *s = &in->side[d][side];
            const struct fluid_side_kind *kind = fluid_side_kind_of(s->type);
            if ((s->type == FLUID_PERIODIC) != (in->side[d][!side].type == FLUID_PERIODIC))
                die_all(EXIT_CODE_SCENE, "fluid.sides.%s: periodic on one side and not on the other",
                        side_name[d][side]);
            if (kind->moves && s->velocity[d] != 0)
                die_all(EXIT_CODE_SCENE, "fluid.sides.%s.velocity: a wall moves in its own plane only",
                        side_name[d][side]);
            if (kind->is_general && s->condition[d] == s->condition[3])
                die_all(EXIT_CODE_SCENE,
                        "fluid.sides.%s: needs a Dirichlet condition on either the normal velocity or the "
                        "pressure, and a "
                        "Neumann condition on the other",
                        side_name[d][side]);
        }
}

/* The normal velocity on a side's face, into the domain, m/s; values [n_b][n_a] are 0 before. */
static void values_of(const struct fluid_input *in, int d, int side, int n, double *values) {
    const double sign = side ? -1 : 1;
    switch (fluid_side_kind_of(in->side[d][side].type)->values) {
    case FLUID_VALUES_ZERO:
        break;
    case FLUID_VALUES_PROFILE:
        fluid_profile_inflow(in, d, side, values);
        break;
    case FLUID_VALUES_OWN:
        for (int i = 0; i < n; i++) values[i] = sign * in->side[d][side].velocity[d];
        break;
    }
}

/* Fills the plane of values of a side. Returns the sum over the whole side of velocity into the domain times area,
 * m3/s. */
static double fill_plane(const struct fluid_grid *g, const struct fluid_input *in, int d, int side,
                         struct fluid_boundary_side *s) {
    int a, b;
    fluid_boundary_others(d, &a, &b);
    const double sign = side ? -1 : 1, area = g->d[a] * g->d[b];
    const int na = g->n[a], nb = g->n[b];
    double *profile = memory_new(MEMORY_FLUID, (size_t)na * (size_t)nb, sizeof *profile);
    values_of(in, d, side, na * nb, profile);
    double sum = 0;
    for (int i = 0; i < na * nb; i++) sum += profile[i];
    if (s->here) {
        s->plane = memory_new(MEMORY_FLUID, (size_t)g->m[a] * (size_t)g->m[b], sizeof *s->plane);
        for (int l = 0; l < g->m[b]; l++)
            for (int j = 0; j < g->m[a]; j++)
                s->plane[l * g->m[a] + j] = sign * profile[(l + g->lo[b]) * na + j + g->lo[a]];
    }
    memory_free(profile);
    return sum * area;
}

static void set_drains(const struct fluid_input *in, struct fluid_boundary *boundary) {
    double highest = -INFINITY;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            const struct fluid_boundary_side *s = &boundary->side[d][side];
            if (s->normal == FLUID_NORMAL_FREE) highest = fmax(highest, s->value[3]);
            if (fluid_side_flow(&in->side[d][side], d, side) > 0) highest = INFINITY;
        }
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            struct fluid_boundary_side *s = &boundary->side[d][side];
            s->drains = s->normal == FLUID_NORMAL_FREE && s->value[3] < highest;
        }
}

struct fluid_boundary *fluid_boundary_new(const struct fluid_grid *g, const struct fluid_input *in) {
    struct fluid_boundary *boundary = calloc(1, sizeof *boundary);
    double through = 0;
    refuse_contradictions(in);
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            struct fluid_boundary_side *s = &boundary->side[d][side];
            if (g->periodic[d]) continue;
            s->here = par_halo_at_side(g->halos, d, side);
            fluid_side_conditions(&in->side[d][side], d, s);
            const double flux = s->normal == FLUID_NORMAL_FREE ? 0 : fill_plane(g, in, d, side, s);
            if (s->normal == FLUID_NORMAL_FREE) boundary->open = 1;
            if (s->normal != FLUID_NORMAL_GIVEN && side == 0) boundary->low_unowned = 1;
            if (s->normal == FLUID_NORMAL_CONVECTIVE)
                boundary->outlet += g->length[0] * g->length[1] * g->length[2] / g->length[d];
            if (s->normal == FLUID_NORMAL_GIVEN) {
                boundary->inflow += flux;
                through += fabs(flux);
            }
        }
    set_drains(in, boundary);
    if (!boundary->open && boundary->outlet == 0 && fabs(boundary->inflow) > 1e-12 * through)
        die_all(EXIT_CODE_SCENE, "fluid.sides: %g m3/s flow in and none out; an outflow or pressure side is missing",
                boundary->inflow);
    return boundary;
}

void fluid_boundary_free(struct fluid_boundary *boundary) {
    if (!boundary) return;
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) memory_free(boundary->side[d][side].plane);
    free(boundary);
}

/* How a field is extended at one side: about the side's face, or (on_face) about the value on the face. */
struct extension {
    int on_face;
    enum fluid_condition condition;
    double value;
};

/* Extends over the part's range of the other two directions. */
static void extend(const struct fluid_grid *g, double *q, int d, int side, const struct extension *e,
                   const struct par_halo_part *part) {
    int a, b;
    fluid_boundary_others(d, &a, &b);
    const ptrdiff_t sa = fluid_boundary_stride(g, a), sb = fluid_boundary_stride(g, b);
    const ptrdiff_t out = side ? fluid_boundary_stride(g, d) : -fluid_boundary_stride(g, d);
    const ptrdiff_t face = (ptrdiff_t)fluid_boundary_face(g, d, side, 0, 0);
    /* the first value to be mirrored: the cell at the side, or the one before the face itself */
    const ptrdiff_t inner = e->on_face ? face - out : side ? face : face - out;
    const int first_ghost = e->on_face ? 2 : 1, layers = part->layers;
    const int count = e->on_face && !side ? layers - 1 : layers, first = part->low[a], last = part->high[a];
    for (int l = 0; l < count; l++) {
        const ptrdiff_t from = inner - l * out, to = inner + (first_ghost + l) * out;
        const double step = (e->on_face ? 2 * (l + 1) : 2 * l + 1) * g->d[d] * e->value;
        for (int kb = part->low[b]; kb < part->high[b]; kb++) {
            double *restrict line = q + kb * sb;
            if (e->condition == FLUID_NEUMANN)
                for (int ka = first; ka < last; ka++) line[to + ka * sa] = line[from + ka * sa] + step;
            else if (e->on_face)
                for (int ka = first; ka < last; ka++)
                    line[to + ka * sa] = 2 * line[face + ka * sa] - line[from + ka * sa];
            else
                for (int ka = first; ka < last; ka++) line[to + ka * sa] = 2 * e->value - line[from + ka * sa];
        }
    }
}

static int most(int a, int b) { return a > b ? a : b; }
static int least(int a, int b) { return a < b ? a : b; }

void fluid_boundary_faces(const struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3],
                          const struct par_halo_part *part) {
    for (int d = 0; d < 3; d++)
        for (int side = 0; side < 2; side++) {
            const struct fluid_boundary_side *s = &boundary->side[d][side];
            const int face = side ? g->m[d] - 1 : -1;
            int a, b;
            fluid_boundary_others(d, &a, &b);
            if (!s->here || s->normal == FLUID_NORMAL_FREE) continue;
            if (face < part->low[d] || face >= part->high[d]) continue;
            const int first = most(part->low[a], 0), last = least(part->high[a], g->m[a]);
            for (int l = most(part->low[b], 0); l < least(part->high[b], g->m[b]); l++)
                for (int j = first; j < last; j++)
                    q[d][fluid_boundary_face(g, d, side, j, l)] = s->plane[l * g->m[a] + j];
        }
}

void fluid_boundary_ghosts(const struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3],
                           int direction, const struct par_halo_part *part) {
    par_halo_fill_part(g->halos, direction, 3, q, part);
    for (int side = 0; side < 2; side++) {
        const struct fluid_boundary_side *s = &boundary->side[direction][side];
        if (!s->here || !part->wanted[direction][side]) continue;
        for (int c = 0; c < 3; c++) {
            /* an outflow's normal velocity has an even extension, as the other components have */
            const int normal = c == direction;
            const enum fluid_condition k =
                normal && s->normal == FLUID_NORMAL_CONVECTIVE ? FLUID_NEUMANN : s->condition[c];
            const struct extension e = {normal, k, s->value[c]};
            extend(g, q[c], direction, side, &e, part);
        }
    }
}

void fluid_boundary_velocity_part(const struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3],
                                  const struct par_halo_part *part) {
    fluid_boundary_faces(boundary, g, q, part);
    for (int d = 0; d < 3; d++) fluid_boundary_ghosts(boundary, g, q, d, part);
}

void fluid_boundary_velocity(const struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3],
                             int layers) {
    const struct par_halo_part whole = par_halo_whole(g->halos, layers);
    fluid_boundary_velocity_part(boundary, g, q, &whole);
}

void fluid_boundary_pressure(const struct fluid_boundary *boundary, const struct fluid_grid *g, double *p,
                             const struct par_halo_part *part) {
    for (int d = 0; d < 3; d++) {
        par_halo_fill_part(g->halos, d, 1, &p, part);
        for (int side = 0; side < 2; side++) {
            const struct fluid_boundary_side *s = &boundary->side[d][side];
            const struct extension e = {0, s->condition[3], s->value[3]};
            if (s->here && part->wanted[d][side]) extend(g, p, d, side, &e, part);
        }
    }
}

void fluid_boundary_close(const struct fluid_boundary *boundary, const struct fluid_grid *g, double *const q[3]) {
    for (int d = 0; d < 3; d++) {
        const struct fluid_boundary_side *s = &boundary->side[d][0];
        int a, b;
        fluid_boundary_others(d, &a, &b);
        const ptrdiff_t sd = fluid_boundary_stride(g, d), sa = fluid_boundary_stride(g, a),
                        sb = fluid_boundary_stride(g, b);
        if (!s->here || s->normal == FLUID_NORMAL_GIVEN) continue;
        for (int l = 0; l < g->m[b]; l++)
            for (int j = 0; j < g->m[a]; j++) {
                const size_t f = fluid_boundary_face(g, d, 0, j, l), n = f + (size_t)sd;
                q[d][f] = q[d][n] + g->d[d] * ((q[a][n] - q[a][n - (size_t)sa]) / g->d[a] +
                                               (q[b][n] - q[b][n - (size_t)sb]) / g->d[b]);
            }
    }
}

void fluid_boundary_advanced(const struct fluid_boundary *boundary, const struct fluid_grid *g, int c, int low[3],
                             int high[3]) {
    for (int d = 0; d < 3; d++) {
        low[d] = 0;
        high[d] = g->m[d];
    }
    const struct fluid_boundary_side *side = boundary->side[c];
    if (side[0].here && side[0].normal == FLUID_NORMAL_FREE) low[c] = -1;
    if (side[1].here && side[1].normal != FLUID_NORMAL_FREE) high[c] = g->m[c] - 1;
}

enum fluid_end fluid_boundary_end(const struct fluid_boundary *boundary, int direction, int side, int quantity) {
    const enum fluid_condition condition = boundary->side[direction][side].condition[quantity];
    switch (condition) {
    case FLUID_DIRICHLET:
        return FLUID_END_DIRICHLET;
    case FLUID_NEUMANN:
        return FLUID_END_NEUMANN;
    }
    ENSURE(0, "condition %d", (int)condition);
}
