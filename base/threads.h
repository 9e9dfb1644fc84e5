/* Threads within a rank: they share the loops that take most of a step. The first one does everything else; MPI, clocks
 * and memory are used by it alone. OpenMP is used in base/ only. */
#pragma once

enum { THREADS_MAX = 256 };

/* To be called before anything is made. Returns 0, and there is one thread, if the program was built without OpenMP.
 * Not collective. */
int threads_set(int threads);
int threads_count(void);
int threads_me(void);    /* 0 .. threads_count() - 1; 0 outside threads_run */
int threads_cores(void); /* that this rank may run on; 0: not known */

/* Calls work on all threads, and returns once all have ended. With one thread this is a plain call. */
void threads_run(void (*work)(int thread, void *data), void *data);
/* Within work: waits until all threads have come here. */
void threads_wait(void);
/* A thread's part of n numbers, from .. to-1, in multiples of `unit` but for the end. */
void threads_share(int n, int unit, int thread, int *from, int *to);
