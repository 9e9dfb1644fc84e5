#include "solid/surface_state.h"
#include "base/par.h"
#include "solid/family.h"
#include "solid/normal.h"
#include "solid/surface_lists.h"
#include "solid/surface_lost.h"
#include "solid/surface_sector.h"

#include <string.h>

/* n (3), what the two feelers had moved (6), their places in the family (2), two-sided, open cones */
enum { STATE = 13 };

int solid_surface_state_size(void) { return STATE; }

static double place_of(const struct solid_family_view *view, int l) {
    for (int b = 0; b < view->n; b++)
        if (view->l[b] == l) return b;
    return -1;
}

void solid_surface_save(const struct solid *s, const struct solid_surface *f, double *state) {
    struct solid_family_view view;
    memset(state, 0, (size_t)s->n * STATE * sizeof *state);
    for (int i = 0; i < f->n; i++) {
        const int h = f->h[i];
        const struct solid_facing *facing = &f->facing[h];
        double *to = state + (size_t)h * STATE;
        solid_family_view(s, h, &view);
        memcpy(to, facing->n, sizeof facing->n);
        memcpy(to + 3, facing->moved, sizeof facing->moved);
        for (int k = 0; k < 2; k++) to[9 + k] = place_of(&view, facing->l[k]);
        to[11] = facing->two_sided;
        to[12] = facing->open;
    }
}

/* Lists and watched particles, from d, the bonds, the flags and the normals as they are now. */
static void resume(struct solid *s, struct solid_surface *f) {
    for (int k = 0; k < f->watched; k++) f->watch_of[f->watch[k].h] = -1;
    f->watched = 0;
    solid_lost_find(f->lost, s); /* what is lost is known */
    for (int h = 0; h < s->n; h++) {
        struct solid_watch w;
        if (s->flag[h] & SOLID_BROKEN) solid_surface_look(s, f, h, &w);
    }
    s->broke = SOLID_BROKE_CONTACT; /* its lists are to be made */
    solid_surface_gather(s, f);
    solid_surface_count(f, 0);
}

void solid_surface_load(struct solid *s, struct solid_surface *f, const double *state) {
    struct solid_family_view view;
    for (int h = 0; h < s->n; h++) {
        const double *from = state + (size_t)h * STATE;
        if (!(s->flag[h] & SOLID_INTERFACE)) continue;
        solid_family_view(s, h, &view);
        struct solid_facing *facing = &f->facing[h];
        memcpy(facing->n, from, sizeof facing->n);
        memcpy(facing->moved, from + 3, sizeof facing->moved);
        for (int k = 0; k < 2; k++) facing->l[k] = from[9 + k] < 0 ? -1 : view.l[(int)from[9 + k]];
        facing->two_sided = (uint8_t)from[11];
        facing->open = (uint8_t)from[12];
    }
    resume(s, f);
}

void solid_surface_keep(const struct solid_surface *f, struct solid_facing *kept) {
    for (int i = 0; i < f->n; i++) kept[i] = f->facing[f->h[i]];
}

void solid_surface_restore(struct solid *s, struct solid_surface *f, const struct solid_facing *kept) {
    for (int h = 0; h < s->n; h++)
        if (s->flag[h] & SOLID_INTERFACE) f->facing[h] = *kept++;
    resume(s, f);
}
