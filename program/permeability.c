/* frana permeability: chooses how the tensor of permeability is found. */
#include "program/permeability.h"
#include "base/die.h"
#include "base/files/log.h"
#include "coupling/setup/pores.h"
#include "program/permeability/creeping.h"
#include "program/permeability/stepped.h"

int permeability_run(const struct command *c, const struct scene *scene) {
    const struct permeability_drive drive = permeability_drive_of(scene);
    const char *why = c->stepped ? NULL : setup_pores_why(scene);
    if (c->fields && (c->stepped || why))
        die_all(EXIT_CODE_SCENE,
                "--fields: only where the flow is solved at once%s%s; runs that are stepped write fields "
                "by output.fields_every",
                why ? ", and here " : "", why ? why : "");
    if (why) log_line("the flow is stepped in time, because %s", why);
    return c->stepped || why ? permeability_stepped_run(c, scene, &drive) : permeability_creeping_run(c, scene, &drive);
}
