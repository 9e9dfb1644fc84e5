/* frana calibrate: makes small scenes of a scene's materials, runs them in one process, and reports what was measured.
 */
#include "program/calibrate/calibrate.h"
#include "base/die.h"
#include "base/par.h"
#include "base/text.h"
#include "coupling/setup/setup.h"
#include "base/files/atomic_write.h"
#include "base/files/folder.h"
#include "physics/bond.h"
#include "physics/dilatation.h"
#include "program/calibrate/measure.h"
#include "program/calibrate/report.h"
#include "program/calibrate/scenes.h"
#include "program/run/status.h"
#include "program/run/run.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Energy stored in a strip ahead of the crack, over G0: the next one where the crack stops. */
enum { STORED = 3 };
static const double stored_running[STORED] = {1.5, 1.9, 2.4}, stored_damped[STORED] = {1.3, 1.6, 2};

struct calibrate {
    const struct command *command;
    const struct scene *scene;
    double start;                   /* s, of the clock */
    int material;                   /* the present one */
    char *folder;                   /* of its scenes and runs; owned */
    struct calibrate_sample sample; /* of it */
    struct calibrate_rows rows;
};

static struct calibrate_sample sample_of(const struct scene *s, int m, int quick) {
    const struct scene_material *k = &s->solid->material[m];
    struct calibrate_sample sample = {.model = s->solid->model,
                                      .micromodulus = k->micromodulus,
                                      .correction = s->solid->surface_correction,
                                      .partial = s->solid->partial_volume,
                                      .m = k->horizon_ratio,
                                      .ratio_excess =
                                          physics_dilatation_ratio_excess(s->solid->model, k->poisson_ratio),
                                      .quick = quick};
    if (k->breakage == SCENE_BILINEAR)
        sample.length =
            k->youngs_modulus * k->fracture_energy / (k->tensile_strength * k->tensile_strength) / s->solid->spacing;
    return sample;
}

static int is_same(const struct calibrate_sample *a, const struct calibrate_sample *b) {
    return a->model == b->model && a->micromodulus == b->micromodulus && a->correction == b->correction &&
           a->partial == b->partial && a->m == b->m && a->length == b->length && a->ratio_excess == b->ratio_excess;
}

/* The folder of a material; those whose bonds are alike share that of the first one. */
static char *folder_of(const struct calibrate *t) {
    int first = t->material;
    for (int k = t->material - 1; k >= 0; k--) {
        const struct calibrate_sample other = sample_of(t->scene, k, t->sample.quick);
        if (isfinite(t->scene->solid->material[k].fracture_energy) && is_same(&other, &t->sample)) first = k;
    }
    char *folder = text_new("%s/%s", t->command->out, t->scene->solid->material[first].name);
    for (char *at = folder + strlen(t->command->out) + 1; *at; at++)
        if (!isalnum((unsigned char)*at) && !strchr("-_.", *at)) *at = '_';
    return folder;
}

/* Writes the scene beside its run folder, and runs it unless the folder holds that run already. Returns the exit code.
 */
static int run(const struct calibrate *t, const struct calibrate_scene *c, const char *name, char *folder) {
    struct command one = *t->command;
    char path[FOLDER_PATH];
    if ((size_t)snprintf(folder, sizeof one.out, "%s/%s", t->folder, name) >= sizeof one.out - 8)
        die_all(EXIT_CODE_FILE, "%s/%s: the path is too long", t->folder, name);
    snprintf(path, sizeof path, "%s.yaml", folder);
    if (par_rank() == 0) {
        struct atomic_write a;
        atomic_write_begin(&a, path);
        a.unsynced = 1;
        calibrate_scenes_write(a.file, c);
        atomic_write_end(&a);
    }
    par_barrier();
    struct scene *scene = scene_new(path, 0, NULL);
    setup_check(scene);
    const enum run_status status = run_status_of(folder, scene);
    if (status == RUN_STATUS_OTHER_SCENE && !t->command->fresh)
        die_all(EXIT_CODE_FILE, "%s holds a run of another scene: --fresh makes it again, --out DIR writes elsewhere",
                folder);
    int code = EXIT_CODE_DONE;
    if (status != RUN_STATUS_DONE || t->command->fresh) {
        one.resume = status == RUN_STATUS_RESUMABLE && !t->command->fresh;
        one.quiet = 1;
        if (status != RUN_STATUS_NONE && !one.resume) folder_clear(folder);
        snprintf(one.out, sizeof one.out, "%s", folder);
        if (t->command->max_wall > 0) one.max_wall = fmax(t->command->max_wall - (par_seconds() - t->start), 1e-3);
        code = program_run(&one, scene);
    }
    scene_free(scene);
    return code;
}

static const struct scene_material *material_of(const struct calibrate *t) {
    return &t->scene->solid->material[t->material];
}

/* Adds a row to the table, and writes what is measured so far. */
static void add_row(struct calibrate *t, const char *quantity, double degrees, double value, const char *over,
                    double measured, const char *unit) {
    calibrate_report_add(&t->rows, (struct calibrate_row){t->material, quantity, degrees, value, over, measured, unit});
    if (par_rank() != 0) return;
    calibrate_report_csv(t->command->out, t->scene, &t->rows);
    if (!t->command->quiet) calibrate_report_print(t->scene, &t->rows.row[t->rows.n - 1]);
}

static void add_energy(struct calibrate *t, const char *quantity, double degrees, double value) {
    add_row(t, quantity, degrees, value, "G0", value * material_of(t)->fracture_energy, "J/m2");
}

/* Whether the crack has run through enough of its window; in a wedge it stops somewhere. */
static int has_run(const struct calibrate_scene *c, const struct calibrate_measure_crack *found) {
    const struct calibrate_sizes z = calibrate_sample_sizes(c);
    const double least = c->kind == CALIBRATE_CREEPING ? 2 * c->sample->m : 0.7 * (z.to - z.from);
    return found->samples >= 6 && found->reached >= z.from + least;
}

/* A crack through a strip. A run that does not end measures nothing. Returns the exit code. */
static int measure_strip(struct calibrate *t, enum calibrate_kind kind, double degrees) {
    const int damped = kind == CALIBRATE_DAMPED, creeping = kind == CALIBRATE_CREEPING;
    const char *const quantity = kind == CALIBRATE_RUNNING ? "running_crack" : "creeping_crack";
    struct calibrate_scene c = {&t->sample, kind, degrees, 1};
    struct calibrate_measure_crack found = {0};
    int done = 0;
    for (int k = 0; k < (creeping ? 1 : STORED) && !done; k++) {
        char folder[sizeof t->command->out], name[64];
        c.stored = creeping ? 1 : damped ? stored_damped[k] : stored_running[k];
        if (creeping)
            snprintf(name, sizeof name, "%s_%g", quantity, degrees);
        else
            snprintf(name, sizeof name, "%s_%g_held_%g", quantity, degrees, c.stored);
        const int code = run(t, &c, name, folder);
        if (code != EXIT_CODE_DONE && code != EXIT_CODE_UNSTABLE) return code;
        if (par_rank() == 0 && code == EXIT_CODE_DONE) found = calibrate_measure_crack(folder, &c);
        par_bcast(&found, sizeof found, 0);
        done = code == EXIT_CODE_DONE && has_run(&c, &found);
    }
    if (!done) found.balance = found.bonds = found.deflection = NAN;
    add_energy(t, quantity, degrees, damped ? found.bonds : found.balance);
    if (creeping) add_energy(t, "creeping_crack_bonds", degrees, found.bonds);
    if (!creeping) {
        const char *const stored = damped ? "creeping_crack_held" : "running_crack_held";
        add_energy(t, stored, degrees, done ? c.stored : NAN);
    }
    if (degrees != 0)
        add_row(t, damped || creeping ? "creeping_crack_turns" : "running_crack_turns", degrees, found.deflection,
                "deg", found.deflection, "deg");
    return EXIT_CODE_DONE;
}

/* The notch's energy release rate is the difference of the strain energies with notches longer and shorter by a
 * spacing. */
static int measure_notch(struct calibrate *t) {
    static const struct {
        enum calibrate_kind kind;
        const char *name;
    } part[] = {{CALIBRATE_SHORTER, "notch_shorter"}, {CALIBRATE_LONGER, "notch_longer"}};
    char folder[sizeof t->command->out];
    double energy[2] = {NAN, NAN};
    struct calibrate_measure_notch found = {NAN, NAN};
    struct calibrate_scene c = {&t->sample, CALIBRATE_NOTCHED, 0, 1};
    for (int k = 0; k < 2; k++) {
        c.kind = part[k].kind;
        const int code = run(t, &c, part[k].name, folder);
        if (code != EXIT_CODE_DONE && code != EXIT_CODE_UNSTABLE) return code;
        if (par_rank() == 0 && code == EXIT_CODE_DONE) energy[k] = calibrate_measure_energy(folder);
    }
    par_bcast(energy, sizeof energy, 0);
    const struct calibrate_sizes z = calibrate_sample_sizes(&c);
    const double rate = (energy[0] - energy[1]) / (2. * z.depth);
    if (rate > 0) {
        c.kind = CALIBRATE_NOTCHED;
        c.stored = sqrt(calibrate_sample_g0(&t->sample) / rate);
        const int code = run(t, &c, "notch", folder);
        if (code != EXIT_CODE_DONE && code != EXIT_CODE_UNSTABLE) return code;
        if (par_rank() == 0 && code == EXIT_CODE_DONE)
            found = calibrate_measure_notch(folder, &c, 0.5 * (energy[0] + energy[1]) / z.half_opening * c.stored);
        par_bcast(&found, sizeof found, 0);
    }
    const double g0 = material_of(t)->fracture_energy;
    add_row(t, "notch_first_bond", 0, found.first, "Griffith's load", found.first * found.first * g0, "J/m2");
    add_row(t, "notch_largest_load", 0, found.largest, "Griffith's load", found.largest * found.largest * g0, "J/m2");
    return EXIT_CODE_DONE;
}

static int measure_bar(struct calibrate *t) {
    char folder[sizeof t->command->out];
    const struct calibrate_scene c = {&t->sample, CALIBRATE_BAR, 0, 1};
    const struct scene_material *k = material_of(t);
    const struct calibrate_sample *s = &t->sample;
    const enum physics_model model = (enum physics_model)s->model;
    const enum physics_micromodulus law = (enum physics_micromodulus)s->micromodulus;
    const double g0 = calibrate_sample_g0(s);
    double strength = NAN;
    const int code = run(t, &c, "bar", folder);
    if (code != EXIT_CODE_DONE && code != EXIT_CODE_UNSTABLE) return code;
    if (par_rank() == 0 && code == EXIT_CODE_DONE) strength = calibrate_measure_strength(folder, &c);
    par_bcast(&strength, sizeof strength, 0);
    const double s0_sample = physics_bond_elastic(model, law, 1, 1, s->ratio_excess, g0, s->m).s0,
                 s0_scene = physics_bond_elastic(model, law, t->scene->solid->thickness, k->youngs_modulus,
                                                 s->ratio_excess, k->fracture_energy, s->m * t->scene->solid->spacing)
                                .s0;
    if (s->length > 0) {
        strength /= sqrt(g0 / s->length);
        add_row(t, "bar_strength", NAN, strength, "sigma_t", strength * k->tensile_strength, "Pa");
    } else {
        strength /= s0_sample;
        add_row(t, "bar_strength", NAN, strength, "E s0", strength * k->youngs_modulus * s0_scene, "Pa");
    }
    return EXIT_CODE_DONE;
}

/* Whether --only names the part, or is not given. */
static int is_wanted(const struct command *c, const char *part) {
    const size_t length = strlen(part);
    if (!c->only) return 1;
    for (const char *at = c->only; at; at = strchr(at, ',') ? strchr(at, ',') + 1 : NULL)
        if (!strncmp(at, part, length) && (at[length] == ',' || at[length] == '\0')) return 1;
    return 0;
}

/* Dies on a word of --only that is not the name of a part. */
static void check_only(const struct command *c) {
    static const char *const part[] = {"running", "creeping", "notch", "bar"};
    int words = 1, known = 0;
    if (!c->only) return;
    for (const char *at = c->only; *at; at++) words += *at == ',';
    for (int k = 0; k < 4; k++) known += is_wanted(c, part[k]);
    if (known != words)
        die_all(EXIT_CODE_SCENE, "--only %s: must be of running, creeping, notch and bar, each at most once", c->only);
}

/* All measurements of a material, the shortest first. Returns the exit code. */
static int measure_material(struct calibrate *t) {
    static const double all[] = {0, 15, 30, 45};
    const int space = t->sample.model == PHYSICS_3D, quick = t->sample.quick;
    const enum calibrate_kind creeping = t->sample.length > 0 ? CALIBRATE_DAMPED : CALIBRATE_CREEPING;
    int code = is_wanted(t->command, "bar") ? measure_bar(t) : EXIT_CODE_DONE;
    if (code == EXIT_CODE_DONE && is_wanted(t->command, "notch")) code = measure_notch(t);
    for (int k = 0; k < 4 && code == EXIT_CODE_DONE && is_wanted(t->command, "running"); k++)
        if (all[k] == 0 || (!space && !quick) || (all[k] == 45 && !(space && quick)))
            code = measure_strip(t, CALIBRATE_RUNNING, all[k]);
    for (int k = 0; k < 4 && code == EXIT_CODE_DONE && is_wanted(t->command, "creeping"); k++)
        if (all[k] == 0 || (all[k] == 45 && !space && !quick)) code = measure_strip(t, creeping, all[k]);
    return code;
}

static void report(const struct calibrate *t) {
    char path[FOLDER_PATH];
    struct atomic_write a;
    if (par_rank() != 0) return;
    atomic_write_begin(&a, folder_path(path, t->command->out, "calibration.txt"));
    calibrate_report_page(a.file, t->scene, &t->rows);
    atomic_write_end(&a);
    if (!t->command->quiet) fputc('\n', stdout);
    if (!t->command->quiet) calibrate_report_page(stdout, t->scene, &t->rows);
    printf("%s/calibration.csv, calibration.txt\n", t->command->out);
}

int calibrate_run(const struct command *c, const struct scene *scene) {
    struct calibrate t = {.command = c, .scene = scene, .start = par_seconds()};
    int code = EXIT_CODE_DONE, measured = 0;
    if (!scene->solid) die_all(EXIT_CODE_SCENE, "frana calibrate: needs a scene with a solid");
    check_only(c);
    for (t.material = 0; t.material < scene->solid->materials && code == EXIT_CODE_DONE; t.material++) {
        if (!isfinite(material_of(&t)->fracture_energy)) continue;
        measured++;
        t.sample = sample_of(scene, t.material, c->quick);
        t.folder = folder_of(&t);
        if (par_rank() == 0 && folder_make_path(t.folder) != 0)
            die(EXIT_CODE_FILE, "%s: the folder cannot be made", t.folder);
        code = measure_material(&t);
        free(t.folder);
    }
    if (measured == 0)
        die_all(EXIT_CODE_SCENE, "frana calibrate: no material of the scene has a fracture_energy: nothing breaks");
    if (code == EXIT_CODE_DONE) report(&t);
    if (code == EXIT_CODE_REQUEUE && par_rank() == 0)
        fprintf(stderr, "frana: calibrate: stopped before its last sample: the same command goes on\n");
    free(t.rows.row);
    return code;
}
