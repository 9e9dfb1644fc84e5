/* The wet particles, their struts and links: found from the solid's broken bonds. */
#include "cracks/struts.h"
#include "base/ensure.h"
#include "base/memory.h"
#include "base/par.h"
#include "base/par_ghost.h"
#include "cracks/axis.h"
#include "cracks/off.h"
#include "solid/bonds/family.h"
#include "solid/bonds/lost.h"

#include <math.h>
#include <string.h>

/* Below this part of the sum of omega/2 the area vectors of several faces cancel in a_h. A single face has more: half
 * of it in the layer next to a plane, 0.9 in the last one. */
static const double CANCELLED = 0.2;

int cracks_struts_changed(struct cracks *c) {
    struct solid *s = c->solid;
    const int here =
        solid_lost_take(s, SOLID_BROKE_PUSH) || c->stale || c->restored || c->struts.bonds_version != s->bonds_version;
    return par_max(here) > 0;
}

void cracks_struts_update(const struct cracks_struts *t, size_t bytes, void *record) {
    par_ghost_update_records(t->plan, bytes, record, t->n);
}

void cracks_struts_free(struct cracks_struts *t) {
    void *const own[] = {t->h,    t->start,    t->middle, t->other,     t->kind,     t->link_start,
                         t->link, t->mobility, t->area,   t->area_size, t->diagonal, t->id};
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) memory_free(own[i]);
    par_ghost_free(t->plan);
    *t = (struct cracks_struts){0};
}

/* Room for one more wet particle and its struts. */
static void make_room(struct cracks_struts *t, long struts, int porous) {
    if (t->n + 1 >= t->room) {
        const int room = 2 * t->room + 64;
        t->h = memory_grown(MEMORY_SOLID, t->h, (size_t)t->n, (size_t)room, sizeof *t->h);
        t->start = memory_grown(MEMORY_SOLID, t->start, (size_t)t->n, (size_t)room, sizeof *t->start);
        if (porous) t->middle = memory_grown(MEMORY_SOLID, t->middle, (size_t)t->n, (size_t)room, sizeof *t->middle);
        t->room = room;
    }
    if (struts + SOLID_FAMILY_MAX > t->strut_room) {
        const size_t used = (size_t)struts, room = 2 * (size_t)t->strut_room + SOLID_FAMILY_MAX;
        t->other = memory_grown(MEMORY_SOLID, t->other, used, room, sizeof *t->other);
        t->kind = memory_grown(MEMORY_SOLID, t->kind, used, room, sizeof *t->kind);
        t->strut_room = (long)room;
    }
}

/* Reads the struts of all wet particles: h, start, other (local index in the solid) and kind. With pores the intact
 * bonds follow the broken ones. */
static void read_struts(const struct solid *s, const struct cracks_table *table, int porous, struct cracks_struts *t) {
    int other[SOLID_FAMILY_MAX];
    signed char step[SOLID_FAMILY_MAX][3];
    long struts = 0;
    t->n = 0;
    for (int h = 0; h < s->n; h++) {
        const int found = s->flag[h] & SOLID_BROKEN ? solid_family_struts(s, h, other, step) : 0;
        if (found == 0 && !porous) continue;
        make_room(t, struts, porous);
        t->h[t->n] = h;
        t->start[t->n] = struts;
        for (int k = 0; k < found; k++, struts++) {
            t->other[struts] = other[k];
            t->kind[struts] = (uint16_t)cracks_table_number(table, step[k]);
        }
        if (porous) {
            t->middle[t->n] = struts;
            const int intact = solid_family_intact(s, h, other, step);
            for (int k = 0; k < intact; k++, struts++) {
                t->other[struts] = other[k];
                t->kind[struts] = (uint16_t)(table->kinds + cracks_table_number(table, step[k]));
            }
        }
        t->n++;
    }
    if (t->room == 0) t->start = memory_new(MEMORY_SOLID, (size_t)(t->room = 1), sizeof *t->start);
    t->start[t->n] = struts;
}

/* Reads the links: nearest neighbours that are wet, by local index in the solid. */
static void read_links(const struct solid *s, struct cracks_struts *t) {
    int nearest[6], links = 0;
    t->link_start = memory_renew(MEMORY_SOLID, t->link_start, (size_t)t->n + 1, sizeof *t->link_start);
    t->link = memory_renew(MEMORY_SOLID, t->link, 6 * (size_t)t->n + 1, sizeof *t->link);
    for (int i = 0; i < t->n; i++) {
        t->link_start[i] = links;
        solid_family_nearest(s, t->h[i], nearest);
        for (int f = 0; f < 6; f++)
            if (nearest[f] >= 0 && t->id[nearest[f]] >= 0) t->link[links++] = nearest[f];
    }
    t->link_start[t->n] = links;
}

/* The arrays of the state in the order of the new wet particles. Both lists ascend. */
static void carry_over(struct cracks *c, int old_n, const int *old_h, int ghosts) {
    const struct cracks_struts *t = &c->struts;
    const size_t n = (size_t)t->n + 1;
    const int leaks = c->in.leak_off > 0, arrays = leaks ? 5 : 4;
    double **const array[] = {&c->content, &c->cavity, &c->volume, &c->storage, &c->since};
    double *p = memory_new(MEMORY_SOLID, n + (size_t)ghosts, sizeof *p), *value[5];
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
    memory_free(c->p);
    memory_free(c->share);
    c->p = p;
    c->share = share;
    for (int a = 0; a < arrays; a++) {
        memory_free(*array[a]);
        *array[a] = value[a];
    }
}

/* Numbers the wet particles of all ranks: id of owned ones and of the solid's ghosts. Returns the first number of every
 * rank [size + 1]. Collective. */
static long *number(const struct solid *s, struct cracks_struts *t, int old_n, const int *old_h) {
    const int size = par_size();
    long *first = memory_new(MEMORY_SOLID, (size_t)size + 1, sizeof *first), mine = t->n;
    par_all_gather(&mine, sizeof mine, first + 1);
    for (int r = 0; r < size; r++) first[r + 1] += first[r];
    if (!t->id) {
        t->id = memory_new(MEMORY_SOLID, (size_t)(s->n + s->n_ghost) + 1, sizeof *t->id);
        for (int h = 0; h < s->n; h++) t->id[h] = -1;
    }
    for (int i = 0; i < old_n; i++) t->id[old_h[i]] = -1;
    for (int i = 0; i < t->n; i++) t->id[t->h[i]] = first[par_rank()] + i;
    par_ghost_update_records(s->ghost, sizeof *t->id, t->id, s->n);
    return first;
}

/* The ghosts at the ends of struts and links: their places in h and the plan. Struts and links then hold wet indices.
 * Collective. */
static void link_ghosts(const struct solid *s, struct cracks_struts *t, const long *first) {
    int *slot = memory_new(MEMORY_SOLID, (size_t)s->n_ghost + 1, sizeof *slot);
    const long struts = t->start[t->n], links = t->link_start[t->n], before = first[par_rank()];
    for (long k = 0; k < struts; k++)
        if (t->other[k] >= s->n) slot[t->other[k] - s->n] = 1;
    for (long k = 0; k < links; k++)
        if (t->link[k] >= s->n) slot[t->link[k] - s->n] = 1;
    t->ghosts = 0;
    for (int g = 0; g < s->n_ghost; g++) t->ghosts += slot[g];
    long *wanted = memory_new(MEMORY_SOLID, (size_t)t->ghosts + 1, sizeof *wanted);
    t->h = memory_grown(MEMORY_SOLID, t->h, (size_t)t->n, (size_t)(t->room + t->ghosts), sizeof *t->h);
    t->ghosts = 0;
    for (int g = 0; g < s->n_ghost; g++) {
        if (!slot[g]) continue;
        wanted[t->ghosts] = t->id[s->n + g];
        ENSURE(wanted[t->ghosts] >= 0, "ghost %d has a strut at one end only", g);
        slot[g] = t->n + t->ghosts++;
        t->h[slot[g]] = s->n + g;
    }
    for (long k = 0; k < struts; k++)
        t->other[k] = t->other[k] < s->n ? (int)(t->id[t->other[k]] - before) : slot[t->other[k] - s->n];
    for (long k = 0; k < links; k++)
        t->link[k] = t->link[k] < s->n ? (int)(t->id[t->link[k]] - before) : slot[t->link[k] - s->n];
    par_ghost_free(t->plan);
    t->plan = par_ghost_new(first, t->ghosts, wanted);
    memory_free(wanted);
    memory_free(slot);
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

/* Area vector, area, and the diagonal of B^T M^-1 B, where a_h and the sum are those of all struts, intact bonds
 * included: sum over c of a_h^2/m_h + sum over struts of (omega/2)^2 (xi_c/|xi|)^2/m_l */
void cracks_struts_area(struct cracks_struts *t, const struct cracks_table *table, int i) {
    const long broken = t->middle ? t->middle[i] : t->start[i + 1];
    cracks_vec area = {0}, others = {0};
    double sum = 0;
    for (long k = t->start[i]; k < broken; k++) {
        const cracks_vec half = table->half[t->kind[k]];
        area += half;
        others += half * half * t->mobility[t->other[k]];
        sum += 0.5 * table->omega[t->kind[k]];
    }
    t->area[i] = area;
    t->area_size[i] = sqrt(cracks_kernel_sum(area * area));
    if (t->area_size[i] < CANCELLED * sum)
        t->area_size[i] = cracks_axis_area(table, (int)(broken - t->start[i]), t->kind + t->start[i]);
    for (long k = broken; k < t->start[i + 1]; k++) {
        const cracks_vec half = table->half[t->kind[k]];
        area += half;
        others += half * half * t->mobility[t->other[k]];
    }
    t->diagonal[i] = cracks_kernel_sum(area * area * t->mobility[i] + others);
}

static void arrays_resize(struct cracks *c) {
    struct cracks_struts *t = &c->struts;
    const size_t n = (size_t)t->n + 1, all = n + (size_t)t->ghosts;
    t->mobility = memory_renew(MEMORY_SOLID, t->mobility, all, sizeof *t->mobility);
    t->area = memory_renew(MEMORY_SOLID, t->area, n, sizeof *t->area);
    t->area_size = memory_renew(MEMORY_SOLID, t->area_size, all, sizeof *t->area_size);
    t->diagonal = memory_renew(MEMORY_SOLID, t->diagonal, n, sizeof *t->diagonal);
    if (c->in.porous) c->open = memory_renew(MEMORY_SOLID, c->open, n, sizeof *c->open);
    if (c->in.leak_off > 0) c->leak = memory_renew(MEMORY_SOLID, c->leak, n, sizeof *c->leak);
}

/* The places of a swap: struts a and b. */
static void swap_struts(struct cracks_struts *t, long a, long b) {
    const int other = t->other[a];
    const uint16_t kind = t->kind[a];
    t->other[a] = t->other[b];
    t->kind[a] = t->kind[b];
    t->other[b] = other;
    t->kind[b] = kind;
}

/* Intact bonds of a particle that are broken now move in front of the others. Returns whether there are some. */
static int move_broken(const struct solid *s, const struct cracks_table *table, struct cracks_struts *t, int i) {
    int other[SOLID_FAMILY_MAX];
    signed char step[SOLID_FAMILY_MAX][3];
    uint8_t is_broken[SOLID_FAMILY_MAX] = {0};
    const int found = solid_family_struts(s, t->h[i], other, step);
    if (found == t->middle[i] - t->start[i]) return 0;
    for (int k = 0; k < found; k++) is_broken[cracks_table_number(table, step[k])] = 1;
    for (long k = t->middle[i]; k < t->start[i + 1]; k++) {
        const int kind = t->kind[k] - table->kinds;
        if (!is_broken[kind]) continue;
        t->kind[k] = (uint16_t)kind;
        swap_struts(t, k, t->middle[i]++);
    }
    ENSURE(t->middle[i] - t->start[i] == found, "particle %d has %d broken bonds", t->h[i], found);
    return 1;
}

/* With pores all particles are wet, so that only the kinds of struts change when bonds break. */
static void renew_kinds(struct cracks *c) {
    struct cracks_struts *t = &c->struts;
    for (int i = 0; i < t->n; i++)
        if (c->solid->flag[t->h[i]] & SOLID_BROKEN && move_broken(c->solid, &c->table, t, i))
            cracks_struts_area(t, &c->table, i);
    cracks_struts_update(t, sizeof *t->area_size, t->area_size);
    c->renewals++;
}

void cracks_struts_renew(struct cracks *c) {
    const struct solid *s = c->solid;
    struct cracks_struts *t = &c->struts;
    if (c->in.porous && !par_max(c->stale || c->restored || t->bonds_version != s->bonds_version)) {
        renew_kinds(c);
        return;
    }
    const int old_n = t->n;
    int *old_h = memory_copy(MEMORY_SOLID, t->h, (size_t)old_n, sizeof *old_h);
    const int switches = c->in.outside && !c->restored && old_n > 0;
    const long old_struts = switches ? t->start[old_n] : 0;
    long *old_start = switches ? memory_copy(MEMORY_SOLID, t->start, (size_t)old_n + 1, sizeof *old_start) : NULL;
    uint16_t *old_kind = switches ? memory_copy(MEMORY_SOLID, t->kind, (size_t)old_struts, sizeof *old_kind) : NULL;
    read_struts(s, &c->table, c->in.porous, t);
    long *first = number(s, t, old_n, old_h);
    read_links(s, t);
    link_ghosts(s, t, first);
    carry_over(c, old_n, old_h, t->ghosts);
    arrays_resize(c);
    mobilities(s, t);
    if (switches) cracks_off_keep(c, old_n, old_h, old_start, old_kind);
    for (int i = 0; i < t->n; i++) cracks_struts_area(t, &c->table, i);
    cracks_struts_update(t, sizeof *t->area_size, t->area_size);
    memory_free(old_start);
    memory_free(old_kind);
    memory_free(old_h);
    memory_free(first);
    t->bonds_version = s->bonds_version;
    c->stale = 0;
    c->renewals++;
}
