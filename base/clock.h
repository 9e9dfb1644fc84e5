/* Wall seconds by part of the program. Parts nest: an inner part's time is not counted in the outer one's. */
#pragma once

enum clock_part {
    CLOCK_MOMENTUM,
    CLOCK_POISSON,
    CLOCK_HALO,
    CLOCK_FORCING,
    CLOCK_PROBE,
    CLOCK_SOLID,
    CLOCK_CONTACT,
    CLOCK_INTERFACE,
    CLOCK_OUTPUT,
    CLOCK_PARTS,
    /* details of a part: their time also counts in that part */
    CLOCK_FORWARD = CLOCK_PARTS, /* of poisson: divergence and forward transforms */
    CLOCK_COLUMNS,               /* of poisson: the last direction's solve */
    CLOCK_BACKWARD,              /* of poisson: backward transforms and correction */
    CLOCK_ALL
};

void clock_begin(enum clock_part part); /* Not collective. */
void clock_end(enum clock_part part);   /* Not collective. */
void clock_clear(void);                 /* A new run begins: all seconds are 0. Not collective. */
double clock_seconds(enum clock_part part);
const char *clock_name(enum clock_part part);
