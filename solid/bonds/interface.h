/* Interfaces: bonds between the particles of two bodies. For solid/ only.
 *
 * A body with an interface has lists of bonds. The bonds to another body stand in its families behind those within it,
 * with particles of the other body as other ends. Both bodies have each of them, as any other bond stands at both of
 * its ends. Their stiffness and their critical stretch are made of two halves, one of each end's law. */
#pragma once
#include "solid/body/cloud.h"

/* An interface as one of its bodies sees it. */
struct solid_interface_side {
    const struct solid_cloud *cloud;  /* of the other body; borrowed during the set-up, then NULL */
    struct solid_bond_law law, other; /* of the body and of the other one, with critical stretches by the interface's
                                       * fracture energy; their tables are those of the list */
};

/* Whether an interface joins the two bodies. Not collective, nor is any function here. */
int solid_interface_joins(const struct solid_input *in, int body, int other);
/* Whether the body has an interface at all. */
int solid_interface_any(const struct solid_input *in, int body);
/* Those of a body, *n of them; NULL where there are none. */
struct solid_interface_side *solid_interface_new(const struct solid_input *in, struct solid_cloud *const *cloud,
                                                 int body, int *n);
/* Finds the ends in the other body of the bonds of particle `number` of the cloud. Numbers are those of the other
 * cloud. Dies (exit 2) when there are more than `capacity`, or when two particles coincide. */
void solid_interface_find(const struct solid_interface_side *interface, const struct solid_cloud *cloud, long number,
                          int capacity, struct solid_cloud_near *near);
