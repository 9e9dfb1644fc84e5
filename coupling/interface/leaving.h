/* Moving bodies near an outflow. */
#pragma once

struct run;

/* Tells the fluid which outflows this rank's markers are near, if the solid moves. The markers are set. Not
 * collective. */
void leaving_update(const struct run *r);
