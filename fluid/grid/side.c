/* Table of the types of sides: conditions of u, v, w and p, and whether fluid passes.  (001: sec. 4.1, eqs 4.1-4.4) */
#include "fluid/grid/side.h"
#include "base/ensure.h"

/* It has no conditions. */
static const struct fluid_side_kind periodic = {.name = "periodic"};
static const struct fluid_side_kind wall = {.name = "wall",
                                            .moves = 1,
                                            .normal = FLUID_NORMAL_GIVEN,
                                            .tangential = FLUID_DIRICHLET,
                                            .pressure = FLUID_NEUMANN,
                                            .flow = FLUID_FLOW_NONE};
static const struct fluid_side_kind slip = {.name = "slip",
                                            .normal = FLUID_NORMAL_GIVEN,
                                            .tangential = FLUID_NEUMANN,
                                            .pressure = FLUID_NEUMANN,
                                            .flow = FLUID_FLOW_NONE};
static const struct fluid_side_kind inflow = {.name = "inflow",
                                              .normal = FLUID_NORMAL_GIVEN,
                                              .tangential = FLUID_DIRICHLET,
                                              .pressure = FLUID_NEUMANN,
                                              .values = FLUID_VALUES_PROFILE,
                                              .flow = FLUID_FLOW_IN};
static const struct fluid_side_kind outflow = {.name = "outflow",
                                               .normal = FLUID_NORMAL_CONVECTIVE,
                                               .tangential = FLUID_NEUMANN,
                                               .pressure = FLUID_NEUMANN,
                                               .flow = FLUID_FLOW_OUT};
static const struct fluid_side_kind pressure = {.name = "pressure",
                                                .normal = FLUID_NORMAL_FREE,
                                                .tangential = FLUID_NEUMANN,
                                                .pressure = FLUID_DIRICHLET,
                                                .flow = FLUID_FLOW_OUT};
static const struct fluid_side_kind general = {
    .name = "general", .is_general = 1, .values = FLUID_VALUES_OWN, .flow = FLUID_FLOW_BY_VALUE};

/* The table: a type without a line does not compile. */
const struct fluid_side_kind *fluid_side_kind_of(enum fluid_side_type type) {
    switch (type) {
    case FLUID_PERIODIC:
        return &periodic;
    case FLUID_WALL:
        return &wall;
    case FLUID_SLIP:
        return &slip;
    case FLUID_INFLOW:
        return &inflow;
    case FLUID_OUTFLOW:
        return &outflow;
    case FLUID_PRESSURE:
        return &pressure;
    case FLUID_GENERAL:
        return &general;
    }
    ENSURE(0, "side type %d", (int)type);
}

void fluid_side_conditions(const struct fluid_side *in, int d, struct fluid_boundary_side *s) {
    const struct fluid_side_kind *k = fluid_side_kind_of(in->type);
    s->normal = k->normal;
    for (int c = 0; c < 3; c++) {
        s->condition[c] = k->is_general ? in->condition[c] : c == d ? FLUID_DIRICHLET : k->tangential;
        s->value[c] = k->is_general || (k->moves && c != d) ? in->velocity[c] : 0;
    }
    s->condition[3] = k->is_general ? in->condition[3] : k->pressure;
    s->value[3] = s->condition[3] == FLUID_DIRICHLET ? in->pressure : 0;
    if (s->condition[3] == FLUID_DIRICHLET) {
        s->normal = FLUID_NORMAL_FREE;
        s->condition[d] = FLUID_NEUMANN;
    }
}

int fluid_side_is_wall(const struct fluid_side *s, int component) {
    const struct fluid_side_kind *k = fluid_side_kind_of(s->type);
    return k->moves || (k->is_general && s->condition[component] == FLUID_DIRICHLET);
}

int fluid_side_flow(const struct fluid_side *s, int d, int high) {
    const double in = high ? -s->velocity[d] : s->velocity[d];
    switch (fluid_side_kind_of(s->type)->flow) {
    case FLUID_FLOW_NONE:
        return 0;
    case FLUID_FLOW_IN:
        return 1;
    case FLUID_FLOW_OUT:
        return -1;
    case FLUID_FLOW_BY_VALUE:
        return s->condition[d] == FLUID_NEUMANN || in < 0 ? -1 : in > 0;
    }
    ENSURE(0, "side type %d", (int)s->type);
}
