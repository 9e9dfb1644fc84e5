/* Recognises a launcher of another MPI than the library's. */
#pragma once

/* Dies (exit 2) if several ranks were started and each runs alone, because its library does not know the launcher: all
 * would write the same files. After par_begin. */
void launcher_check(void);
