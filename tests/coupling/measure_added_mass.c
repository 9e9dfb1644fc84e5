/* Measures the added mass that the coupled step gives a porous block set in motion. */
/* How the fluid answers when a porous block is set in motion as a whole within one step and then kept going: the
 * probes' force in each of the next steps, times the step, over the block's momentum. The sum over the steps, less the
 * drag that stays, is the added mass as the coupled step feels it, in units of the solid's mass
 * (docs/design/coupling.md). usage: measure_added_mass SCENE.yaml [--set-like overrides]...   one rank; the scene's
 * first stage must be elastic */
#include "base/die.h"
#include "base/par.h"
#include "coupling/interface/interface.h"
#include "coupling/run.h"
#include "coupling/step.h"

#include <stdio.h>

enum { STEPS = 8, HELD = SOLID_HELD_X };
static const double VELOCITY = 1e-6; /* m/s: displacements stay far below a bond's length */

int main(int argc, char **argv) {
    par_begin(&argc, &argv);
    if (argc < 2) die_all(EXIT_CODE_SCENE, "measure_added_mass: which scene?");
    struct scene *scene = scene_new(argv[1], argc - 2, (const char *const *)(argv + 2));
    struct run *r = run_new(scene);
    struct solid *s = r->solid;
    double mass = 0;
    step_begin_stage(r);
    for (int h = 0; h < s->n; h++) {
        if (s->flag[h] & HELD) continue;
        mass += s->in.material[s->in.body[s->body[h]].material].density * s->volume[h];
        s->v[0][h] = VELOCITY;
    }
    printf("step, force dt/(m V)\n");
    for (int n = 0; n < STEPS; n++) {
        for (int c = 0; c < 3; c++)
            for (int h = 0; h < s->n; h++) r->v_last[c][h] = s->v[c][h]; /* without the carried part */
        interface_update(r);
        ibm_markers_set(r->ibm, r->markers.n, (const double *const *)r->markers.x, (const double *const *)r->markers.v,
                        r->markers.volume);
        for (int stage = 0; stage < 3; stage++) {
            fluid_predict(r->fluid, stage, r->dt);
            ibm_forcing_stage(r->ibm, stage, r->dt);
            fluid_project(r->fluid, stage, r->dt);
        }
        load_sample(r);
        printf("%d, %.4f\n", n, r->load[0] * r->dt / (mass * VELOCITY));
    }
    run_free(r);
    scene_free(scene);
    par_end();
    return 0;
}
