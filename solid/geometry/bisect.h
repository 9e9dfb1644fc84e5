/* The order of the particles' numbers: halves of the body, halves of these, and so on, each cut by a plane of bricks.
 * So a range of numbers is a box, or nearly one, wherever the ranks' borders are.  (001: sec. 4.4) */
#pragma once
#include <stdint.h>

/* A brick of the lattice, a cell or a point. */
struct solid_bisect_item {
    int at[3]; /* indices of the brick */
    int weight;
    uint8_t low[3], high[3]; /* bounds of what it holds, in sites from the brick's corner */
    long item;
};

/* Sorts the items. side: sites along a brick. is_ring: of each direction, whether the body touches itself across the
 * periodic sides. first: direction of the first cut; -1: across the longest side. Items of one brick keep their order.
 * Not collective. */
void solid_bisect_order(struct solid_bisect_item *item, long n, int side, const int is_ring[3], int first);
