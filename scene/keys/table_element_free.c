/* Keys of the section solid.element_free. */
#include "scene/keys/table.h"

static const struct scene_word bases[] = {WORD("linear", GALERKIN_LINEAR), WORD("sqrt_r", GALERKIN_SQRT_R),
                                          WORD("tip", GALERKIN_TIP)};
static const struct scene_word weights[] = {WORD("cubic", GALERKIN_CUBIC), WORD("quartic", GALERKIN_QUARTIC)};
static const struct scene_word cracks[] = {WORD("virtual", GALERKIN_VIRTUAL), WORD("diffraction", GALERKIN_DIFFRACTION),
                                           WORD("visibility", GALERKIN_VISIBILITY)};
static const struct scene_word updates[] = {WORD("conjugate", GALERKIN_CONJUGATE),
                                            WORD("hestenes_powell", GALERKIN_HESTENES_POWELL)};

/* clang-format off */
#define OF scene_growth
static const struct scene_key growth[] = {
    KEY("step", NUMBER(step), "m", NEEDED, ABOVE(0)),
    KEY("steps", WHOLE(steps), "1", DEFAULT("1000"), WITHIN(0, 100000)),
    KEY("until", NUMBER(until), "m", DEFAULT(".inf"), ABOVE(0), OR(".inf", INFINITY)),
    KEY("radius", NUMBER(radius), "m", ABOVE(0)),
    KEY("toughness", NUMBER(toughness), "Pa m^0.5", ABOVE(0)),
    END};
#undef OF

#define OF scene_element_free
const struct scene_key scene_table_element_free[] = {
    KEY("basis", CHOICE(basis, bases), "choice", DEFAULT("linear")),
    KEY("weight", CHOICE(weight, weights), "choice", DEFAULT("cubic")),
    KEY("support", NUMBER(support), "spacings", DEFAULT("2.5"), WITHIN(1, 8)),
    /* tips near each other: their zones may not overlap */
    KEY("tip_radius", NUMBER(tip_radius), "spacings", DEFAULT(".inf"), ABOVE(0), OR(".inf", INFINITY),
        WHERE("basis", "sqrt_r tip")),
    KEY("tip_levels", WHOLE(tip_levels), "1", DEFAULT("3"), WITHIN(0, 12)),
    KEY("tip_patch", NUMBER(tip_patch), "spacings", DEFAULT("2"), WITHIN(1, 20)),
    KEY("cells", VECTOR_OF(2, scene_table_whole, cells), "1", WITHIN(1, 100000)),
    /* for a check that the quadrature is fine enough, as a study of gauss, gauss_tip, cells and interface_spacing */
    KEY("gauss", WHOLE(gauss), "1", DEFAULT("4"), WITHIN(1, 16)),
    KEY("gauss_tip", WHOLE(gauss_tip), "1", DEFAULT("6"), WITHIN(1, 16)),
    KEY("crack", CHOICE(crack, cracks), "choice", DEFAULT("virtual")),
    KEY("interface_spacing", NUMBER(interface_spacing), "spacings", DEFAULT("1"), ABOVE(0), WHERE("crack", "virtual")),
    KEY("penalty", NUMBER(penalty), "1", DEFAULT("100"), ABOVE(0)),
    KEY("tolerance", NUMBER(tolerance), "1", DEFAULT("1.0e-10"), WITHIN(0, 1), WITHOUT_ENDS),
    KEY("iterations", WHOLE(iterations), "1", DEFAULT("1000"), WITHIN(1, 1000000)),
    KEY("update", CHOICE(update, updates), "choice", DEFAULT("conjugate")),
    KEY("growth", SECTION(growth, growth), "section", WHERE("basis", "linear sqrt_r")),
    END};
#undef OF
/* clang-format on */
