/* The table of the fluid's state: what of struct fluid_state a later step depends on.  (docs/design/state.md) */
#include "fluid/state_table.h"
#include "fluid/internal.h"

#include <string.h>

static int has_predictor(const void *owner) {
    const struct fluid_state *s = &((const struct fluid *)owner)->state;
    return s->pi != s->p;
}

static int keeps_rate(const void *owner) { return ((const struct fluid *)owner)->in.keeps_rate; }

/* Ghosts are rebuilt from the sides' conditions and the neighbours after reading; a snapshot has them. */
const struct state_item fluid_state_table[] = {
    {"u", STATE_DOUBLE, STATE_CELL, STATE_MEMBER(struct fluid_state, u), .in = STATE_BOTH},
    {"v", STATE_DOUBLE, STATE_CELL, STATE_MEMBER(struct fluid_state, v), .in = STATE_BOTH},
    {"w", STATE_DOUBLE, STATE_CELL, STATE_MEMBER(struct fluid_state, w), .in = STATE_BOTH},
    {"p", STATE_DOUBLE, STATE_CELL, STATE_MEMBER(struct fluid_state, p), .in = STATE_BOTH},
    {"pi", STATE_DOUBLE, STATE_CELL, STATE_MEMBER(struct fluid_state, pi), .in = STATE_BOTH, .missing = STATE_ABOVE,
     .is_part = has_predictor},
    {"rate_u", STATE_DOUBLE, STATE_CELL, STATE_MEMBER(struct fluid_state, rate[0]), .in = STATE_BOTH,
     .missing = STATE_LEFT, .is_part = keeps_rate},
    {"rate_v", STATE_DOUBLE, STATE_CELL, STATE_MEMBER(struct fluid_state, rate[1]), .in = STATE_BOTH,
     .missing = STATE_LEFT, .is_part = keeps_rate},
    {"rate_w", STATE_DOUBLE, STATE_CELL, STATE_MEMBER(struct fluid_state, rate[2]), .in = STATE_BOTH,
     .missing = STATE_LEFT, .is_part = keeps_rate},
    {"driving", STATE_DOUBLE, STATE_ONE, STATE_MEMBER(struct fluid_state, driving), .in = STATE_BOTH},
    {"rate_dt", STATE_DOUBLE, STATE_ONE, STATE_MEMBER(struct fluid_state, rate_dt), .in = STATE_BOTH,
     .missing = STATE_ZERO, .is_part = keeps_rate},
};

static void size_of(const void *owner, struct state_size *size) {
    const struct fluid_grid *g = ((const struct fluid *)owner)->grid;
    *size = (struct state_size){.cells = g->size, .inner = g->first, .block = {.row = g->row, .plane = g->plane}};
    memcpy(size->block.n, g->n, sizeof g->n);
    memcpy(size->block.lo, g->lo, sizeof g->lo);
    memcpy(size->block.m, g->m, sizeof g->m);
}

/* The velocities on the low faces of the domain are part of the state on an open side. They follow from its condition,
 * and are not stored. */
static void settle(void *owner) { fluid_state_refresh(owner); }

struct state_part fluid_state_table_part(struct fluid *f) {
    return (struct state_part){.item = fluid_state_table,
                               .items = sizeof fluid_state_table / sizeof fluid_state_table[0],
                               .base = &f->state,
                               .owner = f,
                               .size = size_of,
                               .settle = settle};
}
