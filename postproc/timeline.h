/* The timeline of run.json as a table of the report: parts by set-up, stages and end, with waiting. */
#pragma once
#include "postproc/report.h"
#include "postproc/tree.h"

/* Nothing if the run has no timeline. */
void postproc_timeline_report(struct postproc_report *report, const struct postproc_tree *record);
