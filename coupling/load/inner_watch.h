/* Watches that the inner fluid gives back what its momentum changes by, and no more. */
#pragma once

struct run;
struct inner_fluid;

/* After each accepted step of a solid that moves. Collective where a stage has just begun. */
void inner_watch_note(const struct inner_fluid *k, struct run *r);
/* Compares; the log warns of 1 % and more. Collective. */
void inner_watch_check(const struct inner_fluid *k, struct run *r);
