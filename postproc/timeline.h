/* The timeline of run.json as a table of the report: parts by set-up, stages and end, with waiting. */
#pragma once
#include "base/files/json_read.h"
#include "postproc/report.h"

/* Nothing if the run has no timeline. */
void postproc_timeline_report(struct postproc_report *report, const struct json_read *record);
