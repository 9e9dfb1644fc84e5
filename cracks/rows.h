/* The wet particles in rows of eight, with their struts and links: what the kernels sweep over.
 *
 * Every particle of a rank and every ghost has a place. Neighbours along one axis of the lattice have consecutive
 * places. A row is the eight places from a multiple of eight on. An entry stands for the struts of one kind of a row's
 * particles whose other ends have consecutive places:
 *
 *     row       places 8 q .. 8 q + 7                     lane k: place 8 q + k
 *     entry     kind, lanes, at                           where bit k is set: from lane k to place at + k
 *
 * Places stay as they are while cracks grow, and so do the entries of rows in which no bond breaks. Where one does, the
 * struts that are switched off stay off. */
#pragma once
#include "cracks/table.h"

struct cracks_rows {
    int *place;                 /* [solid's n + n_ghost], from 8 on */
    int places;                 /* end of the last row */
    int *row_of;                /* [places/8] row of eight places, -1: none */
    uint8_t *wet;               /* [places + 8] 1: a wet particle, owned or ghost */
    double *x;                  /* [places + 8] what the kernels read by place: a number of each wet particle .. */
    double *u[3];               /* [places + 8] .. and a vector */
    int n, capacity;            /* rows with an owned wet particle, ascending by place */
    int *first;                 /* [n] place of lane 0 */
    int (*index)[CRACKS_LANES]; /* [n] wet index by lane, -1: not wet, or not owned */
    uint16_t (*intact)[CRACKS_LANES]; /* [n] intact bonds when the entries were made */
    long *start, *middle, *end;       /* [n] entries of a row: broken bonds, from middle on intact ones (pores) */
    struct cracks_entry *strut;       /* entries that were made later lie behind the others */
    long struts, struts_capacity, struts_dead; /* dead: entries that no row has any more */
    long *last;                                /* [2 kinds] where the last entry of a kind may be */
    long *link_start;                          /* [n + 1] links of a row: to nearest particles that are wet too */
    struct cracks_entry *link;                 /* kind: the direction -x, x, -y, y, -z, z */
    long links_capacity;
    double *y[3]; /* [8 n] what the kernels write by slot */
};

/* Gives every particle and ghost a place; no rows yet. Collective. */
void cracks_rows_place(struct cracks_rows *r, const struct solid *s, const struct cracks_table *table);
void cracks_rows_clear(struct cracks_rows *r); /* no rows */
/* Removes all wet particles. The rows stay, with the struts that are switched off, but all are read again. Not
 * collective. */
void cracks_rows_mark_stale(struct cracks_rows *r);
/* The rows of the wet particles: n owned, then ghosts; h [n + ghosts] their local indices. Known rows keep their
 * entries. Not collective. */
void cracks_rows_renew(struct cracks_rows *r, const struct solid *s, int n, int ghosts, const int *h);
/* Makes the entries of a row again if bonds have broken in it or particles have become wet. Returns whether. porous:
 * the intact bonds have entries too. Not collective. */
int cracks_rows_read(struct cracks_rows *r, const struct solid *s, const struct cracks_table *table, const int *h,
                     int porous, int row);
/* Removes the entries that belong to no row any more. Not collective. */
void cracks_rows_compact(struct cracks_rows *r);
void cracks_rows_free(struct cracks_rows *r);
