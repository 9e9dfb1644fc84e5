/* Roma's three-point kernel.  (001: eq. 3.78; Roma, Peskin and Berger 1999) */
#include "ibm/ibm.h"

#include <math.h>

double ibm_kernel(double t) {
    const double r = fabs(t);
    if (r <= 0.5) return (1 + sqrt(1 - 3 * r * r)) / 3;
    if (r >= IBM_KERNEL_REACH) return 0;
    /* the difference of the last two terms vanishes at r = 3/2; fmax avoids a negative value by rounding */
    return fmax(0, (5 - 3 * r - sqrt(1 - 3 * (1 - r) * (1 - r))) / 6);
}
