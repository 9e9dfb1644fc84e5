/* The surface's normals as stored in a checkpoint and in a snapshot. */
#include "solid/surface/state.h"
#include "base/memory.h"
#include "solid/bonds/family.h"
#include "solid/bonds/broken_tracker.h"
#include "solid/surface/lists.h"
#include "solid/surface/normal.h"
#include "solid/surface/sector.h"

#include <string.h>

/* n (3), d_l - d_h of the two reference bonds (6), their numbers in the family (2), two_sided, open cones */
enum { STATE = 13 };

int solid_surface_state_size(void) { return STATE; }

static double place_of(const struct solid_family_view *view, int l) {
    for (int b = 0; b < view->n; b++)
        if (view->l[b] == l) return b;
    return -1;
}

void solid_surface_state_save(const struct solid *s, const struct solid_surface *f, double *state) {
    struct solid_family_view view;
    memset(state, 0, (size_t)s->n * STATE * sizeof *state);
    for (int i = 0; i < f->n; i++) {
        const int h = f->h[i];
        const struct solid_normal_data *data = &f->normal_data[h];
        double *to = state + (size_t)h * STATE;
        solid_family_view(s, h, &view);
        memcpy(to, data->n, sizeof data->n);
        memcpy(to + 3, data->moved, sizeof data->moved);
        for (int k = 0; k < 2; k++) to[9 + k] = place_of(&view, data->l[k]);
        to[11] = data->two_sided;
        to[12] = data->open;
    }
}

/* Makes the cones and the lists from the present bonds, flags and normals. f->tracker is up to date. */
static void resume(struct solid *s, struct solid_surface *f) {
    for (int k = 0; k < f->cones_used; k++) f->cones_of[f->cones[k].h] = -1;
    f->cones_used = 0;
    for (int h = 0; h < s->n; h++) {
        struct solid_cones w;
        if (s->flag[h] & SOLID_BROKEN) solid_surface_classify(s, f, h, &w);
    }
    solid_surface_gather(s, f);
}

void solid_surface_state_load(struct solid *s, struct solid_surface *f, const double *state) {
    struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        const double *from = state + (size_t)h * STATE;
        if (!(s->flag[h] & SOLID_INTERFACE)) continue;
        solid_family_view(s, h, &view);
        struct solid_normal_data *data = &f->normal_data[h];
        memcpy(data->n, from, sizeof data->n);
        memcpy(data->moved, from + 3, sizeof data->moved);
        for (int k = 0; k < 2; k++) data->l[k] = from[9 + k] < 0 ? -1 : view.l[(int)from[9 + k]];
        data->two_sided = (uint8_t)from[11];
        data->open = (uint8_t)from[12];
    }
    solid_broken_tracker_find(f->tracker, s);
    resume(s, f);
    s->broke = SOLID_BROKE_CONTACT; /* contact's lists are still to be made */
    solid_surface_count(f, 0);
}

struct solid_surface_snapshot {
    long total, isolated;
    struct solid_normal_data *data; /* [interface particles, with room for s->n] by rising index */
};

struct solid_surface_snapshot *solid_surface_state_snapshot_new(const struct solid *s) {
    struct solid_surface_snapshot *k = memory_new(MEMORY_OUTPUT, 1, sizeof *k);
    k->data = memory_new(MEMORY_OUTPUT, (size_t)s->n + 1, sizeof *k->data);
    return k;
}

void solid_surface_state_snapshot_free(struct solid_surface_snapshot *k) {
    if (!k) return;
    MEMORY_FREE(k->data, k);
}

void solid_surface_state_snapshot_take(struct solid_surface_snapshot *k, const struct solid_surface *f) {
    for (int i = 0; i < f->n; i++) k->data[i] = f->normal_data[f->h[i]];
    k->total = f->total;
    k->isolated = f->isolated;
}

void solid_surface_state_snapshot_restore(const struct solid_surface_snapshot *k, struct solid *s,
                                          struct solid_surface *f, const struct solid_broken_tracker *tracker) {
    const struct solid_normal_data *saved = k->data;
    for (int h = 0; h < s->n; h++)
        if (s->flag[h] & SOLID_INTERFACE) f->normal_data[h] = *saved++;
    if (tracker) {
        solid_broken_tracker_copy(f->tracker, tracker, s);
        resume(s, f);
    } else {
        solid_surface_renew(s, f);
    }
    f->total = k->total;
    f->isolated = k->isolated;
}
