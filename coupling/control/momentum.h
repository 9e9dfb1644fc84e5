/* Watches the momentum of a solid that moves: it changes by the impulses on the solid, and by nothing else.
 *
 * Counted are the fluid's load (struct run, load), loads, body force, constraints, indenters, walls and absolute
 * damping. Directions in which particles are held are left out, because the force of their support is a reaction
 * (solid/imposed/reactions.h). The fluid in cracks pushes their faces apart, and gives no momentum. Not watched: the
 * added mass, whose impulse is not summed; and constraints and loads without reactions. */
#pragma once

struct run;

struct momentum_watch {
    int begun;
    double first[3];        /* of the free directions at the start, N s */
    double impulse[3];      /* since then, this rank's share, N s */
    double mass;            /* of the whole solid, kg */
    double largest_impulse; /* the largest impulse of the fluid, of loads or of supports since then, N s */
    double sizes;           /* the largest sum of the magnitudes of the particles' momenta so far, N s */
    double fluid[3];        /* the fluid's impulse since then, N s */
    double off, exchanged;  /* at the last check, N s */
    double logged;          /* the last off over exchanged that the log has */
};

/* At the start of a stage, and of a resumed run. Collective. */
void momentum_begin(struct run *r);
/* After each accepted step. Not collective. */
void momentum_note(struct run *r);
/* Compares. Returns off over exchanged, 0: nothing to compare. Collective. */
double momentum_check(struct run *r);
