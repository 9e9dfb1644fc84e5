/* Compares the size of a voxel in an image's header with that of the scene, which counts. */
#include "coupling/setup/image_voxel.h"
#include "coupling/setup/image.h"

#include <math.h>
#include <stdio.h>

static const double SAME = 0.01; /* headers round */

int image_voxel_differs(const struct scene *scene, int b, char sentence[IMAGE_VOXEL_SENTENCE]) {
    const struct scene_body *body = &scene->solid->body[b];
    char problem[512];
    if (body->own.shape != SOLID_IMAGE) return 0;
    struct files_image *file = setup_image_file(body, problem, sizeof problem);
    if (!file) return 0; /* the set-up has said why */
    double says[3];
    int d = 0;
    for (int c = 0; c < 3; c++) says[c] = files_image_unit(file)[0] ? files_image_voxel(file)[c] : 0;
    files_image_close(file);
    while (d < 3 && (!(says[d] > 0) || fabs(body->image.voxel[d] / says[d] - 1) <= SAME)) d++;
    if (d == 3) return 0;
    const double ratio = body->image.voxel[d] / says[d];
    snprintf(sentence, IMAGE_VOXEL_SENTENCE,
             "the header of %.400s says voxels of %.6g m along %c, and solid.bodies[%d].voxel is %.6g m, which counts: "
             "lengths along it are %.4g and permeabilities %.4g times the header's",
             body->own.file, says[d], "xyz"[d], b, body -> image.voxel[d], ratio, ratio *ratio);
    return 1;
}
