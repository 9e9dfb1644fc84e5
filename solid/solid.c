/* Builds and frees the solid: particles, ghosts, bonds, weights, initial state; exchange of ghost values. */
#include "solid/body/bricks.h"
#include "solid/solid.h"
#include "base/clock.h"
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "physics/micromodulus.h"
#include "solid/body/number.h"
#include "solid/body/plane.h"
#include "solid/bonds/interface.h"
#include "solid/bonds/breaks.h"
#include "solid/bonds/cut_bonds.h"
#include "solid/bonds/cut_shapes.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/soft.h"
#include "solid/build.h"
#include "solid/contact/contact.h"
#include "solid/geometry/shape.h"
#include "solid/force/absorbed.h"
#include "solid/force/dilatation.h"
#include "solid/step/absolute.h"
#include "solid/step/rk3_loss.h"
#include "solid/imposed/constraint.h"
#include "solid/imposed/external_loads.h"
#include "solid/imposed/indenter.h"
#include "solid/imposed/walls.h"
#include "solid/imposed/reactions.h"
#include "solid/input.h"
#include "solid/law/stencil.h"
#include "solid/refine/refine.h"

#include <math.h>

/* Checks that no site belongs to two bodies. */
static void overlap_check(const struct solid_input *in, struct solid_sites *const *sites) {
    for (int a = 0; a < in->bodies; a++)
        for (int b = a + 1; b < in->bodies; b++) {
            struct solid_bricks_walk row = {0};
            while (sites[a]->is_lattice && solid_bricks_next(sites[b], &row)) {
                for (int k = 0; k < 8; k++) {
                    const int site[3] = {row.site[0] + k, row.site[1], row.site[2]};
                    if ((row.bits >> k & 1) && solid_sites_id(sites[a], site) >= 0)
                        die_all(EXIT_CODE_SCENE, "solid bodies %s and %s overlap", in->body[a].name, in->body[b].name);
                }
            }
        }
}

/* Whether the lattice store can hold the body: one micromodulus, exact partial volumes. */
static int is_fast(const struct solid_input *in, const struct solid_material *m) {
    return !in->general_bonds && in->partial == SOLID_PARTIAL_EXACT &&
           physics_micromodulus_of((enum physics_micromodulus)m->micromodulus)->is_constant;
}

/* The particles of a body that has lists of bonds; NULL: it goes into the lattice store. */
static struct solid_cloud *cloud_new(const struct solid_input *in, const struct solid_body *body,
                                     const struct solid_sites *sites) {
    switch (solid_shape_of(body)->places) {
    case SOLID_PLACES_LATTICE:
        return is_fast(in, &in->material[body->material]) && !solid_interface_any(in, (int)(body - in->body))
                   ? NULL
                   : solid_cloud_lattice(in, body, sites);
    case SOLID_PLACES_CELLS:
        return solid_plane_cloud(in, body, sites);
    case SOLID_PLACES_POINTS:
        return solid_cloud_points(in, body, sites);
    }
    ENSURE(0, "shape %d", (int)body->shape);
}

/* Checks that no point has the position of a particle of another body. */
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
    int mixed = 0;
    for (int b = 0; b < f->bodies; b++) {
        const struct solid_body *body = &in->body[b];
        if (!cloud[b]) {
            const struct solid_stencil *stencil = f->stencil[body->material];
            const struct solid_law law = solid_build_law(in, body->material);
            const int single = in->precision == SOLID_MIXED && body->image_materials < 2;
            mixed += single;
            f->lattice[b] = solid_lattice_new(sites[b], stencil, law, from, to, f->first[b], in->rigid, single);
            f->first[b + 1] = f->first[b] + f->lattice[b]->n;
        } else {
            int interfaces;
            struct solid_interface_side *interface = solid_interface_new(in, cloud, b, &interfaces);
            f->list[b] = solid_list_find_new(cloud[b], interface, interfaces, from, to, f->first[b]);
            f->first[b + 1] = f->first[b] + f->list[b]->n;
        }
    }
    if (in->precision == SOLID_MIXED && !mixed)
        die_all(EXIT_CODE_SCENE,
                "solid.precision = mixed: this scene has no body that can be swept so: one on the "
                "lattice, of one material with a constant micromodulus, with exact partial volumes and "
                "without interfaces");
    s->n = (int)(to - from);
    ENSURE(f->first[f->bodies] == s->n, "%d particles in the stores, %d owned", f->first[f->bodies], s->n);
}

/* Dies on an interface without a bond. */
static void interfaces_check(const struct solid *s) {
    for (int k = 0; k < s->in.interfaces; k++) {
        const int *pair = s->in.interface[k].body;
        const struct solid_list *list = s->family->list[pair[0]];
        long bonds = 0;
        for (int r = 0; r < list->others; r++)
            bonds += list->interface_of[r] && s->body[list->other_local[r]] == pair[1];
        if (par_sum_long(bonds) == 0)
            die_all(EXIT_CODE_SCENE, "solid.interfaces[%d]: %s and %s are farther apart than a horizon", k,
                    s->in.body[pair[0]].name, s->in.body[pair[1]].name);
    }
}

static void arrays_new(struct solid *s) {
    const size_t all = (size_t)(s->n + s->n_ghost) + 1, owned = (size_t)s->n + 1;
    for (int c = 0; c < s->dim; c++) {
        s->x0[c] = memory_new(MEMORY_SOLID, all, sizeof(double));
        s->d[c] = memory_new(MEMORY_SOLID, all, sizeof(double));
        s->v[c] = memory_new(MEMORY_SOLID, all, sizeof(double));
        s->load[c] = memory_new(MEMORY_SOLID, owned, sizeof(double));
        if (s->in.rigid) continue;
        s->a[c] = memory_new(MEMORY_SOLID, owned, sizeof(double));
        s->v_old[c] = memory_new(MEMORY_SOLID, owned, sizeof(double));
        s->a_old[c] = memory_new(MEMORY_SOLID, owned, sizeof(double));
    }
    s->volume = memory_new(MEMORY_SOLID, all, sizeof(double));
    s->family_volume = memory_new(MEMORY_SOLID, all, sizeof(double));
    s->body = memory_new(MEMORY_SOLID, all, 1);
    s->flag = memory_new(MEMORY_SOLID, all, 1);
    for (int b = 0; b < s->in.bodies && !s->material; b++)
        if (s->in.body[b].image_materials > 1) s->material = memory_new(MEMORY_SOLID, all, 1);
    if (!s->in.limit) return;
    s->stretch_limit = memory_new(MEMORY_SOLID, all, sizeof(double));
    s->stretch_limit_next = memory_new(MEMORY_SOLID, owned, sizeof(double));
    for (int h = 0; h < s->n; h++) s->stretch_limit[h] = INFINITY;
}

/* The displacement's factor, r widths from the centre. */
static double initial_part(enum solid_initial_shape shape, double r) {
    switch (shape) {
    case SOLID_GAUSSIAN:
        return exp(-r * r);
    case SOLID_SINE:
        return sin(2 * M_PI * r);
    }
    ENSURE(0, "initial shape %d", (int)shape);
}

/* Coordinates relative to the centre are rounded to 2^-32 spacing: mirror images get the same displacement to the
 * bit. */
static void initial_set(struct solid *s) {
    for (int k = 0; k < s->in.initials; k++) {
        const struct solid_initial *i = &s->in.initial[k];
        for (int h = 0; h < s->n; h++) {
            const double steps = ldexp(rint(ldexp((s->x0[i->along][h] - i->centre) / s->in.spacing, 32)), -32);
            const double r = steps * (s->in.spacing / i->width);
            const double part = initial_part(i->shape, r);
            for (int c = 0; c < s->dim; c++) s->d[c][h] += i->displacement[c] * part;
        }
    }
}

static void velocity_set(struct solid *s) {
    for (int h = 0; h < s->n; h++)
        for (int c = 0; c < s->dim; c++) s->v[c][h] = s->in.body[s->body[h]].velocity[c];
}

struct solid *solid_new(const struct solid_input *in) {
    struct solid *s = memory_new(MEMORY_SOLID, 1, sizeof *s);
    solid_input_check(in);
    solid_input_copy(&s->in, in);
    s->refine = solid_refine_new(&s->in);
    s->dim = solid_dim(in);
    s->soft = solid_soft_new(s);
    s->stage = (struct solid_stage){.integrator = SOLID_RK3, .breakage = 1};
    s->first = memory_new(MEMORY_SOLID, (size_t)par_size() + 1, sizeof *s->first);
    struct solid_family *f = s->family = memory_new(MEMORY_SOLID, 1, sizeof *f);
    f->bodies = in->bodies;
    f->stencils = in->materials;
    f->stencil = memory_new(MEMORY_SOLID, (size_t)in->materials, sizeof *f->stencil);
    for (int m = 0; s->dim == 3 && m < in->materials; m++)
        f->stencil[m] = solid_stencil_new(in->spacing, in->material[m].horizon_ratio);

    struct solid_sites **sites = memory_new(MEMORY_SOLID, (size_t)in->bodies, sizeof *sites);
    for (int b = 0; b < in->bodies; b++) {
        const struct solid_material *m = &in->material[in->body[b].material];
        sites[b] =
            solid_sites_new(in, &in->body[b], s->n_global, (int)floor(m->horizon_ratio + (s->dim == 3 ? 0.5 : 1)));
        s->n_global += sites[b]->count;
        struct solid_body *body = (struct solid_body *)(uintptr_t)&s->in.body[b];
        body->on_surface = sites[b]->on_surface;
        body->surface_gap = sites[b]->gap;
    }
    overlap_check(in, sites);
    solid_plane_overlap_check(in, sites);
    solid_number_divide(sites, in->bodies, in->general_bonds, s->first);
    struct solid_cloud **cloud = memory_new(MEMORY_SOLID, (size_t)in->bodies, sizeof(struct solid_cloud *));
    for (int b = 0; b < in->bodies; b++) cloud[b] = cloud_new(&s->in, &s->in.body[b], sites[b]);
    const enum clock_phase phase = clock_phase(CLOCK_PHASE_BONDS);
    family_new(s, sites, cloud);
    clock_phase(phase);
    solid_build_ghosts(s, sites, cloud);
    arrays_new(s);
    solid_build_materials(s, sites);
    solid_build_places(s, sites, cloud);
    points_check(s, sites, cloud);
    interfaces_check(s);
    clock_phase(CLOCK_PHASE_BONDS);
    solid_dilatation_new(s);
    solid_cut_bonds(s, cloud);
    solid_cut_shapes(s);
    clock_phase(phase);
    solid_build_edges(s);
    solid_external_loads_new(s, sites, NULL);
    solid_indenter_new(s);
    for (int b = 0; b < in->bodies; b++) {
        solid_sites_free(sites[b]);
        if (s->dim == 2)
            f->cloud[b] = cloud[b]; /* kept, because a plate may change during the run */
        else
            solid_cloud_free(cloud[b]);
    }
    MEMORY_FREE(sites, cloud);

    solid_refine_start(s);
    initial_set(s);
    velocity_set(s);
    solid_constraint_check(s);
    solid_constraint_mark(s);
    solid_walls_new(s);
    for (int b = 0; b < in->bodies; b++) ((struct solid_body *)(uintptr_t)&s->in.body[b])->voxels = NULL;
    par_ghost_update_bytes(s->ghost, s->flag, s->n);
    par_ghost_update(s->ghost, s->dim, s->d, s->n);
    par_ghost_update(s->ghost, s->dim, s->v, s->n);
    solid_build_counts(s);
    return s;
}

void solid_free_bonds(struct solid *s) {
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
        double **const arrays[] = {&s->a[c], &s->v_old[c], &s->a_old[c]};
        for (size_t i = 0; i < sizeof arrays / sizeof arrays[0]; i++) {
            memory_free(*arrays[i]);
            *arrays[i] = NULL;
        }
    }
    memory_free(s->family_volume);
    s->family_volume = NULL;
}

void solid_free(struct solid *s) {
    if (!s) return;
    struct solid_family *f = s->family;
    solid_contact_free(s);
    solid_soft_free(s->soft);
    solid_breaks_free(s->breaks);
    solid_free_bonds(s);
    for (int m = 0; m < f->stencils; m++) solid_stencil_free(f->stencil[m]);
    MEMORY_FREE(f->lattice, f->list, f->cloud, f->first, f->stencil, f);
    for (int c = 0; c < 3; c++) MEMORY_FREE(s->x0[c], s->d[c], s->v[c], s->load[c]);
    MEMORY_FREE(s->volume, s->body, s->material, s->flag, s->first, s->fragment, s->fragment_since, s->stretch_limit,
                s->stretch_limit_next);
    solid_refine_free(s->refine);
    solid_input_free(&s->in);
    solid_external_loads_free(s->external_loads);
    solid_indenter_free(s->indent);
    solid_walls_free(s->walls);
    solid_reactions_free(s->reactions);
    solid_absorbed_free(s->absorbed);
    solid_dilatation_free(s->dilatation);
    solid_absolute_free(s->absolute);
    solid_rk3_loss_free(s->rk3_loss);
    par_ghost_free(s->ghost);
    memory_free(s);
}
