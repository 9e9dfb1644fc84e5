/* Every variable of the state is in a table of state, in a checkpoint or in the state kept in memory, and comes back.
 */
#include "coupling/guard.h"
#include "coupling/run_state.h"
#include "coupling/step.h"
#include "cracks/mouth.h"
#include "cracks/project.h"
#include "cracks/state_table.h"
#include "files/folder.h"
#include "files/seal.h"
#include "files/state_file.h"
#include "fluid/state_table.h"
#include "tests/coupling/scene_of.h"
#include "solid/bonds/breaks.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/segments.h"
#include "solid/bonds/soft.h"
#include "solid/contact/list.h"
#include "solid/imposed/given.h"
#include "solid/measure/detachment.h"
#include "solid/refine/refine.h"

#include <stdio.h>

/* A block in a periodic flow: no side's condition sets any of the fields when a checkpoint is read. */
static const char *const flow =
    "title: test\n"
    "domain: {size: [0.16, 0.08, 0.08], cells: [32, 16, 16]}\n"
    "fluid:\n"
    "  density: 1000\n"
    "  viscosity: 1.0e-3\n"
    "  initial: {velocity: [0.1, 0, 0]}\n"
    "  driving: {type: bulk_velocity, direction: x, value: 0.1}\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
    "  materials:\n"
    "    - {name: soft, youngs_modulus: 1.0e6, density: 3000, fracture_energy: 1.0}\n"
    "  bodies:\n"
    "    - {name: block, material: soft, shape: box, low: [0.06, 0.02, 0.02], high: [0.09, 0.055, 0.06]}\n"
    "coupling: {medium: {low: [0, 0, 0], high: [0.16, 0.08, 0.08]}}\n"
    "stages:\n"
    "  - {name: first, steps: 100, time_step: 1.0e-3, integrator: verlet}\n"
    "  - {name: second, steps: 100, time_step: 1.0e-3, integrator: verlet, until: {}}\n";

/* Two blocks in contact, under a load. */
static const char *const blocks =
    "title: test\n"
    "domain: {size: [0.2, 0.1, 0.1]}\n"
    "solid:\n"
    "  spacing: 0.005\n"
    "  materials:\n"
    "    - {name: soft, youngs_modulus: 1.0e7, density: 1000, fracture_energy: 0.05,\n"
    "       breakage: {law: bilinear, tensile_strength: 2500}}\n"
    "  bodies:\n"
    "    - {name: left, material: soft, shape: box, low: [0.05, 0.03, 0.03], high: [0.09, 0.06, 0.06]}\n"
    "    - {name: right, material: soft, shape: box, low: [0.1, 0.04, 0.04], high: [0.13, 0.07, 0.07]}\n"
    "  constraints:\n"
    "    - {low: [0.12, 0.04, 0.04], high: [0.13, 0.07, 0.07], velocity: [-5, 0, 0], time: [[0, 1], [1.0e-2, 2]]}\n"
    "  loads:\n"
    "    - {low: [0.05, 0.03, 0.03], high: [0.06, 0.06, 0.06], force: [1.0e7, 0, 0], time: [[0, 0], [1.0, 2]]}\n"
    "stages:\n"
    "  - {name: first, steps: 1000, time_step: 5.0e-5, integrator: verlet}\n"
    "  - {name: second, steps: 1000, time_step: 5.0e-5, integrator: verlet}\n";

/* A plate that is refined by hand. */
static const char *const plate =
    "title: test\n"
    "domain: {size: [0.06, 0.04]}\n"
    "solid:\n"
    "  spacing: 0.002\n"
    "  model: plane_stress\n"
    "  thickness: 0.002\n"
    "  materials:\n"
    "    - {name: glass, youngs_modulus: 7.2e10, density: 2235, fracture_energy: 20}\n"
    "  bodies:\n"
    "    - {name: plate, material: glass, shape: rectangle, low: [0, 0], high: [0.06, 0.04]}\n"
    "  refinement: {levels: 1, damage: 0.3, from: 1}\n"
    "stages:\n"
    "  - {name: first, steps: 1000, time_step: 5.0e-8, integrator: verlet}\n"
    "  - {name: second, steps: 1000, time_step: 5.0e-8, integrator: verlet}\n";

/* A plate with a notch that fluid is pumped into. */
static const char *const cracked = "title: test\n"
                                   "domain: {size: [0.03, 0.03]}\n"
                                   "solid:\n"
                                   "  spacing: 1.0e-3\n"
                                   "  model: plane_strain\n"
                                   "  thickness: 1.0e-3\n"
                                   "  materials: [{name: rock, youngs_modulus: 2.0e10, density: 2500}]\n"
                                   "  bodies: [{shape: rectangle, low: [0, 0], high: [0.03, 0.03]}]\n"
                                   "  cracks: [{points: [[0.01, 0.015], [0.02, 0.015]]}]\n"
                                   "crack_fluid:\n"
                                   "  viscosity: 1.0e-3\n"
                                   "  leak_off: 1.0e-6\n"
                                   "  least_aperture: 1.0e-8\n"
                                   "  injections: [{low: [0.014, 0.012], high: [0.016, 0.018], rate: 1.0e-5}]\n"
                                   "stages:\n"
                                   "  - {name: first, steps: 1000, integrator: verlet, crack_fluid: true}\n"
                                   "  - {name: second, steps: 1000, integrator: verlet, crack_fluid: true}\n";

/* A block in a flow, with a notch that is open to it. */
static const char *const open_notch =
    "title: test\n"
    "domain: {size: [0.12, 0.08, 0.08], cells: [24, 16, 16]}\n"
    "fluid:\n"
    "  density: 1000\n"
    "  viscosity: 1.0e-3\n"
    "  initial: {velocity: [0.1, 0, 0]}\n"
    "  driving: {type: bulk_velocity, direction: x, value: 0.1}\n" SCENE_OF_PERIODIC_SIDES "solid:\n"
    "  materials: [{name: soft, youngs_modulus: 1.0e6, density: 3000}]\n"
    "  bodies: [{material: soft, shape: box, low: [0.04, 0.02, 0.02], high: [0.08, 0.06, 0.06]}]\n"
    "  cracks: [{points: [[0.03, 0.04, 0.01], [0.06, 0.04, 0.01], [0.06, 0.04, 0.07], [0.03, 0.04, 0.07]]}]\n"
    "coupling: {load: wall, medium: {low: [0, 0, 0], high: [0.12, 0.08, 0.08]}}\n"
    "crack_fluid:\n"
    "  least_pressure: -1.0e5\n"
    "  least_aperture: 1.0e-5\n"
    "  injections: [{low: [0.04, 0.03, 0.03], high: [0.05, 0.05, 0.05], rate: 1.0e-9}]\n"
    "stages:\n"
    "  - {name: first, steps: 100, time_step: 1.0e-3, integrator: verlet, crack_fluid: true}\n"
    "  - {name: second, steps: 100, time_step: 1.0e-3, integrator: verlet, crack_fluid: true}\n";

/* A block that an indenter moves into, whose limits of the stretch follow the other bonds. */
static const char *const indented =
    "title: test\n"
    "domain: {size: [12, 12, 12]}\n"
    "solid:\n"
    "  spacing: 1\n"
    "  materials:\n"
    "    - {name: glass, youngs_modulus: 1, density: 1, breakage: {law: brittle, s00: 0.01, alpha: 0.25}}\n"
    "  bodies: [{shape: box, low: [2, 2, 2], high: [10, 8, 10]}]\n"
    "  indenters: [{shape: sphere, centre: [6, 9.9, 6], radius: 2, velocity: [0, -0.1, 0], stiffness: 1}]\n"
    "stages:\n"
    "  - {name: first, steps: 100, time_step: 0.3, integrator: verlet}\n"
    "  - {name: second, steps: 100, time_step: 0.3, integrator: verlet}\n";

/* A run whose fragments are followed and whose bonds that break are recorded. */
static struct run *run_followed(const struct scene *scene) {
    struct run *r = run_new(scene);
    if (r->solid) solid_detachment_begin(r->solid);
    if (r->solid && r->needs.breakage) solid_breaks_begin(r->solid);
    return r;
}

/* Items without a plain member, and what fills them and reads them. seed: 1, 2: other values. */
typedef void filler(struct run *r, const struct state_item *item, const struct state_part *part, int seed);
typedef size_t reader(struct run *r, void *bytes); /* into bytes, room for 1 MB; returns how many */
struct special {
    const char *name;
    filler *fill;
    reader *read; /* NULL: item->save does */
};

static void fill_nothing(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)r, (void)item, (void)part, (void)seed;
}

static void fill_stage(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    r->stage = 2 - seed;
}

/* One more bond of some particles is broken. */
static void fill_bonds(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    struct solid_family_view view;
    (void)item, (void)part;
    for (int h = seed; h < r->solid->n && r->needs.breakage; h += 7) {
        solid_family_view(r->solid, h, &view);
        for (int b = 0; b < view.n; b++)
            if (view.intact[b]) {
                solid_family_break(r->solid, h, b);
                break;
            }
    }
}

/* The other flags decide on what is in which list. */
static void fill_flag(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    for (int h = 0; h < r->solid->n + r->solid->n_ghost; h++)
        if (h % 5 == seed) r->solid->flag[h] ^= SOLID_UNBREAKABLE;
}

static void fill_piece(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    for (int h = 0; h < r->solid->n; h++) r->solid->piece[h] = 1000 * seed + r->solid->first[par_rank()] + h;
}

/* Normals and feelers of the interface. */
static void fill_surface(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    const int comps = item->comps_of(part->owner);
    double *value = calloc((size_t)r->solid->n * (size_t)comps + 1, sizeof *value);
    char why[64];
    item->save(part->owner, value);
    for (int i = 0; i < r->surface->n; i++)
        for (int c = 0; c < 9; c++) value[r->surface->h[i] * comps + c] *= 1 + 1e-6 * seed;
    assert_int_equal(item->load(part->owner, value, why, sizeof why), 0);
    free(value);
}

static void fill_demand(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    double *value = calloc(3 * (size_t)r->solid->n + 1, sizeof *value);
    char why[64];
    for (int i = 0; i < 3 * r->solid->n; i++) value[i] = seed + 0.001 * i;
    assert_int_equal(item->load(part->owner, value, why, sizeof why), 0);
    free(value);
}

static void fill_given(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    solid_given_set(r->solid, 0.1 * seed, 0);
}

static size_t read_given(struct run *r, void *bytes) {
    solid_given_keep(r->solid, bytes);
    return (size_t)r->solid->in.loads * sizeof(double);
}

static void path_of(struct run *r, int b, uint8_t **large, void **high, size_t *size, int *n) {
    const struct solid_family *f = r->solid->family;
    *large = f->lattice[b] ? f->lattice[b]->segments->large : f->list[b]->large;
    *high = f->lattice[b] ? (void *)f->lattice[b]->segments->high : (void *)f->list[b]->power;
    *size = f->lattice[b] ? sizeof(float) : sizeof(double);
    *n = f->lattice[b] ? f->lattice[b]->segments->n : f->list[b]->n;
}

static void fill_paths(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    for (int b = 0; b < r->solid->in.bodies; b++) {
        uint8_t *large;
        void *high;
        size_t size;
        int n;
        path_of(r, b, &large, &high, &size, &n);
        memset(large, seed - 1, (size_t)n);
        memset(high, 16 * seed, (size_t)n * size);
    }
}

static size_t read_paths(struct run *r, void *bytes) {
    char *to = bytes;
    for (int b = 0; b < r->solid->in.bodies; b++) {
        uint8_t *large;
        void *high;
        size_t size;
        int n;
        path_of(r, b, &large, &high, &size, &n);
        memcpy(to, large, (size_t)n);
        memcpy(to + n, high, (size_t)n * size);
        to += (size_t)n * (1 + size);
    }
    return (size_t)(to - (char *)bytes);
}

/* The lists are longest at first: what is added to them later is cut off. */
static void fill_contact(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    struct solid_contact *c = r->solid->contact;
    (void)item, (void)part;
    if (!c) return;
    for (int k = 0; k < SOLID_CONTACT_KINDS && seed == 2; k++) c->pairs[k].n = 0;
    c->any = seed;
}

static size_t read_contact(struct run *r, void *bytes) {
    const struct solid_contact *c = r->solid->contact;
    int *to = bytes;
    for (int k = 0; c && k < SOLID_CONTACT_KINDS; k++) to[k] = c->pairs[k].n;
    to[SOLID_CONTACT_KINDS] = c ? c->any : 0;
    return (SOLID_CONTACT_KINDS + 1) * sizeof *to;
}

/* One more bond of some particles softens. */
static void fill_soft(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    struct solid_family_view view;
    (void)item, (void)part;
    for (int h = seed; h < r->solid->n; h += 7) {
        solid_family_view(r->solid, h, &view);
        for (int b = seed; b < view.n; b++)
            if (view.intact[b] && solid_soft_share(r->solid, h, b) == 1) {
                double s_e, s_c;
                solid_soft_limits(r->solid, h, &s_e, &s_c);
                solid_soft_add_placed(r->solid, h, b, s_e + 0.1 * (s_c - s_e));
                break;
            }
    }
    solid_soft_order(r->solid->soft);
}

static size_t read_soft(struct run *r, void *bytes) {
    double *to = bytes;
    for (int i = 0; i < r->solid->soft->n; i++) {
        const struct solid_soft_bond *bond = &r->solid->soft->bond[i];
        *to++ = bond->h;
        *to++ = bond->l;
        *to++ = bond->place;
        *to++ = (double)bond->at;
        *to++ = bond->weight;
        *to++ = bond->elastic;
        *to++ = bond->most;
    }
    return (size_t)((char *)to - (char *)bytes);
}

static void fill_released(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    for (int i = 0; i < r->solid->soft->n; i++) {
        struct solid_soft_bond *bond = &r->solid->soft->bond[i];
        bond->released = seed + 1e-3 * bond->place;
    }
}

static size_t read_released(struct run *r, void *bytes) {
    double *to = bytes;
    for (int i = 0; i < r->solid->soft->n; i++) *to++ = r->solid->soft->bond[i].released;
    return (size_t)((char *)to - (char *)bytes);
}

static void fill_breaks(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    const double xi[3] = {1, 0, 0};
    (void)item, (void)part;
    for (int k = 0; k < seed; k++) solid_breaks_add(r->solid, 0, 0, xi, 1, 1);
}

static size_t read_breaks(struct run *r, void *bytes) {
    const struct solid_breaks *b = r->solid->breaks;
    const long number[2] = {b->made, b->n};
    memcpy(bytes, number, sizeof number);
    return sizeof number;
}

/* Values by global id. */
static void fill_wet(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    struct cracks *c = r->cracks;
    (void)item, (void)part;
    cracks_project_settle(c);
    for (int i = 0; i < c->struts.n; i++) {
        const double base = 100 * seed + 1e-3 * (double)(r->solid->first[par_rank()] + c->struts.h[i]);
        c->p[i] = base;
        c->content[i] = base + 1;
        c->cavity[i] = base + 2;
        c->volume[i] = base + 3;
        c->storage[i] = base + 4;
        c->share[i] = (cracks_vec){base + 5, base + 6, 0, 0};
        if (c->since) c->since[i] = base + 7;
    }
}

static void fill_injected(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    r->cracks->injected[0] = seed;
    r->cracks->rate[0] = 10 * seed;
}

static void fill_totals(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    (void)item, (void)part;
    r->cracks->leaked = seed;
    r->cracks->filled = 10 * seed;
    r->cracks->began = 1;
}

static void fill_mouths(struct run *r, const struct state_item *item, const struct state_part *part, int seed) {
    const struct cracks_struts *t = &r->cracks->struts;
    struct cracks_mouths *m = r->cracks->mouths;
    (void)item, (void)part;
    cracks_project_settle(r->cracks);
    cracks_mouth_room(m, t->n);
    m->n = t->n;
    for (int i = 0; i < t->n; i++) {
        const double base = 100 * seed + 1e-3 * (double)(r->solid->first[par_rank()] + t->h[i]);
        m->h[i] = t->h[i];
        m->rate[i] = base;
        m->gain[t->h[i]] = base + 1;
    }
}

static const struct special special[] = {{"stage", fill_stage, NULL},
                                         {"spacing", fill_nothing, NULL},
                                         {"body", fill_nothing, NULL},
                                         {"level", fill_nothing, NULL},
                                         {"place", fill_nothing, NULL},
                                         {"bonds", fill_bonds, NULL},
                                         {"flag", fill_flag, NULL},
                                         {"surface", fill_surface, NULL},
                                         {"demand", fill_demand, NULL},
                                         {"given", fill_given, read_given},
                                         {"paths", fill_paths, read_paths},
                                         {"contact", fill_contact, read_contact},
                                         {"piece", fill_piece, NULL},
                                         {"softening", fill_soft, read_soft},
                                         {"breaks", fill_breaks, read_breaks},
                                         {"softening_released", fill_released, read_released},
                                         {"crack_fluid", fill_wet, NULL},
                                         {"crack_injected", fill_injected, NULL},
                                         {"crack_totals", fill_totals, NULL},
                                         {"crack_mouths", fill_mouths, NULL}};

static const struct special *special_of(const struct state_item *item) {
    for (size_t k = 0; k < sizeof special / sizeof special[0]; k++)
        if (!strcmp(special[k].name, item->name)) return &special[k];
    if (item->save || item->bytes == 0)
        fail_msg("%s has functions of its own: test_state.c must be told how to fill it", item->name);
    return NULL;
}

static struct state_size size_of(const struct state_part *part) {
    struct state_size size = {0};
    part->size(part->owner, &size);
    return size;
}

/* Values of a plain array on this rank, ghosts included. */
static size_t values_of(const struct state_item *item, const struct state_size *size) {
    if (item->shape == STATE_CELL) return size->cells;
    if (item->shape == STATE_BODY) return (size_t)item->comps * (size_t)size->bodies;
    return (size_t)(size->n + (item->ghosts ? size->n_ghost : 0));
}

/* Numbers that no other item or place has; displacements stay small. */
static void fill_plain(const struct state_item *item, const struct state_part *part, int number, int seed) {
    const struct state_size size = size_of(part);
    const double scale = strcmp(item->name, "displacement") == 0 ? 1e-12 : 1;
    const int share = item->shape == STATE_SHARE ? par_rank() : 0;
    const double base = 1000 * number + 500 * seed + 0.25 + share;
    if (item->shape == STATE_ONE || item->shape == STATE_SHARE) {
        char *member = state_item_array(item, part, 0);
        const long count = 10 * number + seed;
        const int small = (int)count;
        if (item->kind == STATE_DOUBLE)
            for (size_t k = 0; k < item->bytes / sizeof base; k++)
                memcpy(member + k * sizeof base, &(double){base + (double)k}, sizeof base);
        else if (item->kind == STATE_LONG)
            memcpy(member, &count, sizeof count);
        else if (item->kind == STATE_INT)
            memcpy(member, &small, sizeof small);
        else
            memset(member, small, item->bytes);
        return;
    }
    assert_int_equal(item->kind, STATE_DOUBLE);
    const int comps = item->shape == STATE_BODY ? 1 : state_item_comps(item, part);
    for (int c = 0; c < comps; c++) {
        double *value = state_item_array(item, part, c);
        const long first = item->shape == STATE_PARTICLE ? size.first : 0;
        for (size_t i = 0; i < values_of(item, &size); i++)
            value[i] = scale * (base + 0.125 * c + 1e-6 * (double)(first + (long)i));
    }
}

static void fill(struct run *r, int seed) {
    struct run_state state;
    run_state_of(r, &state);
    for (int last = 0; last < 2; last++)
        for (int k = 0; k < state.list.n; k++) {
            const struct state_item *item = state.list.at[k].item;
            const struct special *is = special_of(item);
            if (item->last != last) continue;
            if (is)
                is->fill(r, item, state.list.at[k].part, seed);
            else
                fill_plain(item, state.list.at[k].part, k + 1, seed);
        }
}

/* A number for what an item holds over all ranks, whatever their shares of the particles. local: also of the ghosts. */
static uint64_t print_of(struct run *r, const struct state_item *item, const struct state_part *part, int local) {
    const struct state_size size = size_of(part);
    const struct special *is = special_of(item);
    const size_t value = state_item_value_bytes(item->kind);
    uint64_t sum = 0;
    if (is && is->read) {
        char *bytes = calloc(1 << 20, 1);
        const size_t n = is->read(r, bytes);
        sum = seal_sum(bytes, n, 1, 0);
        free(bytes);
    } else if (item->save) {
        const size_t row = item->shape == STATE_ONE ? value : value * (size_t)state_item_comps(item, part);
        const size_t n = item->shape == STATE_ONE ? par_rank() == 0 : (size_t)size.n;
        char *bytes = calloc(n * row + STATE_TEXT_BYTES, 1);
        item->save(part->owner, bytes);
        sum = seal_sum(bytes, n, row, (uint64_t)size.first);
        free(bytes);
    } else if (item->shape == STATE_SHARE && !local) {
        const double all = par_sum(*(double *)state_item_array(item, part, 0));
        sum = seal_sum(&all, par_rank() == 0, sizeof all, 0);
    } else if (item->shape == STATE_ONE || item->shape == STATE_SHARE) {
        sum = seal_sum(state_item_array(item, part, 0), 1, item->bytes, (uint64_t)par_rank());
    } else if (item->shape == STATE_CELL && !local) {
        const struct store_block *b = &size.block;
        const char *array = state_item_array(item, part, 0);
        for (int k = 0; k < b->m[2]; k++)
            for (int j = 0; j < b->m[1]; j++)
                sum += seal_sum(array + value * (size_t)(size.inner + k * b->plane + j * b->row), (size_t)b->m[0],
                                value, (uint64_t)(1000 * (b->lo[2] + k) + 100000 * (b->lo[1] + j)));
    } else {
        const int is_particle = item->shape == STATE_PARTICLE || item->shape == STATE_SET;
        const int comps = item->shape == STATE_BODY ? 1 : state_item_comps(item, part);
        const size_t n = is_particle && !local ? (size_t)size.n : values_of(item, &size);
        for (int c = 0; c < comps; c++)
            sum += seal_sum(state_item_array(item, part, c), n, value,
                            (uint64_t)(1000000 * c + (is_particle ? size.first : 0)));
    }
    return (uint64_t)par_sum_long((long)sum);
}

struct prints {
    int n;
    const char *name[STATE_LIST_MAX];
    uint64_t of[STATE_LIST_MAX];
};

static struct prints prints_of(struct run *r, int local) {
    struct run_state state;
    struct prints p = {0};
    run_state_of(r, &state);
    for (int k = 0; k < state.list.n; k++, p.n++) {
        p.name[k] = state.list.at[k].item->name;
        p.of[k] = print_of(r, state.list.at[k].item, state.list.at[k].part, local);
    }
    return p;
}

/* What has been tested in some scene. */
enum { TESTED_MAX = 256 };
static const struct state_item *tested[TESTED_MAX];
static int tests;

static int is_tested(const struct state_item *item, enum state_in in) {
    for (int k = 0; k < tests; k++)
        if (tested[k] == item) return (int)(item->in & in) != 0;
    return 0;
}

/* The items of `in` are what they were in `a`, and another thing than in `other`, so that it can be seen. */
static void assert_back(struct run *r, enum state_in in, const struct prints *a, const struct prints *other,
                        const struct prints *back) {
    struct run_state state;
    int lost = 0;
    run_state_of(r, &state);
    assert_int_equal(a->n, back->n);
    for (int k = 0; k < state.list.n; k++) {
        const struct state_item *item = state.list.at[k].item;
        const int is_parameter = item->bytes == 0 && item->shape == STATE_ONE;
        /* where loads are given, s->load is made anew by the next step */
        const int is_anew = in == STATE_STORED && !strcmp(item->name, "load") && r->solid->given;
        /* body and, kept, which particles there are, are the same throughout */
        const int is_one = !strcmp(item->name, "body") && r->solid->in.bodies == 1;
        const int is_none = (!strcmp(item->name, "contact") && !r->solid->contact) || /* nothing can touch yet */
                            (!strcmp(item->name, "bonds") && !r->needs.breakage);
        if (!(item->in & in) || is_anew || is_none) continue;
        if (!is_parameter && !is_one && a->of[k] == other->of[k]) {
            print_message("%s: the test does not change it\n", item->name);
            lost++;
        }
        if (a->of[k] != back->of[k]) {
            print_message("%s does not come back from %s\n", item->name,
                          in == STATE_STORED ? "a checkpoint" : "the state kept in memory");
            lost++;
        }
        if (!is_tested(item, item->in)) tested[tests++] = item;
    }
    if (lost) fail_msg("%d items of state are lost", lost);
}

/* Filled; written; read into another run. */
static void check_checkpoint(struct run *r, const struct scene *scene) {
    char folder[FOLDER_PATH], why[256];
    int head;
    struct run_state state, other_state;
    struct run *other = run_followed(scene);
    snprintf(folder, sizeof folder, "%s/tests/coupling/state_%d", FRANA_BINARY_DIR, par_size());
    folder_make(folder);
    folder_clear(folder);
    fill(r, 1);
    run_state_of(r, &state);
    struct store *s = store_begin(folder, "state", 0);
    state_file_write(s, &state.list);
    store_end(s);
    const struct prints written = prints_of(r, 0), fresh = prints_of(other, 0);
    s = store_read_open_latest(folder);
    assert_non_null(s);
    run_state_of(other, &other_state);
    if (state_file_read(s, &other_state.list, &head, why, sizeof why)) fail_msg("%s %s", why, store_read_error());
    store_read_close(s);
    const struct prints read = prints_of(other, 0);
    assert_back(r, STATE_STORED, &written, &fresh, &read);
    if (r->solid) assert_int_equal(r->solid->n_global, other->solid->n_global);
    run_free(other);
}

/* A checkpoint without pi: it starts from p. */
static void check_without_predictor(struct run *r, const struct scene *scene) {
    char folder[FOLDER_PATH], why[256];
    int head, n = 0;
    struct run_state state, other_state;
    struct run *other = run_followed(scene);
    const struct fluid_state *from = fluid_state_of(r->fluid), *to = fluid_state_of(other->fluid);
    const struct fluid_grid *g = fluid_grid_of(r->fluid);
    snprintf(folder, sizeof folder, "%s/tests/coupling/state_without_%d", FRANA_BINARY_DIR, par_size());
    folder_make(folder);
    folder_clear(folder);
    fill(r, 1);
    run_state_of(r, &state);
    for (int k = 0; k < state.list.n; k++)
        if (strcmp(state.list.at[k].item->name, "pi") != 0) state.list.at[n++] = state.list.at[k];
    assert_int_equal(n, state.list.n - 1);
    state.list.n = n;
    struct store *s = store_begin(folder, "state", 0);
    state_file_write(s, &state.list);
    store_end(s);
    s = store_read_open_latest(folder);
    assert_non_null(s);
    run_state_of(other, &other_state);
    if (state_file_read(s, &other_state.list, &head, why, sizeof why)) fail_msg("%s %s", why, store_read_error());
    store_read_close(s);
    for (int k = 0; k <= g->m[2]; k++) /* the ghosts that the momentum equation reads are set */
        for (int j = 0; j <= g->m[1]; j++)
            for (int i = 0; i <= g->m[0]; i++) {
                const size_t at = fluid_grid_at(g, i, j, k);
                check_equal(to->pi[at], to->p[at]);
                if (i < g->m[0] && j < g->m[1] && k < g->m[2]) check_equal(to->pi[at], from->p[at]);
            }
    run_free(other);
}

/* Filled; kept; filled with other values; restored. */
static void check_kept(struct run *r) {
    struct guard *g = guard_new(r);
    fill(r, 1);
    const struct prints kept = prints_of(r, 1);
    guard_keep(g, r);
    fill(r, 2);
    const struct prints other = prints_of(r, 1);
    assert_true(guard_restore(g, r) >= 0);
    const struct prints back = prints_of(r, 1);
    assert_back(r, STATE_KEPT, &kept, &other, &back);
    guard_free(g);
}

static struct run *run_of(struct scene *scene, int steps) {
    struct run *r = run_followed(scene);
    step_begin_stage(r);
    for (int k = 0; k < steps; k++) step_advance(r);
    return r;
}

static void go(const char *text, int steps, int settings, const char *const *set) {
    struct scene *scene = scene_of(text, "", settings, set);
    struct run *r = run_of(scene, steps);
    if (r->needs.bonds && r->solid->refine) {
        uint8_t *mark = calloc((size_t)r->solid->n + 1, 1);
        for (int h = 0; h < r->solid->n; h++) mark[h] = r->solid->x0[0][h] < 0.01;
        assert_true(solid_refine_marked(r->solid, mark) > 0);
        free(mark);
    }
    check_checkpoint(r, scene);
    check_kept(r);
    run_free(r);
    scene_free(scene);
}

/* A checkpoint of an earlier version, or of a flow with implicit diffusion. */
static void test_without_predictor(void **state) {
    (void)state;
    struct scene *scene = scene_of(flow, "", 0, NULL);
    struct run *r = run_of(scene, 3);
    check_without_predictor(r, scene);
    run_free(r);
    scene_free(scene);
}

static void test_flow(void **state) {
    (void)state;
    const char *const balanced[] = {"coupling.load=balanced"};
    const char *const implicit[] = {"fluid.diffusion=implicit", "solid.materials.soft.fracture_energy=.inf"};
    go(flow, 3, 1, balanced);
    go(flow, 3, 0, NULL);
    go(flow, 3, 2, implicit);
}

static void test_indented(void **state) {
    (void)state;
    go(indented, 30, 0, NULL);
}

static void test_cracked(void **state) {
    (void)state;
    go(cracked, 10, 0, NULL);
    go(open_notch, 3, 0, NULL);
}

static void test_blocks(void **state) {
    (void)state;
    go(blocks, 30, 0, NULL);
}

static void test_plate(void **state) {
    (void)state;
    go(plate, 3, 0, NULL);
}

/* A struct whose members between two offsets are state, and nothing else. */
struct group {
    const char *name, *table;
    struct state_part part;
    size_t from, to;
};

/* The item whose member ends at an offset. */
static const char *behind(const struct group *g, size_t at) {
    for (int k = 0; k < g->part.items; k++)
        if (g->part.item[k].offset + g->part.item[k].bytes == at) return g->part.item[k].name;
    return "nothing";
}

/* No member has been added to a struct's state that its table does not have. */
static void test_covered(void **state) {
    (void)state;
    struct scene *scene = scene_of(flow, "", 0, NULL);
    struct run *r = run_followed(scene);
    struct solid_state_owner owner = {r->solid, r->surface};
    const struct state_part run = run_state_part(r);
    const size_t adapt = offsetof(struct run, adapt);
    const struct group group[] = {
        {"run", "coupling/run_state.c", run, offsetof(struct run, t), offsetof(struct run, parts)},
        {"adapt", "coupling/run_state.c", run, adapt + offsetof(struct adapt, approach),
         adapt + offsetof(struct adapt, limits)},
        {"solid", "solid/state_table.c", solid_state_table_part(&owner), offsetof(struct solid, d),
         offsetof(struct solid, a)},
        {"fluid_state", "fluid/state_table.c", fluid_state_table_part(r->fluid), 0,
         offsetof(struct fluid_state, driven)}};
    struct scene *wet = scene_of(cracked, "", 0, NULL);
    struct run *of_wet = run_new(wet);
    const struct group cracks = {"cracks", "cracks/state_table.c", cracks_state_table_part(of_wet->cracks),
                                 offsetof(struct cracks, p), offsetof(struct cracks, struts)};
    int gaps = state_item_uncovered(cracks.part.item, cracks.part.items, cracks.from, cracks.to) < cracks.to;
    if (gaps) print_message("struct %s has state that is in no line of %s\n", cracks.name, cracks.table);
    run_free(of_wet);
    scene_free(wet);
    for (size_t k = 0; k < sizeof group / sizeof group[0]; k++) {
        const struct group *g = &group[k];
        size_t at = g->from;
        while ((at = state_item_uncovered(g->part.item, g->part.items, at, g->to)) < g->to) {
            size_t end = at;
            while (end < g->to && state_item_uncovered(g->part.item, g->part.items, end, g->to) == end) end++;
            print_message("struct %s: bytes %zu to %zu, behind %s, are state and in no line of %s\n", g->name, at,
                          end - 1, behind(g, at), g->table);
            at = end;
            gaps++;
        }
    }
    run_free(r);
    scene_free(scene);
    if (gaps) fail_msg("%d gaps in the tables of state", gaps);
}

/* Each line says why it is not stored or not kept, has a name of its own, and some scene above has it. */
static void test_lines(void **state) {
    (void)state;
    struct scene *scene = scene_of(flow, "", 0, NULL);
    struct run *r = run_followed(scene);
    struct run_state all;
    int bad = 0;
    run_state_of(r, &all);
    for (int p = 0; p < all.parts; p++)
        for (int k = 0; k < all.part[p].items; k++) {
            const struct state_item *item = &all.part[p].item[k];
            int same = 0, after = item->after == NULL;
            for (int q = 0; q < all.parts; q++)
                for (int l = 0; l < all.part[q].items; l++) {
                    same += !strcmp(all.part[q].item[l].name, item->name);
                    after |= item->after && !strcmp(all.part[q].item[l].name, item->after);
                }
            const char *fault = same != 1                                 ? "is there twice"
                                : !after                                  ? "follows an item that there is not"
                                : (item->in == STATE_BOTH) == !!item->why ? "says why, or does not, for no reason"
                                : !is_tested(item, item->in)              ? "is of none of the scenes here"
                                                                          : NULL;
            if (fault) print_message("%s %s\n", item->name, fault);
            bad += fault != NULL;
        }
    run_free(r);
    scene_free(scene);
    assert_int_equal(bad, 0);
}

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    const struct CMUnitTest all[] = {
        cmocka_unit_test(test_covered),           cmocka_unit_test(test_flow),    cmocka_unit_test(test_blocks),
        cmocka_unit_test(test_indented),          cmocka_unit_test(test_cracked), cmocka_unit_test(test_plate),
        cmocka_unit_test(test_without_predictor), cmocka_unit_test(test_lines)};
    const int failed = cmocka_run_group_tests(all, NULL, NULL);
    par_end();
    return failed;
}
