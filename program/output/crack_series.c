/* Writes crack.csv: tips, speed, length and released energy of the crack during the run; and crack_particles.csv: when
 * which particle of a plate was first damaged. */
#include "program/output/outputs.h"
#include "program/output/crack_particles.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/files/folder.h"
#include "solid/measure/crack_track.h"
#include "solid/measure/damage.h"

#include <math.h>

/* clang-format off */
enum { STEP, T, TIP, SPEED = TIP + 2, LEFT, LEFT_SPEED = LEFT + 2, RIGHT, RIGHT_SPEED = RIGHT + 2, FRONTS, LENGTH,
       RELEASED, PER_AREA, OVER_G0, COLUMNS };
/* clang-format on */

struct crack {
    struct outputs_base base;
    const struct scene_crack_output *scene; /* borrowed */
    double direction[2], axis[2];
    double thickness, g0;                 /* of a plate, m, else NAN; the least of all materials, J/m2 */
    struct solid_crack_particles initial; /* damaged before the first step */
    int has_axis;
    struct solid_crack_track *track;
    struct crack_particles *particles; /* NULL: a body in 3D */
    double *damage;                    /* [capacity], work */
    int capacity;
};

static void damage_of(struct crack *c, struct run *r) {
    if (r->solid->n > c->capacity) {
        memory_free(c->damage);
        c->capacity = r->solid->n;
        c->damage = memory_new(MEMORY_OUTPUT, (size_t)c->capacity, sizeof *c->damage);
    }
    solid_damage_measure(r->solid, c->damage);
}

static int begin(void *self, struct run *r) {
    const struct scene_crack_output *scene = r->scene->output.crack;
    struct crack *c = self;
    if (!scene || !r->needs.bonds) return 0;
    c->base.every = scene->every;
    c->base.rows = 1;
    const struct solid_input *in = &r->solid->in;
    const double length = hypot(scene->direction[0], scene->direction[1]);
    c->scene = scene;
    for (int k = 0; k < 2; k++) c->direction[k] = scene->direction[k] / length;
    c->thickness = r->solid->dim == 2 ? in->thickness : NAN;
    c->g0 = INFINITY;
    for (int m = 0; m < in->materials; m++) {
        c->g0 = fmin(c->g0, in->material[m].fracture_energy);
        if (in->limit && in->limit[m].s00 > 0) c->g0 = fmin(c->g0, in->limit[m].fracture_energy);
    }
    damage_of(c, r);
    c->initial = solid_crack_gather(r->solid, c->damage, scene->damage, c->direction);
    const struct solid_crack_tips tips = solid_crack_tips_of(&c->initial, &c->initial, c->direction, NULL);
    c->has_axis = tips.found;
    for (int k = 0; k < 2; k++) c->axis[k] = tips.tip[k];
    c->track = solid_crack_track_new(scene->window, in->spacing);
    return 1;
}

/* Reads the tips' earlier positions from the table, on all ranks. */
static void read_earlier_tips(struct crack *c, const char *path) {
    struct table_data *d = par_rank() == 0 ? table_read(path, NULL) : NULL;
    long rows = d ? d->rows : 0;
    par_bcast(&rows, sizeof rows, 0);
    if (rows > 0) {
        double *value = memory_new(MEMORY_OUTPUT, (size_t)rows * COLUMNS, sizeof *value);
        for (long i = 0; d && i < rows * COLUMNS; i++) value[i] = d->value[i];
        par_bcast(value, (size_t)rows * COLUMNS * sizeof *value, 0);
        for (long i = 0; i < rows; i++) {
            const double *row = value + i * COLUMNS;
            const struct solid_crack_tips tips = {.found = !isnan(row[TIP]),
                                                  .tip = {row[TIP], row[TIP + 1]},
                                                  .side = {{row[LEFT], row[LEFT + 1]}, {row[RIGHT], row[RIGHT + 1]}}};
            if (!c->has_axis && tips.found)
                for (int k = 0; k < 2; k++) c->axis[k] = tips.tip[k];
            c->has_axis |= tips.found;
            solid_crack_track_add(c->track, row[T], &tips, c->direction);
        }
        memory_free(value);
    }
    table_read_free(d);
}

/* The tips as a resumed run reads them from the table: so its speeds are those of an uninterrupted one. */
static struct solid_crack_tips as_written(struct solid_crack_tips tips) {
    for (int k = 0; k < 2; k++) {
        tips.tip[k] = table_written(tips.tip[k]);
        for (int side = 0; side < SOLID_CRACK_SIDES; side++) tips.side[side][k] = table_written(tips.side[side][k]);
    }
    return tips;
}

/* Measures and appends a row. */
static void sample(void *self, struct run *r, const struct outputs_moment *now) {
    struct crack *c = self;
    (void)now;
    damage_of(c, r);
    struct solid_crack_particles p = solid_crack_gather(r->solid, c->damage, c->scene->damage, c->direction);
    const struct solid_crack_tips tips =
        as_written(solid_crack_tips_of(&p, &c->initial, c->direction, c->has_axis ? c->axis : NULL));
    if (c->particles) crack_particles_sample(c->particles, &p, r->step, r->t);
    solid_crack_particles_free(&p);
    if (!c->has_axis && tips.found)
        for (int k = 0; k < 2; k++) c->axis[k] = tips.tip[k];
    c->has_axis |= tips.found;
    const struct solid_crack_motion m = solid_crack_track_add(c->track, table_written(r->t), &tips, c->direction);
    const double released = par_sum(r->solid->e_fracture);
    const double per_area = m.length > 0 ? released / (m.length * c->thickness) : NAN;
    double row[COLUMNS] = {[SPEED] = m.speed,
                           [LEFT_SPEED] = m.side[SOLID_CRACK_LEFT],
                           [RIGHT_SPEED] = m.side[SOLID_CRACK_RIGHT],
                           [FRONTS] = tips.fronts,
                           [LENGTH] = m.length,
                           [RELEASED] = released,
                           [PER_AREA] = per_area,
                           [OVER_G0] = isfinite(c->g0) ? per_area / c->g0 : NAN};
    for (int k = 0; k < 2; k++) {
        row[TIP + k] = tips.tip[k];
        row[LEFT + k] = tips.side[SOLID_CRACK_LEFT][k];
        row[RIGHT + k] = tips.side[SOLID_CRACK_RIGHT][k];
    }
    outputs_row(&c->base, r, row);
}

static void open(void *self, struct run *r, const char *folder, long resume_step) {
    struct crack *c = self;
    char path[FOLDER_PATH];
    if (r->solid->dim == 2) {
        damage_of(c, r);
        struct solid_crack_particles p = solid_crack_gather(r->solid, c->damage, c->scene->damage, c->direction);
        c->particles = crack_particles_new(folder, &p, r->solid->in.spacing, resume_step);
        solid_crack_particles_free(&p);
    }
    if (resume_step >= 0) read_earlier_tips(c, folder_path(path, folder, "crack.csv"));
}

static void free_crack(void *self) {
    struct crack *c = self;
    crack_particles_free(c->particles);
    solid_crack_track_free(c->track);
    solid_crack_particles_free(&c->initial);
    memory_free(c->damage);
}

const struct output output_crack_series = {
    .file = {"crack.csv", "crack_particles.csv"},
    .columns = "step 1|t s|tip_x m|tip_y m|speed m/s|left_x m|left_y m|left_speed m/s|right_x m|right_y m|right_speed "
               "m/s|fronts 1|length m|e_fracture J|energy_per_area J/m2|energy_over_g0 1",
    .bytes = sizeof(struct crack),
    .when = OUTPUTS_EVERY,
    .first = 1,
    .begin = begin,
    .open = open,
    .sample = sample,
    .free = free_crack,
};
