/* Text files of numbers: points and lists of spheres. */
#pragma once

enum { SETUP_LINES_MAX = 8 }; /* numbers of a line */

/* Takes the n numbers of line `at`; n is -1 where there is anything else, and SETUP_LINES_MAX + 1 where there are
 * more. Returns NULL, or why the line is wrong, malloc'ed. */
typedef char *setup_lines_taker(void *with, long at, int n, const double *value);

/* Gives every line that is not empty or a comment (#) to `take`, until one is wrong. Returns how many were taken. *why:
 * NULL, or the reason, malloc'ed; also if the file cannot be opened. what: "point file of body rock". Not collective.
 */
long setup_lines_read(const char *path, const char *what, setup_lines_taker *take, void *with, char **why);
/* Dies (exit 2) with "path: why" unless rank 0's why is NULL; frees why. Collective. */
void setup_lines_die(const char *path, char *why);
