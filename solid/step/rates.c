/* Largest eigenvalues of stiffness and damping over mass by Lanczos's iteration, for the stable step. */
#include "base/die.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "base/threads.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lattice.h"
#include "solid/bonds/list.h"
#include "solid/bonds/soft.h"
#include "solid/contact/contact.h"
#include "solid/force/force.h"
#include "solid/imposed/indenter.h"
#include "solid/imposed/walls.h"
#include "solid/step/rates.h"
#include "solid/step/rates_cache.h"
#include "solid/step/stable.h"

#include <lapacke.h>
#include <math.h>
#include <string.h>

/* Lanczos: power iteration in the Krylov space of all earlier vectors. Each iteration takes one force sweep. */
enum { ITERATIONS = 60 };
/* From so many particles on the rates are kept for later runs. */
enum { MANY = 20000 };
static const double ENOUGH = 1e-4; /* relative change of omega^2 at which to stop */

struct krylov {
    double *u[3], *before[3];     /* [n] unit vectors in the mass-weighted product */
    double *d[3], *rest[3], step; /* [n] displacement about which forces are linear, and a there; [0] NULL: 0. And the
                                   * largest displacement from it, m */
};

/* Exchanges the present bonds with those of the unbroken body; a second call with the same arrays restores them. */
static void swap_whole(struct solid *s, uint8_t **other) {
    struct solid_family *f = s->family;
    if (s->soft) s->soft->is_hidden = !s->soft->is_hidden;
    for (int b = 0; b < f->bodies; b++) {
        if (f->list[b]) {
            solid_list_swap(f->list[b], other[b]);
            continue;
        }
        uint8_t **bonds = &f->lattice[b]->lambda, *t = *bonds;
        *bonds = other[b];
        other[b] = t;
        f->lattice[b]->is_whole = !f->lattice[b]->is_whole;
        solid_lattice_changed_all(f->lattice[b]);
    }
}

static uint8_t *read_file(const struct solid_family *f, int b) {
    const struct solid_list *list = f->list[b];
    if (list) {
        uint8_t *intact = memory_new(MEMORY_SOLID, (size_t)list->capacity + SOLID_LIST_BLOCK, 1);
        for (int i = 0; i < list->n; i++) memset(intact + list->start[i], 1, (size_t)(list->end[i] - list->start[i]));
        return intact;
    }
    const struct solid_lattice *lattice = f->lattice[b];
    uint8_t *lambda = memory_new(MEMORY_SOLID, (size_t)lattice->rows * (size_t)lattice->stencil->n + 1, 1);
    for (int r = 0; r < lattice->rows; r++)
        solid_lattice_initial_bonds(lattice, r, lambda + (size_t)r * (size_t)lattice->stencil->n);
    return lambda;
}

double solid_rates_product(const struct solid *s, double *const x[3], double *const y[3]) {
    double sum = 0;
    for (int h = 0; h < s->n; h++) {
        const double mass = solid_density(s, h) * s->volume[h];
        for (int c = 0; c < s->dim; c++) sum += mass * x[c][h] * y[c][h];
    }
    return par_sum(sum);
}

/* A matrix divided by the mass: stiffness K + damping D; each number is a factor, or 0. */
struct operator{
    double stiffness, damping; /* 1, s */
};

/* a = (stiffness K + damping D) u/m by one force sweep, negated, at displacements so small that bonds are linear. */
static void apply(struct solid *s, const struct krylov *k, struct operator a) {
    double most = 0;
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) most = fmax(most, fabs(k->u[c][h]));
    const double scale = k->step / par_max(most);
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) {
            s->d[c][h] = a.stiffness * scale * k->u[c][h] + (k->d[0] ? k->d[c][h] : 0);
            s->v[c][h] = a.damping * scale * k->u[c][h];
        }
    par_ghost_update(s->ghost, s->dim, s->d, s->n);
    if (a.damping != 0) par_ghost_update(s->ghost, s->dim, s->v, s->n);
    solid_force_bonds(s, 0, a.damping != 0 ? s->stage.damping_relative : 0);
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) {
            const double rest = k->d[0] ? k->rest[c][h] : 0;
            s->a[c][h] = s->flag[h] & SOLID_HELD_X << c ? 0 : (rest - s->a[c][h]) / scale;
        }
}

static double largest_eigenvalue(int n, const double *diagonal, const double *beside) {
    double value[ITERATIONS], off[ITERATIONS];
    memcpy(value, diagonal, (size_t)n * sizeof *value);
    memcpy(off, beside, (size_t)(n - 1) * sizeof *off);
    for (int i = 0; i < n; i++)
        if (!isfinite(value[i]) || (i < n - 1 && !isfinite(off[i])))
            die_all(EXIT_CODE_SCENE, "solid.materials: the bonds' frequencies are not numbers that a computer "
                                     "holds; look at youngs_modulus, density and spacing");
    ENSURE(LAPACKE_dsterf(n, value, off) == 0, "the eigenvalues of %d rows", n);
    return fmax(value[n - 1], 0);
}

static double start_value(long id, int c) { /* the same on any number of ranks */
    uint64_t z = (uint64_t)(3 * id + c) * 0x9e3779b97f4a7c15u + 0x632be59bd9b4e019u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return (double)(z >> 11) * 0x1p-53 - 0.5;
}

/* Begins with vectors of length 1 that are the same on any number of ranks. Returns 0 if all particles are held. */
static int start(struct solid *s, struct krylov *k) {
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++)
            k->u[c][h] = s->flag[h] & SOLID_HELD_X << c ? 0 : start_value(s->first[par_rank()] + h, c);
    const double norm = sqrt(solid_rates_product(s, k->u, k->u));
    if (!(norm > 0)) return 0;
    for (int c = 0; c < s->dim; c++)
        for (int h = 0; h < s->n; h++) k->u[c][h] /= norm;
    return 1;
}

/* An iteration after n sweeps. */
struct lanczos {
    int n, ended;
    double eigenvalue, diagonal[ITERATIONS], beside[ITERATIONS];
};

/* Goes on with an iteration up to `most` sweeps. Returns the largest eigenvalue, at least 0. */
static double lanczos(struct solid *s, struct krylov *k, struct operator a, struct lanczos *l, int most) {
    double *diagonal = l->diagonal, *beside = l->beside;
    if (l->n == 0) l->ended = !start(s, k);
    while (l->n < most && !l->ended) {
        const int i = l->n++;
        apply(s, k, a);
        diagonal[i] = solid_rates_product(s, k->u, s->a);
        for (int c = 0; c < s->dim; c++)
            for (int h = 0; h < s->n; h++)
                s->a[c][h] -= diagonal[i] * k->u[c][h] + (i ? beside[i - 1] * k->before[c][h] : 0);
        beside[i] = sqrt(solid_rates_product(s, s->a, s->a));
        const double last = l->eigenvalue;
        l->eigenvalue = largest_eigenvalue(i + 1, diagonal, beside);
        l->ended = (i >= 10 && fabs(l->eigenvalue - last) < ENOUGH * l->eigenvalue) ||
                   !(beside[i] > 1e-10 * l->eigenvalue); /* the Krylov space is complete */
        for (int c = 0; c < s->dim && !l->ended; c++)
            for (int h = 0; h < s->n; h++) {
                k->before[c][h] = k->u[c][h];
                k->u[c][h] = s->a[c][h] / beside[i];
            }
    }
    return l->eigenvalue;
}

static double largest(struct solid *s, struct krylov *k, struct operator a) {
    struct lanczos l = {0};
    return lanczos(s, k, a, &l, ITERATIONS);
}

static void mark_of(const struct lanczos *l, double mark[SOLID_RATES_MARK]) {
    for (int i = 0; i < SOLID_RATES_MARK / 2; i++) {
        mark[2 * i] = l->diagonal[i];
        mark[2 * i + 1] = l->beside[i];
    }
}

static const struct operator stiffness = {1, 0}, damping = {0, 1};

/* Begins the iterations; returns 1 if an earlier run has ended those of the same solid. */
static int begin(struct solid *s, struct krylov *k, struct solid_rates_mark *mark, struct lanczos *first,
                 struct solid_rates *rates) {
    *mark =
        (struct solid_rates_mark){.particles = (double)s->n_global, .ranks = par_size(), .threads = threads_count()};
    lanczos(s, k, stiffness, first, SOLID_RATES_MARK / 2);
    mark_of(first, mark->stiffness);
    if (!solid_rates_cache_like(mark)) return 0;
    struct lanczos second = {0};
    if (s->stage.damping_relative > 0) lanczos(s, k, damping, &second, SOLID_RATES_MARK / 2);
    mark_of(&second, mark->damping);
    *first = (struct lanczos){0};
    return solid_rates_cache_find(mark, rates);
}

static void find(struct solid *s, struct krylov *k, struct solid_rates *rates) {
    const int reuses = s->n_global >= MANY && !s->refine && !s->indent;
    struct solid_rates_mark mark;
    struct lanczos first = {0}, second = {0};
    *rates = (struct solid_rates){.sum = 1, .difference = 1, .absolute = s->stage.damping_absolute};
    if (reuses && begin(s, k, &mark, &first, rates)) return;
    rates->stiffness = lanczos(s, k, stiffness, &first, ITERATIONS);
    if (s->indent) rates->stiffness += solid_indenter_rate(s);
    if (s->stage.damping_relative > 0 && rates->stiffness > 0) {
        rates->damping = lanczos(s, k, damping, &second, ITERATIONS);
        const double ratio = rates->stiffness / rates->damping;
        rates->sum = largest(s, k, (struct operator){1, ratio}) / rates->stiffness;
        rates->difference = largest(s, k, (struct operator){1, -ratio}) / rates->stiffness;
    }
    if (!reuses) return;
    mark_of(&second, mark.damping);
    solid_rates_cache_add(&mark, rates);
}

/* The vectors of an iteration, with the present displacements and velocities. */
static void krylov_new(struct solid *s, struct krylov *k, double *d[3], double *v[3]) {
    *k = (struct krylov){.step = 1e-7 * s->in.spacing};
    for (int c = 0; c < s->dim; c++) {
        k->u[c] = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof(double));
        k->before[c] = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof(double));
        d[c] = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof(double));
        v[c] = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof(double));
        memcpy(d[c], s->d[c], (size_t)s->n * sizeof(double));
        memcpy(v[c], s->v[c], (size_t)s->n * sizeof(double));
    }
}

/* Gives displacements and velocities back. */
static void krylov_free(struct solid *s, struct krylov *k, double *d[3], double *v[3]) {
    for (int c = 0; c < s->dim; c++) {
        memcpy(s->d[c], d[c], (size_t)s->n * sizeof(double));
        memcpy(s->v[c], v[c], (size_t)s->n * sizeof(double));
        memset(s->a[c], 0, (size_t)s->n * sizeof(double));
        MEMORY_FREE(k->u[c], k->before[c], k->rest[c], d[c], v[c]);
    }
    par_ghost_update(s->ghost, s->dim, s->d, s->n);
    par_ghost_update(s->ghost, s->dim, s->v, s->n);
}

/* The iteration's sweeps leave no trace: what they did with each bond is forgotten before them, so that the same solid
 * has the same rates to the bit, and after them, so that the next steps are the same whether rates were found or known.
 */
void solid_rates_of(struct solid *s, struct solid_rates *rates) {
    struct solid_family *f = s->family;
    struct krylov k;
    double *d[3], *v[3];
    uint8_t **whole = memory_new(MEMORY_SOLID, (size_t)f->bodies, sizeof *whole);
    for (int b = 0; b < f->bodies; b++) whole[b] = read_file(f, b);
    krylov_new(s, &k, d, v);
    const long sweeps = s->sweeps;
    swap_whole(s, whole);
    solid_force_reset(s);
    find(s, &k, rates);
    if (s->walls) rates->stiffness = fmax(rates->stiffness, 0.5 * rates->stiffness + solid_walls_rate(s));
    swap_whole(s, whole);
    solid_force_reset(s);
    s->sweeps = sweeps;
    s->a_holds = 0;
    for (int b = 0; b < f->bodies; b++) memory_free(whole[b]);
    memory_free(whole);
    krylov_free(s, &k, d, v);
}

/* Forces are linear to 1e-3 over a step of 1e-4 spacings, and rounded by less than that in mixed precision. */
double solid_rates_strained(struct solid *s) {
    struct krylov k;
    struct lanczos l = {0};
    double *d[3], *v[3];
    const long sweeps = s->sweeps;
    const int holds = s->a_holds;
    krylov_new(s, &k, d, v);
    k.step = 1e-4 * s->in.spacing;
    solid_force_reset(s);
    par_ghost_update(s->ghost, s->dim, s->d, s->n);
    solid_force_bonds(s, 0, 0);
    for (int c = 0; c < s->dim; c++) {
        k.d[c] = d[c];
        k.rest[c] = memory_new(MEMORY_SOLID, (size_t)s->n + 1, sizeof(double));
        memcpy(k.rest[c], s->a[c], (size_t)s->n * sizeof(double));
    }
    const double rate2 = lanczos(s, &k, stiffness, &l, ITERATIONS);
    solid_force_reset(s);
    s->sweeps = sweeps;
    krylov_free(s, &k, d, v);
    s->a_holds = holds;
    return rate2;
}

/* The iteration depends on the unbroken body, its held particles and the pairwise damping alone. */
int solid_rates_again(struct solid *s, const struct solid_rates_found *found, struct solid_rates *rates) {
    if (!found->known || found->damping_relative != s->stage.damping_relative || s->refine || s->indent) return 0;
    *rates = found->rates;
    rates->absolute = s->stage.damping_absolute;
    solid_force_reset(s);
    s->a_holds = 0;
    return 1;
}

double solid_rates_stable_step(struct solid *s, enum solid_integrator integrator) {
    struct solid_rates rates;
    solid_rates_of(s, &rates);
    return solid_stable_of(&rates, integrator, s->contact ? 4 * solid_contact_rate_touch(s) : 0, NULL);
}
