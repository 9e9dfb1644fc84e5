/* Writes the fluid's and the solid's fields for ParaView. */
#include "coupling/interface/deposit.h"
#include "program/output/outputs.h"
#include "base/clock.h"
#include "base/memory.h"
#include "base/par.h"
#include "cracks/measure.h"
#include "base/files/folder.h"
#include "base/files/vtkhdf.h"
#include "solid/bonds/ghosts.h"
#include "solid/measure/damage.h"
#include "solid/measure/energy.h"
#include "solid/measure/fragments.h"
#include "solid/measure/stress.h"
#include "solid/measure/tensors.h"
#include "solid/refine/refine.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* Velocity at cell centres: the mean of the two faces.  [m_z][m_y][m_x][3] m/s */
static void centre_velocity(const struct fluid_grid *g, const struct fluid_state *q, double *out) {
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++, out += 3) {
                const size_t at = fluid_grid_at(g, i, j, k);
                out[0] = 0.5 * (q->u[at - 1] + q->u[at]);
                out[1] = 0.5 * (q->v[at - (size_t)g->row] + q->v[at]);
                out[2] = 0.5 * (q->w[at - (size_t)g->plane] + q->w[at]);
            }
}

/* Copies the cells of an array without its ghosts. */
static void inside(const struct fluid_grid *g, const double *a, double *out) {
    for (int k = 0; k < g->m[2]; k++)
        for (int j = 0; j < g->m[1]; j++)
            for (int i = 0; i < g->m[0]; i++) *out++ = a[fluid_grid_at(g, i, j, k)];
}

static void write_fluid(struct run *r, const char *folder, const char *name, const char *path) {
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    const struct fluid_state *q = fluid_state_of(r->fluid);
    const size_t cells = (size_t)g->m[0] * (size_t)g->m[1] * (size_t)g->m[2];
    double *work = memory_new(MEMORY_OUTPUT, 3 * cells + 1, sizeof *work);
    struct vtkhdf_image_input in = {.path = path, .time = r->t, .step = r->step};
    for (int c = 0; c < 3; c++) {
        in.n[c] = g->n[c];
        in.origin[c] = 0.5 * g->d[c];
        in.spacing[c] = g->d[c];
        in.lo[c] = g->lo[c];
        in.m[c] = g->m[c];
    }
    struct vtkhdf *f = vtkhdf_image_begin(&in);
    centre_velocity(g, q, work);
    vtkhdf_add(f, "velocity", 3, work);
    inside(g, q->p, work);
    vtkhdf_add(f, "pressure", 1, work);
    if (r->medium) {
        deposit_update(r);
        inside(g, medium_fraction(r->medium), work);
        vtkhdf_add(f, "solid_fraction", 1, work);
    }
    vtkhdf_end(f);
    memory_free(work);
    char series[FOLDER_PATH];
    vtkhdf_series_add(folder_path(series, folder, "fields/fluid.hdf.series"), name, r->t);
}

/* Adds a vector field; the third component in a plate is 0. */
static void add_vector(struct vtkhdf *f, const char *name, int n, double *const a[3], double *work) {
    for (int h = 0; h < n; h++)
        for (int c = 0; c < 3; c++) work[3 * h + c] = a[c] ? a[c][h] : 0;
    vtkhdf_add(f, name, 3, work);
}

/* work [n][3] */
static void add_stress(struct vtkhdf *f, int n, double (*t)[6], double *work) {
    double(*principal)[3] = (double(*)[3])(void *)work;
    solid_tensors_sorted(n, t, principal);
    vtkhdf_add(f, "stress", 6, &t[0][0]);
    vtkhdf_add(f, "stress_principal", 3, work);
    for (int h = 0; h < n; h++) work[h] = principal[h][0];
    vtkhdf_add(f, "stress_max", 1, work);
    for (int h = 0; h < n; h++) work[h] = solid_tensors_von_mises(t[h]);
    vtkhdf_add(f, "von_mises", 1, work);
}

static void add_strain(struct vtkhdf *f, int n, double (*t)[6], double *work) {
    solid_tensors_largest(n, t, work);
    vtkhdf_add(f, "strain", 6, &t[0][0]);
    vtkhdf_add(f, "strain_max", 1, work);
}

static void write_solid(struct run *r, const char *folder, const char *name, const char *path) {
    struct solid *s = r->solid;
    const int n = s->n;
    double *work = memory_new(MEMORY_OUTPUT, 3 * (size_t)n + 1, sizeof *work);
    int64_t *whole = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *whole);
    uint8_t *byte = memory_new(MEMORY_OUTPUT, (size_t)n + 1, 1);
    double(*tensor)[6] = memory_new(MEMORY_OUTPUT, (size_t)n + 1, sizeof *tensor);
    for (int h = 0; h < n; h++) solid_position(s, h, work + 3 * h);
    const struct vtkhdf_points_input in = {
        .path = path, .time = r->t, .step = r->step, .n = n, .x = (const double(*)[3])(const void *)work};
    struct vtkhdf *f = vtkhdf_points_begin(&in);
    for (int h = 0; h < n; h++) whole[h] = s->first[par_rank()] + h;
    vtkhdf_add_long(f, "id", 1, whole);
    vtkhdf_add_byte(f, "body", 1, s->body);
    if (s->material) vtkhdf_add_byte(f, "material", 1, s->material);
    for (int h = 0; h < n; h++) byte[h] = (s->flag[h] & SOLID_INTERFACE) != 0;
    if (r->surface) vtkhdf_add_byte(f, "interface", 1, byte);
    for (int h = 0; h < n; h++) byte[h] = (s->flag[h] & (SOLID_HELD_X | SOLID_HELD_Y | SOLID_HELD_Z)) != 0;
    vtkhdf_add_byte(f, "held", 1, byte);
    if (r->needs.bonds) {
        add_vector(f, "displacement", n, s->d, work);
        add_vector(f, "velocity", n, s->v, work);
        add_vector(f, "load", n, s->load, work);
        solid_damage_measure(s, work);
        vtkhdf_add(f, "damage", 1, work);
        solid_fragments_measure(s, whole, NULL);
        vtkhdf_add_long(f, "fragment", 1, whole);
    }
    for (int k = 0; r->cracks && k < CRACKS_FIELDS; k++) {
        cracks_measure_field(r->cracks, k, work);
        vtkhdf_add(f, cracks_measure_field_name[k], 1, work);
    }
    if (r->needs.bonds && !r->fluid) {
        solid_ghosts_update(s);
        solid_energy_bonds(s, work, work + n);
        vtkhdf_add(f, "energy_density", 1, work);
        vtkhdf_add(f, "stretch_max", 1, work + n);
    }
    if (!r->fluid) vtkhdf_add(f, "volume", 1, s->volume);
    for (int h = 0; s->refine && h < n; h++) byte[h] = (uint8_t)solid_refine_level(s, h);
    if (s->refine) vtkhdf_add_byte(f, "level", 1, byte);
    if (r->needs.bonds && r->scene->output.stress) {
        solid_stress_measure(s, tensor);
        add_stress(f, n, tensor, work);
        solid_stress_strain(s, tensor);
        add_strain(f, n, tensor, work);
    }
    vtkhdf_end(f);
    MEMORY_FREE(tensor, byte, whole, work);
    char series[FOLDER_PATH];
    vtkhdf_series_add(folder_path(series, folder, "fields/solid.hdf.series"), name, r->t);
}

struct fields {
    struct outputs_base base;
    const char *folder; /* borrowed */
};

static int begin(void *self, struct run *r) {
    (void)self, (void)r;
    return 1;
}

/* A resumed run drops the files later than its time from the lists. */
static void open(void *self, struct run *r, const char *folder, long resume_step) {
    char path[FOLDER_PATH];
    ((struct fields *)self)->folder = folder;
    if (resume_step < 0) return;
    if (r->fluid) vtkhdf_series_cut(folder_path(path, folder, "fields/fluid.hdf.series"), r->t);
    if (r->solid) vtkhdf_series_cut(folder_path(path, folder, "fields/solid.hdf.series"), r->t);
}

static void sample(void *self, struct run *r, const struct outputs_moment *m) {
    const char *folder = ((const struct fields *)self)->folder;
    char name[64], file[128], path[FOLDER_PATH];
    (void)m;
    clock_begin(CLOCK_FIELDS);
    if (r->fluid) {
        snprintf(name, sizeof name, "fluid_%08ld.hdf", r->step);
        snprintf(file, sizeof file, "fields/%s", name);
        write_fluid(r, folder, name, folder_path(path, folder, file));
    }
    if (r->solid) {
        snprintf(name, sizeof name, "solid_%08ld.hdf", r->step);
        snprintf(file, sizeof file, "fields/%s", name);
        write_solid(r, folder, name, folder_path(path, folder, file));
    }
    clock_end(CLOCK_FIELDS);
}

const struct output output_fields = {
    .bytes = sizeof(struct fields), .when = OUTPUTS_FIELDS, .begin = begin, .open = open, .sample = sample};
