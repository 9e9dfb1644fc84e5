/* How u* continues beyond a side, for a reader without ghost cells. */
#include "fluid/grid/boundary.h"
#include "fluid/internal.h"

struct fluid_mirror fluid_mirror_predicted(const struct fluid *f, int component, int direction, int side) {
    const struct fluid_boundary_side *s = &f->boundary->side[direction][side];
    const int on_face = component == direction;
    const double d = f->grid->d[direction], value = s->value[component];
    struct fluid_mirror m = {.inner = 1};
    if (f->grid->periodic[direction]) return m;
    m.is_free = on_face && s->normal == FLUID_NORMAL_FREE;
    /* an outflow's normal velocity has an even extension, as the other components have */
    const int even = s->condition[component] == FLUID_NEUMANN || (on_face && s->normal == FLUID_NORMAL_CONVECTIVE);
    if (even) {
        m.constant = (on_face ? 2 * d : d) * value;
    } else {
        m.inner = -1;
        m.face = on_face ? 2 : 0;
        m.constant = on_face ? 0 : 2 * value;
    }
    return m;
}
