/* The wet particles, their struts and links: found from the solid's broken bonds. */
#include "cracks/struts.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "base/vec.h"
#include "cracks/axis.h"
#include "solid/bonds/family.h"
#include "solid/bonds/broken_tracker.h"

#include <math.h>
#include <string.h>

/* Below this part of the sum of omega/2 the area vectors of several faces cancel in a_h. A single face has more: half
 * of it in the layer next to a plane, 0.9 in the last one. */
static const double CANCELLED = 0.2;
/* A sum within this share of the bound counts as beyond it, in whatever order it was added. */
static const double TIE = 1e-9;

int cracks_struts_changed(struct cracks *c) {
    struct solid *s = c->solid;
    const int here = solid_broken_tracker_take(s, SOLID_BROKE_PUSH) || c->stale || c->restored ||
                     c->struts.bonds_version != s->bonds_version;
    return par_max(here) > 0;
}

void cracks_struts_update(const struct cracks_struts *t, size_t bytes, void *record) {
    par_ghost_update_records(t->plan, bytes, record, t->n);
}

void cracks_struts_update_near(const struct cracks_struts *t, double *work, double *x) {
    const int *serve;
    if (par_size() == 1) return;
    const int served = par_ghost_served(t->near, &serve);
    for (int k = 0; k < served; k++) work[serve[k]] = x[t->place[serve[k]]];
    par_ghost_update_records(t->near, sizeof *work, work, t->n);
    for (int k = 0; k < t->nears; k++) x[t->place[t->near_index[k]]] = work[t->n + k];
}

void cracks_struts_free(struct cracks_struts *t) {
    MEMORY_FREE(t->h, t->place, t->slot, t->mobility, t->area, t->area_size, t->diagonal, t->id, t->rate[0], t->rate[1],
                t->rate[2], t->near_index);
    cracks_rows_free(&t->rows);
    par_ghost_free(t->plan);
    par_ghost_free(t->near);
    *t = (struct cracks_struts){0};
}

static int has_struts(const struct solid *s, int h) {
    int other[SOLID_FAMILY_MAX];
    signed char step[SOLID_FAMILY_MAX][3];
    return s->flag[h] & SOLID_BROKEN && solid_family_struts(s, h, other, step) > 0;
}

/* The next particle from h on whose flag BROKEN is set; s->n: none. */
static int next_broken(const struct solid *s, int h) {
    uint64_t flags, broken;
    memset(&broken, SOLID_BROKEN, sizeof broken);
    for (; h + (int)sizeof flags <= s->n; h += (int)sizeof flags) {
        memcpy(&flags, s->flag + h, sizeof flags);
        if (flags & broken) break;
    }
    while (h < s->n && !(s->flag[h] & SOLID_BROKEN)) h++;
    return h;
}

/* Finds the wet particles: with pores all, else those with a broken bond. Those with an id are known to be. Returns how
 * many were not known. h: NULL, or written. */
static int find_wet(const struct solid *s, const struct cracks_struts *t, int porous, int *h, int *n) {
    int added = 0;
    *n = 0;
    for (int k = porous ? 0 : next_broken(s, 0); k < s->n; k = porous ? k + 1 : next_broken(s, k + 1)) {
        const int known = t->id[k] >= 0;
        if (!known && !porous && !has_struts(s, k)) continue;
        added += !known;
        if (h) h[*n] = k;
        ++*n;
    }
    return added;
}

/* The arrays of the state in the order of the new wet particles. Both lists ascend. */
static void carry_over(struct cracks *c, int old_n, const int *old_h, int ghosts) {
    const struct cracks_struts *t = &c->struts;
    const size_t n = (size_t)t->n + 1;
    const int leaks = c->in.leak_off > 0, arrays = leaks ? 5 : 4;
    double **const array[] = {&c->content, &c->cavity, &c->volume, &c->storage, &c->since};
    double *p = memory_new(MEMORY_SOLID, n + (size_t)ghosts, sizeof *p), *value[5] = {0};
    cracks_vec *share = memory_new(MEMORY_SOLID, n, sizeof *share);
    for (int a = 0; a < arrays; a++) value[a] = memory_new(MEMORY_SOLID, n, sizeof *value[a]);
    for (int i = 0, j = 0; i < t->n; i++) {
        while (j < old_n && old_h[j] < t->h[i]) j++;
        if (j < old_n && old_h[j] == t->h[i]) {
            p[i] = c->p[j];
            share[i] = c->share[j];
            for (int a = 0; a < arrays; a++) value[a][i] = (*array[a])[j];
        } else {
            p[i] = c->in.least_pressure;
            if (leaks) value[4][i] = -1;
        }
    }
    MEMORY_FREE(c->p, c->share);
    c->p = p;
    c->share = share;
    for (int a = 0; a < arrays; a++) {
        memory_free(*array[a]);
        *array[a] = value[a];
    }
}

/* Numbers the wet particles of all ranks: id of owned ones and of the solid's ghosts. The wet ghosts follow the owned
 * particles in h, and the plan brings their values. Collective. */
static void number(const struct solid *s, struct cracks_struts *t) {
    const int size = par_size();
    long *first = memory_new(MEMORY_SOLID, (size_t)size + 1, sizeof *first), local = t->n;
    par_all_gather(&local, sizeof local, first + 1);
    for (int r = 0; r < size; r++) first[r + 1] += first[r];
    for (int i = 0; i < t->n; i++) t->id[t->h[i]] = first[par_rank()] + i;
    par_ghost_update_records(s->ghost, sizeof *t->id, t->id, s->n);
    long *wanted = memory_new(MEMORY_SOLID, (size_t)s->n_ghost + 1, sizeof *wanted);
    t->h = memory_grown(MEMORY_SOLID, t->h, (size_t)t->n, (size_t)(t->n + s->n_ghost) + 1, sizeof *t->h);
    t->ghosts = 0;
    for (int g = s->n; g < s->n + s->n_ghost; g++) {
        if (t->id[g] < 0) continue;
        wanted[t->ghosts] = t->id[g];
        t->h[t->n + t->ghosts++] = g;
    }
    par_ghost_free(t->plan);
    t->plan = par_ghost_new(first, t->ghosts, wanted);
    t->served = par_ghost_served(t->plan, &t->serve);
    MEMORY_FREE(wanted, first);
}

/* The plan of the ghosts at the ends of links. Collective. */
static void find_near(struct cracks_struts *t) {
    const struct cracks_rows *r = &t->rows;
    const int size = par_size();
    long *first = memory_new(MEMORY_SOLID, (size_t)size + 1, sizeof *first), local = t->n;
    long *wanted = memory_new(MEMORY_SOLID, (size_t)t->ghosts + 1, sizeof *wanted);
    uint8_t *ends = memory_new(MEMORY_SOLID, (size_t)r->places + CRACKS_LANES, sizeof *ends);
    par_all_gather(&local, sizeof local, first + 1);
    for (int q = 0; q < size; q++) first[q + 1] += first[q];
    for (long k = 0; r->n > 0 && k < r->link_start[r->n]; k++)
        for (int lane = 0; lane < CRACKS_LANES; lane++)
            if (r->link[k].lanes >> lane & 1) ends[r->link[k].at + lane] = 1;
    t->near_index = memory_renew(MEMORY_SOLID, t->near_index, (size_t)t->ghosts + 1, sizeof *t->near_index);
    t->nears = 0;
    for (int i = t->n; i < t->n + t->ghosts; i++) {
        if (!ends[t->place[i]]) continue;
        wanted[t->nears] = t->id[t->h[i]];
        t->near_index[t->nears++] = i;
    }
    par_ghost_free(t->near);
    t->near = par_ghost_new(first, t->nears, wanted);
    MEMORY_FREE(ends, wanted, first);
}

/* 1/mass of the free components, of wet particles and ghosts. Flags, volumes and bodies of ghosts are current. */
static void mobilities(const struct solid *s, struct cracks_struts *t) {
    for (int i = 0; i < t->n + t->ghosts; i++) {
        const int h = t->h[i];
        t->mobility[i] = (cracks_vec){0};
        for (int c = 0; c < s->dim; c++)
            if (!(s->flag[h] & SOLID_HELD_X << c)) t->mobility[i][c] = 1 / (solid_density(s, h) * s->volume[h]);
    }
}

void cracks_struts_areas_begin(const struct cracks_struts *t) {
    for (int i = 0; i < t->n + t->ghosts; i++)
        for (int k = 0; k < 3; k++) t->rows.u[k][t->place[i]] = t->mobility[i][k];
}

/* Sums over a row's struts, by lane: a_h of all and of the cracks' alone, m2; omega/2 of these, m2; and of all
 * (omega/2)^2 (xi_c/|xi|)^2/m_l, m4/kg. */
struct sums {
    double area[3][CRACKS_LANES], cracks[3][CRACKS_LANES], omega[CRACKS_LANES], others[CRACKS_LANES];
};

/* Those of the lanes from `lane` on, as many as a vec has. */
static void sums_of(const struct cracks *c, int row, int lane, struct sums *to) {
    const struct cracks_rows *r = &c->struts.rows;
    vec area[3] = {{0}}, cracks[3] = {{0}}, sum = {0}, others = {0};
    for (long k = r->start[row]; k < r->end[row]; k++) {
        const struct cracks_entry e = r->strut[k];
        const double *half = (const double *)&c->table.half[e.kind];
        if (k == r->middle[row]) memcpy(cracks, area, sizeof area);
        for (int d = 0; d < 3; d++) {
            area[d] += vec_where(e.lanes >> lane, vec_set(half[d]));
            others += vec_where(e.lanes >> lane, half[d] * half[d] * vec_load(r->u[d] + e.at + lane));
        }
        if (k < r->middle[row]) sum += vec_where(e.lanes >> lane, vec_set(0.5 * c->table.omega[e.kind]));
    }
    if (r->middle[row] == r->end[row]) memcpy(cracks, area, sizeof area);
    for (int d = 0; d < 3; d++) {
        vec_store(to->area[d] + lane, area[d]);
        vec_store(to->cracks[d] + lane, cracks[d]);
    }
    vec_store(to->omega + lane, sum);
    vec_store(to->others + lane, others);
}

/* Area vector, area, and the diagonal of B^T M^-1 B of a row's particles, where a_h and the sum are those of all
 * struts, intact bonds included: sum over c of a_h^2/m_h + sum over struts of (omega/2)^2 (xi_c/|xi|)^2/m_l */
void cracks_struts_areas(struct cracks *c, int row) {
    struct cracks_struts *t = &c->struts;
    const struct cracks_rows *r = &t->rows;
    struct sums sums;
    for (int lane = 0; lane < CRACKS_LANES; lane += VEC_LANES) sums_of(c, row, lane, &sums);
    for (int k = 0; k < CRACKS_LANES; k++) {
        const int i = r->index[row][k];
        if (i < 0) continue;
        const cracks_vec all = {sums.area[0][k], sums.area[1][k], sums.area[2][k], 0};
        t->area[i] = (cracks_vec){sums.cracks[0][k], sums.cracks[1][k], sums.cracks[2][k], 0};
        t->diagonal[i] = cracks_kernel_sum(all * all * t->mobility[i]) + sums.others[k];
        t->area_size[i] = sqrt(cracks_kernel_sum(t->area[i] * t->area[i]));
        if (!(t->area_size[i] < CANCELLED * (1 - TIE) * sums.omega[k])) continue;
        uint16_t kind[2 * SOLID_FAMILY_MAX];
        int broken = 0;
        for (long e = r->start[row]; e < r->middle[row]; e++)
            if (r->strut[e].lanes >> k & 1) kind[broken++] = r->strut[e].kind;
        t->area_size[i] = cracks_axis_area(&c->table, broken, kind);
    }
}

static void arrays_resize(struct cracks *c) {
    struct cracks_struts *t = &c->struts;
    const size_t n = (size_t)t->n + 1, all = n + (size_t)t->ghosts;
    t->place = memory_renew(MEMORY_SOLID, t->place, all, sizeof *t->place);
    t->slot = memory_renew(MEMORY_SOLID, t->slot, n, sizeof *t->slot);
    t->mobility = memory_renew(MEMORY_SOLID, t->mobility, all, sizeof *t->mobility);
    if (c->in.porous) c->open = memory_renew(MEMORY_SOLID, c->open, n, sizeof *c->open);
    if (c->in.leak_off > 0) c->leak = memory_renew(MEMORY_SOLID, c->leak, n, sizeof *c->leak);
}

/* A copy of an array of the particles that were wet before, by their new indices; new ones get 0. old_h [old_n] and h
 * ascend. Frees the old one. */
static void *moved(const struct cracks_struts *t, int old_n, const int *old_h, size_t bytes, void *array) {
    char *from = array, *to = memory_new(MEMORY_SOLID, (size_t)(t->n + t->ghosts) + 1, bytes);
    for (int i = 0, j = 0; i < t->n; i++) {
        while (j < old_n && old_h[j] < t->h[i]) j++;
        if (j < old_n && old_h[j] == t->h[i]) memcpy(to + bytes * (size_t)i, from + bytes * (size_t)j, bytes);
    }
    memory_free(array);
    return to;
}

/* The wet particles are others than before, or all is to be made again. Collective. */
static void renew_wet(struct cracks *c, int n) {
    const struct solid *s = c->solid;
    struct cracks_struts *t = &c->struts;
    const int old_n = t->n;
    int *old_h = t->h;
    t->h = memory_new(MEMORY_SOLID, (size_t)n + 1, sizeof *t->h);
    t->version++;
    find_wet(s, t, c->in.porous, t->h, &t->n);
    number(s, t);
    carry_over(c, old_n, old_h, t->ghosts);
    const int kept = t->rows.n > 0 ? old_n : 0; /* without rows all areas are found again */
    t->area = moved(t, kept, old_h, sizeof *t->area, t->area);
    t->area_size = moved(t, kept, old_h, sizeof *t->area_size, t->area_size);
    t->diagonal = moved(t, kept, old_h, sizeof *t->diagonal, t->diagonal);
    memory_free(old_h);
    arrays_resize(c);
    mobilities(s, t);
    cracks_rows_renew(&t->rows, s, t->n, t->ghosts, t->h);
    for (int i = 0; i < t->n + t->ghosts; i++) t->place[i] = t->rows.place[t->h[i]];
    for (int i = 0; i < t->n; i++)
        t->slot[i] = CRACKS_LANES * t->rows.row_of[t->place[i] / CRACKS_LANES] + t->place[i] % CRACKS_LANES;
    find_near(t);
    for (int k = 0; k < 3; k++) {
        t->rate[k] = memory_renew(MEMORY_SOLID, t->rate[k], CRACKS_LANES * (size_t)t->rows.n + 1, sizeof *t->rate[k]);
        for (int i = 0; i < t->n; i++) t->rate[k][t->slot[i]] = t->mobility[i][k];
    }
}

void cracks_struts_renew(struct cracks *c) {
    const struct solid *s = c->solid;
    struct cracks_struts *t = &c->struts;
    const int all = par_max(c->stale || c->restored || t->bonds_version != s->bonds_version) > 0;
    int n;
    if (!t->id) {
        t->id = memory_new(MEMORY_SOLID, (size_t)(s->n + s->n_ghost) + 1, sizeof *t->id);
        cracks_rows_place(&t->rows, s, &c->table);
    }
    if (all) {
        memset(t->id, 0xff, (size_t)(s->n + s->n_ghost) * sizeof *t->id);
        if (c->in.outside && !c->restored)
            cracks_rows_mark_stale(&t->rows);
        else
            cracks_rows_clear(&t->rows);
    }
    const int added = find_wet(s, t, c->in.porous, NULL, &n);
    if (par_max(all || added > 0) > 0) renew_wet(c, n);
    cracks_struts_areas_begin(t);
    for (int row = 0; row < t->rows.n; row++)
        if (cracks_rows_read(&t->rows, s, &c->table, t->h, c->in.porous, row)) cracks_struts_areas(c, row);
    cracks_rows_compact(&t->rows);
    cracks_struts_update(t, sizeof *t->area_size, t->area_size);
    t->bonds_version = s->bonds_version;
    c->stale = 0;
    c->renewals++;
}
