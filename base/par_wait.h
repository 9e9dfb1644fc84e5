/* Wall seconds that this rank has spent inside MPI's calls that wait for other ranks: waits for messages, reductions,
 * broadcasts, gathers, barriers. What a call itself moves is included. Reading and writing files through MPI is not. */
#pragma once

/* Makes a call of MPI and counts its time. For base/par*.c alone. */
#define PAR_WAIT(call)                                                                                                 \
    do {                                                                                                               \
        const double par_wait_from = par_wait_begin();                                                                 \
        call;                                                                                                          \
        par_wait_end(par_wait_from);                                                                                   \
    } while (0)

double par_wait_begin(void);    /* Not collective, nor are the others. */
void par_wait_end(double from); /* from: what par_wait_begin returned */
double par_wait_seconds(void);  /* since the program began */
