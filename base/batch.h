/* When the batch system (Slurm, PBS) ends this job. The answer is asked of a command that runs beside the steps. */
#pragma once

/* Begins to ask when this process is in a job whose environment does not say when it ends: `squeue` of Slurm, `qstat`
 * of PBS. Does nothing if it was asked before. A command that is missing or fails is not an error. Not collective. */
void batch_query(void);
/* The end of the job, seconds since 1970; 0: not known, or not known yet. Never waits. Not collective. */
double batch_end(void);
/* Ends a command that has not answered yet, and forgets what was answered. Not collective. */
void batch_reset(void);

/* A duration, s: "[[days-]hours:]minutes:seconds" of Slurm, "[[[days:]hours:]minutes:]seconds" of PBS; -1: none. Pure.
 */
double batch_duration(const char *text);
/* The end of the job by what `qstat -f` prints, seconds since 1970; 0: it does not say. now: when it was asked,
 * seconds since 1970. */
double batch_end_of_pbs(const char *text, double now);
