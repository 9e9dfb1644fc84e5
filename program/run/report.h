/* What a run writes to its log. Collective. */
#pragma once
#include "coupling/control/early_breakage.h"
#include "coupling/run.h"
#include "program/output/series.h"

/* Parts that are left out, warnings on the scene, and along what the permeability is measured. */
void report_set_up(struct run *r);
/* A warning if the ranks' threads share cores. */
void report_threads(void);
/* What changes in time before the solid moves (ramp.h), or, ends, after the run. Not collective. */
void report_ramp(const struct run *r, int ends);
void report_duration(const struct run *r); /* at a stage's end: whether its steps ended before its duration */
void report_strength(struct run *r);       /* at the end of a stage. Collective. */
void report_early_breakage(struct run *r,
                           const struct early_breakage_load *load); /* at the start of a stage. Collective. */
void report_ramp_of_stage(const struct run *r);                     /* at the end of a stage */
/* Steps and substeps of the stage that begins. */
void report_stage(const struct run *r);
/* The progress after a step. last: the last row of the series. */
void report_progress(const struct run *r, const struct series_sample *last);
/* After a step: whether a stage that waits for a steady quantity is steady, or ends without. */
void report_steadiness(const struct run *r, const struct steady_found *found, int is_steady, int is_last);
/* At a stage's end: what the permeability of the last row is worth. */
void report_flow(const struct run *r, const struct series_sample *last);
/* At a stage's end, of particles that have left through an outflow: what it does to their momentum. Collective. */
void report_leaving(const struct run *r);
/* At a stage's end: the work of the pressures in cracks. */
void report_crack_fluid(const struct run *r);
