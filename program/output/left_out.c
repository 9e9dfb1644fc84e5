/* Parts of the program that a scene leaves out, in sentences: for the log, run.json and frana check. */
#include "program/output/left_out.h"
#include "coupling/setup/setup.h"

#include <stdio.h>

int left_out_of(const struct scene *scene, char sentence[LEFT_OUT_MAX][LEFT_OUT_SENTENCE]) {
    const struct setup_needs needs = setup_needs_of(scene);
    int n = 0;
#define ADD(...) snprintf(sentence[n++], LEFT_OUT_SENTENCE, __VA_ARGS__)
    if (!needs.fluid) ADD("fluid: the scene has no section fluid");
    if (!needs.solid) ADD("solid: the scene has no section solid");
    if (!needs.immersed) ADD("forcing and probe: nothing is immersed");
    if (needs.fluid && scene->fluid->diffusion != SCENE_DIFFUSION_IMPLICIT)
        ADD("implicit diffusion: fluid.diffusion is explicit");
    if (needs.solid && !needs.bonds) ADD("bonds: the solid is rigid in every stage");
    if (needs.bonds && !needs.breakage)
        ADD("breakage: no stage lets bonds break, or no material has a fracture energy");
    if (needs.bonds && !scene->solid->contact) ADD("contact: switched off");
    if (needs.bonds && scene->solid->contact && !needs.contact) ADD("contact: nothing can come loose");
    if (scene->output.fields_every == 0) ADD("fields: output.fields_every is 0");
    if (scene->output.checkpoint_every == 0) ADD("checkpoints while running: output.checkpoint_every is 0");
#undef ADD
    return n;
}
