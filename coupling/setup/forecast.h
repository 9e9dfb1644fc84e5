/* Refuses a scene that cannot fit into memory, before anything is made. */
#pragma once
#include "scene/scene.h"

/* Dies (exit 2) on a fluid or a body of which least needs are more memory than the machines of all ranks have. Bodies
 * whose volume is not known from the scene alone, those of files, with holes or with cavities, are not checked.
 * Collective. */
void forecast_check(const struct scene *scene);
/* Bytes of memory that a rank may take: its node's memory, in equal parts for the node's ranks. Collective. */
double forecast_share(void);
