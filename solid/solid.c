#include "solid/solid.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_exchange.h"
#include "solid/build.h"
#include "solid/imposed/constraint.h"
#include "solid/contact/contact.h"
#include "solid/bonds/cut_bonds.h"
#include "solid/bonds/family.h"
#include "solid/input.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/imposed/given.h"
#include "solid/body/number.h"
#include "solid/body/plane.h"
#include "solid/refine/refine.h"

#include <math.h>

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
                        die_all(EXIT_CODE_SCENE, "solid bodies %s and %s overlap", in->body[a].name, in->body[b].name);
                }
            }
        }
}

/* The particles of a body that is on no lattice, or is to have lists of bonds. */
static struct solid_cloud *cloud_new(const struct solid_input *in, const struct solid_body *body,
                                     const struct solid_sites *sites) {
    if (sites->is_lattice) {
        const struct solid_material *m = &in->material[body->material];
        const int fast = !in->general_bonds && in->partial == SOLID_PARTIAL_EXACT && m->micromodulus == SOLID_CONSTANT;
        return fast ? NULL : solid_cloud_lattice(in, body, sites);
    }
    return body->shape == SOLID_POLYGON ? solid_plane_cloud(in, body, sites) : solid_cloud_points(in, body, sites);
}

/* Points may stand anywhere: none where a particle of another body is. */
static void points_check(const struct solid *s, struct solid_sites *const *sites, struct solid_cloud *const *cloud) {
    for (int b = 0; b < s->in.bodies; b++) {
        if (!sites[b]->point || sites[b]->cell) continue;
        for (int h = 0; h < s->n; h++) {
            double x[3] = {0};
            for (int c = 0; c < s->dim; c++) x[c] = s->x0[c][h];
            if (s->body[h] != b && solid_cloud_near_holds(cloud[b], x))
                die(EXIT_CODE_SCENE, "a particle of solid body %s and one of %s coincide", s->in.body[s->body[h]].name,
                    s->in.body[b].name);
        }
    }
}

static void family_new(struct solid *s, struct solid_sites *const *sites, struct solid_cloud *const *cloud) {
    const struct solid_input *in = &s->in;
    struct solid_family *f = s->family;
    const long from = s->first[par_rank()], to = s->first[par_rank() + 1];
    f->lattice = memory_new(MEMORY_SOLID, (size_t)f->bodies, sizeof *f->lattice);
    f->list = memory_new(MEMORY_SOLID, (size_t)f->bodies, sizeof *f->list);
    f->cloud = memory_new(MEMORY_SOLID, (size_t)f->bodies, sizeof *f->cloud);
    f->first = memory_new(MEMORY_SOLID, (size_t)f->bodies + 1, sizeof *f->first);
    for (int b = 0; b < f->bodies; b++) {
        const struct solid_body *body = &in->body[b];
        const struct solid_material *m = &in->material[body->material];
        if (!cloud[b]) {
            const struct solid_stencil *stencil = f->stencil[body->material];
            const double s0 = solid_material_critical_stretch(m, in->spacing);
            const struct solid_law law = {solid_material_micromodulus(m, in->spacing), m->density, s0 * (2 + s0)};
            f->lattice[b] = solid_lattice_new(sites[b], stencil, law, from, to, f->first[b]);
            f->first[b + 1] = f->first[b] + f->lattice[b]->n;
        } else {
            f->list[b] = solid_list_find_new(cloud[b], from, to, f->first[b]);
            f->first[b + 1] = f->first[b] + f->list[b]->n;
        }
    }
    s->n = (int)(to - from);
    ENSURE(f->first[f->bodies] == s->n, "%d particles in the stores, %d owned", f->first[f->bodies], s->n);
}

void solid_build_ghosts(struct solid *s, struct solid_sites *const *sites, struct solid_cloud *const *cloud) {
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
            solid_list_link(f->list[b], cloud[b], &numbering);
    }
    memory_free(id);
}

static void arrays_new(struct solid *s) {
    const size_t all = (size_t)(s->n + s->n_ghost) + 1, owned = (size_t)s->n + 1;
    for (int c = 0; c < s->dim; c++) {
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

static void cloud_place(struct solid *s, const struct solid_cloud *t, int first, int n) {
    const long from = s->first[par_rank()] + first - t->first;
    for (int i = 0; i < n; i++) {
        for (int c = 0; c < s->dim; c++) s->x0[c][first + i] = solid_cloud_x(t, c, from + i);
        s->volume[first + i] = t->volume[from + i] * t->unit;
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
            for (int c = 0; c < 3; c++) s->x0[c][h] = s->in.origin[c] + (site[c] + (c == 0 ? k : 0) + 0.5) * spacing;
            s->volume[h++] = spacing * spacing * spacing;
        }
    }
}

void solid_build_places(struct solid *s, struct solid_sites *const *sites, struct solid_cloud *const *cloud) {
    const struct solid_family *f = s->family;
    for (int b = 0; b < f->bodies; b++) {
        const int first = f->first[b], n = f->first[b + 1] - first;
        if (sites && sites[b]->is_lattice)
            lattice_place(s, sites[b]);
        else
            cloud_place(s, cloud[b], first, n);
        for (int h = first; h < first + n; h++) s->body[h] = (uint8_t)b;
        if (f->lattice[b])
            solid_lattice_volumes(f->lattice[b], s->family_volume);
        else
            solid_list_volumes(f->list[b], s->family_volume);
    }
    double *const field[] = {s->volume, s->family_volume};
    par_ghost_update(s->ghost, s->dim, s->x0, s->n);
    par_ghost_update(s->ghost, 2, field, s->n);
    par_ghost_update_bytes(s->ghost, s->body, s->n);
    for (int b = 0; b < f->bodies; b++) {
        if (f->lattice[b])
            solid_lattice_weights(f->lattice[b], s->family_volume, s->in.surface_correction);
        else
            solid_list_weights(f->list[b], s->family_volume, s->in.surface_correction);
    }
}

/* Coordinates beside the centre are rounded to 2^-32 spacing: mirror images get the same displacement to the bit. */
static void initial_set(struct solid *s) {
    for (int k = 0; k < s->in.initials; k++) {
        const struct solid_initial *i = &s->in.initial[k];
        for (int h = 0; h < s->n; h++) {
            const double steps = ldexp(rint(ldexp((s->x0[i->along][h] - i->centre) / s->in.spacing, 32)), -32);
            const double r = steps * (s->in.spacing / i->width);
            const double part = i->shape == SOLID_SINE ? sin(2 * M_PI * r) : exp(-r * r);
            for (int c = 0; c < s->dim; c++) s->d[c][h] += i->displacement[c] * part;
        }
    }
}

static void plate_edges(struct solid *s, const struct solid_list *t) {
    struct solid_end last = {0};
    double full = 0;
    for (int i = 0; i < t->n; i++) {
        const struct solid_end *p = &t->particle[i];
        if (p->size != last.size || p->horizon != last.horizon)
            full = solid_pair_full_volume(&t->law, p->horizon, p->size);
        last = *p;
        if (t->own_volume[i] < (1 - 1e-6) * full) s->flag[t->first + i] |= SOLID_INTERFACE;
    }
}

/* Until a surface is looked for, which only a fluid asks for, whatever lacks a part of its family may touch a stranger;
 * of points on no lattice in space nobody knows what a whole family is. */
void solid_build_edges(struct solid *s) {
    const struct solid_family *f = s->family;
    for (int b = 0; s->dim == 2 && b < f->bodies; b++) plate_edges(s, f->list[b]);
    for (int h = 0; s->dim == 3 && h < s->n; h++) {
        const struct solid_lattice *t = f->lattice[s->body[h]];
        struct solid_family_view view;
        if (t) solid_family_view(s, h, &view);
        if (!t || view.n < t->stencil->n) s->flag[h] |= SOLID_INTERFACE;
    }
}

void solid_build_counts(struct solid *s) {
    struct solid_family *f = s->family;
    double longest = 0;
    for (int b = 0; b < f->bodies; b++)
        longest = fmax(longest, f->lattice[b] ? f->lattice[b]->stencil->n : solid_list_longest(f->list[b]));
    f->bytes = ((int)par_max(fmax(longest, 1)) + 7) / 8;
    s->bonds_total = par_sum_long(solid_family_directed(s)) / 2;
}

struct solid *solid_new(const struct solid_input *in) {
    struct solid *s = memory_new(MEMORY_SOLID, 1, sizeof *s);
    solid_input_check(in);
    solid_input_copy(&s->in, in);
    s->refine = solid_refine_new(&s->in);
    s->dim = solid_dim(in);
    s->stage = (struct solid_stage){.integrator = SOLID_RK3, .breakage = 1};
    s->first = memory_new(MEMORY_SOLID, (size_t)par_size() + 1, sizeof *s->first);
    struct solid_family *f = s->family = memory_new(MEMORY_SOLID, 1, sizeof *f);
    f->bodies = in->bodies;
    f->stencils = in->materials;
    f->stencil = memory_new(MEMORY_SOLID, (size_t)in->materials, sizeof *f->stencil);
    for (int m = 0; s->dim == 3 && m < in->materials; m++)
        f->stencil[m] = solid_weight_stencil_new(in->spacing, in->material[m].horizon_ratio);

    struct solid_sites **sites = memory_new(MEMORY_SOLID, (size_t)in->bodies, sizeof *sites);
    for (int b = 0; b < in->bodies; b++) {
        const struct solid_material *m = &in->material[in->body[b].material];
        sites[b] =
            solid_sites_new(in, &in->body[b], s->n_global, (int)floor(m->horizon_ratio + (s->dim == 3 ? 0.5 : 1)));
        s->n_global += sites[b]->count;
    }
    overlap_check(in, sites);
    solid_plane_overlap_check(in, sites);
    solid_number_divide(sites, in->bodies, in->general_bonds, s->first);
    struct solid_cloud **cloud = memory_new(MEMORY_SOLID, (size_t)in->bodies, sizeof(struct solid_cloud *));
    for (int b = 0; b < in->bodies; b++) cloud[b] = cloud_new(&s->in, &s->in.body[b], sites[b]);
    family_new(s, sites, cloud);
    solid_build_ghosts(s, sites, cloud);
    arrays_new(s);
    solid_build_places(s, sites, cloud);
    points_check(s, sites, cloud);
    solid_cut_bonds(s, cloud);
    solid_build_edges(s);
    solid_given_new(s, sites);
    for (int b = 0; b < in->bodies; b++) {
        solid_sites_free(sites[b]);
        if (s->dim == 2)
            f->cloud[b] = cloud[b]; /* a plate may change while it runs */
        else
            solid_cloud_free(cloud[b]);
    }
    memory_free(sites);
    memory_free(cloud);

    solid_refine_start(s);
    initial_set(s);
    solid_constraint_check(s);
    solid_constraint_mark(s);
    par_ghost_update_bytes(s->ghost, s->flag, s->n);
    par_ghost_update(s->ghost, s->dim, s->d, s->n);
    par_ghost_update(s->ghost, s->dim, s->v, s->n);
    solid_build_counts(s);
    return s;
}

void solid_forget_bonds(struct solid *s) {
    struct solid_family *f = s->family;
    for (int b = 0; b < f->bodies; b++) {
        solid_lattice_free(f->lattice[b]);
        solid_list_free(f->list[b]);
        solid_cloud_free(f->cloud[b]);
        f->cloud[b] = NULL;
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
    for (int m = 0; m < f->stencils; m++) solid_weight_stencil_free(f->stencil[m]);
    void *const family[] = {f->lattice, f->list, f->cloud, f->first, f->stencil, f};
    for (size_t i = 0; i < sizeof family / sizeof family[0]; i++) memory_free(family[i]);
    for (int c = 0; c < 3; c++) {
        void *const of[] = {s->x0[c], s->d[c], s->v[c], s->load[c]};
        for (size_t i = 0; i < sizeof of / sizeof of[0]; i++) memory_free(of[i]);
    }
    void *const own[] = {s->volume, s->body, s->flag, s->first};
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) memory_free(own[i]);
    solid_refine_free(s->refine);
    solid_input_free(&s->in);
    solid_given_free(s->given);
    par_ghost_free(s->ghost);
    memory_free(s);
}

void solid_ghosts_begin(struct solid *s) {
    double *field[6];
    for (int c = 0; c < s->dim; c++) {
        field[c] = s->d[c];
        field[s->dim + c] = s->v[c];
    }
    par_ghost_begin(s->ghost, s->stage.damping_relative > 0 ? 2 * s->dim : s->dim, field, s->n);
}

void solid_ghosts_update(struct solid *s) {
    solid_ghosts_begin(s);
    par_ghost_end(s->ghost);
}
