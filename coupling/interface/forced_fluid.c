/* A step of the fluid with the solid immersed: predictor, forcing and projection of each stage. */
#include "coupling/interface/forced_fluid.h"
#include "coupling/run.h"
#include "fluid/scheme.h"

static void begin(struct run *r) {
    fluid_state_of(r->fluid)->t = r->t;
    ibm_inside_begin(r->ibm);
}

/* (001: eqs 3.70-3.73, 3.79-3.82) */
void forced_fluid_step(struct run *r) {
    begin(r);
    for (int s = 0; s < fluid_scheme_stages(r->fluid); s++) {
        fluid_predict(r->fluid, s, r->dt);
        ibm_forcing_stage(r->ibm, s, r->dt);
        fluid_project(r->fluid, s, r->dt);
    }
}

/* The force of the last stage diffuses with the velocity, then the rest of the force is added. */
void forced_fluid_step_implicit(struct run *r) {
    begin(r);
    for (int s = 0; s < fluid_scheme_stages(r->fluid); s++) {
        fluid_predict(r->fluid, s, r->dt);
        ibm_implicit_force_again(r->ibm, s, r->dt);
        fluid_diffusion_stage(r->fluid, s, r->dt);
        ibm_implicit_force(r->ibm, s, r->dt);
        fluid_project(r->fluid, s, r->dt);
    }
}
