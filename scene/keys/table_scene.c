/* Keys of the whole scene, of its domain and of its stages. */
#include "scene/keys/table.h"

static const struct scene_word solid_modes[] = {WORD("rigid", SCENE_SOLID_RIGID), WORD("elastic", SCENE_SOLID_ELASTIC)};
static const struct scene_word integrators[] = {WORD("rk3", SOLID_RK3), WORD("verlet", SOLID_VERLET)};
static const struct scene_word fluid_integrators[] = {WORD("rk3", FLUID_RK3), WORD("ab2", FLUID_AB2)};
static const struct scene_word quantities[] = {WORD("permeability", SCENE_UNTIL_PERMEABILITY),
                                               WORD("rest", SCENE_UNTIL_REST)};

/* clang-format off */
#define OF scene_domain
static const struct scene_key domain[] = {
    KEY("size", VECTOR(size), "m", NEEDED, ABOVE(0)),
    KEY("cells", VECTOR_OF(3, scene_table_whole, cells), "1", WITHIN(1, CELLS_MAX), ONLY(SPACE), NEEDED_IN(FLUID)),
    KEY("periodic", VECTOR_OF(3, scene_table_switch, periodic), "bool", DEFAULT("[false, false, false]"), ONLY(NO_FLUID)),
    END};
#undef OF

#define OF scene_stage
static const struct scene_key until[] = {
    KEY("quantity", CHOICE(until_quantity, quantities), "choice", DEFAULT("permeability")),
    KEY("change", NUMBER(until_change), "1", WITHIN(0, 1), WITHOUT_LOW),
    KEY("kinetic", NUMBER(until_kinetic), "1", DEFAULT("1.0e-3"), WITHIN(0, 1), WITHOUT_LOW, WHERE("quantity", "rest")),
    KEY("window", WHOLE(until_window), "steps", DEFAULT("20"), FROM(2)),
    END};
static const struct scene_key stage[] = {
    KEY("name", TEXT(name), "text", NEEDED),
    KEY("steps", WHOLE(steps), "1", NEEDED, FROM(0)),
    KEY("duration", NUMBER(duration), "s", ABOVE(0)),
    KEY("until", PART(until), "section"),
    KEY("time_step", NUMBER(time_step), "s", DEFAULT("auto"), ABOVE(0), OR("auto", 0)),
    KEY("cfl", NUMBER(cfl), "1", WITHIN(0, 1), WITHOUT_LOW),
    KEY("solid", CHOICE(solid, solid_modes), "choice", DEFAULT("elastic"), ONLY(SOLID)),
    KEY("relax", SWITCH(relax), "bool", DEFAULT("false"), ONLY(SOLID | NO_FLUID)),
    KEY("increment", NUMBER(increment), "s", ABOVE(0), ONLY(SOLID | NO_FLUID)),
    KEY("tolerance", NUMBER(tolerance), "1", DEFAULT("1.0e-6"), WITHIN(0, 0.1), WITHOUT_LOW, ONLY(SOLID | NO_FLUID)),
    KEY("integrator", CHOICE(integrator, integrators), "choice", ONLY(SOLID)),
    KEY("fluid_integrator", CHOICE(fluid_integrator, fluid_integrators), "choice", DEFAULT("rk3"), ONLY(FLUID)),
    KEY("substeps", WHOLE(substeps), "1", DEFAULT("auto"), WITHIN(1, 1e6), OR("auto", 0), ONLY(SOLID)),
    KEY("safety", NUMBER(safety), "1", DEFAULT("0.95"), WITHIN(0, 1), WITHOUT_LOW, ONLY(SOLID)),
    KEY("breakage", SWITCH(breakage), "bool", DEFAULT("true"), ONLY(SOLID)),
    KEY("damping_relative", NUMBER(damping_relative), "N s/m7", DEFAULT("0"), FROM(0), ONLY(SOLID)),
    KEY("damping_absolute", NUMBER(damping_absolute), "1/s", FROM(0), OR("auto", -1), ONLY(SOLID)),
    KEY("crack_fluid", SWITCH(crack_fluid), "bool", ONLY(SOLID)),
    END};
#undef OF
ENTRY(a_stage, scene_stage, stage);

#define OF scene
static const struct scene_key scene[] = {
    KEY("title", TEXT(title), "text"),
    KEY("domain", INNER(domain, domain), "section", NEEDED, NOT_WITH("nonlocal")),
    KEY("fluid", SECTION(fluid, scene_table_fluid), "section", ONLY(STEPPED)),
    KEY("solid", SECTION(solid, scene_table_solid), "section", NOT_WITH("nonlocal")),
    KEY("coupling", SECTION(coupling, scene_table_coupling), "section", DEFAULT("{}"), ONLY(BOTH)),
    KEY("crack_fluid", SECTION(crack_fluid, scene_table_crack_fluid), "section", ONLY(SOLID | STEPPED)),
    KEY("nonlocal", SECTION(nonlocal, scene_table_nonlocal), "section"),
    KEY("stages", LIST(a_stage, stage, stages, 1, LIST_MAX), "list", NEEDED, ONLY(STEPPED)),
    KEY("output", INNER(output, scene_table_output), "section", DEFAULT("{}")),
    END};
#undef OF
/* clang-format on */

const struct scene_value scene_table_scene = {
    .type = SCENE_SECTION, .bytes = sizeof(struct scene), .keys = scene, .is_allocated = 1};
