/* What the environment tells of the program that started the ranks, and tells the one that will start others. */
#pragma once

/* Dies (exit 2) if several ranks were started and each runs alone, because its library does not know the launcher: all
 * would write the same files. After par_begin. */
void launcher_check(void);
int launcher_started(void); /* whether a launcher started this process. Not collective. */
/* Open MPI's launcher starts ranks of the superuser only if two environment variables allow it: sets them for whoever
 * is the superuser. Not collective. */
void launcher_allow(void);
