/* Finds samples that fill the domain between periodic sides of a flow, and whose pores end at solid there. */
#include "coupling/setup/image_cut.h"
#include "stokes/mask.h"

#include <math.h>
#include <stdio.h>

static int is_pore(const struct solid_voxels *v, const uint64_t *gone, const int at[3]) {
    return !solid_voxels_is(v, v->bits, at[0], at[1], at[2]) || (gone && solid_voxels_is(v, gone, at[0], at[1], at[2]));
}

double image_cut_share(const struct scene *scene, const struct solid_voxels *v, const uint64_t *gone, int axis) {
    const int a = (axis + 1) % 3, b = (axis + 2) % 3;
    struct stokes_mask_overlap q = {0};
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
    const double share = stokes_mask_overlap_share(&q, (double)v->n[a] * v->n[b], &is_cut);
    return is_cut ? share : NAN;
}

int image_cut_describe(double share, int axis, char sentence[IMAGE_CUT_SENTENCE]) {
    if (isnan(share)) return 0;
    snprintf(
        sentence, IMAGE_CUT_SENTENCE,
        "across the periodic sides of %c only %.3g %% of the pores' area is open: the other pores end at solid, as in "
        "a "
        "sample that was cut from a larger one. Its permeability is too small, perhaps by a large factor. Mirror it "
        "(mirror: %c), or give pressures at two sides",
        "xyz"[axis], 100 * share, "xyz"[axis]);
    return 1;
}
