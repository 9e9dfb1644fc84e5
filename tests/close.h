/* |a - b| <= tolerance in double precision; NaN is never close. Include after cmocka.h. */
#pragma once
#include <math.h>

#define assert_close(a, b, tolerance)                                                                                  \
    do {                                                                                                               \
        const double a_ = (a), b_ = (b), off_ = (tolerance);                                                           \
        if (!(fabs(a_ - b_) <= off_)) fail_msg("%s = %.12g, not %.12g within %.3g", #a, a_, b_, off_);                 \
    } while (0)
