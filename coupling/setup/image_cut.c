/* Finds samples that fill the domain between periodic sides of a flow, and whose pores are shut there. */
#include "coupling/setup/image_cut.h"
#include "stokes/mask.h"

#include <math.h>
#include <stdio.h>

static int is_pore(const struct solid_voxels *v, const uint64_t *gone, const int at[3]) {
    return !solid_voxels_is(v, v->bits, at[0], at[1], at[2]) || (gone && solid_voxels_is(v, gone, at[0], at[1], at[2]));
}

double image_cut_meets(const struct scene *scene, const struct solid_voxels *v, const uint64_t *gone, int axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    struct stokes_mask_meeting q = {0};
    int is_cut;
    if (!scene->fluid || !scene->domain.periodic[axis]) return NAN;
    const double edge = v->sites[axis] * scene->solid->spacing;
    if (fabs(v->n[axis] * edge - scene->domain.size[axis]) > 0.5 * edge) return NAN;
    for (int i = 0; i < v->n[a]; i++)
        for (int j = 0; j < v->n[b]; j++) {
            int at[3] = {0};
            at[a] = i;
            at[b] = j;
            const int first = is_pore(v, gone, at);
            at[axis] = v->n[axis] - 1;
            const int last = is_pore(v, gone, at);
            q.low += first;
            q.high += last;
            q.both += first && last;
        }
    const double meets = stokes_mask_share(&q, (double)v->n[a] * v->n[b], &is_cut);
    return is_cut ? meets : NAN;
}

int image_cut_say(double meets, int axis, char sentence[IMAGE_CUT_SENTENCE]) {
    if (isnan(meets)) return 0;
    snprintf(
        sentence, IMAGE_CUT_SENTENCE,
        "across the periodic sides of %c %.3g %% of the pores' area meets pores, and the others are shut: a sample "
        "that is cut from a larger one is too tight there, perhaps many times. Mirror it (mirror: %c), or give "
        "pressures at two sides",
        "xyz"[axis], 100 * meets, "xyz"[axis]);
    return 1;
}
