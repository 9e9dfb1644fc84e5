/* The plan of an exchange, for par_exchange.c and par_ghost.c only. */
#pragma once
#include "base/par_count.h"
#include "base/par_exchange.h"

#include <mpi.h>

struct par_exchange {
    int sent, served;                        /* copies sent, items served */
    int *order, capacity;                    /* [sent] the item of each copy, by destination */
    int *to, *to_at, *from, *from_at, *next; /* [size] counts and offsets */
    int in_order;                            /* 1: all items stay on this rank, in their order */
    char *buffer;
    size_t buffer_bytes;
    MPI_Request *request;     /* [2 size] */
    enum par_count_kind kind; /* the kind that its messages count as */
};

/* A buffer of at least so many bytes, contents not kept. Not collective. */
char *par_exchange_reserve(struct par_exchange *x, size_t bytes);
/* Begins the exchange of pieces of unequal size between all ranks (empty ones and this rank's own are left out).
 * Returns the number of requests to wait for: first those that receive, then those that send. Not collective. */
int par_exchange_begin(struct par_exchange *x, const char *send, const int *to, const int *to_at, char *recv,
                       const int *from, const int *from_at, size_t bytes);
