/* How a scene drives its fluid through the sample. */
#pragma once
#include "scene/scene.h"

struct permeability_drive {
    int axis;     /* -1: all sides are periodic; else the direction whose sides have pressures */
    int bulk;     /* 1: a mean velocity is held */
    double value; /* the driving's, Pa/m or m/s */
};

/* Dies on a scene from which no tensor can be found. Collective. */
struct permeability_drive permeability_drive_of(const struct scene *s);
/* The mean gradient that the scene's driving makes along an axis of a given permeability, Pa/m. Not collective. */
double permeability_drive_gradient(const struct permeability_drive *drive, const struct scene *s, int axis, double k);
/* The direction whose sides the solution along d has at direction c: those of d and of the pressures' axis are
 * exchanged. Not collective. */
int permeability_drive_sides(const struct permeability_drive *drive, int d, int c);
