/* Speed of a length that grows in jumps. */
#include "physics/growth.h"

double physics_growth_speed(const double *t, const double *length, long i, double advance, long *first) {
    while (*first + 1 < i && length[i] - length[*first + 1] >= advance) ++*first;
    if (!(length[i] - length[*first] >= advance)) return 0;
    return (length[i] - length[*first]) / (t[i] - t[*first]);
}
