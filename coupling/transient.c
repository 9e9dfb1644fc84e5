/* Resets what steps pass on to later ones but no checkpoint holds.  (docs/design/state.md) */
#include "coupling/transient.h"
#include "coupling/load/reaction.h"
#include "coupling/run.h"
#include "cracks/project.h"
#include "ibm/ibm.h"
#include "solid/bonds/ghosts.h"
#include "solid/contact/contact.h"
#include "solid/force/force.h"
#include "solid/imposed/external_loads.h"
#include "solid/step/strained.h"

void transient_reset(struct run *r) {
    r->deposited = -1;
    if (r->fluid) fluid_state_refresh(r->fluid);
    if (r->ibm) ibm_markers_sort_again(r->ibm);
    reaction_sort_again(r);
    if (!r->needs.bonds) return;
    solid_external_loads_restart(r->solid);
    if (r->cracks && r->solid->external_loads) cracks_project_load_again(r->cracks);
    solid_strained_forget(r->stretched);
    solid_ghosts_update(r->solid);
    solid_force_reset(r->solid);
    solid_contact_free(r->solid); /* contact finds its lists again when it is next needed */
}
