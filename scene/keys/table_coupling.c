/* Keys of the section coupling. */
#include "scene/keys/table.h"

static const struct scene_word surfaces[] = {WORD("lattice", SOLID_DEPTH_COUNTED), WORD("shape", SOLID_DEPTH_SHAPE),
                                             WORD("cubes", SOLID_DEPTH_HALF)};
static const struct scene_word loads[] = {WORD("reaction", SCENE_LOAD_REACTION), WORD("probe", SCENE_LOAD_PROBE)};
static const struct scene_word directions[] = {WORD("auto", SCENE_MEDIUM_AUTO), WORD("x", SCENE_MEDIUM_X),
                                               WORD("y", SCENE_MEDIUM_Y), WORD("z", SCENE_MEDIUM_Z),
                                               WORD("driving", SCENE_MEDIUM_DRIVING)};

/* clang-format off */
#define OF scene_coupling
static const struct scene_key medium[] = {
    KEY("low", VECTOR(box_low), "m"),
    KEY("high", VECTOR(box_high), "m"),
    KEY("direction", CHOICE(medium_direction, directions), "choice", DEFAULT("auto")),
    END};
const struct scene_key scene_table_coupling[] = {
    KEY("forcing_iterations", WHOLE(forcing_iterations), "1", DEFAULT("2"), WITHIN(1, 100)),
    KEY("surface", CHOICE(surface, surfaces), "choice", DEFAULT("lattice")),
    KEY("retraction", NUMBER(retraction), "cells", WITHIN(-1, 1)),
    KEY("probe_length", NUMBER(probe_length), "cells", DEFAULT("2"), WITHIN(0, 10), WITHOUT_LOW),
    KEY("load", CHOICE(load, loads), "choice"),
    KEY("medium", PART(medium), "section"),
    END};
#undef OF
/* clang-format on */
