/* Finds how a scene drives its fluid, and refuses what cannot be measured. */
#include "program/permeability/drive.h"
#include "base/die.h"
#include "base/side.h"
#include "scene/medium.h"

#include <math.h>

/* Dies on a scene from which no tensor can be found. */
struct permeability_drive permeability_drive_of(const struct scene *s) {
    const struct scene_fluid *f = s->fluid;
    struct permeability_drive drive = {.axis = -1};
    struct scene_medium m;
    if (!s->coupling || !f) die_all(EXIT_CODE_SCENE, "permeability: needs a scene with a fluid and a solid");
    for (int d = 0; d < 3; d++)
        for (int e = 0; e < 2; e++) {
            const struct scene_side *side = &f->side[d][e];
            const int moves = side->velocity[0] != 0 || side->velocity[1] != 0 || side->velocity[2] != 0;
            if (side->type == FLUID_PRESSURE && f->side[d][1 - e].type == FLUID_PRESSURE && (drive.axis < 0 || e == 1))
                drive.axis = d;
            else if (side->type != FLUID_PERIODIC && ((side->type != FLUID_WALL && side->type != FLUID_SLIP) || moves))
                die_all(EXIT_CODE_SCENE,
                        "frana permeability: %s is in the way: all sides must be periodic, or two opposite ones of "
                        "given pressure, with periodic sides, slip sides or walls at rest across",
                        side_name[d][e]);
        }
    const int periodic = s->domain.periodic[0] && s->domain.periodic[1] && s->domain.periodic[2];
    double push[3];
    scene_medium_of(s, &m);
    for (int d = 0; d < 3; d++) {
        const double length =
            sqrt(pow(f->driving_along[0], 2) + pow(f->driving_along[1], 2) + pow(f->driving_along[2], 2));
        const double part = length > 0 ? f->driving_along[d] / length : d == f->driving_direction;
        push[d] = f->density * f->body_force[d] + (f->driving == FLUID_DRIVING_GRADIENT ? part * f->driving_value : 0);
        drive.value += push[d] * push[d];
    }
    drive.value = sqrt(drive.value);
    if (f->driving == FLUID_DRIVING_BULK) drive.bulk = 1, drive.value = fabs(f->driving_value);
    if (drive.axis >= 0 && drive.value != 0)
        die_all(EXIT_CODE_SCENE,
                "frana permeability: sides of given pressure and a driving or a body force: leave one out");
    if (drive.axis >= 0 && f->side[drive.axis][0].pressure == f->side[drive.axis][1].pressure)
        die_all(EXIT_CODE_SCENE, "permeability: nothing drives the fluid along %c: its sides have the same pressure",
                "xyz"[drive.axis]);
    if (drive.axis < 0 && !periodic)
        die_all(EXIT_CODE_SCENE,
                "frana permeability: all sides must be periodic, or two opposite ones of given pressure");
    if (drive.axis < 0 && drive.value == 0)
        die_all(EXIT_CODE_SCENE, "permeability: nothing drives the fluid: give a gradient (fluid.driving), a body "
                                 "force or two sides of given pressure");
    if (f->driving_frequency > 0)
        die_all(EXIT_CODE_SCENE, "permeability: fluid.driving.frequency must be 0: the flow must become steady");
    return drive;
}

int permeability_drive_sides(const struct permeability_drive *drive, int d, int c) {
    if (drive->axis < 0) return c;
    return c == d ? drive->axis : c == drive->axis ? d : c;
}

double permeability_drive_gradient(const struct permeability_drive *drive, const struct scene *s, int axis, double k) {
    const struct scene_fluid *f = s->fluid;
    const int d = drive->axis;
    if (drive->bulk) return drive->value * f->density * f->viscosity / k;
    return d < 0 ? drive->value : fabs(f->side[d][0].pressure - f->side[d][1].pressure) / s->domain.size[axis];
}
