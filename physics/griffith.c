/* Griffith's criterion of fracture, as an equivalent tension. */
#include "physics/griffith.h"

double physics_griffith_tension(const double p[3]) {
    if (3 * p[0] + p[2] >= 0) return p[0];
    const double difference = p[0] - p[2];
    return -difference * difference / (8 * (p[0] + p[2]));
}
