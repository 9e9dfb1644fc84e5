/* Load by probes: the traction of the flow at the wetted faces.  (001: sec. 3.5.3) */
#pragma once
#include "coupling/load/load.h"

extern const struct load_kind probe_kind, probe_kind_at_wall;

/* Functions of the kinds (coupling/load/load.h), also for loads that correct what probes read. */
void probe_begin(struct run *r);
void probe_end(struct run *r);
void probe_sample(struct run *r);
double probe_forcing_times(const struct run *r);
