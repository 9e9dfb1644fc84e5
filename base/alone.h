/* A process that no launcher started: Open MPI without its daemon, for a quicker start. */
#pragma once

/* Around MPI_Init. Not collective. */
void alone_begin(void);
void alone_end(void);
