/* Keys of the section solid.refinement. */
#include "physics/limits.h"
#include "scene/keys/table.h"

static const struct scene_word horizons[] = {WORD("scaled", 0), WORD("kept", 1)};
static const struct scene_word interfaces[] = {WORD("plain", 0), WORD("corrected", 1)};
static const struct scene_word held[] = {WORD("keep", 0), WORD("refine", 1)};

/* clang-format off */
#define OF scene_refined
static const struct scene_key starts[] = {
    KEY("low", VECTOR(low), "m", NEEDED),
    KEY("high", VECTOR(high), "m", NEEDED),
    KEY("rotation", INNER(turn, scene_table_plate_rotation), "section"),
    KEY("level", WHOLE(level), "1", NEEDED, WITHIN(1, PHYSICS_LEVELS_MAX)),
    END};
#undef OF
ENTRY(start, scene_refined, starts);

#define OF scene_refinement
const struct scene_key scene_table_refinement[] = {
    KEY("levels", WHOLE(levels), "1", DEFAULT("1"), WITHIN(1, PHYSICS_LEVELS_MAX)),
    KEY("energy", NUMBER(energy), "1", DEFAULT("0.4"), WITHIN(0, 1), WITHOUT_LOW, OR("off", 0)),
    KEY("damage", NUMBER(damage), "1", DEFAULT("off"), WITHIN(0, 1), WITHOUT_ENDS, OR("off", 0)),
    KEY("from", NUMBER(from), "s", DEFAULT("0"), FROM(0)),
    KEY("low", VECTOR(low), "m", WITH("high")),
    KEY("high", VECTOR(high), "m", WITH("low")),
    KEY("rotation", INNER(turn, scene_table_plate_rotation), "section", WITH("low")),
    KEY("every", WHOLE(every), "steps", DEFAULT("10"), FROM(1)),
    KEY("horizon", CHOICE(horizon_kept, horizons), "choice", DEFAULT("scaled")),
    KEY("interface", CHOICE(interface_corrected, interfaces), "choice", DEFAULT("plain")),
    KEY("held", CHOICE(held_refine, held), "choice", DEFAULT("keep")),
    KEY("start", LIST(start, start, starts, 1, LIST_MAX), "list"),
    END};
#undef OF
/* clang-format on */
