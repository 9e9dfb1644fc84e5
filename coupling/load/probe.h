/* Load by probes: the traction of the flow at the wetted faces.  (001: sec. 3.5.3) */
#pragma once
#include "coupling/load/load.h"

extern const struct load_kind probe_kind;
