/* Work of the forcing with feedback on the fluid in a step, as the scheme has it. */
#pragma once
#include "ibm/ibm.h"

/* Before the first stage of a step, once the markers are set; after the projection of each stage. A reading of the
 * markers each. Collective. */
void ibm_feedback_work_begin(struct ibm *ibm);
void ibm_feedback_work_add(struct ibm *ibm);
/* Of the stages added since it was begun, this rank's share, J. Not collective. */
double ibm_feedback_work_sum(const struct ibm *ibm);
