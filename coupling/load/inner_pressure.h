/* The pressure of the fluid inside a body, which the load by reaction leaves out and the pressure in a crack does not.
 */
#pragma once

struct run;
struct inner_fluid;
struct inner_pressure; /* opaque */

/* NULL unless cracks are open to a resolved flow. Collective. */
struct inner_pressure *inner_pressure_new(struct run *r);
void inner_pressure_free(struct inner_pressure *k);
/* Reads the pressure inside each body, of the fluid's state. Collective. */
void inner_pressure_find(struct inner_pressure *k, struct run *r, const struct inner_fluid *inner);
/* The largest standard deviation, Pa, of the pressure deep in a body since the last call; it starts again. Of k = NULL
 * 0. Not collective, the same on all ranks. */
double inner_pressure_take_uneven(struct inner_pressure *k);
/* Adds its load, and again that of the cracks' pressures, to the solid's, which has been set again. Not collective. */
void inner_pressure_add(const struct inner_pressure *k, struct run *r);
