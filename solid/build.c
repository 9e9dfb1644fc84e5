/* Steps of solid_new that are repeated after a refinement: ghosts, positions, counts. */
#include "solid/body/bricks.h"
#include "solid/build.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "base/sort.h"
#include "solid/body/number.h"
#include "solid/body/sites_image.h"
#include "solid/bonds/correction.h"
#include "solid/bonds/family.h"
#include "solid/bonds/materials.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/list_rows.h"
#include "solid/force/dilatation.h"
#include "solid/law/material.h"

#include <math.h>

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
    s->n_ghost = (int)sort_unique(id, n);
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

static void cloud_place(struct solid *s, const struct solid_cloud *cloud, int first, int n) {
    const long from = s->first[par_rank()] + first - cloud->first;
    for (int i = 0; i < n; i++) {
        for (int c = 0; c < s->dim; c++) s->x0[c][first + i] = solid_cloud_x(cloud, c, from + i);
        s->volume[first + i] = cloud->volume[from + i] * cloud->unit;
    }
}

static void lattice_place(struct solid *s, const struct solid_sites *sites) {
    const long from = s->first[par_rank()], to = s->first[par_rank() + 1];
    const double spacing = s->in.spacing;
    for (struct solid_bricks_walk row = {0}; solid_bricks_next(sites, &row);) {
        if (row.id < from || row.id >= to) continue;
        int h = (int)(row.id - from);
        for (int k = 0; k < 8; k++) {
            if (!(row.bits >> k & 1)) continue;
            for (int c = 0; c < 3; c++) {
                const int site = solid_sites_in_period(&s->in, sites->wrap, c, row.site[c] + (c == 0 ? k : 0));
                s->x0[c][h] = s->in.origin[c] + (site + 0.5) * spacing;
            }
            s->volume[h++] = spacing * spacing * spacing;
        }
    }
}

struct solid_law solid_build_law(const struct solid_input *in, int material) {
    const struct solid_material *m = &in->material[material];
    const struct physics_softening soft =
        solid_material_softening(in->model, in->thickness, m, m->horizon_ratio * in->spacing);
    const double limit = soft.s_c > 0 ? soft.s_e : solid_material_critical_stretch(m, in->spacing);
    return (struct solid_law){
        solid_material_micromodulus(m, in->spacing), m->density, limit * (2 + limit), soft.s_e, soft.s_c,
        solid_material_bonds_energy(in->model, m)};
}

/* The materials of a body's particles. sites: of a body of several. */
static void materials_set(struct solid *s, const struct solid_sites *sites, int b) {
    const struct solid_body *body = &s->in.body[b];
    const long from = s->first[par_rank()], to = s->first[par_rank() + 1];
    for (int h = s->family->first[b]; h < s->family->first[b + 1]; h++) s->material[h] = (uint8_t)body->material;
    for (struct solid_bricks_walk row = {0}; body->image_materials > 1 && solid_bricks_next(sites, &row);) {
        if (row.id < from || row.id >= to) continue;
        int h = (int)(row.id - from);
        for (int k = 0; k < 8; k++) {
            const int site[3] = {row.site[0] + k, row.site[1], row.site[2]};
            if (row.bits >> k & 1)
                s->material[h++] = (uint8_t)body->image_material[solid_sites_image_kind(body->voxels, site)];
        }
    }
}

void solid_build_materials(struct solid *s, struct solid_sites *const *sites) {
    const struct solid_input *in = &s->in;
    if (!s->material) return;
    for (int b = 0; b < in->bodies; b++) materials_set(s, sites[b], b);
    par_ghost_update_bytes(s->ghost, s->material, s->n);
    for (int b = 0; b < in->bodies; b++) {
        const struct solid_body *body = &in->body[b];
        struct solid_law law[SOLID_BODY_MATERIALS_MAX];
        if (body->image_materials < 2 || in->rigid) continue;
        for (int k = 0; k < body->image_materials; k++) law[k] = solid_build_law(in, body->image_material[k]);
        s->family->lattice[b]->materials =
            solid_materials_new(s->family->lattice[b], law, body->image_materials, body->image_material, s->material);
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
    double *w = memory_new(MEMORY_SOLID, (size_t)(s->n + s->n_ghost) + 1, sizeof *w);
    solid_correction_of(s, w);
    for (int b = 0; b < f->bodies; b++) {
        if (f->lattice[b])
            solid_lattice_weights(f->lattice[b], w);
        else
            solid_list_weights(f->list[b], w);
        /* a refined plate has none, nor one whose families have a dilatation */
        if (sites && f->list[b] && !solid_dilatation_is(&s->in, b)) solid_list_rows_find(f->list[b], cloud[b]);
    }
    memory_free(w);
}

static void plate_edges(struct solid *s, const struct solid_list *list) {
    struct solid_end last = {0};
    double full = 0;
    for (int i = 0; i < list->n; i++) {
        const struct solid_end *p = &list->particle[i];
        if (p->size != last.size || p->horizon != last.horizon)
            full = solid_pair_full_volume(&list->law, p->horizon, p->size);
        last = *p;
        if (list->own_volume[i] < (1 - 1e-6) * full) s->flag[list->first + i] |= SOLID_INTERFACE;
    }
}

/* Marks the particles without a complete family: they may meet particles with which they share no bond. The marks are
 * used until a surface is searched for, which only a fluid needs. For points on no lattice in 3D the complete family is
 * not known. */
void solid_build_edges(struct solid *s) {
    const struct solid_family *f = s->family;
    for (int b = 0; s->dim == 2 && b < f->bodies; b++) plate_edges(s, f->list[b]);
    for (int h = 0; s->dim == 3 && h < s->n; h++) {
        const struct solid_lattice *lattice = f->lattice[s->body[h]];
        if (!lattice || solid_family_initial_bonds(s, h) < lattice->stencil->n) s->flag[h] |= SOLID_INTERFACE;
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
