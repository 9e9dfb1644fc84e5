/* The image of a body: read by all ranks, each its slabs, and turned into bits of solid. */
#pragma once
#include "base/files/image.h"
#include "scene/scene.h"
#include "solid/voxels/components.h"

enum { SETUP_IMAGE_LABELS = 32 };

struct setup_image {
    const struct scene_body *body; /* borrowed */
    int number;                    /* of the body */
    int used[3];                   /* voxels that are used along x, y, z, before mirroring */
    int per_cell;                  /* voxels along the edge of a cell that takes several; else 1 */
    char format[16], type[16];
    double header_voxel[3]; /* as the file's header gives it; 0: it does not */
    char header_unit[16];
    /* of the voxels used */
    double least, most, mean;
    long solid; /* voxels of the solid */
    int labels; /* different values; above SETUP_IMAGE_LABELS they are not listed */
    struct {
        int value;
        long voxels;
    } label[SETUP_IMAGE_LABELS];
    struct solid_voxels *voxels; /* as the body is made of them: cropped, turned, coarsened, mirrored; owned */
};

/* Opens the file of a body's image. NULL with a sentence if it cannot be read. Not collective. */
struct files_image *setup_image_file(const struct scene_body *body, char *problem, size_t capacity);
/* Reads the image of body b. Dies (exit 2) where the file cannot be read, a label does not occur, or everything is
 * solid or pore. Collective. */
struct setup_image *setup_image_read(const struct scene *scene, int b);
void setup_image_free(struct setup_image *image); /* may be NULL */

/* Directions in which the image's ends touch across periodic sides. Not collective. */
void setup_image_wraps(const struct scene *scene, const struct setup_image *image, int wraps[3]);
/* The connected pieces of the image's solid; what a constraint holds is not loose. malloc'ed boxes are freed. Not
 * collective. */
struct solid_components *setup_image_solid(const struct scene *scene, const struct setup_image *image);
/* Removes or holds the solid's loose pieces, as the scene asks, and says in the log how many there are. Collective. */
void setup_image_floating(const struct scene *scene, struct setup_image *image);
