#include "solid/solid.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_exchange.h"
#include "solid/constraint.h"
#include "solid/contact.h"
#include "solid/family.h"
#include "solid/lattice.h"
#include "solid/list.h"
#include "solid/number.h"

#include <math.h>
#include <string.h>

static void *copy_of(const void *from, size_t n, size_t size) {
    void *to = memory_new(MEMORY_SOLID, n + 1, size);
    if (n) memcpy(to, from, n * size);
    return to;
}

/* The input with its own copies; the points of a body stay the caller's and are forgotten afterwards. */
static void input_copy(struct solid_input *to, const struct solid_input *from) {
    *to = *from;
    to->body = copy_of(from->body, (size_t)from->bodies, sizeof *from->body);
    to->material = copy_of(from->material, (size_t)from->materials, sizeof *from->material);
    to->constraint = copy_of(from->constraint, (size_t)from->constraints, sizeof *from->constraint);
    to->unbreakable = copy_of(from->unbreakable, (size_t)from->unbreakables, sizeof *from->unbreakable);
}

static void input_check(const struct solid_input *in) {
    if (!(in->spacing > 0)) die_all(EXIT_CODE_SCENE, "solid.spacing = %g: must be above 0", in->spacing);
    if (in->bodies < 1 || in->bodies > 255)
        die_all(EXIT_CODE_SCENE, "solid.bodies: %d of them; must be 1 to 255", in->bodies);
    for (int b = 0; b < in->bodies; b++) {
        const int m = in->body[b].material;
        if (m < 0 || m >= in->materials)
            die_all(EXIT_CODE_SCENE, "solid body %s: material %d of %d", in->body[b].name, m, in->materials);
    }
    for (int m = 0; m < in->materials; m++) {
        const struct solid_material *k = &in->material[m];
        if (!(k->youngs_modulus > 0) || !(k->density > 0) || !(k->fracture_energy >= 0) ||
            !(k->horizon_ratio >= 1))
            die_all(EXIT_CODE_SCENE,
                    "solid material %d: youngs_modulus %g and density %g must be above 0, fracture_energy %g "
                    "not below 0, "
                    "horizon_ratio %g at least 1 particle spacing",
                    m, k->youngs_modulus, k->density, k->fracture_energy, k->horizon_ratio);
    }
}

/* No site may belong to two bodies. */
static void overlap_check(const struct solid_input *in, struct solid_sites *const *sites) {
    for (int a = 0; a < in->bodies; a++)
        for (int b = a + 1; b < in->bodies; b++) {
            const struct solid_sites *t = sites[b];
            for (int q = 0; sites[a]->is_lattice && q < t->filled; q++) {
                const int row = t->order[q];
                for (int k = 0; k < 8; k++) {
                    const int site[3] = {t->low[0] + 8 * (row % t->rows[0]) + k,
                                         t->low[1] + row / t->rows[0] % t->rows[1],
                                         t->low[2] + row / t->rows[0] / t->rows[1]};
                    if ((t->bits[row] >> k & 1) && solid_sites_id(sites[a], site) >= 0)
                        die_all(EXIT_CODE_SCENE, "solid bodies %s and %s overlap", in->body[a].name,
                                in->body[b].name);
                }
            }
        }
}

static void family_new(struct solid *s, struct solid_sites *const *sites) {
    const struct solid_input *in = &s->in;
    struct solid_family *f = s->family;
    const long from = s->first[par_rank()], to = s->first[par_rank() + 1];
    f->lattice = memory_new(MEMORY_SOLID, (size_t)f->bodies, sizeof *f->lattice);
    f->list = memory_new(MEMORY_SOLID, (size_t)f->bodies, sizeof *f->list);
    f->first = memory_new(MEMORY_SOLID, (size_t)f->bodies + 1, sizeof *f->first);
    for (int b = 0; b < f->bodies; b++) {
        const struct solid_body *body = &in->body[b];
        const struct solid_material *m = &in->material[body->material];
        const double s0 = solid_critical_stretch(m, in->spacing);
        const struct solid_law law = {solid_micromodulus(m, in->spacing), m->density, s0 * (2 + s0)};
        const struct solid_stencil *stencil = f->stencil[body->material];
        if (sites[b]->is_lattice && !in->general_bonds) {
            f->lattice[b] = solid_lattice_new(sites[b], stencil, law, from, to, f->first[b]);
            f->first[b + 1] = f->first[b] + f->lattice[b]->n;
        } else {
            f->list[b] = solid_list_new(in, body, sites[b], stencil, law, from, to, f->first[b]);
            f->first[b + 1] = f->first[b] + f->list[b]->n;
        }
    }
    s->n = (int)(to - from);
    ENSURE(f->first[f->bodies] == s->n, "%d particles in the stores, %d owned", f->first[f->bodies], s->n);
}

static void ghosts_new(struct solid *s, struct solid_sites *const *sites) {
    struct solid_family *f = s->family;
    const long from = s->first[par_rank()], to = s->first[par_rank() + 1];
    long n = 0;
    for (int b = 0; b < f->bodies; b++)
        n += f->lattice[b] ? solid_lattice_wanted(f->lattice[b], sites[b], from, to, NULL)
                           : solid_list_wanted(f->list[b], from, to, NULL);
    long *id = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *id);
    n = 0;
    for (int b = 0; b < f->bodies; b++)
        n += f->lattice[b] ? solid_lattice_wanted(f->lattice[b], sites[b], from, to, id + n)
                           : solid_list_wanted(f->list[b], from, to, id + n);
    s->n_ghost = solid_number_unique(id, n);
    s->ghost = par_ghost_new(s->first, s->n_ghost, id);
    const struct solid_numbering numbering = {from, to, s->n_ghost, id};
    for (int b = 0; b < f->bodies; b++) {
        if (f->lattice[b])
            solid_lattice_link(f->lattice[b], sites[b], &numbering);
        else
            solid_list_link(f->list[b], &numbering);
    }
    memory_free(id);
}

static void arrays_new(struct solid *s) {
    const size_t all = (size_t)(s->n + s->n_ghost) + 1, owned = (size_t)s->n + 1;
    for (int c = 0; c < 3; c++) {
        s->x0[c] = memory_new(MEMORY_SOLID, all, sizeof(double));
        s->d[c] = memory_new(MEMORY_SOLID, all, sizeof(double));
        s->v[c] = memory_new(MEMORY_SOLID, all, sizeof(double));
        s->a[c] = memory_new(MEMORY_SOLID, owned, sizeof(double));
        s->load[c] = memory_new(MEMORY_SOLID, owned, sizeof(double));
        s->v_old[c] = memory_new(MEMORY_SOLID, owned, sizeof(double));
        s->a_old[c] = memory_new(MEMORY_SOLID, owned, sizeof(double));
    }
    s->volume = memory_new(MEMORY_SOLID, all, sizeof(double));
    s->family_volume = memory_new(MEMORY_SOLID, all, sizeof(double));
    s->body = memory_new(MEMORY_SOLID, all, 1);
    s->flag = memory_new(MEMORY_SOLID, all, 1);
}

static void points_place(struct solid *s, const struct solid_body *body, const struct solid_sites *t,
                         int first, int n) {
    const long from = s->first[par_rank()] + first - t->first;
    for (int i = 0; i < n; i++) {
        for (int c = 0; c < 3; c++) s->x0[c][first + i] = body->point[c][t->point[from + i]];
        s->volume[first + i] = body->point_volume[t->point[from + i]];
    }
}

static void lattice_place(struct solid *s, const struct solid_sites *t) {
    const long from = s->first[par_rank()], to = s->first[par_rank() + 1];
    const double spacing = s->in.spacing;
    for (int q = 0; q < t->filled; q++) {
        const int row = t->order[q];
        if (t->start[row] < from || t->start[row] >= to) continue;
        const int site[3] = {t->low[0] + 8 * (row % t->rows[0]), t->low[1] + row / t->rows[0] % t->rows[1],
                             t->low[2] + row / t->rows[0] / t->rows[1]};
        int h = (int)(t->start[row] - from);
        for (int k = 0; k < 8; k++) {
            if (!(t->bits[row] >> k & 1)) continue;
            for (int c = 0; c < 3; c++)
                s->x0[c][h] = s->in.origin[c] + (site[c] + (c == 0 ? k : 0) + 0.5) * spacing;
            s->volume[h++] = spacing * spacing * spacing;
        }
    }
}

static void particles_place(struct solid *s, struct solid_sites *const *sites) {
    const struct solid_family *f = s->family;
    for (int b = 0; b < f->bodies; b++) {
        const int first = f->first[b], n = f->first[b + 1] - first;
        if (sites[b]->is_lattice)
            lattice_place(s, sites[b]);
        else
            points_place(s, &s->in.body[b], sites[b], first, n);
        for (int h = first; h < first + n; h++) s->body[h] = (uint8_t)b;
        if (f->lattice[b])
            solid_lattice_volumes(f->lattice[b], s->family_volume);
        else
            solid_list_volumes(f->list[b], s->family_volume);
    }
    double *const field[] = {s->x0[0], s->x0[1], s->x0[2], s->volume, s->family_volume};
    par_ghost_update(s->ghost, 5, field, s->n);
    par_ghost_update_bytes(s->ghost, s->body, s->n);
    for (int b = 0; b < f->bodies; b++) {
        if (f->lattice[b])
            solid_lattice_weights(f->lattice[b], s->family_volume, s->in.surface_correction);
        else
            solid_list_weights(f->list[b], s->x0, s->family_volume, s->in.surface_correction);
    }
}

struct solid *solid_new(const struct solid_input *in) {
    struct solid *s = memory_new(MEMORY_SOLID, 1, sizeof *s);
    input_check(in);
    input_copy(&s->in, in);
    s->dim = in->model == SOLID_3D ? 3 : 2;
    s->stage = (struct solid_stage){.integrator = SOLID_RK3, .breakage = 1};
    s->first = memory_new(MEMORY_SOLID, (size_t)par_size() + 1, sizeof *s->first);
    struct solid_family *f = s->family = memory_new(MEMORY_SOLID, 1, sizeof *f);
    f->bodies = in->bodies;
    f->stencils = in->materials;
    f->stencil = memory_new(MEMORY_SOLID, (size_t)in->materials, sizeof *f->stencil);
    for (int m = 0; m < in->materials; m++)
        f->stencil[m] = solid_stencil_new(in->spacing, in->material[m].horizon_ratio);

    struct solid_sites **sites = memory_new(MEMORY_SOLID, (size_t)in->bodies, sizeof *sites);
    for (int b = 0; b < in->bodies; b++) {
        sites[b] = solid_sites_new(in, &in->body[b], s->n_global, f->stencil[in->body[b].material]->reach);
        s->n_global += sites[b]->count;
    }
    overlap_check(in, sites);
    solid_number_divide(sites, in->bodies, in->general_bonds, s->first);
    family_new(s, sites);
    ghosts_new(s, sites);
    arrays_new(s);
    particles_place(s, sites);
    for (int b = 0; b < in->bodies; b++) solid_sites_free(sites[b]);
    memory_free(sites);

    solid_constraint_mark(s);
    par_ghost_update_bytes(s->ghost, s->flag, s->n);
    par_ghost_update(s->ghost, 3, s->v, s->n);
    double longest = 0;
    for (int b = 0; b < f->bodies; b++)
        longest = fmax(longest, f->lattice[b] ? f->lattice[b]->stencil->n : solid_list_longest(f->list[b]));
    f->bytes = ((int)par_max(longest) + 7) / 8;
    s->bonds_total = par_sum_long(solid_family_directed(s)) / 2;
    return s;
}

void solid_forget_bonds(struct solid *s) {
    struct solid_family *f = s->family;
    for (int b = 0; b < f->bodies; b++) {
        solid_lattice_free(f->lattice[b]);
        solid_list_free(f->list[b]);
        f->lattice[b] = NULL;
        f->list[b] = NULL;
    }
    for (int c = 0; c < 3; c++) {
        double **const of[] = {&s->a[c], &s->v_old[c], &s->a_old[c]};
        for (size_t i = 0; i < sizeof of / sizeof of[0]; i++) {
            memory_free(*of[i]);
            *of[i] = NULL;
        }
    }
    memory_free(s->family_volume);
    s->family_volume = NULL;
}

void solid_free(struct solid *s) {
    if (!s) return;
    struct solid_family *f = s->family;
    solid_contact_free(s);
    solid_forget_bonds(s);
    for (int m = 0; m < f->stencils; m++) solid_stencil_free(f->stencil[m]);
    void *const family[] = {f->lattice, f->list, f->first, f->stencil, f};
    for (size_t i = 0; i < sizeof family / sizeof family[0]; i++) memory_free(family[i]);
    for (int c = 0; c < 3; c++) {
        void *const of[] = {s->x0[c], s->d[c], s->v[c], s->load[c]};
        for (size_t i = 0; i < sizeof of / sizeof of[0]; i++) memory_free(of[i]);
    }
    void *const own[] = {s->volume,
                         s->body,
                         s->flag,
                         s->first,
                         (void *)(uintptr_t)s->in.body,
                         (void *)(uintptr_t)s->in.material,
                         (void *)(uintptr_t)s->in.constraint,
                         (void *)(uintptr_t)s->in.unbreakable};
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) memory_free(own[i]);
    par_ghost_free(s->ghost);
    memory_free(s);
}

void solid_ghosts_begin(struct solid *s) {
    double *const field[] = {s->d[0], s->d[1], s->d[2], s->v[0], s->v[1], s->v[2]};
    par_ghost_begin(s->ghost, s->stage.damping_relative > 0 ? 6 : 3, field, s->n);
}

void solid_ghosts_update(struct solid *s) {
    solid_ghosts_begin(s);
    par_ghost_end(s->ghost);
}
