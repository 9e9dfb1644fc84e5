/* Reasons to stop early with a checkpoint: a signal, or the end of the time that the run may take. */
#pragma once

enum signals_reason {
    SIGNALS_NONE,
    SIGNALS_SIGNAL,   /* SIGTERM, SIGUSR1 or SIGINT */
    SIGNALS_MAX_WALL, /* --max-wall */
    SIGNALS_BATCH     /* the batch system's limit (base/batch.h) */
};

/* A loop of many turns that all ranks go through together; zero at its beginning. */
struct signals_poll_state {
    int turns, every; /* since the last poll; until the next one */
    double last;      /* when, s */
};

/* max_wall: seconds from now, 0 for no limit. A second SIGINT ends the program at once. SIGXFSZ and SIGPIPE are
 * ignored: the write fails instead. Not collective. */
void signals_begin(double max_wall);
/* The reason to stop now, if any rank has one; a signal comes before a time limit. reserve: seconds that a last step
 * and the checkpoint will take; time limits are reached that much earlier. The same on every rank. Collective. */
enum signals_reason signals_stop(double reserve);
/* The same; each of also[n] becomes the largest of all ranks. Collective. */
enum { SIGNALS_ALSO = 8 };
enum signals_reason signals_stop_also(double reserve, double *also, int n);
/* The same within a long loop: to be called in each turn, and answered about once a second, after the first turn at the
 * earliest. --max-wall counts here when it is over by ten seconds. None before signals_begin. Collective. */
enum signals_reason signals_poll(struct signals_poll_state *poll);
/* Seconds that a checkpoint takes, for signals_poll. Not collective. */
void signals_hold_back(double seconds);
/* on 1: nothing would be lost now, so a signal, or --max-wall when it is over by ten seconds, ends the program at once
 * with exit code 75, whatever it does. Ends it also if a signal has come before. 2: the same of what is solved at once
 * and cannot go on. 3: as 1, in a command that makes several runs and has no --resume-or-start. Not collective. */
void signals_at_once(int on);
/* Seconds until the batch system ends the job; infinite: not known, or no limit. Rank 0 knows. Not collective. */
double signals_batch_left(void);
/* The reason's name for the log: "SIGTERM", "--max-wall", ... Not collective. */
const char *signals_name(enum signals_reason reason);
