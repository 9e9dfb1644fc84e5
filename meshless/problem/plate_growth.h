/* Quasi-static growth of the cracks of an element-free plate by the maximum hoop stress.
 *
 * At each step the plate is solved under the scene's loads. K_I and K_II of each tip give the kink angle and K_eq
 * (physics/kink.h), and toughness over the largest K_eq is the factor of the loads at which a crack grows. The tip of
 * the largest K_eq, and those within a hundredth of it, move by `step`, and the next step begins. */
#pragma once
#include "meshless/problem/plate.h"
#include "base/files/json.h"

struct meshless_plate_growth_row {
    int step, tip;
    double x[2], along, kink; /* m; direction of the crack and angle to the next part, degrees */
    double k[2], k_eq;        /* Pa m^1/2 */
    double load;              /* factor of the loads */
    double length;            /* grown so far, m */
};
struct meshless_plate_growth {
    int rows, capacity, steps;
    struct meshless_plate_growth_row *row; /* [rows], owned */
    const char *end;                       /* why it ended */
};

/* Dies (exit 2) where the step or the radius does not fit the plate. Collective. */
void meshless_plate_growth_check(const struct scene *scene, const struct galerkin *g);
/* Solves the plate, and again for each step: *g and its setup are replaced. Collective. */
void meshless_plate_growth_run(struct meshless_plate_growth *a, const struct scene *scene, struct meshless_plate *setup,
                               struct galerkin **g, void (*solve)(struct galerkin *g));
void meshless_plate_growth_write(const struct meshless_plate_growth *a,
                                 const char *folder); /* growth.csv. Collective */
void meshless_plate_growth_write_json(const struct meshless_plate_growth *a, struct json *j); /* run.json. Rank 0 */
void meshless_plate_growth_free(struct meshless_plate_growth *a);
