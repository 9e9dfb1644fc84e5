/* The load: how the flow acts on the solid (coupling.load of the scene). A new one is a file with its struct load_kind
 * and a line of the table in coupling/load/load.c. */
#pragma once
#include "scene/scene.h"

struct run;

struct load_kind {
    int has_probes;  /* probes read the flow's pressure and stress (coupling/interface/wall_probes.h) */
    int keeps_force; /* the forcing keeps each marker's force from step to step (ibm/feedback.c) */
    /* Allocate what the load needs, when the run is made; free it. NULL: nothing. Collective. */
    void (*begin)(struct run *r);
    void (*end)(struct run *r);
    /* Takes fluid and solid through a step together. NULL: they take turns: first the fluid, then `sample` sets the
     * loads, then the solid. Collective. */
    void (*step)(struct run *r);
    /* Sets the particles' loads and r->load from the present fields; for a load with a step of its own r->load alone,
     * of a solid at rest. Collective. */
    void (*sample)(struct run *r);
    /* After the solid has moved with the loads of `sample`: sets r->probes.work. NULL: nothing. Not collective. */
    void (*set_work)(struct run *r);
    /* How often in a step the forcing exchanges the momentum of a marker's volume. Not collective. */
    double (*forcing_times)(const struct run *r);
};

/* The kind of the scene's load. Not collective. */
const struct load_kind *load_kind_of(enum scene_load_form form);
/* A part of the step: r->load_kind->sample. Collective. */
void load_sample(struct run *r);
/* A part of the step: r->load_kind->set_work. Not collective. */
void load_set_work(struct run *r);
/* A part of the step: r->load_kind->step. Collective. */
void load_step(struct run *r);
