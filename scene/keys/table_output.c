/* Keys of the section output. */
#include "scene/keys/table.h"

#define PROBES_MAX 10000
#define MODES_MAX 64
#define EVERY KEY("every", WHOLE(every), "steps", DEFAULT("10"), FROM(1))

/* clang-format off */
#define OF scene_crack_output
static const struct scene_key crack[] = {
    KEY("damage", NUMBER(damage), "1", DEFAULT("0.35"), WITHIN(0, 1), WITHOUT_ENDS),
    KEY("direction", VECTOR(direction), "1", DEFAULT("[1, 0, 0]")),
    KEY("window", NUMBER(window), "s", ABOVE(0)),
    EVERY,
    END};
#undef OF

#define OF scene_intensity
static const struct scene_key intensity[] = {
    KEY("radii", LIST(scene_table_number, radius, radii, 1, LIST_MAX), "m", NEEDED, ABOVE(0)),
    KEY("crack", WHOLE(crack), "1", DEFAULT("all"), FROM(0), OR("all", -1), ONLY(SOLID | STEPPED)),
    KEY("tip", WHOLE(tip), "1", DEFAULT("all"), WITHIN(0, 1), OR("all", -1), ONLY(SOLID | STEPPED)),
    KEY("every", WHOLE(every), "steps", DEFAULT("10"), FROM(1), ONLY(SOLID | STEPPED)),
    END};
#undef OF

#define OF scene_modes
static const struct scene_key modes[] = {
    KEY("centre", VECTOR(centre), "m", NEEDED),
    KEY("axis", VECTOR(axis), "1", DEFAULT("[0, 0, 1]"), ONLY(SPACE)),
    KEY("radii", LIST(scene_table_number, radius, radii, 2, LIST_MAX), "m", NEEDED, FROM(0)),
    /* mode k needs rings of several k particles: more than 12 are for fine plates */
    KEY("highest", WHOLE(highest), "1", DEFAULT("12"), WITHIN(1, MODES_MAX)),
    EVERY,
    END};
#undef OF

#define OF scene_probes
static const struct scene_key probes[] = {
    KEY("at", LIST(scene_table_triple, at, places, 1, LIST_MAX), "m", NEEDED),
    EVERY,
    END};
#undef OF

#define OF scene_probe_line
static const struct scene_key lines[] = {
    KEY("from", VECTOR(from), "m", NEEDED),
    KEY("to", VECTOR(to), "m", NEEDED),
    KEY("points", WHOLE(points), "1", NEEDED, WITHIN(2, PROBES_MAX)),
    END};
#undef OF
ENTRY(line, scene_probe_line, lines);

#define OF scene_fluid_probes
static const struct scene_key fluid_probes[] = {
    KEY("at", LIST(scene_table_triple, at, places, 1, LIST_MAX), "m"),
    KEY("lines", LIST(line, line, lines, 1, LIST_MAX), "list"),
    EVERY,
    END};
#undef OF

#define OF scene_output
const struct scene_key scene_table_output[] = {
    KEY("series_every", WHOLE(series_every), "steps", DEFAULT("10"), FROM(0), ONLY(STEPPED)),
    KEY("fields_every", WHOLE(fields_every), "steps", DEFAULT("auto"), FROM(0), OR("auto", -1)),
    KEY("checkpoint_every", WHOLE(checkpoint_every), "steps", DEFAULT("1000"), FROM(0), ONLY(STEPPED)),
    KEY("log_every", WHOLE(log_every), "steps", DEFAULT("100"), FROM(0), ONLY(STEPPED)),
    KEY("permeability_every", WHOLE(permeability_every), "steps", DEFAULT("0"), FROM(0), ONLY(BOTH)),
    KEY("stress", SWITCH(stress), "bool", DEFAULT("true"), ONLY(STEPPED)),
    KEY("fragments", SWITCH(fragments), "bool", DEFAULT("true"), ONLY(SOLID | STEPPED)),
    KEY("reactions", SWITCH(reactions), "bool", DEFAULT("true"), ONLY(SOLID | STEPPED)),
    KEY("bodies", SWITCH(bodies), "bool", DEFAULT("true"), ONLY(SOLID | STEPPED)),
    KEY("events", SWITCH(events), "bool", DEFAULT("false"), ONLY(SOLID | STEPPED)),
    KEY("crack", SECTION(crack, crack), "section", ONLY(SOLID | STEPPED)),
    KEY("intensity", SECTION(intensity, intensity), "section", ONLY(SOLID | PLATE)),
    KEY("modes", SECTION(modes, modes), "section", ONLY(SOLID | STEPPED)),
    KEY("probes", SECTION(probes, probes), "section", ONLY(SOLID | STEPPED)),
    KEY("fluid_probes", SECTION(fluid_probes, fluid_probes), "section", ONLY(FLUID)),
    END};
#undef OF
/* clang-format on */
