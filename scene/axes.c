/* The directions that a word of axes (xy, xyz, ...) names. */
#include "base/ensure.h"
#include "scene/scene.h"

int scene_axes_has(enum scene_axes axes, int direction) {
    switch (axes) {
    case SCENE_XY:
        return direction != 2;
    case SCENE_XZ:
        return direction != 1;
    case SCENE_YZ:
        return direction != 0;
    case SCENE_XYZ:
        return 1;
    }
    ENSURE(0, "axes %d", (int)axes);
}
