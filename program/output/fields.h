/* Fields for ParaView: fields/fluid_*.hdf and fields/solid_*.hdf with their time series.  (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

void fields_write(struct run *r, const char *folder);     /* Collective. */
void fields_cut(const struct run *r, const char *folder); /* drops files later than the run's time from the series.
                                                           * Collective. */
