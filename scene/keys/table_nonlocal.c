/* Keys of the section nonlocal. */
#include "scene/keys/table.h"

/* clang-format off */
#define OF scene_nonlocal
const struct scene_key scene_table_nonlocal[] = {
    KEY("dimension", WHOLE(dimension), "1", NEEDED, WITHIN(1, 3)),
    KEY("exponent", NUMBER(exponent), "1", NEEDED, FROM(0)),
    KEY("horizon", NUMBER(horizon), "m", NEEDED, ABOVE(0)),
    KEY("inner_radius", NUMBER(inner_radius), "m", NEEDED, ABOVE(0)),
    KEY("outer_radius", NUMBER(outer_radius), "m", NEEDED, ABOVE(0)),
    KEY("spacing", NUMBER(spacing), "m", NEEDED, ABOVE(0), NOT_WITH("points")),
    KEY("points", WHOLE(points), "1", FROM(2)),
    KEY("arrangement", INNER(arrangement, scene_table_points), "section", DEFAULT("{}")),
    KEY("condition", SWITCH(condition), "bool", DEFAULT("true")),
    END};
#undef OF
/* clang-format on */
