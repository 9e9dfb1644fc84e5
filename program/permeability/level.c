/* Measures the tensor of permeability on one grid. */
#include "program/permeability/level.h"
#include "base/die.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_piece.h"
#include "base/files/log.h"
#include "coupling/setup/forecast.h"
#include "coupling/setup/pores.h"
#include "program/permeability/fields.h"
#include "stokes/measure.h"

#include <math.h>
#include <string.h>

#define TOLERANCE 1e-4 /* of k over a whole period, whose error is of second order in those of u and p */
#define TOLERANCE_OF_MEANS                                                                                             \
    1e-6          /* where means of u over a part of the domain count, which are off by the root of it                 \
                   */
#define SNAP 1e-9 /* of the domain: the input is decimal */

/* The medium's box, in cells, along each axis. */
struct box {
    double low[3], high[3], d[3];
    int n[3], whole[3]; /* 1: the domain along the axis */
};

static struct box box_of(const struct scene *s, const int n[3]) {
    struct box b;
    for (int c = 0; c < 3; c++) {
        const double size = s->domain.size[c], slack = SNAP * size;
        const double low = s->coupling->has_box ? fmax(s->coupling->box_low[c], 0) : 0,
                     high = s->coupling->has_box ? fmin(s->coupling->box_high[c], size) : size;
        b.n[c] = n[c];
        b.d[c] = size / n[c];
        b.whole[c] = low <= slack && high >= size - slack;
        b.low[c] = b.whole[c] ? 0 : low / b.d[c];
        b.high[c] = b.whole[c] ? n[c] : high / b.d[c];
        if (fabs(b.low[c] - rint(b.low[c])) < 1e-6) b.low[c] = rint(b.low[c]);
        if (fabs(b.high[c] - rint(b.high[c])) < 1e-6) b.high[c] = rint(b.high[c]);
    }
    return b;
}

static double part_of(int i, double low, double high) { return fmax(0, fmin(high, i + 1) - fmax(low, i)); }

/* The share of the box that is pore. */
static double porosity_of(const struct stokes_mask *m, const struct box *b) {
    double sum = 0, volume = 1;
    const int first = par_piece_low(m->n[2], par_size(), par_rank()),
              last = par_piece_low(m->n[2], par_size(), par_rank() + 1);
    for (int c = 0; c < 3; c++) volume *= b->high[c] - b->low[c];
    for (int k = first; k < last; k++)
        for (int j = 0; j < m->n[1]; j++) {
            const double across = part_of(k, b->low[2], b->high[2]) * part_of(j, b->low[1], b->high[1]);
            for (int i = 0; across > 0 && i < m->n[0]; i++)
                if (stokes_mask_is(m, i, j, k)) sum += across * part_of(i, b->low[0], b->high[0]);
        }
    return par_sum(sum) / volume;
}

/* Whether all cells of a section are pore. */
static int is_open(const struct stokes_mask *m, int axis, int section) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    for (int q = 0; q < m->n[a]; q++)
        for (int r = 0; r < m->n[b]; r++) {
            int at[3];
            at[axis] = section;
            at[a] = q;
            at[b] = r;
            if (!stokes_mask_is(m, at[0], at[1], at[2])) return 0;
        }
    return 1;
}

/* The pressure at a face of the box across the axis, with the driving: by the line through the nearest two open
 * sections outside of it. section NULL: asks only whether there is one. Returns 0 if there is none. */
static int face_of(const struct stokes_mask *m, const struct box *b, int axis, int is_periodic, int high,
                   const struct stokes_measure_section *section, double *pressure) {
    const int n = b->n[axis], low_end = (int)floor(b->low[axis]), high_end = (int)ceil(b->high[axis]);
    const double d = b->d[axis], face = (high ? b->high[axis] : b->low[axis]) * d;
    double x[2], p[2];
    int points = 0;
    for (int q = 0; q < 2; q++) {
        const int i = high ? high_end + q : low_end - 1 - q, at = is_periodic ? (i % n + n) % n : i;
        if (at < 0 || at >= n) { /* a side of given pressure */
            x[points] = at < 0 ? 0 : n * d;
            p[points] = -x[points];
            points++;
            break;
        }
        if ((at >= low_end && at < high_end) || !is_open(m, axis, at)) break;
        x[points] = (i + 0.5) * d;
        p[points] = (section ? section[at].p : 0) - x[points];
        points++;
    }
    if (points == 0) return 0;
    *pressure = points == 1 ? p[0] : p[0] + (p[1] - p[0]) * (face - x[0]) / (x[1] - x[0]);
    return 1;
}

/* Dies if nothing resists the flow. */
static void check_walls(const struct scene *s, const struct stokes_mask *m) {
    int walls = 0;
    for (int c = 0; c < 3; c++)
        for (int e = 0; e < 2; e++) walls |= s->fluid->side[c][e].type == FLUID_WALL;
    if (!walls && m->before[(long)m->n[1] * m->n[2]] == (long)m->n[0] * m->n[1] * m->n[2])
        die_all(EXIT_CODE_SCENE,
                "domain.cells: no centre of the %d x %d x %d cells is in a body: nothing resists the flow", m->n[0],
                m->n[1], m->n[2]);
}

/* Dies unless the permeability along the axis is defined. */
static void check(const struct stokes_mask *m, const struct box *b, int axis, int is_periodic) {
    double unused;
    if (b->whole[axis]) return;
    for (int c = 0; c < 3; c++)
        if (c != axis && !b->whole[c])
            die_all(EXIT_CODE_SCENE,
                    "coupling.medium: the box does not reach from side to side along %c: fluid passes beside the "
                    "sample, so it has no permeability along %c",
                    "xyz"[c], "xyz"[axis]);
    if (!face_of(m, b, axis, is_periodic, 0, NULL, &unused) || !face_of(m, b, axis, is_periodic, 1, NULL, &unused))
        die_all(EXIT_CODE_SCENE,
                "coupling.medium: beside the box along %c there is solid: give the whole domain, or a box between open "
                "layers of fluid",
                "xyz"[axis]);
}

/* Whether the sections outside of the box are open layers between sides without friction: all of the driving then drops
 * over the box. */
static int is_layered(const struct stokes *s, const struct stokes_mask *m, const struct box *b, int axis) {
    for (int c = 0; c < 3; c++)
        for (int e = 0; e < 2; e++)
            if (c != axis && s->g.in.side[c][e] == STOKES_SIDE_WALL) return 0;
    for (int k = 0; k < b->n[axis]; k++)
        if ((k + 1 <= b->low[axis] || k >= b->high[axis]) && !is_open(m, axis, k)) return 0;
    return 1;
}

/* The mean gradient along the axis within the box, for a force 1. */
static double gradient_of(const struct stokes *s, const struct stokes_mask *m, const struct box *b, int axis) {
    const int is_periodic = s->g.in.side[axis][0] == STOKES_SIDE_PERIODIC;
    double front = 0, back = 0;
    if (b->whole[axis]) return 1;
    if (is_layered(s, m, b, axis)) return b->n[axis] / (b->high[axis] - b->low[axis]);
    struct stokes_measure_section *section = memory_new(MEMORY_COUPLING, (size_t)b->n[axis], sizeof *section);
    stokes_measure_sections(s, axis, section);
    face_of(m, b, axis, is_periodic, 0, section, &front);
    face_of(m, b, axis, is_periodic, 1, section, &back);
    memory_free(section);
    return (front - back) / ((b->high[axis] - b->low[axis]) * b->d[axis]);
}

static enum stokes_side side_of(enum fluid_side_type type) {
    switch (type) {
    case FLUID_PERIODIC:
        return STOKES_SIDE_PERIODIC;
    case FLUID_SLIP:
        return STOKES_SIDE_SLIP;
    case FLUID_PRESSURE:
        return STOKES_SIDE_PRESSURE;
    case FLUID_WALL:
    case FLUID_INFLOW:
    case FLUID_OUTFLOW:
    case FLUID_GENERAL: /* these three are refused */
        break;
    }
    return STOKES_SIDE_WALL;
}

static struct stokes_input input_of(const struct scene *s, const struct permeability_drive *drive, const struct box *b,
                                    int axis, int smooth, int (*stops)(void *)) {
    const int whole = b->whole[0] && b->whole[1] && b->whole[2] && drive->axis < 0;
    struct stokes_input in = {.smooth = smooth, .tolerance = whole ? TOLERANCE : TOLERANCE_OF_MEANS, .stops = stops};
    for (int c = 0; c < 3; c++) {
        in.d[c] = b->d[c];
        for (int e = 0; e < 2; e++)
            in.side[c][e] = side_of(s->fluid->side[permeability_drive_sides(drive, axis, c)][e].type);
    }
    return in;
}

static void set_column(const struct stokes *s, const struct stokes_mask *m, const struct box *b, int axis,
                       struct permeability_level *l) {
    const struct stokes_measure measured = stokes_measure_box(s, axis, b->low, b->high);
    const double gradient = gradient_of(s, m, b, axis);
    const int whole = b->whole[0] && b->whole[1] && b->whole[2];
    for (int c = 0; c < 3; c++) {
        const int closed = s->g.in.side[c][0] != STOKES_SIDE_PERIODIC;
        l->K[c][axis] =
            whole || (c == axis && !b->whole[axis]) ? s->tensor[c][axis] / gradient : measured.mean[c] / gradient;
        if (c != axis && closed) l->K[c][axis] = NAN;
    }
    l->tortuosity[axis] = measured.tortuosity;
}

/* Of sides that are periodic. */
static void set_overlap(const struct stokes_mask *m, const struct stokes_input *in, int axis,
                        struct permeability_level *l) {
    const struct stokes_mask_overlap q = stokes_mask_overlap(m, axis);
    const double share =
        stokes_mask_overlap_share(&q, (double)m->n[(axis + 1) % 3] * m->n[(axis + 2) % 3], &l->is_cut[axis]);
    l->overlap[axis] = in->side[axis][0] == STOKES_SIDE_PERIODIC ? share : NAN;
}

static void solve_axis(struct stokes *s, const struct stokes_mask *m, const struct box *b, int axis,
                       struct permeability_level *l) {
    l->pores = s->pores;
    l->through = s->through;
    l->percolates[axis] = s->pieces.percolates[axis];
    set_overlap(m, &s->g.in, axis, l);
    for (int c = 0; c < 3; c++) l->K[c][axis] = 0;
    l->tortuosity[axis] = NAN;
    if (!l->percolates[axis]) return;
    l->effort[axis] = stokes_solve(s, axis);
    l->stopped |= l->effort[axis].stopped;
    set_column(s, m, b, axis, l);
    l->bytes = fmax(l->bytes, par_sum((double)memory_high_water(MEMORY_FLUID)));
}

/* The entries that were found last are the best of equal ones. */
static void complete(const struct stokes *s, const struct box *b, struct permeability_level *l) {
    if (!s->cells || !b->whole[0] || !b->whole[1] || !b->whole[2]) return;
    for (int i = 0; i < 9; i++)
        if (!isnan(l->K[i / 3][i % 3])) l->K[i / 3][i % 3] = s->tensor[i / 3][i % 3];
}

static double bytes_of(long pores, const int n[3]) {
    return (double)STOKES_BYTES * (double)pores + 0.25 * (double)n[0] * n[1] * n[2]; /* two bits a cell */
}

double permeability_level_bytes(const struct permeability_level *l) { return bytes_of(l->through, l->n); }

/* Memory and time of a level, before its pores are allocated. Collective. */
static void forecast(const struct stokes_mask *m) {
    const long pores = m->before[(long)m->n[1] * m->n[2]];
    const double bytes = bytes_of(pores, m->n), has = par_min(forecast_share()) * par_size();
    log_line("%d x %d x %d cells, %ld of pore: at most %.3g MB of memory, about %.2g s", m->n[0], m->n[1], m->n[2],
             pores, 1e-6 * bytes, 3e-6 * STOKES_MICROSECONDS * (double)pores / par_size());
    if (bytes > has)
        die_all(
            EXIT_CODE_SCENE,
            "domain.cells: %ld pore cells take %.3g GB of memory, and there are %.3g GB: fewer cells, a crop of the "
            "image, or more nodes",
            pores, 1e-9 * bytes, 1e-9 * has);
}

void permeability_level_measure(const struct scene *s, const struct permeability_drive *drive, int finer, int smooth,
                                const char *out, int (*stops)(void *),
                                void (*axis_done)(const struct permeability_level *, int axis),
                                struct permeability_level *l) {
    const double start = par_seconds();
    memory_high_water(MEMORY_FLUID);
    struct stokes_mask *m = setup_pores(s, finer);
    const struct box b = box_of(s, m->n);
    struct stokes *flow = NULL;
    check_walls(s, m);
    forecast(m);
    *l = (struct permeability_level){.finer = finer, .n = {m->n[0], m->n[1], m->n[2]}};
    for (int c = 0; c < 3; c++)
        check(m, &b, c, s->fluid->side[permeability_drive_sides(drive, c, c)][0].type == FLUID_PERIODIC);
    l->porosity = porosity_of(m, &b);
    for (int c = 0; c < 3; c++) l->layer += (double)stokes_mask_surface(m, c) / ((double)m->n[0] * m->n[1] * m->n[2]);
    for (int c = 0; c < 3 && !l->stopped; c++) {
        if (!flow || drive->axis >= 0) {
            const struct stokes_input in = input_of(s, drive, &b, c, smooth, stops);
            stokes_free(flow);
            flow = stokes_new(m, &in);
        }
        solve_axis(flow, m, &b, c, l);
        l->written[c] = out && l->percolates[c] && !l->stopped;
        if (l->written[c])
            permeability_fields_write(out, s, flow, c, permeability_drive_gradient(drive, s, c, l->K[c][c]));
        if (drive->axis < 0 && c == 2) complete(flow, &b, l);
        l->seconds = par_seconds() - start;
        if (!l->stopped) axis_done(l, c);
    }
    stokes_free(flow);
    stokes_mask_free(m);
}
