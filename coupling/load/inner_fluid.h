/* The inertia of the fluid inside the body, which the load by reaction gives back to the solid. */
#pragma once

struct run;
struct inner_fluid; /* opaque */

/* Also allocates r->inner, which is state. Collective. */
struct inner_fluid *inner_fluid_new(struct run *r);
void inner_fluid_free(struct inner_fluid *k, struct run *r);
/* The next reading sorts the particles by cell (ibm_markers_sort_again). Not collective, on all ranks. */
void inner_fluid_sort_again(struct inner_fluid *k);
/* Stores the particles' positions at the beginning of a stage. Not collective. */
void inner_fluid_begin(struct run *r);
/* Reads the fluid within the body, where the particles were at the beginning of the step. Collective. */
void inner_fluid_read(struct inner_fluid *k, struct run *r, int stage);
/* The same after the last stage, for inner_fluid_work. Collective. */
void inner_fluid_read_last(struct inner_fluid *k, struct run *r);
/* Sets the solid's loads to what the inner fluid gives back in a stage, which takes the solid `length`, s, and the
 * external loads. Adds what the inner fluid gives to impulse, this rank's share, N s. Not collective. */
void inner_fluid_set_loads(struct inner_fluid *k, struct run *r, int stage, double length, double impulse[3]);
/* Gives the predicted velocity of the fluid deep inside the bodies its share of what inner_fluid_set_loads has found.
 * Collective. */
void inner_fluid_push(struct inner_fluid *k, struct run *r, int stage, double length);
/* The mean couple of this over the last step on the fluid about the domain's centre, N m. Collective. */
void inner_fluid_couple(const struct inner_fluid *k, const struct run *r, double couple[3]);
/* Once the fluid is read after the stage: work in the stage of what the inner fluid gives back, on this rank's
 * particles and on the fluid deep inside, J. Not collective. */
double inner_fluid_work(const struct inner_fluid *k, const struct run *r, int stage, double length);
/* What it gave in the last step that was taken, without the body force on it. */
struct inner_fluid_exchange {
    double impulse[3];  /* to particles and fluid, this rank's share, N s */
    double received[3]; /* of it and of the body force, by particles' loads, and by the fluid as it counts it, N s */
    unsigned long carrying; /* a number of which particles carry fluid along */
};
const struct inner_fluid_exchange *inner_fluid_last_exchange(const struct inner_fluid *k);
/* The sum of rho V (gamma U + excess) over stages and particles that carry fluid, and [3] that of the magnitudes of its
 * parts, N s; this rank's share. Not collective. */
void inner_fluid_momentum(const struct inner_fluid *k, const struct run *r, double sum[4]);
/* Whether particle h is deep in its body (solid/surface/deep.h). Not collective. */
int inner_fluid_is_deep(const struct inner_fluid *k, const struct run *r, int h);
/* The body force on the fluid, N/m3. */
double inner_fluid_body_force(const struct run *r, int c);
