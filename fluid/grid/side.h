/* What each type of side stands for: one line of a table.  (001: sec. 4.1, eqs 4.1-4.4) */
#pragma once
#include "fluid/grid/boundary.h"

/* Whether the fluid passes the side. */
enum fluid_flow {
    FLUID_FLOW_NONE,    /* no */
    FLUID_FLOW_IN,      /* a given flow comes in */
    FLUID_FLOW_OUT,     /* fluid may leave */
    FLUID_FLOW_BY_VALUE /* by the condition and value of the normal velocity */
};

/* Where the values of the normal velocity on the side's face come from. */
enum fluid_side_values {
    FLUID_VALUES_ZERO,
    FLUID_VALUES_PROFILE, /* fluid/grid/profile.h */
    FLUID_VALUES_OWN      /* the side's velocity */
};

struct fluid_side_kind {
    const char *name;                /* as a scene has it */
    int is_general;                  /* 1: conditions and values of u, v, w and p are the side's own */
    int moves;                       /* 1: the tangential velocity is the side's, 0: zero */
    enum fluid_normal normal;        /* what decides the normal velocity; free where the pressure is given */
    enum fluid_condition tangential; /* of the velocity components along the side */
    enum fluid_condition pressure;
    enum fluid_side_values values;
    enum fluid_flow flow;
};

const struct fluid_side_kind *fluid_side_kind_of(enum fluid_side_type type); /* Not collective. */
/* Conditions and values of a side along a direction. Not collective. */
void fluid_side_conditions(const struct fluid_side *in, int direction, struct fluid_boundary_side *s);
/* Whether the side holds the velocity component at zero or at its own velocity, as a wall does. Not collective. */
int fluid_side_is_wall(const struct fluid_side *s, int component);
/* 1: the side gives a flow into the domain; -1: fluid may leave through it; 0: neither. Not collective. */
int fluid_side_flow(const struct fluid_side *s, int direction, int high);
