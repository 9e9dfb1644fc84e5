/* Factors that vary in time (struct solid_time). Inside the room only. */
#pragma once
#include "solid/state.h"

double solid_time_factor(const struct solid_time *f, double t);
/* The mean over from .. to; the factor itself where these are equal. */
double solid_time_mean(const struct solid_time *f, double from, double to);
/* Deep copies, as solid_new makes them. */
void solid_time_copy(struct solid_time *f);
void solid_time_free(struct solid_time *f);
