/* The tensor of permeability of creeping flow on two grids. */
#include "program/permeability/creeping.h"
#include "base/die.h"
#include "base/par.h"
#include "base/print.h"
#include "base/signals.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"
#include "base/files/log.h"
#include "coupling/setup/forecast.h"
#include "coupling/setup/pores.h"
#include "program/permeability/fields.h"
#include "program/permeability/result.h"

#include <math.h>
#include <stdio.h>

#define MEMORY_PART 0.8 /* of the machine's memory may be used */

static enum signals_reason reason;

static int stops(void *with) {
    (void)with;
    if (reason == SIGNALS_NONE) reason = signals_stop(0);
    return reason != SIGNALS_NONE;
}

static void print_axis(const struct permeability_level *l, int axis) {
    char text[64] = "no pores lead through";
    if (axis == 0) log_line("  %ld of the pore cells are in pieces that lead through", l->through);
    if (l->percolates[axis]) snprintf(text, sizeof text, "k = %.6g m2", l->K[axis][axis]);
    log_line("  along %c: %s; %d iterations, %ld products, %.3g s", "xyz"[axis], text, l -> effort[axis].outer,
             l->effort[axis].products, l->effort[axis].seconds);
}

/* Whether the pores of a grid `finer` times as fine as the scene's fit in memory; says it if not. Collective. */
static int fits(const struct permeability_level *l, int finer) {
    const double needed = pow(finer, 3) * permeability_level_bytes(l), has = par_min(forecast_share()) * par_size();
    if (needed < MEMORY_PART * has) return 1;
    log_line("a grid %d times as fine takes %.3g GB, more than there is: no %s", finer, 1e-9 * needed,
             finer == 2 ? "error of the grid" : "third grid");
    return 0;
}

static void write_files(const struct command *c, const struct scene *s, const struct permeability_result *r) {
    char path[FOLDER_PATH];
    struct atomic_write a;
    if (par_rank() != 0) return;
    atomic_write_begin(&a, folder_path(path, c->out, "scene.resolved.yaml"));
    fputs(s->resolved, a.file);
    atomic_write_end(&a);
    atomic_write_begin(&a, folder_path(path, c->out, "permeability.csv"));
    permeability_result_csv(a.file, r);
    atomic_write_end(&a);
    atomic_write_begin(&a, folder_path(path, c->out, "permeability.txt"));
    permeability_result_page(a.file, s, r);
    atomic_write_end(&a);
    if (!c->quiet) permeability_result_page(stdout, s, r);
    const char *missing = c->fields ? permeability_fields_draw(c->out, s, r->level[0].written) : NULL;
    if (missing) fprintf(stderr, "frana: %s: %s\n", c->out, missing);
    printf("%s/permeability.csv, permeability.txt%s\n", c->out, c->fields ? ", fields, pictures" : "");
}

static void make_folder(const char *folder) {
    int failed = par_rank() == 0 ? folder_make_path(folder) : 0;
    par_bcast(&failed, sizeof failed, 0);
    if (failed) die_all(EXIT_CODE_FILE, "%s: cannot be made", folder);
}

int permeability_creeping_run(const struct command *c, const struct scene *scene,
                              const struct permeability_drive *drive) {
    struct permeability_result r = {.drive = *drive};
    signals_begin(c->max_wall);
    reason = SIGNALS_NONE;
    signals_at_once(2);
    log_begin(NULL, c->quiet, 0);
    if (c->fields) permeability_fields_begin(c->out);
    r.of_voxels = setup_pores_are_voxels(scene);
    permeability_level_measure(scene, drive, 1, !r.of_voxels, c->fields ? c->out : NULL, stops, print_axis,
                               &r.level[r.levels++]);
    if (!c->quick && !stops(NULL) && fits(&r.level[0], 2))
        permeability_level_measure(scene, drive, 2, !r.of_voxels, NULL, stops, print_axis, &r.level[r.levels++]);
    permeability_result_make(scene, &r);
    if (r.levels == 2 && !stops(NULL) && permeability_result_is_rough(&r) && fits(&r.level[0], 3))
        permeability_level_measure(scene, drive, 3, !r.of_voxels, NULL, stops, print_axis, &r.level[r.levels++]);
    if (!c->quick && r.of_voxels && !stops(NULL)) {
        log_line("the voxels as the stairs of a smooth solid");
        permeability_level_measure(scene, drive, 1, 1, NULL, stops, print_axis, &r.smooth);
        r.has_smooth = 1;
    }
    log_end();
    if (reason != SIGNALS_NONE) {
        print("stopped by %s: nothing is kept of a permeability that is not finished\n", signals_name(reason));
        return EXIT_CODE_REQUEUE;
    }
    signals_at_once(0);
    permeability_result_make(scene, &r);
    make_folder(c->out);
    write_files(c, scene, &r);
    return EXIT_CODE_DONE;
}
