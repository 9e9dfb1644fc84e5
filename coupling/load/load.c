/* The table of loads. */
#include "coupling/load/load.h"
#include "base/ensure.h"
#include "coupling/load/probe.h"
#include "coupling/load/reaction.h"
#include "coupling/run.h"

static const struct load_kind *const kinds[] = {
    [SCENE_LOAD_REACTION] = &reaction_kind, [SCENE_LOAD_PROBE] = &probe_kind};

const struct load_kind *load_kind_of(enum scene_load_form form) {
    ENSURE((size_t)form < sizeof kinds / sizeof *kinds && kinds[form], "load %d is not in the table", (int)form);
    ENSURE(kinds[form]->sample && kinds[form]->forcing_times, "load %d lacks a function", (int)form);
    return kinds[form];
}

void load_sample(struct run *r) { r->load_kind->sample(r); }

void load_set_work(struct run *r) {
    if (r->load_kind->set_work) r->load_kind->set_work(r);
}

void load_step(struct run *r) { r->load_kind->step(r); }
