/* Factors that vary in time (struct solid_time). For solid/ and cracks/. */
#pragma once
#include "solid/state.h"

double solid_time_factor(const struct solid_time *f, double t);
double
solid_time_ends(const struct solid_time *f); /* the time after which it is constant, s; -INFINITY: it always is */
/* The mean over from .. to; the factor itself if both are equal. */
double solid_time_mean(const struct solid_time *f, double from, double to);
/* Replaces the borrowed arrays by copies, for solid_new. */
void solid_time_copy(struct solid_time *f);
void solid_time_free(struct solid_time *f);
