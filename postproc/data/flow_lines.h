/* Streamlines of a fluid in 3D. */
#pragma once
#include "postproc/data/flow.h"
#include "postproc/data/stream.h"

/* Lines from a regular grid of about `lines` seeds on the side where the mean flow enters (of the direction in which
 * the mean velocity is largest) up to where it leaves, by steps of a quarter of a cell. If the mean velocity is below a
 * thousandth of the largest speed, the seeds fill the whole domain, and lines run both ways. Seeds in the solid give no
 * line. No line if nothing flows. */
struct postproc_stream postproc_flow_lines_new(const struct postproc_flow *f, int lines);
