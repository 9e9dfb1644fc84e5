/* The tensor of permeability by time steps: three runs, along x, y and z, until each is steady. */
#include "program/permeability/stepped.h"
#include "base/die.h"
#include "base/par.h"
#include "base/side.h"
#include "base/text.h"
#include "coupling/run.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"
#include "base/files/table.h"
#include "physics/darcy.h"
#include "program/run/status.h"
#include "program/run/run.h"
#include "scene/medium.h"
#include "scene/text/yaml.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { SETS = 16 }; /* of a run beyond the user's */

/* What a run has measured. */
struct measured {
    double k, velocity[3], tortuosity, reynolds, steps; /* NaN: not measured */
    int steady;                                         /* -1: its last stage does not wait */
};

/* A side as the scene's text. */
static char *side_text(int d, int e, const struct scene_side *side) {
    static const char *const word[] = {[FLUID_PERIODIC] = "periodic", [FLUID_WALL] = "wall", [FLUID_SLIP] = "slip"};
    return side->type == FLUID_PRESSURE
               ? text_new("fluid.sides.%s={type: pressure, pressure: %.17g}", side_name[d][e], side->pressure)
               : text_new("fluid.sides.%s={type: %s}", side_name[d][e], word[side->type]);
}

/* The settings of the run along d, each malloc'ed; returns their number. */
static int sets_of(const struct scene *s, const struct permeability_drive *drive, int d, char *set[SETS]) {
    const struct scene_stage *last = &s->stage[s->stages - 1];
    double start[3] = {0, 0, 0};
    int n = 0;
    start[d] = drive->bulk ? drive->value : 0;
    set[n++] = text_new("fluid.initial={velocity: [%.17g, %.17g, %.17g]}", start[0], start[1], start[2]);
    set[n++] = text_new("fluid.body_force=[0, 0, 0]");
    set[n++] = text_new("coupling.medium.direction=%c", "xyz"[d]);
    if (drive->axis < 0)
        set[n++] = text_new("fluid.driving={type: %s, direction: %c, value: %.17g}",
                            drive->bulk ? "bulk_velocity" : "pressure_gradient", "xyz"[d], drive -> value);
    for (int c = 0; c < 3 && drive->axis >= 0; c++)
        for (int e = 0; e < 2; e++)
            set[n++] = side_text(c, e, &s->fluid->side[permeability_drive_sides(drive, d, c)][e]);
    if (!last->has_until)
        set[n++] = text_new("stages[%d].until={quantity: permeability, change: 1.0e-4}", s->stages - 1);
    if (s->output.series_every == 0) set[n++] = text_new("output.series_every=10");
    return n;
}

static double column_of(const struct table_data *t, const char *name) {
    const int c = table_read_column(t, name);
    return c < 0 || t->rows == 0 ? NAN : t->value[(t->rows - 1) * t->columns + c];
}

/* Rank 0 reads the last row of the run's series. */
static struct measured read_measured(const char *folder) {
    char path[FOLDER_PATH];
    const char *why;
    struct measured m = {.steady = -1};
    struct table_data *t = table_read(folder_path(path, folder, "series.csv"), &why);
    if (!t) die(EXIT_CODE_FILE, "%s: %s", path, why);
    m.k = column_of(t, "permeability");
    m.velocity[0] = column_of(t, "velocity_x");
    m.velocity[1] = column_of(t, "velocity_y");
    m.velocity[2] = column_of(t, "velocity_z");
    m.tortuosity = column_of(t, "tortuosity");
    m.reynolds = column_of(t, "reynolds_k");
    m.steps = column_of(t, "step");
    table_read_free(t);
    struct scene_node *root = scene_yaml_read(folder_path(path, folder, "run.json"));
    const struct scene_node *steady = root ? scene_node_child(root, "steady") : NULL;
    if (steady) m.steady = !strcmp(steady->value, "true");
    if (root) scene_node_free(root);
    return m;
}

/* The tensor's column along j. Parts across sides that let nothing through are not measured. */
static void set_column(const struct scene *s, const struct permeability_drive *drive, int j, const struct measured *m,
                       double K[3][3]) {
    for (int i = 0; i < 3; i++) {
        const int closed = s->fluid->side[permeability_drive_sides(drive, j, i)][0].type != FLUID_PERIODIC;
        K[i][j] = i == j ? m->k : closed ? NAN : m->k * m->velocity[i] / m->velocity[j];
    }
}

static void write_csv(const char *out, const double K[3][3], const struct physics_darcy_principal *p,
                      const struct measured m[3]) {
    char path[FOLDER_PATH];
    struct atomic_write a;
    atomic_write_begin(&a, folder_path(path, out, "permeability.csv"));
    fputs("quantity,value,unit\n", a.file);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) fprintf(a.file, "k_%c%c,%.15g,m2\n", "xyz"[i], "xyz"[j], K[i][j]);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            fprintf(a.file, "k_%c%c_md,%.15g,mD\n", "xyz"[i], "xyz"[j], 1e3 * K[i][j] / PHYSICS_DARCY);
    for (int q = 0; q < 3; q++) {
        fprintf(a.file, "principal_%d,%.15g,m2\n", q + 1, p->value[q]);
        fprintf(a.file, "principal_%d_md,%.15g,mD\n", q + 1, 1e3 * p->value[q] / PHYSICS_DARCY);
        for (int i = 0; i < 3; i++) fprintf(a.file, "principal_%d_%c,%.15g,1\n", q + 1, "xyz"[i], p -> along[q][i]);
    }
    fprintf(a.file, "asymmetry,%.15g,1\n", p->asymmetry);
    for (int j = 0; j < 3; j++) {
        fprintf(a.file, "tortuosity_%c,%.15g,1\n", "xyz"[j], m[j].tortuosity);
        fprintf(a.file, "reynolds_k_%c,%.15g,1\n", "xyz"[j], m[j].reynolds);
        fprintf(a.file, "steps_%c,%.15g,1\n", "xyz"[j], m[j].steps);
        fprintf(a.file, "steady_%c,%d,1\n", "xyz"[j], m[j].steady);
    }
    atomic_write_end(&a);
}

static void write_page(FILE *to, const struct scene *s, const struct permeability_drive *drive, const double K[3][3],
                       const struct physics_darcy_principal *p, const struct measured m[3]) {
    const char *const steady[] = {"not steady", "steady"};
    fprintf(to, "%s\n\nTensor of permeability, m2 (a column a run)\n%17s%15s%15s\n", s->title, "x", "y", "z");
    for (int i = 0; i < 3; i++) fprintf(to, "  %c%15.6g%15.6g%15.6g\n", "xyz"[i], K[i][0], K[i][1], K[i][2]);
    fprintf(to, "\nThe same in mD (1 D = 9.869233e-13 m2)\n");
    for (int i = 0; i < 3; i++) {
        fprintf(to, "  %c", "xyz"[i]);
        for (int j = 0; j < 3; j++) fprintf(to, "%15.6g", 1e3 * K[i][j] / PHYSICS_DARCY);
        fprintf(to, "\n");
    }
    if (isnan(p->value[0])) {
        fprintf(to, "\nNo principal values: parts off the diagonal are not measured across sides that let nothing "
                    "through\nor without a way through the sample.\n");
    } else {
        fprintf(to, "\nPrincipal values of the symmetric part, and their directions\n");
        for (int q = 0; q < 3; q++)
            fprintf(to, "  %d %14.6g m2 %14.6g mD   (%.4f, %.4f, %.4f)\n", q + 1, p->value[q],
                    1e3 * p->value[q] / PHYSICS_DARCY, p->along[q][0], p->along[q][1], p->along[q][2]);
        fprintf(to, "Asymmetry |K - K^T|/|K + K^T|: %.2g\n", p->asymmetry);
    }
    fprintf(to, "\nRuns\n");
    for (int j = 0; j < 3; j++)
        fprintf(to, "  %c  %s, %.0f steps, tortuosity %.5g, Reynolds number with the root of k %.3g\n", "xyz"[j],
                m[j].steady < 0 ? "left before its last stage" : steady[m[j].steady], m[j].steps, m[j].tortuosity,
                m[j].reynolds);
    if (drive->axis >= 0)
        fprintf(to,
                "The sides of given pressure along %c stood at the ends of each direction in turn; the sides of that "
                "direction\nstood along %c meanwhile.\n",
                "xyz"[drive->axis], "xyz"[drive->axis]);
}

/* Rank 0 writes permeability.csv and permeability.txt, and shows the text. */
static void report(const struct command *c, const struct scene *s, const struct permeability_drive *drive,
                   char *folder[3]) {
    struct measured m[3];
    double K[3][3];
    if (par_rank() != 0) return;
    struct physics_darcy_principal p = {.asymmetry = NAN};
    int whole = 1;
    for (int j = 0; j < 3; j++) {
        m[j] = read_measured(folder[j]);
        set_column(s, drive, j, &m[j], K);
    }
    for (int i = 0; i < 9; i++) whole &= isfinite(K[i / 3][i % 3]) != 0;
    for (int q = 0; q < 3; q++) p.value[q] = p.along[q][0] = p.along[q][1] = p.along[q][2] = NAN;
    if (whole) p = physics_darcy_principal_of((const double(*)[3])K);
    char path[FOLDER_PATH];
    struct atomic_write a;
    write_csv(c->out, (const double(*)[3])K, &p, m);
    atomic_write_begin(&a, folder_path(path, c->out, "permeability.txt"));
    write_page(a.file, s, drive, (const double(*)[3])K, &p, m);
    atomic_write_end(&a);
    if (!c->quiet) write_page(stdout, s, drive, (const double(*)[3])K, &p, m);
    printf("%s/permeability.csv, permeability.txt\n", c->out);
}

/* Dies on a sample whose pores are not connected along some direction, before the first run. */
static void check_connected(const struct scene *along_x) {
    struct run *r = run_new(along_x); /* this looks along x */
    for (int d = 1; d < 3; d++) {
        const double along[3] = {0, d == 1, d == 2};
        medium_along(r->medium, along);
        if (medium_connect_porosity(r->medium) == 0)
            die_all(EXIT_CODE_SCENE, "coupling.medium: no way through the medium along %c that the cells resolve",
                    "xyz"[d]);
    }
    run_free(r);
}

int permeability_stepped_run(const struct command *c, const struct scene *scene,
                             const struct permeability_drive *drive) {
    const double start = par_seconds();
    struct scene *along[3];
    char *folder[3];
    enum run_status status[3];
    int code = EXIT_CODE_DONE, missing = 0;
    for (int d = 0; d < 3; d++) { /* all scenes are read before the first run */
        char *extra[SETS];
        const int n = sets_of(scene, drive, d, extra);
        const char **set = calloc((size_t)(c->sets + n), sizeof *set);
        for (int k = 0; k < c->sets; k++) set[k] = c->set[k];
        for (int k = 0; k < n; k++) set[c->sets + k] = extra[k];
        along[d] = scene_new(c->file[0], c->sets + n, set);
        setup_check(along[d]);
        folder[d] = text_new("%s/%c", c->out, "xyz"[d]);
        for (int k = 0; k < n; k++) free(extra[k]);
        free(set);
        status[d] = run_status_of(folder[d], along[d]);
        if (status[d] == RUN_STATUS_OTHER_SCENE && !c->fresh)
            die_all(EXIT_CODE_FILE,
                    "%s holds a run of another scene: --fresh makes it again, --out DIR writes elsewhere", folder[d]);
        missing |= c->fresh || status[d] != RUN_STATUS_DONE;
    }
    if (missing) check_connected(along[0]);
    for (int d = 0; d < 3 && code == EXIT_CODE_DONE; d++) {
        struct command one = *c;
        if (status[d] == RUN_STATUS_DONE && !c->fresh) continue;
        one.resume = status[d] == RUN_STATUS_RESUMABLE && !c->fresh;
        if (status[d] != RUN_STATUS_NONE && !one.resume) folder_clear(folder[d]);
        snprintf(one.out, sizeof one.out, "%s", folder[d]);
        if (c->max_wall > 0) one.max_wall = fmax(c->max_wall - (par_seconds() - start), 1e-3);
        code = program_run(&one, along[d]);
    }
    if (code == EXIT_CODE_DONE) report(c, scene, drive, folder);
    for (int d = 0; d < 3; d++) {
        scene_free(along[d]);
        free(folder[d]);
    }
    return code;
}
