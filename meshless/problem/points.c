/* Translates the scene's arrangements and volumes of points. An enumerator that is missing does not compile. */
#include "meshless/problem/points.h"
#include "base/ensure.h"

enum meshless_arrangement meshless_points_arrangement(enum scene_arrangement kind) {
    switch (kind) {
    case SCENE_ARRANGED_LATTICE:
        return MESHLESS_LATTICE;
    case SCENE_ARRANGED_HEXAGONAL:
        return MESHLESS_HEXAGONAL;
    case SCENE_ARRANGED_PERTURBED:
        return MESHLESS_PERTURBED;
    case SCENE_ARRANGED_CENTROIDAL:
        return MESHLESS_CENTROIDAL;
    case SCENE_ARRANGED_RANDOM:
        return MESHLESS_RANDOM;
    }
    ENSURE(0, "arrangement %d of the scene", (int)kind);
}

enum meshless_volume meshless_points_volume(enum scene_point_volume kind) {
    switch (kind) {
    case SCENE_VOLUME_EQUAL:
        return MESHLESS_EQUAL;
    case SCENE_VOLUME_CELL:
        return MESHLESS_CELL;
    }
    ENSURE(0, "volume %d of the scene", (int)kind);
}
