/* Writes the small scenes of a calibration as YAML. */
#include "program/calibrate/scenes.h"
#include "base/ensure.h"

#include <math.h>

/* A displacement as a piece of a sine so wide that it is a straight line. */
#define WIDE 1.0e6

/*            clamp, opened
 *      +---------------------------------+
 *      |                                 |
 *      |_ _ _ _ _ _ _|  middle           | height     turned by an angle on the lattice; the points of the lattice
 * stand |    crack                        |            at (i + 1/2, j + 1/2), the middle line runs between two rows
 *      +---------------------------------+            of them along [100] and [110]
 *            clamp      length                                                                                      */
struct calibrate_frame calibrate_scenes_frame(const struct calibrate_scene *c) {
    const struct calibrate_sizes z = calibrate_sample_sizes(c);
    const double angle = c->degrees * M_PI / 180;
    struct calibrate_frame w = {.cos = cos(angle), .sin = sin(angle), .length = z.length, .height = z.height};
    if (c->degrees == 0) {
        w.centre[0] = 0.5 * w.length;
        w.centre[1] = 0.5 * w.height;
    } else { /* [110]: rows at whole y - x */
        w.centre[0] = ceil(0.5 * (w.length * w.cos + w.height * w.sin)) + 0.5;
        w.centre[1] = ceil(0.5 * (w.length * w.sin + w.height * w.cos));
    }
    return w;
}

void calibrate_scenes_local(const struct calibrate_frame *w, const double x[2], double *along, double *across) {
    const double d[2] = {x[0] - w->centre[0], x[1] - w->centre[1]};
    *along = w->cos * d[0] + w->sin * d[1] + 0.5 * w->length;
    *across = -w->sin * d[0] + w->cos * d[1];
}

struct writer {
    FILE *f;
    const struct calibrate_scene *c;
    struct calibrate_sizes z;
    struct calibrate_frame w;
    int space;
};

/* "[x, y]", in space "[x, y, z]". */
static void write_vector(const struct writer *t, double x, double y, double z) {
    fprintf(t->f, t->space ? "[%.12g, %.12g, %.12g]" : "[%.12g, %.12g]", x, y, z);
}

/* "low: [...], high: [...]" through the whole depth. */
static void write_box(const struct writer *t, double x_low, double y_low, double x_high, double y_high) {
    fputs("low: ", t->f);
    write_vector(t, x_low, y_low, 0);
    fputs(", high: ", t->f);
    write_vector(t, x_high, y_high, t->z.depth);
}

/* A place of the strip: along from its left end, across from its middle line. */
static void write_place(const struct writer *t, double along, double across, double z) {
    const double s = along - 0.5 * t->w.length;
    write_vector(t, t->w.centre[0] + t->w.cos * s - t->w.sin * across,
                 t->w.centre[1] + t->w.sin * s + t->w.cos * across, z);
}

/* Lattice rows first <= j <= last of the strip's part between two lines, in columns i ... i + n - 1; 0: none. */
static int rows(const struct calibrate_frame *w, int i, int n, double low, double high, int *first, int *last) {
    const int most = (int)ceil(2 * w->centre[1]);
    int found = 0;
    for (int j = 0; j < most; j++)
        for (int k = i; k < i + n; k++) {
            double along, across;
            calibrate_scenes_local(w, (const double[]){k + 0.5, j + 0.5}, &along, &across);
            if (along < 0 || along > w->length || across < low || across > high) continue;
            if (!found) *first = j;
            *last = j;
            found = 1;
        }
    return found;
}

static void write_head(const struct writer *t, const char *title) {
    const struct calibrate_sample *k = t->c->sample;
    const char *const correction[] = {
        [SOLID_CORRECTION_NONE] = "none", [SOLID_CORRECTION_VOLUME] = "volume", [SOLID_CORRECTION_ENERGY] = "energy"};
    const char *const law[] = {
        [PHYSICS_CONSTANT] = "constant", [PHYSICS_CONICAL] = "conical", [PHYSICS_EXPONENTIAL] = "exponential"};
    static const char *const partial[] = {
        [SOLID_PARTIAL_EXACT] = "exact", [SOLID_PARTIAL_RAMP] = "ramp", [SOLID_PARTIAL_RAMP_CUT] = "ramp_cut"};
    fprintf(t->f,
            "# Made by frana calibrate. Lengths in spacings, E = 1, density = 1.\ntitle: %s\ndomain: {size: ", title);
    write_vector(t, 2 * t->w.centre[0], 2 * t->w.centre[1], t->z.depth);
    fputs(t->space && t->c->kind != CALIBRATE_BAR ? ", periodic: [false, false, true]}\n" : "}\n", t->f);
    fputs("solid:\n  spacing: 1\n", t->f);
    if (!t->space)
        fprintf(t->f, "  model: %s\n  partial_volume: %s\n",
                k->model == PHYSICS_PLANE_STRESS ? "plane_stress" : "plane_strain", partial[k->partial]);
    fprintf(t->f, "  surface_correction: %s\n  contact: {enabled: false}\n  materials:\n    - name: material\n",
            correction[k->correction]);
    fprintf(t->f, "      youngs_modulus: 1\n      density: 1\n      fracture_energy: %.12g\n", calibrate_sample_g0(k));
    if (k->ratio_excess != 0)
        fprintf(t->f, "      poisson_ratio: %.12g\n", physics_model_poisson_ratio(k->model) + k->ratio_excess);
    fprintf(t->f, "      horizon_ratio: %.12g\n      micromodulus: %s\n", k->m, law[k->micromodulus]);
    if (k->length > 0)
        fprintf(t->f, "      breakage: {law: bilinear, tensile_strength: %.12g} # E G0/sigma_t2 = %.6g spacings\n",
                sqrt(calibrate_sample_g0(k) / k->length), k->length);
    fputs("  bodies:\n", t->f);
}

/* An upright box or rectangle that fills the frame. */
static void write_upright(const struct writer *t) {
    fprintf(t->f, "    - {shape: %s, ", t->space ? "box" : "rectangle");
    write_box(t, 0, 0, t->w.length, t->w.height);
    fputs("}\n", t->f);
}

/* A strip that is turned: a polygon in a plate; in space a box for each column of the lattice. */
static void write_turned(const struct writer *t) {
    int first = 0, last = 0, n = 0;
    if (!t->space) {
        fputs("    - shape: polygon\n      outline: [", t->f);
        for (int k = 0; k < 4; k++) {
            write_place(t, k == 1 || k == 2 ? t->w.length : 0, k < 2 ? -0.5 * t->w.height : 0.5 * t->w.height, 0);
            fputs(k < 3 ? ", " : "]\n", t->f);
        }
        return;
    }
    for (int i = 0; i < 2 * t->w.centre[0]; i++) {
        if (!rows(&t->w, i, 1, -t->w.height, t->w.height, &first, &last)) continue;
        fputs(n ? "        - {shape: box, " : "    - shape: box\n      ", t->f);
        if (n == 0) {
            fputs("low: ", t->f);
            write_vector(t, i, first, 0);
            fputs("\n      high: ", t->f);
            write_vector(t, i + 1, last + 1, t->z.depth);
            fputs("\n      pieces:\n", t->f);
        } else {
            write_box(t, i, first, i + 1, last + 1);
            fputs("}\n", t->f);
        }
        n++;
    }
}

/* A quadrilateral in space, a line in a plate. */
static void write_cut(const struct writer *t, double from, double to) {
    fputs("  cracks:\n    - points: [", t->f);
    write_place(t, from, 0, 0);
    fputs(", ", t->f);
    write_place(t, to, 0, 0);
    if (t->space) {
        fputs(", ", t->f);
        write_place(t, to, 0, t->z.depth);
        fputs(", ", t->f);
        write_place(t, from, 0, t->z.depth);
    }
    fputs("]\n", t->f);
}

/* Upper and lower clamp, one box a column of the lattice; a strip along the lattice that is not opened as a wedge has
 * one box a clamp. The opening of a wedge is full at the cut's end and falls to 0 over 1.5 heights. constrained: clamps
 * as constraints; else as unbreakable regions. */
static void write_clamps(const struct writer *t, int constrained) {
    const int wedge = t->c->kind == CALIBRATE_CREEPING;
    const int width = wedge ? 1 : t->c->degrees == 0 ? (int)ceil(2 * t->w.centre[0]) : 2;
    const double inner = 0.5 * t->w.height - t->z.clamp, outer = 0.5 * t->w.height;
    fputs(constrained ? "  constraints:\n" : "  unbreakable:\n", t->f);
    for (int side = -1; side <= 1; side += 2)
        for (int i = 0; i < 2 * t->w.centre[0]; i += width) {
            int first = 0, last = 0;
            double along, across, opening = side * t->z.half_opening;
            if (!rows(&t->w, i, width, side < 0 ? -outer : inner, side < 0 ? -inner : outer, &first, &last)) continue;
            fputs("    - {", t->f);
            write_box(t, i, first, i + width, last + 1);
            if (constrained) {
                calibrate_scenes_local(&t->w, (const double[]){i + 0.5 * width, 0.5 * (first + last + 1)}, &along,
                                       &across);
                if (wedge) opening *= fmax(1 - (along - t->z.crack) / (1.5 * t->w.height), 0);
                fputs(", displacement: ", t->f);
                write_vector(t, -t->w.sin * opening, t->w.cos * opening, 0);
                if (wedge) fprintf(t->f, ", time: [[0, %.6g], [1, %.6g]]", t->z.first, t->z.first + 1);
            }
            fputs("}\n", t->f);
        }
}

/* The strip's initial strain, uniform between the clamps. */
static void write_initial_strain(const struct writer *t) {
    const double strain = t->z.half_opening / (0.5 * t->w.height - t->z.clamp) * WIDE / (2 * M_PI);
    const double n[2] = {-t->w.sin, t->w.cos};
    fputs("  initial:\n", t->f);
    for (int d = 0; d < 2; d++) {
        if (fabs(n[d]) < 1e-12) continue;
        fprintf(t->f, "    - {shape: sine, along: %c, centre: %.12g, width: %g, displacement: ", "xy"[d],
                t -> w.centre[d], WIDE);
        write_vector(t, n[0] * n[d] * strain, n[1] * n[d] * strain, 0);
        fputs("}\n", t->f);
    }
}

static void write_output(const struct writer *t, int cracked) {
    fprintf(t->f, "output:\n  series_every: %d\n  checkpoint_every: 0\n  fields_every: 0\n  stress: false\n",
            t->z.every);
    fputs("  fragments: false\n", t->f);
    if (t->c->kind != CALIBRATE_NOTCHED && t->c->kind != CALIBRATE_BAR) fputs("  reactions: false\n", t->f);
    if (cracked) {
        fprintf(t->f, "  crack: {every: %d, direction: ", t->z.every);
        write_vector(t, t->w.cos, t->w.sin, 0);
        fputs("}\n", t->f);
    }
}

static void write_stage(const struct writer *t, const char *name) {
    fprintf(t->f, "  - {name: %s, steps: %d, time_step: %.12g, integrator: verlet, damping_absolute: %.6g}\n", name,
            t->z.steps, t->z.step, t->z.damping);
}

static void write_strip(const struct writer *t, const char *title) {
    write_head(t, title);
    if (t->c->degrees == 0)
        write_upright(t);
    else
        write_turned(t);
    write_cut(t, -1, t->z.crack);
    write_clamps(t, 1);
    write_clamps(t, 0);
    write_initial_strain(t);
    fputs("stages:\n", t->f);
    if (t->c->kind == CALIBRATE_CREEPING) {
        fprintf(t->f, "  - {name: open, steps: %d, relax: true, increment: %.6g, tolerance: 1.0e-5}\n", t->z.steps,
                t->z.increment);
    } else {
        if (t->c->kind == CALIBRATE_RUNNING)
            fputs("  - {name: stretch, steps: 1, relax: true, tolerance: 1.0e-5}\n", t->f);
        write_stage(t, "run");
    }
    write_output(t, 1);
}

/* A square plate between clamps that are moved apart, with a notch from one side. */
static void write_notched(const struct writer *t, const char *title) {
    const int elastic = t->c->kind != CALIBRATE_NOTCHED, soft = t->z.step > 0;
    write_head(t, title);
    write_upright(t);
    write_cut(t, -1, t->z.crack);
    fputs("  constraints:\n", t->f);
    for (int side = -1; side <= 1; side += 2) {
        fputs("    - {", t->f);
        write_box(t, 0, side < 0 ? 0 : t->w.height - t->z.clamp, t->w.length, side < 0 ? t->z.clamp : t->w.height);
        fputs(", displacement: ", t->f);
        write_vector(t, 0, side * t->z.half_opening, 0);
        if (!elastic && soft) fprintf(t->f, ", time: [[0, 0], [%.12g, 2]]", t->z.steps * t->z.step);
        if (!elastic && !soft) fprintf(t->f, ", time: [[0, %.6g], [1, %.6g]]", t->z.first, t->z.first + 1);
        fputs("}\n", t->f);
    }
    fputs("  unbreakable:\n", t->f);
    for (int part = 0; part < 3; part++) { /* the clamps, and what is far ahead of the notch */
        fputs("    - {", t->f);
        write_box(t, part < 2 ? 0 : t->z.to, part == 1 ? t->w.height - t->z.clamp : 0, t->w.length,
                  part == 0 ? t->z.clamp : t->w.height);
        fputs("}\n", t->f);
    }
    if (elastic || !soft) write_initial_strain(t);
    fputs("stages:\n", t->f);
    if (elastic)
        fputs("  - {name: stretch, steps: 1, relax: true, breakage: false, tolerance: 1.0e-6}\n", t->f);
    else if (soft)
        write_stage(t, "open");
    else
        fprintf(t->f, "  - {name: open, steps: %d, relax: true, increment: %.6g, tolerance: 1.0e-5}\n", t->z.steps,
                t->z.increment);
    write_output(t, 1);
}

/* A bar that is pulled along its length, its sides free. */
static void write_bar(const struct writer *t, const char *title) {
    const double speed = t->z.half_opening / (t->z.steps * t->z.step);
    write_head(t, title);
    write_upright(t);
    for (int constrained = 1; constrained >= 0; constrained--) {
        fputs(constrained ? "  constraints:\n" : "  unbreakable:\n", t->f);
        for (int end = -1; end <= 1; end += 2) {
            const double width = constrained ? t->z.clamp : 2 * t->z.clamp;
            fputs("    - {", t->f);
            write_box(t, end < 0 ? 0 : t->w.length - width, 0, end < 0 ? width : t->w.length, t->w.height);
            if (constrained) {
                fputs(", directions: x, velocity: ", t->f);
                write_vector(t, end * speed, 0, 0);
                fprintf(t->f, ", time: [[0, 0], [%.6g, 1]]", 0.05 * t->z.steps * t->z.step);
            }
            fputs("}\n", t->f);
        }
    }
    fputs("stages:\n", t->f);
    write_stage(t, "pull");
    write_output(t, 0);
}

void calibrate_scenes_write(FILE *f, const struct calibrate_scene *c) {
    const struct writer t = {f, c, calibrate_sample_sizes(c), calibrate_scenes_frame(c),
                             c->sample->model == PHYSICS_3D};
    switch (c->kind) {
    case CALIBRATE_RUNNING:
        write_strip(&t, "A crack runs through a strip between clamps");
        return;
    case CALIBRATE_DAMPED:
        write_strip(&t, "A crack creeps through a damped strip between clamps");
        return;
    case CALIBRATE_CREEPING:
        write_strip(&t, "A crack creeps through a strip that is opened as a wedge");
        return;
    case CALIBRATE_SHORTER:
    case CALIBRATE_LONGER:
        write_notched(&t, "A notched plate between clamps");
        return;
    case CALIBRATE_NOTCHED:
        write_notched(&t, "A notched plate is opened until the notch runs");
        return;
    case CALIBRATE_BAR:
        write_bar(&t, "A smooth bar is pulled apart");
        return;
    }
    ENSURE(0, "no scene of kind %d", (int)c->kind);
}
