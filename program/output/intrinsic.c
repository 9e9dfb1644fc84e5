/* Writes intrinsic.csv: the tensor of permeability of the medium as it is at a step, by creeping flow, beside the
 * apparent one of the run's flow. */
#include "program/output/outputs.h"
#include "base/clock.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "base/files/log.h"
#include "coupling/stage.h"
#include "coupling/interface/deposit.h"
#include "coupling/medium/intrinsic.h"
#include "physics/darcy.h"

#include <math.h>
#include <stdio.h>

/* clang-format off */
enum { STEP, T, XX, YY, ZZ, XY, XZ, YZ, XX_MD, YY_MD, ZZ_MD, APPARENT, POROSITY, ERROR, SOLVED, ITERATIONS, PRODUCTS,
       COLUMNS };
/* clang-format on */

struct intrinsic {
    struct outputs_base base;
    struct medium_intrinsic *medium;
    struct medium_intrinsic_values now; /* of the last sample */
    long samples, solved;               /* since the run began or was resumed */
};

static int begin(void *self, struct run *r) {
    struct intrinsic *t = self;
    t->base.every = r->scene->output.permeability_every;
    if (!r->medium || t->base.every == 0) return 0;
    t->base.rows = 1;
    t->medium = medium_intrinsic_new(r->medium, fluid_input_of(r->fluid));
    return 1;
}

static double md(double k) { return 1e3 * k / PHYSICS_DARCY; }

/* A row. Returns why it was given up. */
static enum signals_reason measure(struct intrinsic *t, struct run *r) {
    deposit_update(r);
    const struct medium_intrinsic_values v = medium_intrinsic_measure(t->medium);
    if (v.stopped != SIGNALS_NONE) return v.stopped;
    t->now = v;
    t->samples++;
    t->solved += v.solved;
    outputs_row(&t->base, r,
                (double[COLUMNS]){[XX] = v.K[0][0],
                                  [YY] = v.K[1][1],
                                  [ZZ] = v.K[2][2],
                                  [XY] = v.K[0][1],
                                  [XZ] = v.K[0][2],
                                  [YZ] = v.K[1][2],
                                  [XX_MD] = md(v.K[0][0]),
                                  [YY_MD] = md(v.K[1][1]),
                                  [ZZ_MD] = md(v.K[2][2]),
                                  [APPARENT] = deposit_measure(r).permeability,
                                  [POROSITY] = v.porosity,
                                  [ERROR] = v.error,
                                  [SOLVED] = v.solved,
                                  [ITERATIONS] = (double)v.iterations,
                                  [PRODUCTS] = (double)v.products});
    return SIGNALS_NONE;
}

/* A run that was stopped in a sample has no row of it: whether that of the step that it goes on from is missing. */
static int is_missing(const struct intrinsic *t, const struct run *r, const char *path) {
    double last = -1;
    struct table_data *d = par_rank() == 0 ? table_read(path, NULL) : NULL;
    if (d && d->rows > 0) last = d->value[(d->rows - 1) * d->columns + STEP];
    table_read_free(d);
    return r->step > 0 && r->stage_step > 0 && (r->step % t->base.every == 0 || stage_has_ended(r)) &&
           par_max(last) < (double)r->step;
}

static void open(void *self, struct run *r, const char *folder, long resume_step) {
    struct intrinsic *t = self;
    char path[FOLDER_PATH];
    if (resume_step < 0 || !is_missing(t, r, folder_path(path, folder, "intrinsic.csv"))) return;
    measure(t, r); /* within the set-up no signal gives it up: it ends the program */
    medium_intrinsic_reset(t->medium);
}

static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    struct intrinsic *t = self;
    clock_begin(CLOCK_PERMEABILITY);
    m->found->stopped = measure(t, r);
    if (m->found->stopped != SIGNALS_NONE)
        log_line("the sample of the intrinsic permeability at step %ld is given up; a resumed run takes it", r->step);
    if (m->stage_ends) medium_intrinsic_reset(t->medium); /* the stage's checkpoint */
    clock_end(CLOCK_PERMEABILITY);
}

/* A checkpoint does not hold the last solutions: the run that goes on forgets them as the one that resumes. */
static void flush(void *self, struct run *r) {
    (void)r;
    medium_intrinsic_reset(((struct intrinsic *)self)->medium);
}

/* One axis: its k, or what takes its place. */
static void axis_text(char text[96], const struct medium_intrinsic_values *v, int c) {
    const double k = v->K[c][c];
    if (isinf(k))
        snprintf(text, 96, "%c infinite: nothing resists the flow", "xyz"[c]);
    else if (!v->percolates[c])
        snprintf(text, 96, "%c 0: no pores lead through", "xyz"[c]);
    else
        snprintf(text, 96, "%c %.4g m2 (%.4g mD)", "xyz"[c], k, md(k));
}

static void report(const void *self, const struct run *r) {
    const struct intrinsic *t = self;
    char text[3][96];
    clock_count();
    const double seconds = clock_seconds(CLOCK_PERMEABILITY), all = par_seconds() - r->wall_start;
    if (t->samples == 0) return;
    for (int c = 0; c < 3; c++) axis_text(text[c], &t->now, c);
    log_line("stage %s: intrinsic permeability along %s, %s, %s", r->scene->stage[r->stage].name, text[0], text[1],
             text[2]);
    log_line("intrinsic permeability: %ld samples, %ld solutions, %.3g s, %.2g %% of the run's time", t->samples,
             t->solved, seconds, 100 * seconds / all);
}

static void free_intrinsic(void *self) { medium_intrinsic_free(((struct intrinsic *)self)->medium); }

const struct output output_intrinsic = {
    .file = {"intrinsic.csv"},
    .columns = "step 1|t s|k_xx m2|k_yy m2|k_zz m2|k_xy m2|k_xz m2|k_yz m2|k_xx_md mD|k_yy_md mD|k_zz_md mD|apparent "
               "m2|porosity 1|error 1|solved 1|iterations 1|products 1",
    .bytes = sizeof(struct intrinsic),
    .when = OUTPUTS_EVERY | OUTPUTS_STAGE,
    .begin = begin,
    .open = open,
    .sample = sample,
    .free = free_intrinsic,
    .flush = flush,
    .report = report,
};
