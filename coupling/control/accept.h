/* The decision whether a step that was taken is accepted. */
#pragma once
struct run;
struct step_status;

/* This rank's numbers for accept_step, to be reduced by max; failed: of step_check. Not collective. */
enum { ACCEPT_FAILED, ACCEPT_RATE, ACCEPT_FASTEST, ACCEPT_NUMBERS };
void accept_numbers(const struct run *r, int failed, double number[ACCEPT_NUMBERS]);
/* Decides whether a step is accepted, from the largest numbers of all ranks; sets the limits of the next step. A step
 * is rejected if a value is NaN or beyond reason; if an automatic step exceeds the limit of the velocities that it led
 * to; if an automatic number of substeps is unstable with new contact. A rejected step is to be made again, shorter or
 * with more substeps, or the run ends; status says why, the same on all ranks. Collective. */
enum accept_verdict { ACCEPT_STEP, ACCEPT_REPEAT, ACCEPT_ABORT };
enum accept_verdict accept_step(struct run *r, const double number[ACCEPT_NUMBERS], struct step_status *status);
/* To be called before a rejected step is made again, in the state before it: sets the number of substeps where no part
 * of the step does. Not collective. */
void accept_begin_repeat(struct run *r);
/* To be called when the step was accepted, perhaps after repeats. Not collective. */
void accept_end_step(struct run *r);
