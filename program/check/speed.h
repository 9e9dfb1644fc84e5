/* Measured speed of this machine, stored in the user's cache: $XDG_CACHE_HOME/frana/speed.csv, or
 * ~/.cache/frana/speed.csv. A cache that is missing, damaged or not writable is ignored: nothing here fails.
 * (docs/run-folder.md) */
#pragma once
#include "coupling/run.h"

enum speed_part {
    SPEED_CELL,     /* a step of a cell of the fluid, ns */
    SPEED_IMMERSED, /* a step of a particle of the interface: forcing, probe, surface, ns */
    SPEED_BOND,     /* a sweep over a directed bond, with contact and integration, ns */
    SPEED_SAMPLE,   /* a sample of the tables, over cells and directed bonds, ns */
    SPEED_FILE,     /* a byte of fields and checkpoints, ns */
    SPEED_REST,     /* everything else, as a fraction of these */
    SPEED_PARTS
};
enum { SPEED_TEXT = 96 };
enum speed_size {
    SPEED_CELLS,
    SPEED_PARTICLES,
    SPEED_BONDS,
    SPEED_SIZES
}; /* particles: of the interface; bonds: directed */

/* One line of the file. */
struct speed_sample {
    char processor[SPEED_TEXT], build[SPEED_TEXT], kind[SPEED_TEXT]; /* without commas */
    int cores, ranks;
    double when;              /* s since 1970 */
    double part[SPEED_PARTS]; /* times the number of ranks; 0: the run had none of it */
    double size[SPEED_SIZES]; /* of the whole scene */
};

/* Work that was done, or will be. */
struct speed_work {
    double seconds;                 /* wall, of the steps alone */
    double amount[SPEED_PARTS];     /* cells x steps, particles x steps, directed bonds x sweeps, samples x (cells and
                                     * directed bonds), bytes; SPEED_REST: unused */
    double seconds_of[SPEED_PARTS]; /* of them, sums over the ranks */
};

/* A sample with machine, build, kind and sizes of the scene, without times: others are compared by these. Collective.
 */
struct speed_sample speed_sample_for(const struct run *r);
/* Amounts of work of so many steps, cells x steps and sweeps. Collective. */
void speed_amounts(const struct run *r, double steps, double cells, double sweeps, double amount[SPEED_PARTS]);
/* Amounts of the output after the steps from + 1 .. to. Collective. */
void speed_outputs(struct run *r, long from, long to, double amount[SPEED_PARTS]);
/* The steps that the run has taken since it began or was resumed, by the clocks. Collective. */
struct speed_work speed_work_done(struct run *r);
/* Stores the times of the work, if it took `least` s or more, no stage relaxes, and no node has more ranks than cores.
 * Collective. */
void speed_store_work(const struct run *r, const struct speed_work *work, double least);
/* The same of one step of a bench: its seconds, and those of each part of the clocks, which are of the slowest rank.
 * Collective. */
void speed_store_step(const struct run *r, double seconds, const double *clock);
/* Sets the sample's times from the work. Returns 0 if the work was too little. Not collective. */
int speed_sample_set(const struct speed_work *work, struct speed_sample *sample);

/* A small solid takes longer a particle than a large one, because a step has costs that do not depend on the size. */
enum { SPEED_NEAR = 4 };

/* The measured speed of runs like this one. */
struct speed_estimate {
    int samples;              /* number of runs; 0: nothing is known */
    int same_kind;            /* they were of the same kind of scene */
    int same_ranks;           /* on the same number of ranks */
    double apart;             /* the largest ratio of one of their sizes to that of the scene, or the reverse; >= 1 */
    double newest;            /* s since 1970 */
    double part[SPEED_PARTS]; /* medians; 0: not known */
};
/* Reads the file of this machine: samples of the same kind whose sizes are within a factor of SPEED_NEAR, else
 * within 16, else of any size, else of other kinds; of equals those on as many ranks. Where these samples have no times
 * of tables and files, as those of benches, the times of other runs are taken. Not collective. */
struct speed_estimate speed_lookup(const struct speed_sample *like);
/* Appends a line; the newest 200 lines stay. Not collective. */
void speed_append(const struct speed_sample *sample);
