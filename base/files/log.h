/* Messages to the user: lines on the screen and in run.log, and on a terminal a progress bar with rate and time left.
 * Only rank 0 writes; the others return at once. Not collective, except log_begin. */
#pragma once

/* folder NULL: screen only. quiet: run.log only. resume: run.log is appended to. Dies with exit code 4. Collective. */
void log_begin(const char *folder, int quiet, int resume);
void log_end(void);

void log_line(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Called after every step of a stage: step of total are done. On a terminal it redraws the bar at most ten times a
 * second; the log, and the screen where it is not a terminal, get a line every `every` steps and at the last. The
 * format adds values of the caller ("dp %.3g"); the text is formatted only when a line is shown. */
void log_progress(const char *stage, long step, long total, long every, const char *format, ...)
    __attribute__((format(printf, 5, 6)));
